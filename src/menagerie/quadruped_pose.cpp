// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

#include "menagerie/quadruped.hpp"

namespace posepack::menagerie {
namespace {

namespace channel = quadruped_channel;
using Values = std::vector<double>;

constexpr double kDegreesPerRadian = 57.29577951308232;

double value(const Values& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

// Spreads a turn over a chain of joints, with these shares.
template <std::size_t N>
void bend(Pose& pose, const std::vector<int>& chain, const std::array<double, N>& shares,
          double pitch_degrees, double yaw_degrees) {
    for (std::size_t index = 0; index < chain.size(); ++index) {
        const double share = shares[std::min(index, N - 1)];
        pose.turns[static_cast<std::size_t>(chain[index])] =
            yaw(yaw_degrees * share) * pitch(pitch_degrees * share);
    }
}

void pose_trunk(const Quadruped& animal, const Values& v, Pose& pose) {
    const QuadrupedJoints& j = animal.joints;
    const auto body = static_cast<std::size_t>(j.body);
    const Vec3 way(value(v, channel::body_x), value(v, channel::body_y), value(v, channel::body_z));
    pose.shifts[body] = way * animal.shape.hip_height;
    pose.turns[body] = roll(value(v, channel::body_roll)) * yaw(value(v, channel::body_yaw)) *
                       pitch(value(v, channel::body_pitch));
    if (const double squash = value(v, channel::squash); squash != 0.0) {
        // The bone of the body lies nearly level: its own X is across and its own Z is up and down.
        const double height = 1.0 - squash;
        pose.scales[body] = {1.0 + squash * 0.5, 1.0 + squash * 0.25, height};
        pose.shifts[body].y += animal.rig.joints[body].head.y * (height - 1.0);
    }
    bend<3>(pose, j.spine, {0.35, 0.35, 0.30}, value(v, channel::spine_pitch), value(v, channel::spine_yaw));
    bend<3>(pose, j.neck, {0.55, 0.27, 0.18}, value(v, channel::neck_pitch), value(v, channel::neck_yaw));
}

void pose_head(const Quadruped& animal, const Values& v, Pose& pose) {
    const QuadrupedJoints& j = animal.joints;
    pose.turns[static_cast<std::size_t>(j.head)] = roll(value(v, channel::head_roll)) *
                                                   yaw(value(v, channel::head_yaw)) *
                                                   pitch(value(v, channel::head_pitch));
    pose.turns[static_cast<std::size_t>(j.jaw)] = pitch(value(v, channel::jaw));
    if (j.beard >= 0) pose.turns[static_cast<std::size_t>(j.beard)] = pitch(value(v, channel::beard));
    for (const int joint : j.trunk) {
        pose.turns[static_cast<std::size_t>(joint)] =
            pitch(value(v, channel::trunk_curl) / static_cast<double>(j.trunk.size()));
    }
    for (int side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        const double flick = value(v, channel::ear_flick_left + side);
        const double lift = sign * value(v, channel::ear_pitch);
        pose.turns[static_cast<std::size_t>(j.ear[0] + side)] = roll(lift * 0.7) * yaw(sign * flick * 0.6);
        pose.turns[static_cast<std::size_t>(j.ear[1] + side)] = roll(lift * 0.3) * yaw(sign * flick * 0.4);
    }
}

void pose_tail(const Quadruped& animal, const Values& v, Pose& pose) {
    // The root turns most.
    const double count = static_cast<double>(animal.joints.tail.size());
    double share = 2.0 / (count + 1.0);
    for (const int joint : animal.joints.tail) {
        // The tail points backwards: lifting it is a turn the other way round than the neck's.
        pose.turns[static_cast<std::size_t>(joint)] =
            yaw(value(v, channel::tail_yaw) * share) * pitch(value(v, channel::tail_pitch) * share);
        share -= 2.0 / (count * (count + 1.0));
    }
}

// What the gait adds to a foot's channels.
struct GaitOffset {
    Vec3 way{};  // parts of the hip's height
    double foot_pitch = 0.0;
    double cannon_pitch = 0.0;
};

// A thick foot has no room to tip in: `foot_height` is that of the shape.
GaitOffset gait_offset(const ClipScript& script, double phase, int foot_index, double foot_height) {
    if (!script.gait) return {};
    const Gait& gait = *script.gait;
    const FootStep step = foot_step(gait, phase + gait.offsets[static_cast<std::size_t>(foot_index)]);
    const bool front = foot_index < 2;
    // The joints close most in the first half of the swing.
    const double fold = 4.0 * step.swing * (1.0 - step.swing) * (1.35 - 0.7 * step.swing);
    return {{0.0, step.height * gait.lift, step.forward * gait.stroke},
            step.height * 55.0 / (foot_height * foot_height),
            fold * (front ? 55.0 : 22.0) * std::min(1.0, gait.lift * 8.0)};
}

void pose_foot(const Quadruped& animal, const ClipScript& script, double phase, const Values& v,
               int foot_index, Pose& pose) {
    const QuadrupedJoints& j = animal.joints;
    const bool front = foot_index < 2;
    const int side = foot_index % 2;
    const int first = channel::foot_x + 5 * foot_index;
    const GaitOffset step = gait_offset(script, phase, foot_index, animal.shape.foot_height);
    const Vec3 told(value(v, first), value(v, first + 1), value(v, first + 2));
    const Vec3 way = (told + step.way) * animal.shape.hip_height;

    // The girdle swings with the foot and lengthens the stride.
    const int blade = (front ? j.front_blade : j.back_blade) + side;
    const double lean = -(told.z + step.way.z) * kDegreesPerRadian;
    pose.turns[static_cast<std::size_t>(blade)] = pitch(lean * (front ? 0.30 : 0.12));

    if (front) {
        const double lift = value(v, channel::shoulder_lift) * animal.shape.hip_height;
        pose.shifts[static_cast<std::size_t>(blade)] = kAxisY * lift;
    }

    const Leg leg = side == 0 ? (front ? j.front : j.back) : other_leg(front ? j.front : j.back);
    const Placement placed = place(animal.rig, pose);
    const auto girdle = static_cast<std::size_t>(front ? j.spine.back() : j.body);
    const Vec3 rest = animal.rig.joints[static_cast<std::size_t>(leg.foot)].head;
    const Vec3 carried =
        placed.heads[girdle] + placed.turns[girdle] * (rest + way - animal.rig.joints[girdle].head);
    const double follow = value(v, front ? channel::front_follow : channel::back_follow);
    const Quat turn = blended(kNoTurn, placed.turns[girdle], follow);

    LegGoal goal;
    goal.ankle = (rest + way) * (1.0 - follow) + carried * follow;
    goal.cannon_turn = turn * pitch(value(v, first + 4) + step.cannon_pitch + lean * 0.45);
    goal.foot_turn = turn * pitch(value(v, first + 3) + step.foot_pitch);
    pose_leg(animal.rig, placed, leg, goal, pose);
}

}  // namespace

Pose quadruped_pose(const Quadruped& animal, const ClipScript& script, double phase) {
    const Values values = channel_values(script, channel::count, phase);
    Pose pose = rest_pose(animal.rig);
    pose_trunk(animal, values, pose);
    pose_head(animal, values, pose);
    pose_tail(animal, values, pose);
    for (int foot_index = 0; foot_index < 4; ++foot_index) {
        pose_foot(animal, script, phase, values, foot_index, pose);
    }
    return pose;
}

Model quadruped_model(const QuadrupedShape& shape, const ExportStyle& style, int rate_hz) {
    const Quadruped animal = quadruped_of(shape);
    const auto pose = [&animal](const ClipScript& script, double phase) {
        return quadruped_pose(animal, script, phase);
    };
    std::vector<Clip> clips = perform(quadruped_scripts(shape), rate_hz, shape.hip_height, pose);
    Model model{shape.name, animal.rig, quadruped_mesh(animal), std::move(clips), style};
    name_clips(model);
    return model;
}

}  // namespace posepack::menagerie
