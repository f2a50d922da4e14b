// SPDX-License-Identifier: MIT
// What the channels of an animation aim at.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "animal/animal.hpp"
#include "animal/gltf_facts.hpp"
#include "animal/tinygltf.hpp"

namespace posepack::animal {

// A node, what of it moves, and the sampler; indices are as the file has them, below 0 where it has none.
struct Aim {
    int node = -1, sampler = -1;
    Path path = Path::translation;
};

// "translation", "rotation" or "scale"; nothing for all else.
std::optional<Path> path_of(std::string_view name);

// "/nodes/3/rotation" of KHR_animation_pointer; nothing for every other pointer.
std::optional<Aim> aim_of(const PointerChannel& channel);

// The nodes that some channel of some animation moves, node by node.
std::vector<bool> animated_nodes(const tinygltf::Model& model, const GltfFacts& facts);

}  // namespace posepack::animal
