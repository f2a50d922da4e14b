// SPDX-License-Identifier: MIT
#include "menagerie/fish.hpp"

#include <fmt/format.h>

namespace posepack::menagerie {
namespace {

namespace channel = fish_channel;
using Values = std::vector<double>;

double value(const Values& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

// Places along the body: `along` 0 at the snout, 1 at the root of the tail fin.
Vec3 station(const FishShape& s, double along, double above = 0.0) {
    return {0.0, s.swim_height + above, s.length * (0.45 - along)};
}

void add_axis(Fish& animal) {
    const FishShape& s = animal.shape;
    FishJoints& j = animal.joints;
    Rig& rig = animal.rig;
    j.root = add_joint(rig, "Root", -1, station(s, 0.45, -s.swim_height), station(s, 0.45));
    j.body = add_joint(rig, "Body", j.root, station(s, 0.38), station(s, 0.24));
    j.head = add_joint(rig, "Head", j.body, station(s, 0.24), station(s, 0.0));
    add_joint(rig, "Head_end", j.head, station(s, 0.0), station(s, -0.05));
    j.jaw = add_joint(rig, "Jaw", j.head, station(s, 0.12, -0.18 * s.body_depth),
                      station(s, 0.01, -0.18 * s.body_depth));
    const Vec3 gill = station(s, 0.16, -0.05 * s.body_depth) + kAxisX * (s.body_radius * 0.8);
    j.gill = add_joint_pair(rig, "Gill", j.head, gill, gill - kAxisZ * 0.02);
    const Vec3 eye = station(s, 0.075, 0.22 * s.body_depth) + kAxisX * (s.body_radius * 0.58);
    j.eye = add_joint_pair(rig, "Eye", j.head, eye, eye + kAxisX * 0.01);
    int parent = j.body;
    for (int index = 0; index < s.spine_joints; ++index) {
        const double step = 0.58 / s.spine_joints;
        const double along = 0.42 + step * index;
        parent = add_joint(rig, fmt::format("Spine{}", index + 1), parent, station(s, along),
                           station(s, along + step));
        j.spine.push_back(parent);
    }
}

void add_fins(Fish& animal) {
    const FishShape& s = animal.shape;
    FishJoints& j = animal.joints;
    Rig& rig = animal.rig;
    const double step = s.tail_fin_length / s.length;
    j.tail_fin = add_joint(rig, "TailFin", j.spine.back(), station(s, 1.0), station(s, 1.0 + step * 0.4));
    for (const double side : {1.0, -1.0}) {
        const Vec3 root = station(s, 1.0 + step * 0.3, side * s.tail_depth);
        const Vec3 tip = station(s, 1.0 + step, side * s.tail_fin_spread);
        const int joint = add_joint(rig, side > 0.0 ? "TailUpper" : "TailLower", j.tail_fin, root, tip);
        (side > 0.0 ? j.tail_upper : j.tail_lower) = joint;
        add_joint(rig, side > 0.0 ? "TailUpper_end" : "TailLower_end", joint, tip, tip + (tip - root) * 0.3);
    }
    const auto spine = [&j](double share) {
        return j.spine[static_cast<std::size_t>(share * static_cast<double>(j.spine.size()))];
    };
    const Vec3 dorsal = station(s, 0.44, s.body_depth * 0.9);
    const Vec3 middle = dorsal + Vec3(0.0, s.dorsal_height * 0.5, -s.dorsal_length * 0.35);
    j.dorsal.push_back(add_joint(rig, "Dorsal1", spine(0.1), dorsal, middle));
    j.dorsal.push_back(add_joint(rig, "Dorsal2", j.dorsal.front(), middle,
                                 middle + Vec3(0.0, s.dorsal_height * 0.5, -s.dorsal_length * 0.4)));
    const Vec3 adipose = station(s, 0.80, s.body_depth * 0.44);
    j.adipose =
        add_joint(rig, "Adipose", spine(0.7), adipose, adipose + Vec3(0.0, 0.4, -0.5) * s.dorsal_height);
    const Vec3 anal = station(s, 0.74, -s.body_depth * 0.52);
    j.anal = add_joint(rig, "Anal", spine(0.6), anal, anal + Vec3(0.0, -0.7, -0.7) * s.dorsal_height);
    const Vec3 pectoral = station(s, 0.235, -s.body_depth * 0.42) + kAxisX * (s.body_radius * 0.82);
    const Vec3 way = Vec3(0.62, -0.30, -0.72) * s.pectoral_length;
    j.pectoral.push_back(add_joint_pair(rig, "Pectoral1", j.body, pectoral, pectoral + way * 0.5));
    j.pectoral.push_back(
        add_joint_pair(rig, "Pectoral2", j.pectoral.front(), pectoral + way * 0.5, pectoral + way));
    const Vec3 pelvic = station(s, 0.52, -s.body_depth * 0.82) + kAxisX * (s.body_radius * 0.40);
    j.pelvic = add_joint_pair(rig, "Pelvic", spine(0.2), pelvic,
                              pelvic + Vec3(0.35, -0.55, -0.75) * s.pelvic_length);
}

void pose_axis(const Fish& animal, const Values& v, Pose& pose) {
    const FishJoints& j = animal.joints;
    const auto turn = [&pose](int joint) -> Quat& { return pose.turns[static_cast<std::size_t>(joint)]; };
    const Vec3 way(value(v, channel::body_x), value(v, channel::body_y), value(v, channel::body_z));
    pose.shifts[static_cast<std::size_t>(j.body)] = way * animal.shape.length;
    turn(j.body) = roll(value(v, channel::body_roll)) * yaw(value(v, channel::body_yaw)) *
                   pitch(value(v, channel::body_pitch));
    turn(j.head) = yaw(value(v, channel::head_yaw) - 0.25 * value(v, channel::bend)) *
                   pitch(value(v, channel::head_pitch));
    turn(j.jaw) = pitch(value(v, channel::jaw));
    // Carangiform: the wave grows towards the tail and is nearly one body long.
    constexpr double kLagTurns = 0.105;
    const double count = static_cast<double>(j.spine.size());
    for (std::size_t index = 0; index <= j.spine.size(); ++index) {
        const double along = (static_cast<double>(index) + 1.0) / (count + 1.0);
        const double lag = kLagTurns * static_cast<double>(index);
        const double wave = value(v, channel::wave_sine) * cosine_of_turns(lag) -
                            value(v, channel::wave_cosine) * sine_of_turns(lag);
        const double grown = 0.25 + 0.75 * along * along;
        turn(index < j.spine.size() ? j.spine[index] : j.tail_fin) =
            yaw(wave * grown * (index < j.spine.size() ? 1.0 : 1.5) + value(v, channel::bend) / count);
    }
}

void pose_fins(const Fish& animal, const Values& v, Pose& pose) {
    const FishJoints& j = animal.joints;
    const auto turn = [&pose](int joint) -> Quat& { return pose.turns[static_cast<std::size_t>(joint)]; };
    turn(j.tail_upper) = pitch(-value(v, channel::tail_spread));
    turn(j.tail_lower) = pitch(value(v, channel::tail_spread));
    turn(j.dorsal[0]) = pitch(-value(v, channel::dorsal_fold) * 0.6);
    turn(j.dorsal[1]) = pitch(-value(v, channel::dorsal_fold) * 0.4);
    for (int side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        const double extra = value(v, side == 0 ? channel::pectoral_left : channel::pectoral_right);
        const Quat fin = yaw(-sign * value(v, channel::pectoral_spread)) *
                         roll(sign * (value(v, channel::pectoral_pitch) + extra));
        turn(j.pectoral[0] + side) = fin;
        turn(j.pectoral[1] + side) = blended(kNoTurn, fin, 0.4);
        turn(j.pelvic + side) = roll(sign * value(v, channel::pelvic_spread));
        turn(j.gill + side) = yaw(-sign * value(v, channel::gill));
    }
}

}  // namespace

Fish fish_of(const FishShape& shape) {
    Fish animal;
    animal.shape = shape;
    add_axis(animal);
    add_fins(animal);
    return animal;
}

Pose fish_pose(const Fish& animal, const ClipScript& script, double phase) {
    const Values values = channel_values(script, channel::count, phase);
    Pose pose = rest_pose(animal.rig);
    pose_axis(animal, values, pose);
    pose_fins(animal, values, pose);
    return pose;
}

Model fish_model(const FishShape& shape, const ExportStyle& style, int rate_hz) {
    const Fish animal = fish_of(shape);
    const auto pose = [&animal](const ClipScript& script, double phase) {
        return fish_pose(animal, script, phase);
    };
    std::vector<Clip> clips = perform(fish_scripts(), rate_hz, shape.length, pose);
    Model model{shape.name, animal.rig, fish_mesh(animal), std::move(clips), style};
    name_clips(model);
    return model;
}

}  // namespace posepack::menagerie
