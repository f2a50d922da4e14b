// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include <fmt/format.h>

#include "menagerie/quadruped.hpp"

namespace posepack::menagerie {
namespace {

Vec3 direction(double rise_degrees) {
    return pitch(-rise_degrees) * kAxisZ;
}

// A chain of `count` joints along a straight line; returns their numbers.
std::vector<int> add_chain(Rig& rig, std::string_view name, int count, int parent, const Vec3& start,
                           const Vec3& end) {
    std::vector<int> chain;
    const Vec3 step = (end - start) / static_cast<double>(count);
    for (int index = 0; index < count; ++index) {
        const Vec3 head = start + step * static_cast<double>(index);
        parent = add_joint(rig, fmt::format("{}{}", name, index + 1), parent, head, head + step);
        chain.push_back(parent);
    }
    return chain;
}

void add_trunk(Quadruped& animal) {
    const QuadrupedShape& s = animal.shape;
    QuadrupedJoints& j = animal.joints;
    const double back = -s.body_length / 2;
    const double spine_height = s.hip_height * 0.985;
    const Vec3 hip(0.0, spine_height, back);
    const Vec3 chest(0.0, s.shoulder_height * 0.95, back + s.body_length * 0.80);
    const Vec3 first = hip + (chest - hip) * 0.38;
    const Vec3 second = hip + (chest - hip) * 0.70;
    const Vec3 neck(0.0, s.shoulder_height * 0.97, s.body_length * 0.54);
    j.body = add_joint(animal.rig, "Body", -1, hip, first);
    j.spine.push_back(add_joint(animal.rig, "Spine1", j.body, first, second));
    j.spine.push_back(add_joint(animal.rig, "Spine2", j.spine.back(), second, chest));
    j.spine.push_back(add_joint(animal.rig, "Chest", j.spine.back(), chest, neck));
    const Vec3 poll = neck + direction(s.neck_rise_degrees) * s.neck_length;
    j.neck = add_chain(animal.rig, "Neck", 3, j.spine.back(), neck, poll);
}

void add_head(Quadruped& animal) {
    const QuadrupedShape& s = animal.shape;
    QuadrupedJoints& j = animal.joints;
    Rig& rig = animal.rig;
    const RigJoint& last_neck = rig.joints[static_cast<std::size_t>(j.neck.back())];
    const Vec3 poll = last_neck.head + direction(s.neck_rise_degrees) * (s.neck_length / 3.0);
    const Vec3 forward = direction(-s.head_drop_degrees);
    const Vec3 up = pitch(s.head_drop_degrees) * kAxisY;
    const Vec3 nose = poll + forward * s.head_length;
    j.head = add_joint(rig, "Head", j.neck.back(), poll, nose);
    add_joint(rig, "Head_end", j.head, nose, nose + forward * 0.05);
    const Vec3 hinge = poll + forward * (s.head_length * 0.22) - up * (s.head_depth * 0.75);
    const Vec3 chin = poll + forward * (s.head_length * 0.86) - up * (s.head_depth * 0.95);
    j.jaw = add_joint(rig, "Jaw", j.head, hinge, chin);
    if (s.beard_length > 0.0) {
        const Vec3 root = hinge + (chin - hinge) * 0.8;
        j.beard = add_joint(rig, "Beard", j.jaw, root, root - kAxisY * s.beard_length);
    }
    if (s.trunk_length > 0.0) {
        const Vec3 root = nose - forward * (s.head_length * 0.08) - up * (s.head_depth * 0.15);
        const Vec3 tip = root + Vec3(0.0, -0.985, 0.17) * s.trunk_length;
        j.trunk = add_chain(rig, "Trunk", 4, j.head, root, tip);
        add_joint(rig, "Trunk4_end", j.trunk.back(), tip, tip - kAxisY * 0.05);
    }
    const Vec3 eye =
        poll + forward * (s.head_length * 0.34) + up * (s.head_depth * 0.36) + kAxisX * s.head_radius;
    j.eye = add_joint_pair(rig, "Eye", j.head, eye, eye + kAxisX * 0.02);
    const Vec3 ear = poll + up * (s.head_depth * 0.55) + kAxisX * (s.head_radius * 0.72);
    const Vec3 ear_way = roll(s.ear_rise_degrees) * kAxisX * s.ear_length;
    j.ear.push_back(add_joint_pair(rig, "Ear1", j.head, ear, ear + ear_way * 0.5));
    j.ear.push_back(add_joint_pair(rig, "Ear2", j.ear.front(), ear + ear_way * 0.5, ear + ear_way));
    if (s.horns != Horns::swept_back) return;
    const Vec3 horn = poll + forward * (s.head_length * 0.12) + up * (s.head_depth * 0.85) +
                      kAxisX * (s.head_radius * 0.40);
    const Vec3 middle = horn + Vec3(0.10, 0.62, -0.30) * s.horn_length;
    j.horn.push_back(add_joint_pair(rig, "Horn1", j.head, horn, middle));
    j.horn.push_back(
        add_joint_pair(rig, "Horn2", j.horn.front(), middle, middle + Vec3(0.2, 0.1, -0.5) * s.horn_length));
}

void add_tail(Quadruped& animal) {
    const QuadrupedShape& s = animal.shape;
    const Vec3 root(0.0, s.hip_height * 0.99, -s.body_length / 2 - s.rump_radius * 1.12);
    const Vec3 way = pitch(s.tail_rise_degrees) * -kAxisZ * s.tail_length;
    animal.joints.tail = add_chain(animal.rig, "Tail", s.tail_joints, animal.joints.body, root, root + way);
    add_joint(animal.rig, fmt::format("Tail{}_end", s.tail_joints), animal.joints.tail.back(), root + way,
              root + way * 1.2);
}

// The joints of a leg at rest, from the girdle to the tip of the toe, for the left side.
struct LegLine {
    Vec3 blade, upper, lower, cannon, foot, toe, tip;
};

LegLine front_line(const QuadrupedShape& s) {
    const double h = s.shoulder_height;
    const double x = s.stance_width;
    const double z = s.body_length * 0.5;
    return {{x * 0.62, h * 0.93, z - 0.06 * h},
            {x * 1.08, h * 0.66, z + 0.075 * h},
            {x * 1.05, h * 0.525, z - 0.055 * h},
            {x, h * 0.285, z - 0.02 * h},
            {x, h * 0.095 * s.foot_height, z - 0.03 * h},
            {x, h * 0.045 * s.foot_height, z + 0.008 * h},
            {x, 0.0, z + 0.05 * h}};
}

LegLine back_line(const QuadrupedShape& s) {
    const double h = s.hip_height;
    const double x = s.stance_width;
    const double z = -s.body_length * 0.5;
    return {{x * 0.55, h * 0.93, z + 0.03 * h},
            {x * 0.98, h * 0.80, z - 0.015 * h},
            {x * 1.12, h * 0.545, z + 0.115 * h},
            {x, h * 0.345, z - 0.135 * h},
            {x, h * 0.095 * s.foot_height, z - 0.105 * h},
            {x, h * 0.045 * s.foot_height, z - 0.067 * h},
            {x, 0.0, z - 0.025 * h}};
}

Leg add_leg(Rig& rig, const std::string& end, int girdle, const LegLine& line, int& blade, int& toe) {
    Leg leg;
    blade = add_joint_pair(rig, end + "Shoulder", girdle, line.blade, line.upper);
    leg.upper = add_joint_pair(rig, end + "UpperLeg", blade, line.upper, line.lower);
    leg.lower = add_joint_pair(rig, end + "LowerLeg", leg.upper, line.lower, line.cannon);
    leg.cannon = add_joint_pair(rig, end + "Cannon", leg.lower, line.cannon, line.foot);
    leg.foot = add_joint_pair(rig, end + "Foot", leg.cannon, line.foot, line.toe);
    toe = add_joint_pair(rig, end + "Toe", leg.foot, line.toe, line.tip);
    return leg;
}

int add_target(Rig& rig, const std::string& end, const Vec3& ankle) {
    return add_joint_pair(rig, "IK" + end + "Leg", -1, ankle, ankle - kAxisZ * 0.1);
}

}  // namespace

Quadruped quadruped_of(const QuadrupedShape& shape) {
    Quadruped animal;
    animal.shape = shape;
    QuadrupedJoints& j = animal.joints;
    add_trunk(animal);
    add_head(animal);
    const LegLine front = front_line(shape);
    const LegLine back = back_line(shape);
    j.front = add_leg(animal.rig, "Front", j.spine.back(), front, j.front_blade, j.front_toe);
    j.back = add_leg(animal.rig, "Back", j.body, back, j.back_blade, j.back_toe);
    add_tail(animal);
    j.front.target = add_target(animal.rig, "Front", front.foot);
    j.back.target = add_target(animal.rig, "Back", back.foot);
    return animal;
}

}  // namespace posepack::menagerie
