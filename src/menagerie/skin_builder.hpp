// SPDX-License-Identifier: MIT
// What the skin of every body plan is built with.
#pragma once

#include "menagerie/loft.hpp"
#include "menagerie/mesh.hpp"

namespace posepack::menagerie {

// A mesh under construction over an animal's measures and joints. Plan: a struct with shape, joints and rig.
template <typename Plan>
struct SkinBuilder {
    const Plan& animal;
    Mesh mesh;

    const auto& shape() const { return animal.shape; }
    const auto& joints() const { return animal.joints; }
    const Vec3& head_of(int joint) const { return animal.rig.joints[static_cast<std::size_t>(joint)].head; }
};

}  // namespace posepack::menagerie
