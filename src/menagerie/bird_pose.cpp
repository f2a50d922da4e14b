// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include <array>

#include "menagerie/bird.hpp"

namespace posepack::menagerie {
namespace {

namespace channel = bird_channel;
using Values = std::vector<double>;

double value(const Values& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

Quat& turn_of(Pose& pose, int joint) {
    return pose.turns[static_cast<std::size_t>(joint)];
}

void pose_trunk(const Bird& animal, const Values& v, Pose& pose) {
    const BirdJoints& j = animal.joints;
    const Vec3 way(value(v, channel::body_x), value(v, channel::body_y), value(v, channel::body_z));
    pose.shifts[static_cast<std::size_t>(j.body)] = way * animal.shape.hip_height;
    turn_of(pose, j.body) = roll(value(v, channel::body_roll)) * yaw(value(v, channel::body_yaw)) *
                            pitch(value(v, channel::body_pitch));
    const std::array<double, 3> shares = {0.45, 0.30, 0.25};
    for (std::size_t index = 0; index < j.neck.size(); ++index) {
        turn_of(pose, j.neck[index]) = yaw(value(v, channel::neck_yaw) * shares[index]) *
                                       pitch(value(v, channel::neck_pitch) * shares[index]);
    }
    turn_of(pose, j.head) = roll(value(v, channel::head_roll)) * yaw(value(v, channel::head_yaw)) *
                            pitch(value(v, channel::head_pitch));
    turn_of(pose, j.beak) = pitch(value(v, channel::beak));
    pose.scales[static_cast<std::size_t>(j.breast)] = Vec3(1.0 + value(v, channel::puff));
    for (const int joint : j.tail) {
        turn_of(pose, joint) =
            yaw(value(v, channel::tail_yaw) * 0.5) * pitch(value(v, channel::tail_pitch) * 0.5);
    }
    for (int side = 0; side < 2; ++side) {
        turn_of(pose, j.fan + side) = yaw(value(v, channel::tail_fan) * (side == 0 ? -1.0 : 1.0));
    }
}

// The joints of a left wing, as turns in the chest's frame.
struct WingTurns {
    Quat arm, forearm, hand, tertials, secondaries, primaries;
};

WingTurns spread_wing(const Values& v) {
    const double bend = value(v, channel::flap_bend);
    const double sweep = value(v, channel::wing_sweep);
    WingTurns turns;
    turns.arm = roll(value(v, channel::flap)) * yaw(sweep * 0.4) * pitch(value(v, channel::wing_tilt));
    turns.forearm = turns.arm * roll(bend * 0.5);
    turns.hand = turns.forearm * roll(bend * 0.5) * yaw(sweep * 0.6);
    turns.tertials = turns.arm;
    turns.secondaries = turns.forearm;
    turns.primaries = turns.hand * roll(bend * 0.25);
    return turns;
}

// Folded against the body's side: arm back, forearm forward, hand back, all feathers to the tail.
WingTurns folded_wing(const BirdShape& shape) {
    const auto laid = [&shape](const Vec3& rest, const Vec3& way, const Vec3& outside) {
        const Quat body = pitch(-shape.body_rise_degrees);  // ways below are along a level body
        return turn_of_frames(rest, kAxisY, body * way, body * outside);
    };
    WingTurns turns;
    turns.arm = laid({0.24, 0.0, -0.03}, {0.52, -0.20, -0.83}, {0.80, 0.33, 0.50});
    turns.forearm = laid({0.26, 0.0, 0.09}, {0.02, 0.08, 0.99}, {0.88, 0.46, 0.0});
    turns.hand = laid({0.16, 0.0, -0.05}, {-0.05, -0.20, -0.98}, {0.93, 0.36, -0.08});
    turns.tertials = laid({0.0, 0.0, -1.0}, {-0.10, 0.02, -0.99}, {0.62, 0.78, -0.05});
    turns.secondaries = laid({0.0, 0.0, -1.0}, {-0.16, -0.12, -0.98}, {0.86, 0.48, -0.15});
    turns.primaries = laid({0.80, 0.0, -0.60}, {-0.16, -0.10, -0.98}, {0.90, 0.42, -0.10});
    return turns;
}

void pose_wings(const Bird& animal, const Values& v, Pose& pose) {
    const BirdJoints& j = animal.joints;
    const WingTurns open = spread_wing(v);
    const WingTurns folded = folded_wing(animal.shape);
    const double share = 1.0 - value(v, channel::wing_open);
    const Quat arm = blended(open.arm, folded.arm, share);
    const Quat forearm = blended(open.forearm, folded.forearm, share);
    const Quat hand = blended(open.hand, folded.hand, share);
    const Quat tertials = blended(open.tertials, folded.tertials, share);
    const Quat secondaries = blended(open.secondaries, folded.secondaries, share);
    const Quat primaries = blended(open.primaries, folded.primaries, share);
    const auto set = [&pose](int joint, const Quat& turn) {
        turn_of(pose, joint) = turn;
        turn_of(pose, joint + 1) = mirrored(turn);
    };
    set(j.upper_arm, arm);
    set(j.forearm, glm::conjugate(arm) * forearm);
    set(j.hand, glm::conjugate(forearm) * hand);
    set(j.tertials, glm::conjugate(arm) * tertials);
    set(j.secondaries, glm::conjugate(forearm) * secondaries);
    set(j.primaries, glm::conjugate(hand) * primaries);
}

void pose_foot(const Bird& animal, const ClipScript& script, double phase, const Values& v, int side,
               Pose& pose) {
    const BirdJoints& j = animal.joints;
    const Leg leg = side == 0 ? j.leg : other_leg(j.leg);
    const int first = channel::foot_x + 4 * side;
    FootStep step;
    Vec3 way(value(v, first), value(v, first + 1), value(v, first + 2));
    if (script.gait) {
        step = foot_step(*script.gait, phase + script.gait->offsets[static_cast<std::size_t>(side)]);
        way += Vec3(0.0, step.height * script.gait->lift, step.forward * script.gait->stroke);
    }
    const Placement placed = place(animal.rig, pose);
    const auto body = static_cast<std::size_t>(j.body);
    const Vec3 rest = animal.rig.joints[static_cast<std::size_t>(leg.foot)].head;
    const Vec3 told = rest + way * animal.shape.hip_height;
    const Vec3 carried = placed.heads[body] + placed.turns[body] * (told - animal.rig.joints[body].head);
    const double follow = value(v, channel::follow);
    const Quat turn = blended(kNoTurn, placed.turns[body], follow);
    const double fold = 4.0 * step.swing * (1.0 - step.swing);
    LegGoal goal;
    goal.ankle = told * (1.0 - follow) + carried * follow;
    goal.cannon_turn = turn * pitch(fold * 18.0 - way.z * 16.0);
    goal.foot_turn = turn * pitch(value(v, first + 3) + step.height * 40.0);
    pose_leg(animal.rig, placed, leg, goal, pose);
    turn_of(pose, j.hind_toe + side) = pitch(-0.5 * value(v, first + 3) - fold * 20.0);
}

}  // namespace

Pose bird_pose(const Bird& animal, const ClipScript& script, double phase) {
    const Values values = channel_values(script, channel::count, phase);
    Pose pose = rest_pose(animal.rig);
    pose_trunk(animal, values, pose);
    pose_wings(animal, values, pose);
    for (int side = 0; side < 2; ++side) pose_foot(animal, script, phase, values, side, pose);
    return pose;
}

Model bird_model(const BirdShape& shape, const ExportStyle& style, int rate_hz) {
    const Bird animal = bird_of(shape);
    const auto pose = [&animal](const ClipScript& script, double phase) {
        return bird_pose(animal, script, phase);
    };
    std::vector<Clip> clips = perform(bird_scripts(shape), rate_hz, shape.hip_height, pose);
    Model model{shape.name, animal.rig, bird_mesh(animal), std::move(clips), style};
    name_clips(model);
    return model;
}

}  // namespace posepack::menagerie
