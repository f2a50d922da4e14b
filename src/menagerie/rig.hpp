// SPDX-License-Identifier: MIT
// Skeletons and their poses. Poses are authored in model axes: a joint's turn is a rotation about the axes
// of the model as they stood at rest, carried along by the joint's parents. The bone axes that a modelling
// tool would show (+Y along the bone) appear only when a model is written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "menagerie/math.hpp"

namespace posepack::menagerie {

struct RigJoint {
    std::string name;
    int parent = -1;      // index of an earlier joint; -1: directly under the armature
    int mirror = -1;      // the joint on the other side; itself when it lies in the middle
    Vec3 head{};          // where it turns, in the model's space at rest, metres
    Quat bone = kNoTurn;  // takes +Y to the bone's direction at rest
};

// Parents stand before children.
struct Rig {
    std::vector<RigJoint> joints;
};

// Appends a joint of the middle line whose bone runs from `head` to `tail`; returns its index.
int add_joint(Rig& rig, std::string_view name, int parent, const Vec3& head, const Vec3& tail);

// Appends `name`.L as given and its mirror image `name`.R; returns the index of the left one (the right one
// follows it). `parent` may be a left joint, whose mirror then carries the right one.
int add_joint_pair(Rig& rig, std::string_view name, int parent, const Vec3& head, const Vec3& tail);

// Index of the joint with this name, or -1.
int find_joint(const Rig& rig, std::string_view name);

// One key of a clip. All three have a value for each joint.
struct Pose {
    std::vector<Quat> turns;
    std::vector<Vec3> shifts;  // added to the head, in the axes of the turned parent, metres
    std::vector<Vec3> scales;  // along the bone's own axes; for joints without children only
};

Pose rest_pose(const Rig& rig);

// Where the joints of a pose are in the model's space: head positions and turns away from the rest pose.
struct Placement {
    std::vector<Vec3> heads;
    std::vector<Quat> turns;
};

Placement place(const Rig& rig, const Pose& pose);

}  // namespace posepack::menagerie
