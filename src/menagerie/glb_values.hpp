// SPDX-License-Identifier: MIT
// Numbers, vectors and joint transforms as glTF writes them.
#pragma once

#include "menagerie/glb_buffer.hpp"
#include "menagerie/model.hpp"

namespace posepack::menagerie {

// Nodes: the armature, the skinned mesh, then the joints in their order.
inline constexpr int kArmatureNode = 0;
inline constexpr int kMeshNode = 1;
inline constexpr int kFirstJointNode = 2;

// The shortest decimal number that reads back as the float nearest to `value`; never a negative zero.
Json number(double value);
Json vector_json(const Vec3& v);
Json quaternion_json(const Quat& q);  // x, y, z, w

void put_vector(Payload& payload, const Vec3& v);
void put_quaternion(Payload& payload, const Quat& q);

// The rotation of the armature's node.
Quat armature_turn(const ExportStyle& style);

// A joint's transform in its parent's bone axes, as glTF wants it.
struct Local {
    Vec3 translation{};
    Quat rotation = kNoTurn;
};

// The local transform of a joint that is turned and shifted, in model axes, away from its rest pose.
Local local_of(const Model& model, std::size_t index, const Quat& turn, const Vec3& shift);

}  // namespace posepack::menagerie
