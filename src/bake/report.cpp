// SPDX-License-Identifier: MIT
#include "bake/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "animal/read_animal.hpp"
#include "base/interrupt.hpp"
#include "format/texels.h"
#include "measure/decode_cost.hpp"
#include "measure/shader_cost.hpp"
#include "motion/skin_set.hpp"
#include "output/report_heat.hpp"
#include "posepack/loader.h"

namespace posepack::bake {
namespace {

constexpr recipe::Encoding kEncodings[] = {recipe::Encoding::mat4, recipe::Encoding::affine,
                                           recipe::Encoding::dualquat};
constexpr recipe::TexelFormat kFormats[] = {recipe::TexelFormat::rgba32f, recipe::TexelFormat::rgba16f};
constexpr std::uint32_t kHeatColumns = 200;  // of each band of clips that is drawn

// How an entry is to be baked, and what that is called.
struct Scheme {
    recipe::AnimalEntry entry;
    std::string rows;
    bool is_chosen = false;
};

std::string rows_label(std::optional<double> rate_hz) {
    return rate_hz ? fmt::format("{:g} Hz", *rate_hz) : "keys";
}

std::string form_label(const recipe::OutputOptions& output) {
    if (output.bound)
        return fmt::format("within {:g}{} {}", output.bound->max.value,
                           output.bound->max.in_metres ? " m" : " R", name_of(output.texel_format));
    return fmt::format("{} {}", name_of(output.encoding), name_of(output.texel_format));
}

// The rate that the catalog asks of every clip, or none where clips differ.
struct OwnRate {
    bool is_common = true;
    std::optional<double> rate_hz;
};

OwnRate own_rate_of(const recipe::AnimalEntry& entry) {
    if (entry.clips.empty()) return {true, entry.rate_hz};
    const std::optional<double> rate_hz = entry.clips.front().rate_hz;
    const bool is_common = std::all_of(entry.clips.begin(), entry.clips.end(),
                                       [&](const recipe::ClipWish& wish) { return wish.rate_hz == rate_hz; });
    return {is_common, rate_hz};
}

// Every form at every rate, then what the catalog asks for, if it is none of them.
std::vector<Scheme> schemes_of(const recipe::AnimalEntry& entry,
                               const std::vector<std::optional<double>>& rates_hz) {
    const OwnRate own = own_rate_of(entry);
    std::vector<Scheme> schemes;
    bool has_chosen = false;
    for (const recipe::Encoding encoding : kEncodings)
        for (const recipe::TexelFormat format : kFormats)
            for (const auto& rate_hz : rates_hz) {
                Scheme scheme{entry, rows_label(rate_hz)};
                scheme.entry.output.bound.reset();
                scheme.entry.output.encoding = encoding;
                scheme.entry.output.texel_format = format;
                scheme.entry.rate_hz = rate_hz;
                for (recipe::ClipWish& wish : scheme.entry.clips) wish.rate_hz = rate_hz;
                scheme.is_chosen = !has_chosen && !entry.output.bound && own.is_common &&
                                   own.rate_hz == rate_hz && encoding == entry.output.encoding &&
                                   format == entry.output.texel_format;
                has_chosen = has_chosen || scheme.is_chosen;
                schemes.push_back(std::move(scheme));
            }
    if (entry.output.bound)
        schemes.push_back({entry, "chosen", true});
    else if (!has_chosen)
        schemes.push_back({entry, own.is_common ? rows_label(own.rate_hz) : "catalog", true});
    // No form may fail for its texture's size alone.
    for (Scheme& scheme : schemes) scheme.entry.output.caps = recipe::Caps::desktop;
    return schemes;
}

// Texels of the stored rows, without the fill of the last line and of pitches, and the tables of rows.
std::uint64_t palette_bytes(const recipe::BakeRecord& record) {
    return record.texel_bytes + record.row_table_bytes;
}

// Runs cost what their form costs, and the run of each influence beside it.
measure::ShaderCost cost_of(const recipe::BakeRecord& record, recipe::Encoding fixed) {
    if (record.row_scheme != "runs") return measure::shader_cost(fixed);
    measure::ShaderCost cost = measure::shader_cost(record.encoding == "affine" ? recipe::Encoding::affine
                                                                                : recipe::Encoding::dualquat);
    cost.fetches += 4;
    cost.alu_operations += 24;
    return cost;
}

output::ReportRow row_of(const Scheme& scheme, const BakedAnimal& baked, const motion::SkinSet& points) {
    const recipe::BakeRecord& record = baked.record;
    const measure::ShaderCost cost = cost_of(record, scheme.entry.output.encoding);
    output::ReportRow row;
    row.form = form_label(scheme.entry.output);
    row.encoding = record.encoding;
    row.texel_format = record.texel_format;
    row.rows = scheme.rows;
    row.is_chosen = scheme.is_chosen;
    row.bytes = palette_bytes(record);
    row.error = record.error;
    row.decode_ns_per_vertex = measure::decode_cost_ns(baked.container, points);
    row.fetches = cost.fetches;
    row.alu_operations = cost.alu_operations;
    row.bake_ms = baked.bake_s * 1e3;
    return row;
}

// The measured errors with names, of the bones that move vertices.
output::HeatMap named_heat(const measure::ErrorHeat& heat, const animal::Animal& animal,
                           const motion::SkinSet& points, const std::vector<recipe::ClipRecord>& clips) {
    std::vector<bool> is_used(heat.bone_count);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < animal::kMaxInfluences; ++k)
            if (points.weights[i][k] > 0.0f) is_used[points.bones[i][k]] = true;
    output::HeatMap map;
    for (std::uint32_t b = 0; b < heat.bone_count; ++b)
        if (is_used[b]) map.bones.push_back(animal.bones[b].name);
    for (std::size_t c = 0; c < heat.clips.size(); ++c) {
        output::HeatClip clip{clips[c].name, heat.clips[c].edges_s, {}};
        for (std::size_t cell = 0; cell < heat.clips[c].errors.size(); ++cell)
            if (is_used[cell % heat.bone_count]) clip.errors.push_back(heat.clips[c].errors[cell]);
        map.clips.push_back(std::move(clip));
    }
    return map;
}

base::Result<output::AnimalReport> report_animal(const recipe::AnimalEntry& entry,
                                                 std::span<const std::uint8_t> glb,
                                                 const ReportOptions& options) {
    const auto animal = animal::read_animal(glb);
    if (!animal) return base::at(entry.model, animal.issue());
    const motion::SkinSet points = motion::unique_points(animal.value());
    const auto bands = static_cast<std::uint32_t>(1 + animal.value().clips.size() / output::kHeatClips);
    const std::uint32_t heat_columns = kHeatColumns * bands;
    output::AnimalReport report;
    report.id = entry.id;
    for (const Scheme& scheme : schemes_of(entry, options.rates_hz)) {
        if (auto status = base::check_interrupt(); !status) return status.issue();
        AnimalOptions how;
        if (scheme.is_chosen && options.with_heat) how.heat_columns = heat_columns;
        const auto baked = bake_animal(scheme.entry, glb, how);
        if (!baked) {
            if (baked.issue().code != base::IssueCode::lim_similarity) return baked.issue();
            report.refused.push_back({form_label(scheme.entry.output), scheme.rows, baked.issue()});
            continue;
        }
        const recipe::BakeRecord& record = baked.value().record;
        report.radius_m = record.radius_m;
        report.bone_count = record.bone_count;
        report.vertex_count = record.vertex_count;
        report.rows.push_back(row_of(scheme, baked.value(), points));
        if (!scheme.is_chosen) continue;
        report.clips = record.clips;
        if (baked.value().heat)
            report.heat = named_heat(*baked.value().heat, animal.value(), points, record.clips);
    }
    return report;
}

}  // namespace

base::Result<output::Report> report_catalog(const CatalogSource& source, const ReportOptions& options) {
    const auto file = open_catalog(source);
    if (!file) return file.issue();
    output::Report report;
    report.catalog = source.catalog.filename().string();
    for (const recipe::AnimalEntry& entry : file.value().catalog.animals) {
        const auto glb = read_model(file.value(), entry);
        if (!glb) return glb.issue();
        auto animal = report_animal(entry, glb.value(), options);
        if (!animal) return animal.issue();
        report.animals.push_back(std::move(animal).value());
    }
    return report;
}

}  // namespace posepack::bake
