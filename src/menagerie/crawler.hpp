// SPDX-License-Identifier: MIT
// The body plan of what walks on six legs or more: insects, spiders, crabs. Legs by inverse kinematics in
// pairs, a body of three parts, and whatever else a shape asks for: wings, claws, antennae.
#pragma once

#include <string>
#include <vector>

#include "menagerie/leg.hpp"
#include "menagerie/model.hpp"

namespace posepack::menagerie {

// Lengths in metres; "radii" are half of a thickness. A length of zero leaves the part out.
struct CrawlerShape {
    std::string name;
    int leg_pairs = 4;
    double body_height = 0.012;  // of the middle part
    double thorax_length = 0.012;
    double thorax_radius = 0.005;
    double thorax_depth = 0.0035;
    double abdomen_length = 0.016;
    double abdomen_radius = 0.0075;
    double abdomen_depth = 0.0065;
    double abdomen_rise_degrees = 8.0;
    double head_length = 0.005;
    double head_radius = 0.0038;
    double head_depth = 0.003;
    double leg_span = 0.027;  // from the root of a leg to its tip, on the level
    double leg_arch = 0.012;  // of the knee above the root
    double leg_radius = 0.0009;
    double leg_fan_degrees = 58.0;  // of the first pair forwards and the last one backwards
    double jaw_length = 0.004;
    double antenna_length = 0.0;
    double claw_length = 0.0;
    double wing_length = 0.0;
    double wing_breadth = 0.0;
    double eye_radius = 0.0008;
    double eye_stalk = 0.0;
    double stride = 1.0;
    bool flies = false;

    Colour back = 0x4A3A2C;
    Colour side = 0x5C4936;
    Colour belly = 0x6E5A44;
    Colour abdomen = 0x3C2E24;
    Colour band = 0xA08A68;  // of every second ring of the abdomen
    Colour head = 0x43352A;
    Colour leg = 0x5A4634;
    Colour leg_tip = 0x2C2219;
    Colour claw = 0x8A4A36;
    Colour wing = 0xCFD8DC;
    Colour eye = 0x0C0A09;
    Colour jaw = 0x201815;
};

// Joint numbers; pairs name the left one, the right one follows. -1: the shape has none.
struct CrawlerJoints {
    int root = 0;  // no weights
    int body = 0;
    int head = 0;
    int jaw = 0;
    int eye = 0;
    std::vector<int> abdomen;
    std::vector<int> antenna;
    std::vector<int> claw;  // arm, hand, finger
    int fore_wing = -1;
    int hind_wing = -1;
    std::vector<int> coxa;  // of each pair, front to back
    std::vector<Leg> legs;
};

struct Crawler {
    CrawlerShape shape;
    CrawlerJoints joints;
    Rig rig;
};

// Angles in degrees; ways as parts of the legs' span. Legs move together but for what a gait adds; the first
// pair has channels of its own.
namespace crawler_channel {
enum : int {
    body_x,
    body_y,
    body_z,
    body_pitch,
    body_yaw,
    body_roll,
    abdomen_pitch,
    abdomen_yaw,
    head_pitch,
    head_yaw,
    jaw,
    antenna_pitch,
    antenna_yaw,
    claw_lift,
    claw_swing,
    claw_open,
    wing_spread,  // 0: laid back over the body, 1: spread
    wing_flap,
    follow,     // 0: feet stay where they are told; 1: they go with the body
    legs_curl,  // 1: feet drawn in under the body
    front_x,
    front_y,
    front_z,
    front_left_y,
    front_right_y,
    count
};
}  // namespace crawler_channel

Crawler crawler_of(const CrawlerShape& shape);
Mesh crawler_mesh(const Crawler& animal);
Pose crawler_pose(const Crawler& animal, const ClipScript& script, double phase);

// Idle, Walk, Run, Eat, Threaten, Sleep, Attack, Hit, Die; and Fly for those that can.
std::vector<ClipScript> crawler_scripts(const CrawlerShape& shape);

Model crawler_model(const CrawlerShape& shape, const ExportStyle& style, int rate_hz);

}  // namespace posepack::menagerie
