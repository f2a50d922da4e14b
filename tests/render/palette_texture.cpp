// SPDX-License-Identifier: MIT
#include "render/palette_texture.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "render/error.hpp"

namespace posepack::render {
PaletteTexture::PaletteTexture(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {
    const posepack_result result = posepack_open(&view_, bytes_.data(), bytes_.size());
    require(result == POSEPACK_OK,
            fmt::format("the loader refuses the container: {}", posepack_result_name(result)));
    read_spaces();
    upload_texels();
    upload_clips();
}

void PaletteTexture::read_spaces() {
    require(posepack_get_space(&view_, &space_) == POSEPACK_OK && space_.mesh_count > 0 &&
                posepack_get_mesh(&view_, 0, &mesh_) == POSEPACK_OK,
            "expected a container with a mesh");
}

void PaletteTexture::upload_texels() {
    posepack_texels texels{};
    posepack_get_texels(&view_, &texels);
    const bool is_half = texels.format == POSEPACK_TEXEL_RGBA16F;
    const auto texel_bytes = is_half ? 8u : 16u;
    glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(texels.row_pitch_bytes / texel_bytes));
    texels_ = make_texture(is_half ? GL_RGBA16F : GL_RGBA32F, static_cast<int>(texels.width_texels),
                           static_cast<int>(texels.height_texels), GL_RGBA,
                           is_half ? GL_HALF_FLOAT : GL_FLOAT, texels.data);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    check_gl("the upload of a palette");
}

// One texel a clip: first row, row count, period, and wrap + 4 where rows are held + 8 with a closing row.
void PaletteTexture::upload_clips() {
    std::vector<std::array<float, 4>> table;
    for (std::uint32_t index = 0; index < view_.header.clip_count; ++index) {
        const posepack_clip c = clip(index);
        require(c.cut_count == 0, "expected clips without cuts");
        const int mode =
            c.wrap + (c.interpolation == POSEPACK_INTERPOLATION_STEP ? 4 : 0) + (c.closing_row ? 8 : 0);
        table.push_back({static_cast<float>(c.first_row), static_cast<float>(c.row_count), c.period_s,
                         static_cast<float>(mode)});
    }
    clips_ = make_texture(GL_RGBA32F, static_cast<int>(table.size()), 1, GL_RGBA, GL_FLOAT, table.data());
}

posepack_clip PaletteTexture::clip(std::uint32_t index) const {
    posepack_clip found{};
    require(posepack_get_clip(&view_, index, &found) == POSEPACK_OK,
            fmt::format("expected a clip {}", index));
    return found;
}

std::uint32_t PaletteTexture::find_clip(const std::string& name) const {
    std::uint32_t index = 0;
    require(posepack_find_clip(&view_, name.c_str(), &index) == POSEPACK_OK,
            fmt::format("expected a clip \"{}\" in the palette", name));
    return index;
}

void PaletteTexture::bind(const Program& program) const {
    const posepack_header& h = view_.header;
    program.set_texture("palette", 0, texels_.name());
    program.set_texture("clip_table", 1, clips_.name());
    program.set("palette_encoding", static_cast<int>(h.encoding));
    program.set("bone_step",
                h.texel_order == POSEPACK_ORDER_PLANAR ? 1 : static_cast<int>(h.texels_per_bone));
    program.set("texel_step", h.texel_order == POSEPACK_ORDER_PLANAR ? static_cast<int>(h.bone_count) : 1);
    program.set("row_texels", static_cast<int>(h.bone_count * h.texels_per_bone));
    program.set("dualquat_length", h.dualquat_length);
    program.set_rows("model_from_palette", space_.model_from_palette);
    program.set("rows_per_line", static_cast<int>(h.rows_per_line));
}

void PaletteTexture::enter_palette(SkinnedMesh& mesh) const {
    const float* m = mesh_.palette_from_mesh;
    for (MeshVertex& vertex : mesh.vertices) {
        const glm::vec3 p = vertex.position;
        const glm::vec3 n = vertex.normal;
        for (int r = 0; r < 3; ++r) {
            const float* row = m + 4 * r;
            vertex.position[r] = row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
            // model_from_palette takes the scale back: both are similarities here.
            vertex.normal[r] = row[0] * n.x + row[1] * n.y + row[2] * n.z;
        }
        for (float& joint : vertex.joints) {
            std::uint32_t bone = 0;
            require(
                posepack_map_joint(&view_, 0, static_cast<std::uint32_t>(joint), &bone) == POSEPACK_OK,
                fmt::format("expected joint {} in the container: it was baked from another model", joint));
            joint = static_cast<float>(bone);
        }
    }
}

}  // namespace posepack::render
