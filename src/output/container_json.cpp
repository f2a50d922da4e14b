// SPDX-License-Identifier: MIT
#include "output/container_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/sha256.hpp"
#include "base/text.hpp"

namespace posepack::output {
namespace {

using nlohmann::json;

std::string text_of(const posepack_string& string) {
    return {string.data, string.size_bytes};
}

json number(float value) {
    return base::widened(value);
}

json index_or_null(std::uint32_t index) {
    return index == POSEPACK_NONE ? json(nullptr) : json(index);
}

template <std::size_t N>
json numbers(const float (&values)[N]) {
    json array = json::array();
    for (const float value : values) array.push_back(number(value));
    return array;
}

// A fraction of R in metres, as the manifest has it.
json metres(float fraction, float radius_m) {
    return number(static_cast<float>(static_cast<double>(fraction) * static_cast<double>(radius_m)));
}

json error_json(const posepack_clip_error& error, float radius_m) {
    return {{"max", number(error.max)},
            {"p999", number(error.p999)},
            {"rms", number(error.rms)},
            {"max_m", metres(error.max, radius_m)},
            {"p999_m", metres(error.p999, radius_m)},
            {"rms_m", metres(error.rms, radius_m)},
            {"time_s", number(error.time_s)},
            {"mesh", index_or_null(error.mesh)},
            {"vertex", index_or_null(error.vertex)},
            {"bone", index_or_null(error.bone)},
            {"normal_max_deg", number(error.normal_max_deg)},
            {"normal_p999_deg", number(error.normal_p999_deg)},
            {"normal_rms_deg", number(error.normal_rms_deg)},
            {"normal_time_s", number(error.normal_time_s)},
            {"normal_mesh", index_or_null(error.normal_mesh)},
            {"normal_vertex", index_or_null(error.normal_vertex)},
            {"normal_bone", index_or_null(error.normal_bone)}};
}

json clip_json(const posepack_clip& clip, float radius_m) {
    json out{{"name", text_of(clip.name)},
             {"source_name", text_of(clip.source_name)},
             {"closing_row", clip.closing_row},
             {"encoding", encoding_name(clip.encoding)},
             {"wrap", wrap_name(clip.wrap)},
             {"seam", seam_name(clip.seam)},
             {"interpolation", clip.interpolation == POSEPACK_INTERPOLATION_STEP ? "step" : "linear"},
             {"first_row", clip.first_row},
             {"row_count", clip.row_count},
             {"row_scheme", row_scheme_name(clip.row_scheme)},
             {"rate_hz", number(clip.rate_hz)},
             {"period_s", number(clip.period_s)},
             {"start_s", number(clip.start_s)},
             {"speed_mps", number(clip.speed_mps)},
             {"stride_phase", number(clip.stride_phase)},
             {"seam_gap", number(clip.seam_gap)},
             {"box_min", numbers(clip.box_min)},
             {"box_max", numbers(clip.box_max)},
             {"sphere_center", numbers(clip.sphere_center)},
             {"sphere_radius", number(clip.sphere_radius)}};
    out["error"] = clip.measured ? error_json(clip.error, radius_m) : json(nullptr);
    return out;
}

json clips_of(const posepack_view& view) {
    json clips = json::array();
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        posepack_clip clip;
        if (posepack_get_clip(&view, c, &clip) == POSEPACK_OK)
            clips.push_back(clip_json(clip, view.header.radius_m));
    }
    return clips;
}

json states_of(const posepack_view& view) {
    std::uint32_t count = 0;
    std::uint32_t default_state = POSEPACK_NONE;
    json states = json::array();
    if (posepack_count_states(&view, &count, &default_state) != POSEPACK_OK) return states;
    for (std::uint32_t s = 0; s < count; ++s) {
        posepack_state state;
        posepack_clip clip;
        if (posepack_get_state(&view, s, &state) != POSEPACK_OK) continue;
        if (posepack_get_clip(&view, state.clip, &clip) != POSEPACK_OK) continue;
        states.push_back(
            {{"name", text_of(state.name)}, {"clip", text_of(clip.name)}, {"default", s == default_state}});
    }
    return states;
}

json bones_of(const posepack_view& view) {
    json bones = json::array();
    for (std::uint32_t b = 0; b < view.header.bone_count; ++b) {
        posepack_bone bone;
        if (posepack_get_bone(&view, b, &bone) != POSEPACK_OK) continue;
        bones.push_back({{"name", text_of(bone.name)},
                         {"parent", index_or_null(bone.parent)},
                         {"node", bone.node},
                         {"weighted", (bone.flags & POSEPACK_BONE_FLAG_WEIGHTED) != 0}});
    }
    return bones;
}

json meshes_of(const posepack_view& view, std::uint32_t mesh_count) {
    json meshes = json::array();
    for (std::uint32_t m = 0; m < mesh_count; ++m) {
        posepack_mesh mesh;
        if (posepack_get_mesh(&view, m, &mesh) != POSEPACK_OK) continue;
        json joints = json::array();
        for (std::uint32_t j = 0; j < mesh.joint_count; ++j) {
            std::uint32_t bone = POSEPACK_NONE;
            static_cast<void>(posepack_map_joint(&view, m, j, &bone));
            joints.push_back(index_or_null(bone));
        }
        meshes.push_back({{"name", text_of(mesh.name)},
                          {"node", mesh.node},
                          {"mesh", mesh.mesh},
                          {"skin", index_or_null(mesh.skin)},
                          {"vertex_count", mesh.vertex_count},
                          {"bone_of_joint", joints},
                          {"palette_from_mesh", numbers(mesh.palette_from_mesh)}});
    }
    return meshes;
}

json space_of(const posepack_view& view) {
    static constexpr const char* kAxes[] = {"+z", "-z", "+x", "-x"};
    posepack_space space;
    if (posepack_get_space(&view, &space) != POSEPACK_OK) return nullptr;
    return {{"model_from_palette", numbers(space.model_from_palette)},
            {"forward", space.forward_axis < 4 ? kAxes[space.forward_axis] : "?"},
            {"metres_per_unit", number(space.metres_per_unit)},
            {"meshes", meshes_of(view, space.mesh_count)}};
}

json sections_of(const posepack_view& view) {
    json sections = json::array();
    for (std::uint32_t s = 0; s < view.header.section_count; ++s) {
        const posepack_section& section = view.sections[s];
        std::string type;
        for (int i = 0; i < 4; ++i) type += static_cast<char>(section.type >> (8 * i) & 0xFF);
        sections.push_back({{"type", type},
                            {"offset", section.offset},
                            {"bytes", section.stored_bytes},
                            {"crc32c", fmt::format("{:08x}", section.crc)}});
    }
    return sections;
}

}  // namespace

