// SPDX-License-Identifier: MIT
#include "menagerie/leg.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace posepack::menagerie {
namespace {

const RigJoint& joint_at(const Rig& rig, int index) {
    return rig.joints[static_cast<std::size_t>(index)];
}

// The knee between `hip` and `ankle` for bones of these lengths, bent about `hinge`: the way from hip to
// ankle, turned a right angle about it, points to the knee's side. Unlike a pole that pulls the knee, the
// hinge never comes near to that way, however far the leg swings.
Vec3 knee_between(const Vec3& hip, const Vec3& ankle, double upper, double lower, const Vec3& hinge) {
    const Vec3 way = ankle - hip;
    const double distance =
        std::clamp(glm::length(way), std::abs(upper - lower) * 1.001, (upper + lower) * 0.9999);
    const Vec3 along = glm::normalize(way);
    const Vec3 across = glm::normalize(glm::cross(hinge, along));
    const double foot = (upper * upper - lower * lower + distance * distance) / (2.0 * distance);
    return hip + along * foot + across * std::sqrt(std::max(upper * upper - foot * foot, 0.0));
}

}  // namespace

Leg other_leg(const Leg& left) {
    return {left.upper + 1, left.lower + 1, left.cannon + 1, left.foot + 1, left.target + 1};
}

void pose_leg(const Rig& rig, const Placement& placed, const Leg& leg, const LegGoal& goal, Pose& pose) {
    const Vec3 rest_hip = joint_at(rig, leg.upper).head;
    const Vec3 rest_knee = joint_at(rig, leg.lower).head;
    const Vec3 rest_hock = joint_at(rig, leg.cannon).head;
    const Vec3 rest_ankle = joint_at(rig, leg.foot).head;
    const Quat parent_turn = placed.turns[static_cast<std::size_t>(joint_at(rig, leg.upper).parent)];

    const Vec3 hip = placed.heads[static_cast<std::size_t>(leg.upper)];
    const Vec3 hock = goal.ankle - goal.cannon_turn * (rest_ankle - rest_hock);
    const Vec3 rest_bend = rest_knee - (rest_hip + rest_hock) * 0.5;
    const Vec3 rest_hinge = glm::cross(rest_hock - rest_hip, rest_bend);
    const Vec3 knee = knee_between(hip, hock, glm::length(rest_knee - rest_hip),
                                   glm::length(rest_hock - rest_knee), parent_turn * rest_hinge);

    const Vec3 hinge = glm::cross(hock - hip, knee - hip);
    const Quat upper = turn_of_frames(rest_knee - rest_hip, rest_hinge, knee - hip, hinge);
    const Quat lower = turn_of_frames(rest_hock - rest_knee, rest_hinge, hock - knee, hinge);

    pose.turns[static_cast<std::size_t>(leg.upper)] = glm::conjugate(parent_turn) * upper;
    pose.turns[static_cast<std::size_t>(leg.lower)] = glm::conjugate(upper) * lower;
    pose.turns[static_cast<std::size_t>(leg.cannon)] = glm::conjugate(lower) * goal.cannon_turn;
    pose.turns[static_cast<std::size_t>(leg.foot)] = glm::conjugate(goal.cannon_turn) * goal.foot_turn;
    if (leg.target >= 0) {
        const auto target = static_cast<std::size_t>(leg.target);
        pose.shifts[target] = goal.ankle - rig.joints[target].head;
    }
}

}  // namespace posepack::menagerie
