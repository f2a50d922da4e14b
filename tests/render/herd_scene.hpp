// SPDX-License-Identifier: MIT
// Who stands where in the picture.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace posepack::render {

// One animal of a crowd: everything the vertex shader needs beside the palette.
struct Instance {
    glm::vec3 position{};
    float heading = 0.0f;  // radians about +Y; 0 looks along +Z
    float scale = 1.0f;
    float clip = 0.0f;     // index in the palette
    float rate = 1.0f;     // speed of play
    float bank = 0.0f;     // radians about the direction of travel
    glm::vec3 tint{1.0f};  // multiplies the colours of the mesh
};

// An instance that still names its clip.
struct Actor {
    std::string clip;
    Instance instance;
};

struct Crowd {
    std::string animal;  // id in the menagerie
    std::vector<Actor> actors;
};

// A thing that does not move: grass, a tree.
struct Prop {
    glm::vec3 position{};
    float heading = 0.0f;
    float scale = 1.0f;
    glm::vec3 tint{1.0f};
};

struct HerdScene {
    std::vector<Crowd> crowds;
    std::vector<Prop> tufts, flowers, trees;
};

// The same scene on every call.
HerdScene compose_herd();

}  // namespace posepack::render
