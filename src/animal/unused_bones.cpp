// SPDX-License-Identifier: MIT
#include "animal/unused_bones.hpp"

#include <algorithm>

namespace posepack::animal {
namespace {

// The new index of each bone; kNone where it goes.
std::vector<std::uint32_t> new_indices(const std::vector<Bone>& bones) {
    std::vector<std::uint32_t> out;
    std::uint32_t next = 0;
    out.reserve(bones.size());
    for (const Bone& bone : bones) out.push_back(bone.weighted ? next++ : kNone);
    return out;
}

std::uint32_t kept_ancestor(const std::vector<Bone>& bones, std::uint32_t bone) {
    std::uint32_t parent = bones[bone].parent;
    while (parent != kNone && !bones[parent].weighted) parent = bones[parent].parent;
    return parent;
}

}  // namespace

void drop_unused_bones(Animal& animal) {
    const std::vector<std::uint32_t> index = new_indices(animal.bones);
    std::vector<std::uint32_t> parents(animal.bones.size(), kNone);
    for (std::uint32_t b = 0; b < animal.bones.size(); ++b)
        if (const std::uint32_t parent = kept_ancestor(animal.bones, b); parent != kNone)
            parents[b] = index[parent];
    for (std::uint32_t b = 0; b < animal.bones.size(); ++b) animal.bones[b].parent = parents[b];
    std::erase_if(animal.bones, [](const Bone& bone) { return !bone.weighted; });
    for (std::uint16_t& bone : animal.joint_map)
        bone = index[bone] == kNone ? kNoBone : static_cast<std::uint16_t>(index[bone]);
    // Influences without weight may name anything; they name bone 0 here, as everywhere.
    for (InfluenceBones& bones : animal.vertices.bones)
        for (std::uint16_t& bone : bones)
            bone = index[bone] == kNone ? std::uint16_t{0} : static_cast<std::uint16_t>(index[bone]);
    for (std::uint16_t& bone : animal.reduced.bones) bone = static_cast<std::uint16_t>(index[bone]);
}

}  // namespace posepack::animal
