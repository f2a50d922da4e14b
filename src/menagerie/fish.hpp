// SPDX-License-Identifier: MIT
// The body plan of fish: a spine that carries a wave to the tail, and fins.
#pragma once

#include <string>
#include <vector>

#include "menagerie/model.hpp"

namespace posepack::menagerie {

// Lengths in metres. The fish hangs in the water with its lowest fin at y = 0.
struct FishShape {
    std::string name;
    double length = 0.42;         // from the snout to the root of the tail fin
    double swim_height = 0.0774;  // of the middle line
    double body_radius = 0.031;   // across
    double body_depth = 0.056;    // above and below the middle line
    double tail_depth = 0.017;    // of the peduncle
    double tail_fin_length = 0.085;
    double tail_fin_spread = 0.062;  // up and down
    double dorsal_height = 0.048;
    double dorsal_length = 0.075;
    double pectoral_length = 0.062;
    double pelvic_length = 0.045;
    int spine_joints = 6;

    Colour back = 0x4E5A38;
    Colour side = 0xB9A98C;
    Colour belly = 0xEFEBDD;
    Colour band = 0xC7887F;  // along the flank
    Colour spot = 0x232A1E;
    Colour fin = 0x8C7B52;
    Colour fin_tip = 0xC7B58A;
    Colour eye = 0x0E0D0C;
    Colour iris = 0xE0B24C;
};

// Joint numbers; pairs name the left one, the right one follows.
struct FishJoints {
    int root = 0;  // no weights: where a game would attach the fish
    int body = 0;
    int head = 0;
    int jaw = 0;
    int gill = 0;
    int eye = 0;
    std::vector<int> spine;  // towards the tail
    int tail_fin = 0;
    int tail_upper = 0;
    int tail_lower = 0;
    std::vector<int> dorsal;
    int adipose = 0;
    int anal = 0;
    std::vector<int> pectoral;
    int pelvic = 0;
};

struct Fish {
    FishShape shape;
    FishJoints joints;
    Rig rig;
};

// Angles in degrees; ways as parts of the body's length.
namespace fish_channel {
enum : int {
    body_x,
    body_y,
    body_z,
    body_pitch,
    body_yaw,
    body_roll,
    bend,       // of the whole spine to one side
    wave_sine,  // the travelling wave: its two quadratures, amplitudes in degrees
    wave_cosine,
    head_yaw,
    head_pitch,
    jaw,
    gill,
    tail_spread,  // of the fin's lobes
    dorsal_fold,
    pectoral_pitch,
    pectoral_spread,
    pectoral_left,
    pectoral_right,
    pelvic_spread,
    count
};
}  // namespace fish_channel

Fish fish_of(const FishShape& shape);
Mesh fish_mesh(const Fish& animal);
Pose fish_pose(const Fish& animal, const ClipScript& script, double phase);

// Idle, Swim, Swim_Fast, Dart, Turn, Eat, Sleep, Attack, Hit, Die.
std::vector<ClipScript> fish_scripts();

Model fish_model(const FishShape& shape, const ExportStyle& style, int rate_hz);

}  // namespace posepack::menagerie
