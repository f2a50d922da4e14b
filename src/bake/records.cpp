// SPDX-License-Identifier: MIT
#include "bake/records.hpp"

#include "posepack/format.h"
#include "vat/vram.hpp"

namespace posepack::bake {
namespace {

recipe::ErrorRecord error_record(const palette::ClipError& error, const animal::Animal& animal,
                                 const palette::Palette& palette) {
    recipe::ErrorRecord record;
    record.measured = true;
    record.max = error.max;
    record.p999 = error.p999;
    record.rms = error.rms;
    // From the radius as the header has it, so that a reader of the container finds the same metres.
    const double radius_m = static_cast<float>(palette.radius * palette.metres_per_unit);
    record.max_m = static_cast<float>(static_cast<double>(error.max) * radius_m);
    record.p999_m = static_cast<float>(static_cast<double>(error.p999) * radius_m);
    record.rms_m = static_cast<float>(static_cast<double>(error.rms) * radius_m);
    record.normal_max_deg = error.normal_max_deg;
    record.normal_p999_deg = error.normal_p999_deg;
    record.normal_rms_deg = error.normal_rms_deg;
    record.time_s = error.time_s;
    record.vertex = error.vertex;
    if (error.mesh != animal::kNone) record.mesh = animal.meshes[error.mesh].name;
    if (error.bone != animal::kNone) record.bone = animal.bones[error.bone].name;
    return record;
}

// One encoding, or "mixed" where clips differ.
std::string_view runs_encoding(std::uint8_t encoding) {
    if (encoding == POSEPACK_MIXED) return "mixed";
    return recipe::name_of(encoding == POSEPACK_ENCODING_DUALQUAT ? recipe::Encoding::dualquat
                                                                  : recipe::Encoding::affine);
}

// Bytes of RUNS and SLOT.
std::uint64_t row_table_bytes(const palette::Palette& palette) {
    std::uint64_t bytes = palette.has_slots() ? POSEPACK_SLOT_HEAD_BYTES * palette.clips.size() : 0;
    for (const palette::PaletteClip& clip : palette.clips)
        bytes += POSEPACK_RUN_BYTES * clip.runs.entries.size() + POSEPACK_SLOT_BYTES * clip.runs.slots.size();
    return bytes;
}

}  // namespace

recipe::BakeRecord describe(const recipe::AnimalEntry& entry, const animal::Animal& animal,
                            const palette::Palette& palette, const measure::ErrorStats* stats) {
    recipe::BakeRecord record;
    record.id = entry.id;
    record.container = entry.id + ".posepack";
    record.model = entry.model;
    record.encoding =
        palette.has_runs() ? runs_encoding(palette.layout.encoding) : recipe::name_of(entry.output.encoding);
    record.row_scheme = palette.has_runs() ? "runs" : "uniform";
    record.texel_format =
        name_of(palette.layout.texel_format == POSEPACK_TEXEL_RGBA32F ? recipe::TexelFormat::rgba32f
                                                                      : recipe::TexelFormat::rgba16f);
    record.texel_order = name_of(entry.output.texel_order);
    record.bone_count = palette.layout.bone_count;
    record.row_count = palette.layout.row_count;
    for (const animal::Mesh& mesh : animal.meshes) record.vertex_count += mesh.vertex_count;
    record.texture_width = palette.layout.texture_width;
    record.texture_height = palette.layout.texture_height;
    record.texel_bytes = palette.layout.texel_payload_bytes();
    record.row_table_bytes = row_table_bytes(palette);
    record.radius_m = static_cast<float>(palette.radius * palette.metres_per_unit);
    for (std::size_t c = 0; c < palette.clips.size(); ++c) {
        const palette::PaletteClip& clip = palette.clips[c];
        recipe::ClipRecord out;
        out.name = animal.clips[clip.source].name;
        out.source_name = animal.clips[clip.source].source_name;
        out.first_row = clip.first_row;
        const bool has_runs = !clip.runs.is_empty();
        out.row_count = has_runs ? clip.stored_rows() : clip.plan.row_count;
        out.rate_hz = static_cast<float>(has_runs ? clip.runs_rate_hz() : clip.plan.rate_hz);
        out.period_s = clip.plan.row_count == 1 ? 0.0f : static_cast<float>(clip.plan.period_s);
        out.start_s = static_cast<float>(animal.clips[clip.source].start_s);
        out.wrap = name_of(clip.plan.wrap);
        out.seam = name_of(clip.plan.seam);
        out.interpolation = clip.plan.step ? "step" : "linear";
        out.seam_gap = static_cast<float>(clip.plan.seam_gap);
        out.speed_mps = static_cast<float>(clip.speed_mps);
        out.encoding = has_runs ? runs_encoding(clip.runs.encoding) : name_of(entry.output.encoding);
        out.row_scheme = !has_runs ? "uniform" : clip.runs.slots.empty() ? "runs" : "slots";
        if (stats != nullptr) out.error = error_record(stats->clips[c], animal, palette);
        record.clips.push_back(std::move(out));
    }
    for (const palette::PaletteState& state : palette.states)
        record.states.push_back({state.name, record.clips[state.clip].name});
    if (palette.default_state != animal::kNone)
        record.default_state = palette.states[palette.default_state].name;
    if (stats != nullptr && !record.clips.empty()) {
        record.error = error_record(stats->pooled, animal, palette);
        record.error.clip = record.clips[stats->worst_clip].name;
    }
    return record;
}

std::vector<recipe::TryRecord> tried(const std::vector<choose::Attempt>& attempts) {
    std::vector<recipe::TryRecord> out;
    out.reserve(attempts.size());
    for (const choose::Attempt& one : attempts)
        out.push_back({std::string(runs_encoding(one.encoding)), one.has_slots ? "slots" : "runs", one.bytes,
                       one.max, one.p999, one.rms, one.keeps_bound});
    return out;
}

recipe::VramRecord vram_of(std::uint64_t row_count, std::uint64_t bone_count, std::uint64_t vertex_count) {
    const auto bytes = [&](std::size_t form) {
        return vat::texture_bytes(vat::kForms[form], row_count, bone_count, vertex_count);
    };
    return {bytes(0), bytes(1), bytes(2), bytes(3), bytes(4), bytes(5), bytes(6), bytes(7)};
}

}  // namespace posepack::bake
