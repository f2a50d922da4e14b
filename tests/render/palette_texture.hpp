// SPDX-License-Identifier: MIT
// A container on the GPU: its texels and its clips, opened by the shipped loader.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "posepack/loader.h"
#include "render/gl_objects.hpp"
#include "render/glb_mesh.hpp"

namespace posepack::render {

class PaletteTexture {
 public:
    // Opens the container and uploads it. Throws RenderError for bytes that the loader refuses and for
    // clips with cuts, which shaders/palette.glsl does not read.
    explicit PaletteTexture(std::vector<std::uint8_t> bytes);

    const posepack_view& view() const { return view_; }
    const posepack_space& space() const { return space_; }
    posepack_clip clip(std::uint32_t index) const;
    std::uint32_t find_clip(const std::string& name) const;

    // Sets the uniforms of shaders/palette.glsl in the program in use; takes texture units 0 and 1.
    void bind(const Program& program) const;

    // Moves the mesh into palette space, and turns its joints into bones of this palette.
    void enter_palette(SkinnedMesh& mesh) const;

 private:
    void read_spaces();
    void upload_texels();
    void upload_clips();

    std::vector<std::uint8_t> bytes_;
    posepack_view view_{};
    posepack_space space_{};
    posepack_mesh mesh_{};
    Texture texels_;
    Texture clips_;
};

}  // namespace posepack::render
