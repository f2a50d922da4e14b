// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "menagerie/bird.hpp"

namespace posepack::menagerie {
namespace {

Vec3 direction(double rise_degrees) {
    return pitch(-rise_degrees) * kAxisZ;
}

void add_trunk(Bird& animal) {
    const BirdShape& s = animal.shape;
    BirdJoints& j = animal.joints;
    Rig& rig = animal.rig;
    const Vec3 hip(0.0, s.hip_height, -0.006);
    const Vec3 way = direction(s.body_rise_degrees) * s.body_length;
    j.body = add_joint(rig, "Body", -1, hip, hip + way * 0.35);
    j.spine = add_joint(rig, "Spine", j.body, hip + way * 0.35, hip + way * 0.70);
    j.chest = add_joint(rig, "Chest", j.spine, hip + way * 0.70, hip + way);
    const Vec3 up = direction(s.neck_rise_degrees) * s.neck_length;
    Vec3 head = hip + way;
    int parent = j.chest;
    for (const char* name : {"Neck1", "Neck2", "Neck3"}) {
        parent = add_joint(rig, name, parent, head, head + up / 3.0);
        j.neck.push_back(parent);
        head += up / 3.0;
    }
    const Vec3 tip = head + kAxisZ * (s.head_radius + s.beak_length);
    j.head = add_joint(rig, "Head", parent, head, tip);
    add_joint(rig, "Head_end", j.head, tip, tip + kAxisZ * 0.01);
    const Vec3 hinge = head + Vec3(0.0, s.head_radius * 0.02, s.head_radius * 0.75);
    j.beak = add_joint(rig, "Beak", j.head, hinge, hinge + kAxisZ * s.beak_length);
    const Vec3 beak_tip = hinge + kAxisZ * s.beak_length;
    add_joint(rig, "Beak_end", j.beak, beak_tip, beak_tip + kAxisZ * 0.01);
    const Vec3 eye = head + Vec3(s.head_radius * 0.84, s.head_radius * 0.30, s.head_radius * 0.48);
    j.eye = add_joint_pair(rig, "Eye", j.head, eye, eye + kAxisX * 0.005);
    const Vec3 breast = hip + way * 0.75 - kAxisY * (s.body_depth * 0.45);
    j.breast = add_joint(rig, "Breast", j.chest, breast, breast + Vec3(0.0, -0.5, 0.8) * s.body_depth);
}

void add_wing(Bird& animal) {
    const BirdShape& s = animal.shape;
    BirdJoints& j = animal.joints;
    Rig& rig = animal.rig;
    const Vec3 chest = rig.joints[static_cast<std::size_t>(j.chest)].head;
    const Vec3 shoulder = chest + Vec3(s.body_radius * 0.74, s.body_depth * 0.52, 0.002);
    const Vec3 elbow = shoulder + Vec3(0.24, 0.02, -0.03) * s.wing_length;
    const Vec3 wrist = shoulder + Vec3(0.50, 0.03, 0.06) * s.wing_length;
    const Vec3 hand = shoulder + Vec3(0.66, 0.03, 0.01) * s.wing_length;
    j.upper_arm = add_joint_pair(rig, "Wing1", j.chest, shoulder, elbow);
    j.forearm = add_joint_pair(rig, "Wing2", j.upper_arm, elbow, wrist);
    j.hand = add_joint_pair(rig, "Wing3", j.forearm, wrist, hand);
    const Vec3 inner = (shoulder + elbow) * 0.5;
    j.tertials = add_joint_pair(rig, "Tertials", j.upper_arm, inner, inner - kAxisZ * s.wing_chord);
    const Vec3 middle = (elbow + wrist) * 0.5;
    j.secondaries = add_joint_pair(rig, "Secondaries", j.forearm, middle, middle - kAxisZ * s.wing_chord);
    j.primaries =
        add_joint_pair(rig, "Primaries", j.hand, wrist, shoulder + Vec3(1.0, 0.02, -0.22) * s.wing_length);
}

void add_tail(Bird& animal) {
    const BirdShape& s = animal.shape;
    BirdJoints& j = animal.joints;
    const Vec3 way = -direction(s.body_rise_degrees * 0.4) * s.tail_length;
    const Vec3 hip = animal.rig.joints[static_cast<std::size_t>(j.body)].head;
    const Vec3 root = hip - direction(s.body_rise_degrees) * (s.body_length * 0.55);
    j.tail.push_back(add_joint(animal.rig, "Tail1", j.body, root, root + way * 0.4));
    j.tail.push_back(add_joint(animal.rig, "Tail2", j.tail.front(), root + way * 0.4, root + way));
    add_joint(animal.rig, "Tail2_end", j.tail.back(), root + way, root + way * 1.2);
    const Vec3 side = root + way * 0.35 + kAxisX * (s.tail_radius * 0.3);
    j.fan = add_joint_pair(animal.rig, "TailFan", j.tail.back(), side,
                           side + way * 0.6 + kAxisX * (s.tail_radius * 0.3));
}

void add_leg(Bird& animal) {
    const BirdShape& s = animal.shape;
    BirdJoints& j = animal.joints;
    Rig& rig = animal.rig;
    const double h = s.hip_height;
    const double x = s.stance_width;
    const Vec3 hip(x * 0.85, h * 0.90, 0.0);
    const Vec3 knee(x * 1.10, h * 0.66, h * 0.24);
    const Vec3 hock(x, h * 0.40, -h * 0.12);
    const Vec3 foot(x, s.leg_radius * 1.2, h * 0.12);
    j.leg.upper = add_joint_pair(rig, "Thigh", j.body, hip, knee);
    j.leg.lower = add_joint_pair(rig, "Shin", j.leg.upper, knee, hock);
    j.leg.cannon = add_joint_pair(rig, "Tarsus", j.leg.lower, hock, foot);
    j.leg.foot = add_joint_pair(rig, "Toes", j.leg.cannon, foot, foot + kAxisZ * s.toe_length);
    j.hind_toe = add_joint_pair(rig, "HindToe", j.leg.foot, foot, foot - kAxisZ * (s.toe_length * 0.7));
    j.leg.target = add_joint_pair(rig, "IKFoot", -1, foot, foot - kAxisZ * 0.02);
}

}  // namespace

Bird bird_of(const BirdShape& shape) {
    Bird animal;
    animal.shape = shape;
    add_trunk(animal);
    add_wing(animal);
    add_tail(animal);
    add_leg(animal);
    return animal;
}

}  // namespace posepack::menagerie
