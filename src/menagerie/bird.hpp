// SPDX-License-Identifier: MIT
// The body plan of birds: two legs by inverse kinematics, wings that fold, flap and glide, a tail that fans.
#pragma once

#include <string>
#include <vector>

#include "menagerie/leg.hpp"
#include "menagerie/model.hpp"

namespace posepack::menagerie {

// Lengths in metres; "radii" are half of a thickness.
struct BirdShape {
    std::string name;
    double hip_height = 0.058;
    double body_length = 0.062;       // from hip to chest
    double body_rise_degrees = 30.0;  // above the horizontal
    double body_radius = 0.031;       // across
    double body_depth = 0.032;
    double stance_width = 0.015;
    double neck_length = 0.030;
    double neck_rise_degrees = 52.0;
    double neck_radius = 0.019;
    double head_radius = 0.0205;
    double beak_length = 0.017;
    double beak_radius = 0.0062;
    double wing_length = 0.105;  // from the shoulder to the tip, spread
    double wing_chord = 0.052;   // from front to back
    double tail_length = 0.062;
    double tail_radius = 0.017;  // half of its breadth
    double leg_radius = 0.0021;
    double toe_length = 0.020;
    double bow = 1.0;  // of a sparrow's, in Peck, Drink and Attack; see settled()

    Colour back = 0x7A5638;
    Colour side = 0xA8957C;
    Colour belly = 0xD9D0C0;
    Colour cap = 0x5A504A;
    Colour cheek = 0xDDD5C8;
    Colour bib = 0x2A2320;
    Colour nape = 0x7C4526;
    Colour beak = 0x3B3A3C;
    Colour wing = 0x855B36;
    Colour wing_bar = 0xEFE7D8;
    Colour feather = 0x4A3527;
    Colour tail = 0x5A4333;
    Colour leg = 0xC08A72;
    Colour eye = 0x120E0C;
    Colour iris = 0x2E211A;
};

// Joint numbers; pairs name the left one, the right one follows.
struct BirdJoints {
    int body = 0;
    int spine = 0;
    int chest = 0;
    std::vector<int> neck;
    int head = 0;
    int beak = 0;    // the lower half
    int breast = 0;  // swells: the only joint of the plan that scales
    int eye = 0;
    int upper_arm = 0;
    int forearm = 0;
    int hand = 0;
    int tertials = 0;     // the feathers of the upper arm
    int secondaries = 0;  // the feathers of the forearm
    int primaries = 0;    // the feathers of the hand
    std::vector<int> tail;
    int fan = 0;
    Leg leg;
    int hind_toe = 0;
};

struct Bird {
    BirdShape shape;
    BirdJoints joints;
    Rig rig;
};

// Angles in degrees; ways as parts of the hip's height. Left foot, then right, four channels each.
namespace bird_channel {
enum : int {
    body_x,
    body_y,
    body_z,
    body_pitch,
    body_yaw,
    body_roll,
    neck_pitch,
    neck_yaw,
    head_pitch,
    head_yaw,
    head_roll,
    beak,
    puff,
    wing_open,   // 0: folded along the body, 1: spread
    flap,        // both wings up
    flap_bend,   // of forearm and hand against the arm
    wing_sweep,  // back
    wing_tilt,   // leading edge down
    tail_pitch,
    tail_yaw,
    tail_fan,
    follow,  // 0: feet stay where they are told; 1: they go with the body
    foot_x,
    foot_y,
    foot_z,
    foot_pitch,
    count = foot_x + 4 * 2
};
}  // namespace bird_channel

// The shape with a bow that takes its beak to the ground and no farther.
BirdShape settled(BirdShape shape);

Bird bird_of(const BirdShape& shape);
Mesh bird_mesh(const Bird& animal);
Pose bird_pose(const Bird& animal, const ClipScript& script, double phase);

// Idle, Hop, Fly, Glide, Peck, Drink, Sleep, Attack, Hit, Die.
std::vector<ClipScript> bird_scripts(const BirdShape& shape);

Model bird_model(const BirdShape& shape, const ExportStyle& style, int rate_hz);

}  // namespace posepack::menagerie
