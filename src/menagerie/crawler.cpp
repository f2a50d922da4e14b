// SPDX-License-Identifier: MIT
#include "menagerie/crawler.hpp"

#include <fmt/format.h>

#include <array>

#include <glm/geometric.hpp>

namespace posepack::menagerie {
namespace {

namespace channel = crawler_channel;
using Values = std::vector<double>;

double value(const Values& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

// 1 for the first pair of legs, -1 for the last.
double leg_place(const CrawlerShape& s, int pair) {
    return 1.0 - 2.0 * pair / (s.leg_pairs - 1);
}

void add_body(Crawler& animal) {
    const CrawlerShape& s = animal.shape;
    CrawlerJoints& j = animal.joints;
    Rig& rig = animal.rig;
    const Vec3 middle(0.0, s.body_height, 0.0);
    j.root = add_joint(rig, "Root", -1, Vec3(0.0), kAxisY * s.body_height);
    j.body = add_joint(rig, "Body", j.root, middle, middle + kAxisZ * (s.thorax_length * 0.4));
    const Vec3 waist = middle - kAxisZ * (s.thorax_length * 0.48);
    const Vec3 way = pitch(s.abdomen_rise_degrees) * -kAxisZ * s.abdomen_length;
    j.abdomen.push_back(add_joint(rig, "Abdomen1", j.body, waist, waist + way * 0.5));
    j.abdomen.push_back(add_joint(rig, "Abdomen2", j.abdomen[0], waist + way * 0.5, waist + way));
    add_joint(rig, "Abdomen2_end", j.abdomen[1], waist + way, waist + way * 1.1);
    const Vec3 neck = middle + kAxisZ * (s.thorax_length * 0.46);
    const Vec3 nose = neck + kAxisZ * s.head_length;
    j.head = add_joint(rig, "Head", j.body, neck, nose);
    add_joint(rig, "Head_end", j.head, nose, nose + kAxisZ * (s.head_length * 0.2));
    const Vec3 jaw = nose + Vec3(s.head_radius * 0.42, -s.head_depth * 0.45, -s.head_length * 0.15);
    j.jaw = add_joint_pair(rig, "Jaw", j.head, jaw, jaw + kAxisZ * s.jaw_length);
    const Vec3 eye =
        neck + Vec3(s.head_radius * 0.72, s.head_depth * 0.55 + s.eye_stalk, s.head_length * 0.62);
    j.eye = add_joint_pair(rig, "Eye", j.head, eye, eye + kAxisZ * s.eye_radius);
    if (s.antenna_length <= 0.0) return;
    const Vec3 root = neck + Vec3(s.head_radius * 0.35, s.head_depth * 0.7, s.head_length * 0.8);
    const Vec3 half = Vec3(0.25, 0.55, 0.75) * (s.antenna_length * 0.5);
    j.antenna.push_back(add_joint_pair(rig, "Antenna1", j.head, root, root + half));
    j.antenna.push_back(add_joint_pair(rig, "Antenna2", j.antenna[0], root + half,
                                       root + half * 1.8 + kAxisZ * half.z * 0.4));
}

void add_claw(Crawler& animal) {
    const CrawlerShape& s = animal.shape;
    if (s.claw_length <= 0.0) return;
    CrawlerJoints& j = animal.joints;
    const double l = s.claw_length;
    const Vec3 root(s.thorax_radius * 0.72, s.body_height - s.thorax_depth * 0.2, s.thorax_length * 0.42);
    const std::array<Vec3, 4> places = {root, root + Vec3(0.30, 0.08, 0.50) * l,
                                        root + Vec3(0.16, 0.08, 0.85) * l,
                                        root + Vec3(-0.02, 0.06, 1.20) * l};
    int parent = j.body;
    for (std::size_t index = 0; index < 3; ++index) {
        constexpr std::array<const char*, 3> kNames = {"Claw1", "Claw2", "Pincer"};
        parent = add_joint_pair(animal.rig, kNames[index], parent, places[index], places[index + 1]);
        j.claw.push_back(parent);
    }
}

void add_wings(Crawler& animal) {
    const CrawlerShape& s = animal.shape;
    if (s.wing_length <= 0.0) return;
    CrawlerJoints& j = animal.joints;
    const Vec3 fore(s.thorax_radius * 0.45, s.body_height + s.thorax_depth * 0.85, s.thorax_length * 0.12);
    const Vec3 hind = fore - kAxisZ * (s.thorax_length * 0.28);
    j.fore_wing = add_joint_pair(animal.rig, "ForeWing", j.body, fore, fore + kAxisX * s.wing_length);
    j.hind_wing = add_joint_pair(animal.rig, "HindWing", j.body, hind, hind + kAxisX * (s.wing_length * 0.7));
}

void add_legs(Crawler& animal) {
    const CrawlerShape& s = animal.shape;
    CrawlerJoints& j = animal.joints;
    Rig& rig = animal.rig;
    for (int pair = 0; pair < s.leg_pairs; ++pair) {
        const double at = leg_place(s, pair);
        const Vec3 out = yaw(-s.leg_fan_degrees * at) * kAxisX;
        const Vec3 root(s.thorax_radius * 0.62, s.body_height - s.thorax_depth * 0.35,
                        at * s.thorax_length * 0.36);
        const Vec3 hip = root + out * (s.thorax_radius * 0.35);
        const Vec3 knee = hip + out * (s.leg_span * 0.34) + kAxisY * s.leg_arch;
        Vec3 hock = hip + out * (s.leg_span * 0.72);
        Vec3 foot = hip + out * (s.leg_span * 0.93);
        const Vec3 tip(hip.x + out.x * s.leg_span, 0.0, hip.z + out.z * s.leg_span);
        hock.y = hip.y * 0.72 + s.leg_arch * 0.12;
        foot.y = hip.y * 0.20;
        const auto name = [pair](const char* part) { return fmt::format("Leg{}{}", pair + 1, part); };
        Leg leg;
        j.coxa.push_back(add_joint_pair(rig, name("Coxa"), j.body, root, hip));
        leg.upper = add_joint_pair(rig, name("Femur"), j.coxa.back(), hip, knee);
        leg.lower = add_joint_pair(rig, name("Tibia"), leg.upper, knee, hock);
        leg.cannon = add_joint_pair(rig, name("Tarsus"), leg.lower, hock, foot);
        leg.foot = add_joint_pair(rig, name("Foot"), leg.cannon, foot, tip);
        if (pair == 0) {
            add_joint_pair(rig, name("Foot_end"), leg.foot, tip, tip - kAxisY * (s.leg_radius * 2.0));
            leg.target = add_joint_pair(rig, name("IK"), -1, foot, foot - kAxisZ * (s.leg_span * 0.1));
        }
        j.legs.push_back(leg);
    }
}

Quat& turn_of(Pose& pose, int joint) {
    return pose.turns[static_cast<std::size_t>(joint)];
}

void pose_body(const Crawler& animal, const Values& v, Pose& pose) {
    const CrawlerJoints& j = animal.joints;
    const Vec3 way(value(v, channel::body_x), value(v, channel::body_y), value(v, channel::body_z));
    pose.shifts[static_cast<std::size_t>(j.body)] = way * animal.shape.leg_span;
    turn_of(pose, j.body) = roll(value(v, channel::body_roll)) * yaw(value(v, channel::body_yaw)) *
                            pitch(value(v, channel::body_pitch));
    for (const int joint : j.abdomen) {
        turn_of(pose, joint) =
            yaw(value(v, channel::abdomen_yaw) * 0.5) * pitch(value(v, channel::abdomen_pitch) * 0.5);
    }
    turn_of(pose, j.head) = yaw(value(v, channel::head_yaw)) * pitch(value(v, channel::head_pitch));
}

// What comes in pairs and is no leg: left as given, right mirrored.
void pose_sides(const Crawler& animal, const Values& v, Pose& pose) {
    const CrawlerJoints& j = animal.joints;
    const auto set = [&pose](int joint, const Quat& turn) {
        turn_of(pose, joint) = turn;
        turn_of(pose, joint + 1) = mirrored(turn);
    };
    set(j.jaw, yaw(value(v, channel::jaw)));
    for (const int joint : j.antenna)
        set(joint, yaw(value(v, channel::antenna_yaw) * 0.5) * pitch(value(v, channel::antenna_pitch) * 0.5));
    if (!j.claw.empty()) {
        set(j.claw[0], pitch(-value(v, channel::claw_lift)) * yaw(value(v, channel::claw_swing)));
        set(j.claw[1], pitch(-value(v, channel::claw_lift) * 0.3));
        set(j.claw[2], yaw(value(v, channel::claw_open)));
    }
    if (j.fore_wing < 0) return;
    const double share = 1.0 - value(v, channel::wing_spread);
    const double flap = value(v, channel::wing_flap);
    set(j.fore_wing, yaw(62.0 * share) * roll(flap) * roll(14.0 * share));
    set(j.hind_wing, yaw(54.0 * share) * roll(flap * 0.9) * roll(8.0 * share));
}

void pose_foot(const Crawler& animal, const ClipScript& script, double phase, const Values& v, int pair,
               int side, Pose& pose) {
    const CrawlerShape& s = animal.shape;
    const CrawlerJoints& j = animal.joints;
    const Leg& left = j.legs[static_cast<std::size_t>(pair)];
    Leg leg = side == 0 ? left : other_leg(left);
    if (left.target < 0) leg.target = -1;
    const double sign = side == 0 ? 1.0 : -1.0;
    Vec3 way(0.0);
    if (pair == 0) {
        way = {
            sign * value(v, channel::front_x),
            value(v, channel::front_y) + value(v, side == 0 ? channel::front_left_y : channel::front_right_y),
            value(v, channel::front_z)};
    }
    if (script.gait) {
        const std::size_t foot = static_cast<std::size_t>(pair * 2 + side);
        const FootStep step = foot_step(*script.gait, phase + script.gait->offsets[foot]);
        way += Vec3(0.0, step.height * script.gait->lift, step.forward * script.gait->stroke);
    }
    const Placement placed = place(animal.rig, pose);
    const auto body = static_cast<std::size_t>(j.body);
    const Vec3 rest = animal.rig.joints[static_cast<std::size_t>(leg.foot)].head;
    const Vec3 hip = animal.rig.joints[static_cast<std::size_t>(leg.upper)].head;
    const double curl = value(v, channel::legs_curl);
    const Vec3 drawn = hip + (rest - hip) * Vec3(0.42, 0.0, 0.42) - kAxisY * (s.leg_span * 0.30);
    const Vec3 told = mixed(rest, drawn, curl) + way * s.leg_span;
    const Vec3 carried = placed.heads[body] + placed.turns[body] * (told - animal.rig.joints[body].head);
    const double follow = value(v, channel::follow);
    LegGoal goal;
    goal.ankle = told * (1.0 - follow) + carried * follow;
    // The lower leg swings about the hip with its foot and leans in when it is drawn under.
    const Vec3 flat_rest((rest - hip).x, 0.0, (rest - hip).z);
    const Vec3 flat_told((told - hip).x, 0.0, (told - hip).z);
    const Vec3 hinge = glm::normalize(glm::cross(kAxisY, flat_rest));
    const Quat turn = blended(kNoTurn, placed.turns[body], follow) * turn_between(flat_rest, flat_told) *
                      turn_about(hinge, 62.0 * curl);
    goal.cannon_turn = turn;
    goal.foot_turn = turn;
    pose_leg(animal.rig, placed, leg, goal, pose);
}

}  // namespace

Crawler crawler_of(const CrawlerShape& shape) {
    Crawler animal;
    animal.shape = shape;
    add_body(animal);
    add_claw(animal);
    add_wings(animal);
    add_legs(animal);
    return animal;
}

Pose crawler_pose(const Crawler& animal, const ClipScript& script, double phase) {
    const Values values = channel_values(script, channel::count, phase);
    Pose pose = rest_pose(animal.rig);
    pose_body(animal, values, pose);
    pose_sides(animal, values, pose);
    for (int pair = 0; pair < animal.shape.leg_pairs; ++pair) {
        for (int side = 0; side < 2; ++side) pose_foot(animal, script, phase, values, pair, side, pose);
    }
    return pose;
}

Model crawler_model(const CrawlerShape& shape, const ExportStyle& style, int rate_hz) {
    const Crawler animal = crawler_of(shape);
    const auto pose = [&animal](const ClipScript& script, double phase) {
        return crawler_pose(animal, script, phase);
    };
    std::vector<Clip> clips = perform(crawler_scripts(shape), rate_hz, shape.leg_span, pose);
    Model model{shape.name, animal.rig, crawler_mesh(animal), std::move(clips), style};
    name_clips(model);
    return model;
}

}  // namespace posepack::menagerie
