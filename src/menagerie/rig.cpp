// SPDX-License-Identifier: MIT
#include "menagerie/rig.hpp"

namespace posepack::menagerie {

int add_joint(Rig& rig, std::string_view name, int parent, const Vec3& head, const Vec3& tail) {
    const int index = static_cast<int>(rig.joints.size());
    rig.joints.push_back({std::string(name), parent, index, head, turn_between(kAxisY, tail - head)});
    return index;
}

int add_joint_pair(Rig& rig, std::string_view name, int parent, const Vec3& head, const Vec3& tail) {
    const int right_parent = parent < 0 ? -1 : rig.joints[static_cast<std::size_t>(parent)].mirror;
    const int left = add_joint(rig, std::string(name) + ".L", parent, head, tail);
    const int right = add_joint(rig, std::string(name) + ".R", right_parent, mirrored(head), mirrored(tail));
    rig.joints[static_cast<std::size_t>(left)].mirror = right;
    rig.joints[static_cast<std::size_t>(right)].mirror = left;
    return left;
}

int find_joint(const Rig& rig, std::string_view name) {
    for (std::size_t index = 0; index < rig.joints.size(); ++index) {
        if (rig.joints[index].name == name) return static_cast<int>(index);
    }
    return -1;
}

Pose rest_pose(const Rig& rig) {
    const std::size_t count = rig.joints.size();
    return {std::vector<Quat>(count, kNoTurn), std::vector<Vec3>(count, Vec3(0.0)),
            std::vector<Vec3>(count, Vec3(1.0))};
}

Placement place(const Rig& rig, const Pose& pose) {
    Placement placed;
    placed.heads.reserve(rig.joints.size());
    placed.turns.reserve(rig.joints.size());
    for (std::size_t index = 0; index < rig.joints.size(); ++index) {
        const RigJoint& joint = rig.joints[index];
        if (joint.parent < 0) {
            placed.heads.push_back(joint.head + pose.shifts[index]);
            placed.turns.push_back(pose.turns[index]);
            continue;
        }
        const auto parent = static_cast<std::size_t>(joint.parent);
        const Vec3 offset = joint.head - rig.joints[parent].head + pose.shifts[index];
        placed.heads.push_back(placed.heads[parent] + placed.turns[parent] * offset);
        placed.turns.push_back(placed.turns[parent] * pose.turns[index]);
    }
    return placed;
}

}  // namespace posepack::menagerie
