// SPDX-License-Identifier: MIT
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "recipe/manifest.hpp"

namespace posepack::recipe {
namespace {

using Json = nlohmann::json;

Json number(float value) {
    assert(std::isfinite(value));
    return base::widened(value);
}

Json error_json(const ErrorRecord& error, bool names_clip) {
    if (!error.measured) return nullptr;
    Json json{{"bone", error.bone},
              {"max", number(error.max)},
              {"max_m", number(error.max_m)},
              {"mesh", error.mesh},
              {"normal_max_deg", number(error.normal_max_deg)},
              {"normal_p999_deg", number(error.normal_p999_deg)},
              {"normal_rms_deg", number(error.normal_rms_deg)},
              {"p999", number(error.p999)},
              {"p999_m", number(error.p999_m)},
              {"rms", number(error.rms)},
              {"rms_m", number(error.rms_m)},
              {"time_s", number(error.time_s)},
              {"vertex", error.vertex}};
    if (names_clip) json["clip"] = error.clip;
    return json;
}

Json reduction_json(const ReductionRecord& reduction) {
    if (!reduction.measured) return nullptr;
    return {{"clip", reduction.clip},           {"influences_most", reduction.influences_most},
            {"max", number(reduction.max)},     {"max_m", number(reduction.max_m)},
            {"mesh", reduction.mesh},           {"rms", number(reduction.rms)},
            {"rms_m", number(reduction.rms_m)}, {"time_s", number(reduction.time_s)},
            {"vertex", reduction.vertex},       {"vertex_count", reduction.vertex_count}};
}

Json tried_json(const std::vector<TryRecord>& tried) {
    Json list = Json::array();
    for (const TryRecord& one : tried)
        list.push_back({{"bytes", one.bytes},
                        {"encoding", one.encoding},
                        {"keeps_bound", one.keeps_bound},
                        {"max", number(one.max)},
                        {"p999", number(one.p999)},
                        {"rms", number(one.rms)},
                        {"row_scheme", one.row_scheme}});
    return list;
}

Json clip_json(const ClipRecord& clip) {
    return {{"encoding", clip.encoding},
            {"error", error_json(clip.error, false)},
            {"first_row", clip.first_row},
            {"interpolation", clip.interpolation},
            {"name", clip.name},
            {"period_s", number(clip.period_s)},
            {"rate_hz", number(clip.rate_hz)},
            {"row_count", clip.row_count},
            {"row_scheme", clip.row_scheme},
            {"seam", clip.seam},
            {"seam_gap", number(clip.seam_gap)},
            {"source_name", clip.source_name},
            {"speed_mps", number(clip.speed_mps)},
            {"start_s", number(clip.start_s)},
            {"tried", tried_json(clip.tried)},
            {"wrap", clip.wrap}};
}

Json vram_json(const BakeRecord& record) {
    if (!record.has_vram) return nullptr;
    const VramRecord& vram = record.vram;
    return {{"affine_rgba16f", vram.affine_rgba16f},     {"affine_rgba32f", vram.affine_rgba32f},
            {"dualquat_rgba16f", vram.dualquat_rgba16f}, {"mat4_rgba16f", vram.mat4_rgba16f},
            {"mat4_rgba32f", vram.mat4_rgba32f},         {"vat_position_rgb32f", vram.vat_position_rgb32f},
            {"vat_rgba16f", vram.vat_rgba16f},           {"vat_rgba32f", vram.vat_rgba32f}};
}

Json record_json(const BakeRecord& record) {
    Json clips = Json::array();
    for (const ClipRecord& clip : record.clips) clips.push_back(clip_json(clip));
    Json states = Json::array();
    for (const StateRecord& state : record.states) {
        states.push_back({{"clip", state.clip}, {"name", state.name}});
    }
    return {{"bone_count", record.bone_count},
            {"clips", std::move(clips)},
            {"container", record.container},
            {"container_bytes", record.container_bytes},
            {"container_sha256", record.container_sha256},
            {"default_state", record.default_state},
            {"encoding", record.encoding},
            {"error", error_json(record.error, true)},
            {"id", record.id},
            {"model", record.model},
            {"model_bytes", record.model_bytes},
            {"model_sha256", record.model_sha256},
            {"radius_m", number(record.radius_m)},
            {"recipe_sha256", record.recipe_sha256},
            {"reduction", reduction_json(record.reduction)},
            {"remarks", record.remarks},
            {"row_count", record.row_count},
            {"row_scheme", record.row_scheme},
            {"row_table_bytes", record.row_table_bytes},
            {"states", std::move(states)},
            {"texel_bytes", record.texel_bytes},
            {"texel_format", record.texel_format},
            {"texel_order", record.texel_order},
            {"texture_height", record.texture_height},
            {"texture_width", record.texture_width},
            {"vertex_count", record.vertex_count},
            {"vram", vram_json(record)}};
}

Json options_json(const std::string& text) {
    if (text.empty()) return Json::object();
    Json options = Json::parse(text, nullptr, false);
    assert(options.is_object());
    return options;
}

}  // namespace

std::string write_manifest(const Manifest& manifest) {
    Json records = Json::array();
    for (const BakeRecord& record : manifest.records) records.push_back(record_json(record));
    const Json json{{"bake_abi", manifest.bake_abi},
                    {"catalog_sha256", manifest.catalog_sha256},
                    {"options", options_json(manifest.options_json)},
                    {"records", std::move(records)},
                    {"schema", kManifestSchema},
                    {"tool_version", manifest.tool_version}};
    // Names come from checked inputs; should one slip through with malformed UTF-8, dump() must not throw.
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace posepack::recipe
