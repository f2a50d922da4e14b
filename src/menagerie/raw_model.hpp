// SPDX-License-Identifier: MIT
// A skinned, animated model in glTF's own terms, as plain lists: nothing is derived, nothing is mended, and
// key times lie where they are put. For models that are hard on purpose, where model.hpp is for animals.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "menagerie/math.hpp"
#include "menagerie/model.hpp"

namespace posepack::menagerie {

// A node with its rest pose. Parents stand before children; every number is finite.
struct RawNode {
    std::string name;
    int parent = -1;
    Vec3 translation{0.0};
    Quat rotation = kNoTurn;
    Vec3 scale{1.0};
};

enum class RawPath { translation, rotation, scale };

// The keys of one property of a node. Values as in glTF: 3 numbers a key, 4 (x y z w) for rotations, three
// times as many for cubic splines. They may be anything that a float can be.
struct RawChannel {
    int node = 0;
    RawPath path = RawPath::rotation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times_s;
    std::vector<float> values;
};

struct RawClip {
    std::string name;
    std::vector<RawChannel> channels;
};

// One mesh under one skin, whose joints are all nodes in their order.
struct RawModel {
    std::string name;
    std::vector<RawNode> nodes;
    std::vector<std::array<float, 16>> inverse_binds;  // one a node, column by column
    std::vector<float> positions, normals;             // 3 a vertex
    std::vector<std::uint16_t> joints;                 // 4 a vertex
    std::vector<float> weights;                        // 4 a vertex
    std::vector<RawClip> clips;
};

// Sets the inverse binds to the inverses of the nodes' global transforms at rest, so that the mesh binds
// where it lies. Scales must not be zero.
void bind_at_rest(RawModel& model);

// The bytes of the GLB: the same on every host.
std::vector<std::uint8_t> write_glb(const RawModel& model);

}  // namespace posepack::menagerie
