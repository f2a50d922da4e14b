// SPDX-License-Identifier: MIT
// A manifest that uses every field.
#pragma once

#include <string>

#include "recipe/manifest.hpp"

namespace posepack::recipe {

inline ErrorRecord sample_error(std::string clip) {
    ErrorRecord error;
    error.measured = true;
    error.max = 1.234e-4f;
    error.p999 = 1e-4f;
    error.rms = 3e-5f;
    error.max_m = 2.5e-4f;
    error.p999_m = 2e-4f;
    error.rms_m = 6e-5f;
    error.normal_max_deg = 0.7f;
    error.normal_p999_deg = 0.5f;
    error.normal_rms_deg = 0.1f;
    error.clip = std::move(clip);
    error.time_s = 0.3333333f;
    error.mesh = "Body";
    error.vertex = 4'294'967'295u;
    error.bone = "Leg \"left\"";
    return error;
}

inline ClipRecord sample_clip(std::string name, std::string wrap, std::uint32_t first_row) {
    ClipRecord clip;
    clip.source_name = "Armature|" + name;
    clip.name = std::move(name);
    clip.first_row = first_row;
    clip.row_count = 24;
    clip.rate_hz = 23.976f;
    clip.period_s = 1.001f;
    clip.start_s = 0.0416f;
    clip.wrap = std::move(wrap);
    clip.seam = "closed";
    clip.interpolation = "linear";
    clip.seam_gap = 1e-7f;
    clip.speed_mps = 1.4f;
    clip.encoding = "affine";
    clip.row_scheme = "slots";
    clip.tried = {{"affine", "runs", 240, 0.03f, 0.01f, 0.002f, false},
                  {"affine", "slots", 480, 0.01f, 0.004f, 0.001f, true}};
    return clip;
}

inline BakeRecord sample_record(const std::string& id) {
    BakeRecord record;
    record.id = id;
    record.container = id + ".posepack";
    record.container_bytes = 1ull << 40;
    record.container_sha256 = std::string(64, 'a');
    record.model = "herd/" + id + ".glb";
    record.model_bytes = 123;
    record.model_sha256 = std::string(64, '0');
    record.recipe_sha256 = std::string(64, '9');
    record.encoding = "affine";
    record.row_scheme = "runs";
    record.texel_format = "rgba16f";
    record.texel_order = "bone-major";
    record.bone_count = 53;
    record.row_count = 48;
    record.vertex_count = 2500;
    record.texture_width = 159;
    record.texture_height = 48;
    record.texel_bytes = 61'056;
    record.row_table_bytes = 424;
    record.radius_m = 0.1f;
    return record;
}

inline ReductionRecord sample_reduction() {
    ReductionRecord reduction;
    reduction.measured = true;
    reduction.vertex_count = 31;
    reduction.influences_most = 7;
    reduction.max = 2.5e-3f;
    reduction.rms = 1.25e-4f;
    reduction.max_m = 2.5e-4f;
    reduction.rms_m = 1.25e-5f;
    reduction.clip = "Walk";
    reduction.time_s = 0.75f;
    reduction.mesh = "Body";
    reduction.vertex = 412;
    return reduction;
}

inline Manifest sample_manifest() {
    BakeRecord deer = sample_record("deer");
    deer.clips = {sample_clip("Walk", "loop", 0), sample_clip("D\xC3\xA4mmern", "ping-pong", 24)};
    deer.clips[0].error = sample_error("");
    deer.states = {{"idle", "D\xC3\xA4mmern"}, {"wander", "Walk"}};
    deer.default_state = "idle";
    deer.error = sample_error("Walk");
    deer.reduction = sample_reduction();
    deer.has_vram = true;
    deer.vram = {1, 2, 3, 4, 8, 5, 6, 7};
    deer.remarks = {"warning[W-CLIP-RATE]: Walk: baked at 30 Hz"};
    return {
        3,
        "0.1.0",
        std::string(64, 'f'),
        R"({"encoding":"affine","influences":8,"only":["deer","fox"],"rate_hz":23.976,"strict":true,"unused_bones":"drop"})",
        {deer, sample_record("fox")}};
}

}  // namespace posepack::recipe
