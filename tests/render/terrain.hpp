// SPDX-License-Identifier: MIT
// The meadow: a height for every place, and a mesh of it. X is right, Z towards the camera, metres.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace posepack::render {

struct GroundVertex {
    glm::vec3 position{};
    glm::vec3 normal{};
    float trodden = 0.0f;  // 0 grass .. 1 path
};

struct GroundMesh {
    std::vector<GroundVertex> vertices;
    std::vector<std::uint32_t> indices;
};

// Height of the ground at (x, z): nearly flat close to the camera, hills at the horizon.
float ground_height(float x, float z);

// Place on the path that the herd follows, `along` 0 (far) .. 1 (near).
glm::vec2 path_place(float along);

// How bare the ground is: 0 grass .. 1 path.
float trodden_at(glm::vec2 place);

// Smooth noise of a place, 0..1, with features about one unit wide.
float smooth_noise(glm::vec2 place);

// Fine near the camera, coarse at the horizon.
GroundMesh make_ground();

}  // namespace posepack::render
