// SPDX-License-Identifier: MIT
// Legs of four joints by inverse kinematics: upper, lower, cannon (the metatarsus of a bird) and foot. The
// foot and the cannon are told where to be; the upper two meet them by the law of cosines.
#pragma once

#include "menagerie/rig.hpp"

namespace posepack::menagerie {

struct Leg {
    int upper = 0;
    int lower = 0;
    int cannon = 0;
    int foot = 0;
    int target = -1;  // the joint that an artist would drag; -1: none
};

// The right leg of a left one, whose joints were added in pairs.
Leg other_leg(const Leg& left);

struct LegGoal {
    Vec3 ankle{};                // head of the foot joint, in the model's space
    Quat cannon_turn = kNoTurn;  // away from the rest pose, in the model's space
    Quat foot_turn = kNoTurn;
};

// Sets the turns of a leg's joints, and the target's shift, so that the foot is where the goal says. A goal
// out of reach is met as nearly as the leg is long. `placed` is the placement of everything above the leg.
void pose_leg(const Rig& rig, const Placement& placed, const Leg& leg, const LegGoal& goal, Pose& pose);

}  // namespace posepack::menagerie
