// SPDX-License-Identifier: MIT
// The skinned mesh of a GLB that posepack's own generator wrote, ready for drawing.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace posepack::render {

struct MeshVertex {
    glm::vec3 position{};
    glm::vec3 normal{};
    glm::vec3 colour{};             // linear, 0..1
    std::array<float, 4> joints{};  // values of JOINTS_0, later bones of a palette
    std::array<float, 4> weights{};
};

struct SkinnedMesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;  // triangles
};

// Reads the first mesh, all primitives: POSITION, NORMAL, COLOR_0, JOINTS_0, WEIGHTS_0 and indices (glTF 2.0,
// section 3.7.2). Throws RenderError where one is missing, sparse, or outside the BIN chunk.
SkinnedMesh read_skinned_mesh(std::span<const std::uint8_t> glb);

}  // namespace posepack::render