std::string container_json(const posepack_view& view, int indent) {
    const posepack_header& header = view.header;
    const json out{{"schema", "posepack-inspect-1"},
                   {"format", fmt::format("{}.{}", header.major, header.minor)},
                   {"file_bytes", header.file_bytes},
                   {"bone_count", header.bone_count},
                   {"row_count", header.row_count},
                   {"clip_count", header.clip_count},
                   {"encoding", encoding_name(header.encoding)},
                   {"texel_format", texel_format_name(header.texel_format)},
                   {"texels_per_bone", header.texels_per_bone},
                   {"texel_order", texel_order_name(header.texel_order)},
                   {"row_scheme", row_scheme_name(header.row_scheme)},
                   {"texture_width", header.texture_width_texels},
                   {"texture_height", header.texture_height_texels},
                   {"row_pitch_bytes", header.row_pitch_bytes},
                   {"rows_per_line", header.rows_per_line},
                   {"radius_m", number(header.radius_m)},
                   {"bake_abi", header.bake_abi},
                   {"recipe_sha256", base::hexadecimal(header.recipe_sha256)},
                   {"clips", clips_of(view)},
                   {"states", states_of(view)},
                   {"bones", bones_of(view)},
                   {"space", space_of(view)},
                   {"sections", sections_of(view)}};
    return out.dump(indent);
}

std::string clips_json(const posepack_view& view) {
    return clips_of(view).dump();
}
std::string states_json(const posepack_view& view) {
    return states_of(view).dump();
}
std::string bones_json(const posepack_view& view) {
    return bones_of(view).dump();
}
std::string space_json(const posepack_view& view) {
    return space_of(view).dump();
}

std::uint32_t joints_without_bone(const posepack_view& view) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> joints;  // meshes of one skin have the same
    posepack_mesh mesh;
    for (std::uint32_t m = 0; posepack_get_mesh(&view, m, &mesh) == POSEPACK_OK; ++m)
        for (std::uint32_t j = 0; j < mesh.joint_count; ++j) {
            std::uint32_t bone = 0;
            if (posepack_map_joint(&view, m, j, &bone) == POSEPACK_ERROR_NOT_FOUND)
                joints.insert({mesh.skin == POSEPACK_NONE ? ~m : mesh.skin, j});
        }
    return static_cast<std::uint32_t>(joints.size());
}

std::string row_scheme_name(std::uint32_t row_scheme) {
    switch (row_scheme) {
        case POSEPACK_ROWS_UNIFORM:
            return "uniform";
        case POSEPACK_ROWS_SLOTS:
            return "slots";
        case POSEPACK_ROWS_RUNS:
            return "runs";
        default:
            return fmt::format("row scheme {}", row_scheme);
    }
}

std::string encoding_name(std::uint32_t encoding) {
    switch (encoding) {
        case POSEPACK_MIXED:
            return "mixed";
        case POSEPACK_ENCODING_MAT4:
            return "mat4";
        case POSEPACK_ENCODING_AFFINE:
            return "affine";
        case POSEPACK_ENCODING_DUALQUAT:
            return "dualquat";
        default:
            return fmt::format("encoding {}", encoding);
    }
}

std::string texel_format_name(std::uint32_t format) {
    switch (format) {
        case POSEPACK_TEXEL_RGBA16F:
            return "rgba16f";
        case POSEPACK_TEXEL_RGBA32F:
            return "rgba32f";
        default:
            return fmt::format("format {}", format);
    }
}

std::string texel_order_name(std::uint32_t order) {
    return order == POSEPACK_ORDER_PLANAR ? "planar" : "bone-major";
}

std::string wrap_name(std::uint32_t wrap) {
    switch (wrap) {
        case POSEPACK_WRAP_LOOP:
            return "loop";
        case POSEPACK_WRAP_ONCE:
            return "once";
        default:
            return "ping-pong";
    }
}

std::string seam_name(std::uint32_t seam) {
    return seam == POSEPACK_SEAM_OPEN ? "open" : "closed";
}

}  // namespace posepack::output
