// SPDX-License-Identifier: MIT
// Draws a herd: a depth map of the sun, the picture with several samples a pixel, and their average.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/herd_scene.hpp"
#include "render/mesh_buffers.hpp"
#include "render/palette_texture.hpp"

namespace posepack::render {

struct PictureOptions {
    int width = 1600;
    int height = 900;
    int samples_a_side = 3;
    float time_s = 1.0f;
};

// One kind of animal and everybody of it: a palette, a mesh, a buffer of instances.
struct AnimalCrowd {
    std::unique_ptr<PaletteTexture> palette;
    MeshBuffers mesh;
    Buffer instances;
    int instance_count = 0;
};

// Uploads the actors of a crowd. Throws RenderError where the files do not fit each other.
AnimalCrowd upload_crowd(const Crowd& crowd, const std::vector<std::uint8_t>& glb,
                         std::vector<std::uint8_t> container);

struct Picture {
    std::vector<std::uint8_t> rgb;  // lowest line first
    int draw_calls = 0;             // for animals, in the picture itself
};

Picture draw_herd(const HerdScene& scene, const std::vector<AnimalCrowd>& crowds,
                  const PictureOptions& options);

}  // namespace posepack::render
