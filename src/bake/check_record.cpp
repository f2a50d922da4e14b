// SPDX-License-Identifier: MIT
#include "bake/check_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "bake/records.hpp"
#include "base/json.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "output/container_json.hpp"

namespace posepack::bake {
namespace {

using base::Issue;
using base::IssueCode;
using nlohmann::json;

constexpr std::size_t kShownBytes = 80;
constexpr double kBinWidth = 1.01;  // a percentile is the upper edge of a bin of 0.8 % (docs/error_metric.md)

std::string text_of(const posepack_string& string) {
    return {string.data, string.size_bytes};
}

float metres(float fraction, float radius_m) {
    return static_cast<float>(static_cast<double>(fraction) * static_cast<double>(radius_m));
}

std::string mesh_name(const posepack_view& view, std::uint32_t index) {
    posepack_mesh mesh;
    return posepack_get_mesh(&view, index, &mesh) == POSEPACK_OK ? text_of(mesh.name) : std::string();
}

std::string bone_name(const posepack_view& view, std::uint32_t index) {
    posepack_bone bone;
    return posepack_get_bone(&view, index, &bone) == POSEPACK_OK ? text_of(bone.name) : std::string();
}

recipe::ErrorRecord error_of(const posepack_view& view, const posepack_clip& clip) {
    const posepack_clip_error& error = clip.error;
    const float radius_m = view.header.radius_m;
    recipe::ErrorRecord record;
    record.measured = clip.measured != 0;
    record.max = error.max;
    record.p999 = error.p999;
    record.rms = error.rms;
    record.max_m = metres(error.max, radius_m);
    record.p999_m = metres(error.p999, radius_m);
    record.rms_m = metres(error.rms, radius_m);
    record.normal_max_deg = error.normal_max_deg;
    record.normal_p999_deg = error.normal_p999_deg;
    record.normal_rms_deg = error.normal_rms_deg;
    record.time_s = error.time_s;
    record.vertex = error.vertex;
    record.mesh = mesh_name(view, error.mesh);
    record.bone = bone_name(view, error.bone);
    return record;
}

recipe::ClipRecord clip_of(const posepack_view& view, const posepack_clip& clip) {
    recipe::ClipRecord record;
    record.name = text_of(clip.name);
    record.source_name = text_of(clip.source_name);
    record.first_row = clip.first_row;
    record.row_count = clip.row_count;
    record.rate_hz = clip.rate_hz;
    record.period_s = clip.period_s;
    record.start_s = clip.start_s;
    record.wrap = output::wrap_name(clip.wrap);
    record.seam = output::seam_name(clip.seam);
    record.interpolation = clip.interpolation == POSEPACK_INTERPOLATION_STEP ? "step" : "linear";
    record.seam_gap = clip.seam_gap;
    record.speed_mps = clip.speed_mps;
    record.encoding = output::encoding_name(clip.encoding);
    record.row_scheme = output::row_scheme_name(clip.row_scheme);
    record.error = error_of(view, clip);
    return record;
}

// `listed` where it lies between the clips' figures, else the nearest that does.
float between_clips(float listed, const std::vector<recipe::ClipRecord>& clips,
                    float recipe::ErrorRecord::*figure, double slack) {
    const auto [least, most] = std::minmax_element(
        clips.begin(), clips.end(),
        [figure](const auto& a, const auto& b) { return a.error.*figure < b.error.*figure; });
    const auto low = static_cast<float>(static_cast<double>(least->error.*figure) / slack);
    const auto high = static_cast<float>(static_cast<double>(most->error.*figure) * slack);
    return std::clamp(listed, low, high);
}

// The animal's own error: the place of its worst clip, the first of several.
recipe::ErrorRecord pooled_error(const recipe::ErrorRecord& listed,
                                 const std::vector<recipe::ClipRecord>& clips, float radius_m) {
    constexpr double kRounding = 1.0 + 1e-5;
    const auto worst = std::max_element(
        clips.begin(), clips.end(), [](const auto& a, const auto& b) { return a.error.max < b.error.max; });
    recipe::ErrorRecord pooled = worst->error;
    pooled.clip = worst->name;
    for (const recipe::ClipRecord& clip : clips)
        pooled.normal_max_deg = std::max(pooled.normal_max_deg, clip.error.normal_max_deg);
    using Error = recipe::ErrorRecord;
    pooled.p999 = between_clips(listed.p999, clips, &Error::p999, kBinWidth);
    pooled.rms = between_clips(listed.rms, clips, &Error::rms, kRounding);
    pooled.normal_p999_deg = between_clips(listed.normal_p999_deg, clips, &Error::normal_p999_deg, kBinWidth);
    pooled.normal_rms_deg = between_clips(listed.normal_rms_deg, clips, &Error::normal_rms_deg, kRounding);
    pooled.p999_m = metres(pooled.p999, radius_m);
    pooled.rms_m = metres(pooled.rms, radius_m);
    return pooled;
}

// The digest of the model in the recipe that the container holds; `fallback` where it holds none.
std::string model_digest(const posepack_view& view, const std::string& fallback) {
    const void* data = nullptr;
    std::size_t size = 0;
    if (posepack_get_section(&view, POSEPACK_SECTION_PROV, &data, &size) != POSEPACK_OK) return fallback;
    const std::string_view text(static_cast<const char*>(data), size);
    if (base::check_json(text).fault != base::JsonFault::none) return fallback;
    const json recipe = json::parse(text, nullptr, false);
    if (!recipe.is_object()) return fallback;
    const auto digest = recipe.find("glb_sha256");
    return digest != recipe.end() && digest->is_string() ? digest->get<std::string>() : fallback;
}

void fill_states(const posepack_view& view, recipe::BakeRecord& record) {
    record.states.clear();
    record.default_state.clear();
    std::uint32_t count = 0;
    std::uint32_t default_state = POSEPACK_NONE;
    if (posepack_count_states(&view, &count, &default_state) != POSEPACK_OK) return;
    for (std::uint32_t s = 0; s < count; ++s) {
        posepack_state state;
        posepack_clip clip;
        if (posepack_get_state(&view, s, &state) != POSEPACK_OK ||
            posepack_get_clip(&view, state.clip, &clip) != POSEPACK_OK)
            continue;
        record.states.push_back({text_of(state.name), text_of(clip.name)});
        if (s == default_state) record.default_state = record.states.back().name;
    }
}

// Bytes of the texels that hold rows, without fill.
std::uint64_t texel_bytes_of(const posepack_view& view) {
    const posepack_header& header = view.header;
    const std::uint64_t texel_bytes = header.texel_format == POSEPACK_TEXEL_RGBA32F ? 16 : 8;
    if (header.row_scheme != POSEPACK_ROWS_RUNS)
        return texel_bytes * header.texels_per_bone * header.bone_count * header.row_count;
    std::uint64_t texels = 0;
    for (std::uint32_t bone = 0; bone < header.bone_count; ++bone) {
        posepack_run run;  // the texels of the last clip end where those of all do
        if (posepack_get_run(&view, header.clip_count - 1, bone, &run) == POSEPACK_OK)
            texels = std::max<std::uint64_t>(
                texels, run.texel + (std::uint64_t{run.interval_count} + 1) * run.texel_step);
    }
    return texels * texel_bytes;
}

void fill_clips(const posepack_view& view, recipe::BakeRecord& record) {
    const std::vector<recipe::ClipRecord> listed = std::move(record.clips);
    record.clips.clear();
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        posepack_clip clip;
        if (posepack_get_clip(&view, c, &clip) == POSEPACK_OK) record.clips.push_back(clip_of(view, clip));
    }
    // What else was tried, the container cannot say.
    for (std::size_t c = 0; c < std::min(listed.size(), record.clips.size()); ++c)
        record.clips[c].tried = listed[c].tried;
}

void fill_layout(const posepack_view& view, recipe::BakeRecord& record) {
    const posepack_header& header = view.header;
    record.encoding = output::encoding_name(header.encoding);
    record.texel_format = output::texel_format_name(header.texel_format);
    record.texel_order = output::texel_order_name(header.texel_order);
    record.bone_count = header.bone_count;
    record.row_count = header.row_count;
    record.texture_width = header.texture_width_texels;
    record.texture_height = header.texture_height_texels;
    record.row_scheme = output::row_scheme_name(header.row_scheme);
    record.texel_bytes = texel_bytes_of(view);
    record.row_table_bytes = 0;
    for (const std::uint32_t type : {POSEPACK_SECTION_RUNS, POSEPACK_SECTION_SLOT}) {
        const void* data = nullptr;
        std::size_t size = 0;
        if (posepack_get_section(&view, type, &data, &size) == POSEPACK_OK) record.row_table_bytes += size;
    }
    record.radius_m = header.radius_m;
    posepack_space space;
    if (posepack_get_space(&view, &space) != POSEPACK_OK) return;
    std::uint64_t vertices = 0;
    for (std::uint32_t m = 0; m < space.mesh_count; ++m) {
        posepack_mesh mesh;
        if (posepack_get_mesh(&view, m, &mesh) == POSEPACK_OK) vertices += mesh.vertex_count;
    }
    record.vertex_count = static_cast<std::uint32_t>(vertices);
}

// The record as the container would have it; what it cannot answer is taken from `listed`.
recipe::BakeRecord record_of(const recipe::BakeRecord& listed, std::span<const std::uint8_t> bytes,
                             const posepack_view& view) {
    recipe::BakeRecord record = listed;
    record.container_bytes = bytes.size();
    record.container_sha256 = base::hexadecimal(base::sha256(bytes));
    record.recipe_sha256 = base::hexadecimal(view.header.recipe_sha256);
    record.model_sha256 = model_digest(view, listed.model_sha256);
    fill_layout(view, record);
    fill_clips(view, record);
    fill_states(view, record);
    const bool measured = std::all_of(record.clips.begin(), record.clips.end(),
                                      [](const recipe::ClipRecord& clip) { return clip.error.measured; });
    record.error = measured && !record.clips.empty()
                       ? pooled_error(listed.error, record.clips, record.radius_m)
                       : recipe::ErrorRecord{};
    record.reduction.max_m = metres(record.reduction.max, record.radius_m);
    record.reduction.rms_m = metres(record.reduction.rms, record.radius_m);
    if (record.has_vram) record.vram = vram_of(record.row_count, record.bone_count, record.vertex_count);
    return record;
}

// As the manifest writes it, so that every field of the record is compared, those to come too.
json as_json(const recipe::BakeRecord& record, std::uint32_t bake_abi) {
    recipe::Manifest manifest;
    manifest.bake_abi = bake_abi;
    manifest.records.push_back(record);
    const json whole = json::parse(write_manifest(manifest));
    json fields = whole.at("records").at(0);
    fields["bake_abi"] = whole.at("bake_abi");
    return fields;
}

std::string shown(const json& whole, const json::json_pointer& field) {
    if (!whole.contains(field)) return "nothing";
    const json& value = whole.at(field);
    if (value.is_structured()) return fmt::format("an {}", value.type_name());
    return base::shortened(value.dump(-1, ' ', false, json::error_handler_t::replace), kShownBytes);
}

}  // namespace

std::vector<Issue> check_record(const recipe::BakeRecord& listed, std::uint32_t bake_abi,
                                std::span<const std::uint8_t> bytes, const posepack_view& view) {
    const json manifest = as_json(listed, bake_abi);
    const json container = as_json(record_of(listed, bytes, view), view.header.bake_abi);
    std::vector<Issue> issues;
    for (const json& change : json::diff(manifest, container)) {
        const auto path = change.at("path").get<std::string>();
        const std::string end =
            path.ends_with("/-") ? path.substr(0, path.size() - 2) : path;  // beyond an array
        const json::json_pointer field(end);
        issues.push_back({IssueCode::man_field, listed.container + ": " + end.substr(1),
                          fmt::format("expected {} as in the container, found {} in the manifest",
                                      shown(container, field), shown(manifest, field))});
    }
    return issues;
}

}  // namespace posepack::bake
