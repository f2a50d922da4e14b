// SPDX-License-Identifier: MIT
#include "bake/report.hpp"

#include <fmt/format.h>

#include "animal/read_animal.hpp"
#include "base/interrupt.hpp"
#include "measure/decode_cost.hpp"
#include "motion/skin_set.hpp"
#include "posepack/loader.h"

namespace posepack::bake {
namespace {

constexpr recipe::Encoding kEncodings[] = {recipe::Encoding::mat4, recipe::Encoding::affine,
                                           recipe::Encoding::dualquat};
constexpr recipe::TexelFormat kFormats[] = {recipe::TexelFormat::rgba32f, recipe::TexelFormat::rgba16f};

base::Result<ReportRow> report_form(recipe::AnimalEntry entry, std::span<const std::uint8_t> glb,
                                    const motion::SkinSet& points, std::optional<double> rate_hz) {
    entry.rate_hz = rate_hz;
    entry.output.bound.reset();
    for (recipe::ClipWish& wish : entry.clips) wish.rate_hz = rate_hz;
    entry.output.caps = recipe::Caps::desktop;  // no form may fail for its texture's size alone
    const auto baked = bake_animal(entry, glb, AnimalOptions{});
    if (!baked) return baked.issue();
    const recipe::BakeRecord& record = baked.value().record;
    ReportRow row{record.id, record.encoding,           record.texel_format,
                  {},        record.texel_bytes,        record.error,
                  0.0,       baked.value().bake_s * 1e3};
    row.rate = rate_hz ? fmt::format("{:g}", *rate_hz) : "keys";
    row.decode_ns_per_vertex = measure::decode_cost_ns(baked.value().container, points);
    return row;
}

}  // namespace

base::Result<Report> report_catalog(const CatalogSource& source,
                                    const std::vector<std::optional<double>>& rates_hz) {
    const auto file = open_catalog(source);
    if (!file) return file.issue();
    Report report;
    for (const recipe::AnimalEntry& entry : file.value().catalog.animals) {
        const auto glb = read_model(file.value(), entry);
        if (!glb) return glb.issue();
        const auto animal = animal::read_animal(glb.value());
        if (!animal) return base::at(entry.model, animal.issue());
        const motion::SkinSet points = motion::unique_points(animal.value());
        for (const recipe::Encoding encoding : kEncodings)
            for (const recipe::TexelFormat format : kFormats)
                for (const auto& rate_hz : rates_hz) {
                    if (auto status = base::check_interrupt(); !status) return status.issue();
                    recipe::AnimalEntry form = entry;
                    form.output.encoding = encoding;
                    form.output.texel_format = format;
                    auto row = report_form(std::move(form), glb.value(), points, rate_hz);
                    if (!row && row.issue().code != base::IssueCode::lim_similarity) return row.issue();
                    if (row)
                        report.rows.push_back(std::move(row).value());
                    else
                        report.refused.push_back(row.issue());
                }
    }
    return report;
}

}  // namespace posepack::bake
