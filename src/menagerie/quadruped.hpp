// SPDX-License-Identifier: MIT
// The body plan of four-legged animals: one table of measures and colours for each animal, from which its
// skeleton, skin and poses follow.
#pragma once

#include <string>
#include <vector>

#include "menagerie/leg.hpp"
#include "menagerie/model.hpp"

namespace posepack::menagerie {

// Horns that sweep back have joints of their own; the others move with the head.
enum class Horns { none, swept_back, bull, curled, antlers, knobs };
enum class Mane { none, crest, ruff };
enum class Foot { hoof, paw };

// Lengths in metres; "heights" are above the ground, "radii" half of a thickness.
struct QuadrupedShape {
    std::string name;
    double hip_height = 0.66;
    double shoulder_height = 0.68;  // top of the shoulder blade
    double body_length = 0.56;      // from hip joint to shoulder joint
    double stance_width = 0.085;    // from the middle line to a foot
    double chest_radius = 0.135;    // across
    double chest_depth = 0.225;     // down from the spine's middle line
    double belly_radius = 0.155;
    double belly_depth = 0.225;
    double rump_radius = 0.125;
    double neck_length = 0.31;
    double neck_rise_degrees = 48.0;  // above the horizontal
    double neck_radius = 0.066;       // at the head
    double neck_base_depth = 0.13;
    double head_length = 0.25;
    double head_drop_degrees = 28.0;  // below the horizontal
    double head_radius = 0.07;        // across the cheeks
    double head_depth = 0.075;
    double muzzle_radius = 0.036;
    double muzzle_depth = 0.037;
    double leg_radius = 0.022;    // of the front cannon
    double thigh_radius = 0.075;  // along the body
    double ear_length = 0.15;
    double ear_width = 0.036;
    double ear_rise_degrees = 8.0;  // above the horizontal: 0 stands out sideways, 80 upright
    double tail_length = 0.13;
    double tail_radius = 0.024;
    double tail_rise_degrees = 50.0;
    double tail_bush = 0.55;  // by how much of its radius the middle of the tail is thicker
    int tail_joints = 3;
    Horns horns = Horns::none;
    double horn_length = 0.0;
    double beard_length = 0.0;
    Foot foot = Foot::hoof;
    Mane mane = Mane::none;
    double mane_length = 0.0;  // how far it stands out of the neck
    double tail_taper = 0.0;   // by which part of its radius the tail is thinner at its tip
    double ear_thickness = 1.0;
    double trunk_length = 0.0;
    double tusk_length = 0.0;
    double stride = 1.0;       // of a stride, as a part of the goat's for the same height
    double bounce = 1.0;       // of the pitch of body and spine, likewise
    double foot_height = 1.0;  // of ankle and toe joint, likewise: thick feet need room
    bool leaps = false;        // has a Jump that squashes and stretches
    bool butts = false;        // attacks with its head though it has no horns

    // What follows from the measures; see settled().
    bool settles = false;
    double eat_pitch_degrees = 103.0;   // neck bowed until the muzzle meets the ground
    double sleep_pitch_degrees = 50.0;  // neck laid beside the body
    double side_drop = 0.745;           // how far the body sinks until it lies on its side, in hip heights

    Colour coat = 0xB08A62;
    Colour back = 0x6A4A30;  // along the spine
    Colour belly = 0xE8DCC6;
    Colour neck = 0xA67F58;
    Colour face = 0xB9936A;
    Colour muzzle = 0xE6D8C2;
    Colour nose = 0x3A2C28;
    Colour leg = 0x7A5A40;
    Colour sock = 0x4A362A;
    Colour hoof = 0x2B2422;
    Colour ear = 0x9A7450;
    Colour ear_inside = 0xD9A892;
    Colour horn = 0x8C7B64;
    Colour horn_tip = 0x4C4238;
    Colour tail = 0x6A4A30;
    Colour mane_colour = 0x3A2A1E;
    Colour eye = 0x1A1512;
    Colour iris = 0xD9A23A;
};

// Joint numbers of a quadruped; pairs name the left one, the right one follows.
struct QuadrupedJoints {
    int body = 0;
    std::vector<int> spine;  // two, then the chest
    std::vector<int> neck;
    int head = 0;
    int jaw = 0;
    int beard = -1;
    int eye = 0;
    std::vector<int> ear;
    std::vector<int> horn;   // none but for horns that sweep back
    std::vector<int> trunk;  // none but for an elephant
    std::vector<int> tail;
    int front_blade = 0;  // shoulder blade
    int back_blade = 0;   // half of the pelvis
    Leg front;            // left legs
    Leg back;
    int front_toe = 0;
    int back_toe = 0;
};

struct Quadruped {
    QuadrupedShape shape;
    QuadrupedJoints joints;
    Rig rig;
};

// What a script may move. Angles in degrees; ways as parts of the hip's height. Feet in the order left front,
// right front, left back, right back; each has the five channels from foot_x on.
namespace quadruped_channel {
enum : int {
    body_x,
    body_y,
    body_z,
    body_pitch,
    body_yaw,
    body_roll,
    spine_pitch,
    spine_yaw,
    neck_pitch,
    neck_yaw,
    head_pitch,
    head_yaw,
    head_roll,
    jaw,
    ear_pitch,
    ear_flick_left,
    ear_flick_right,
    tail_pitch,
    tail_yaw,
    beard,
    front_follow,  // 0: front feet stay where they are told; 1: they go with the chest
    back_follow,
    shoulder_lift,  // how far the blades slide up beside the spine
    squash,         // the whole animal flatter and wider (negative: taller), feet on the ground
    trunk_curl,     // tip towards the mouth
    foot_x,
    foot_y,
    foot_z,
    foot_pitch,
    cannon_pitch,
    count = foot_x + 4 * 5
};
}  // namespace quadruped_channel

// The skeleton of a shape.
Quadruped quadruped_of(const QuadrupedShape& shape);

// The shape with the numbers that follow from its measures: how far neck and body go until they meet the
// ground in Eat, Sleep and Die. The numbers stay as they are where the animal cannot reach.
QuadrupedShape settled(QuadrupedShape shape);

// Its skin.
Mesh quadruped_mesh(const Quadruped& animal);

// The pose for channel values at a phase of a script's gait.
Pose quadruped_pose(const Quadruped& animal, const ClipScript& script, double phase);

// The nine clips every quadruped has: Idle, Walk, Trot, Gallop, Eat, Sleep, Attack, Hit, Die; and Jump for
// those that leap. Horned animals butt, the others bite.
std::vector<ClipScript> quadruped_scripts(const QuadrupedShape& shape);

Model quadruped_model(const QuadrupedShape& shape, const ExportStyle& style, int rate_hz);

}  // namespace posepack::menagerie
