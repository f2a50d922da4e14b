// SPDX-License-Identifier: MIT
// The body plan of snakes: a chain from its middle to both ends, which crawls along a serpentine without
// slipping sideways.
#pragma once

#include <string>
#include <vector>

#include "menagerie/model.hpp"

namespace posepack::menagerie {

// Lengths in metres.
struct SnakeShape {
    std::string name;
    double length = 0.85;  // from the neck to the tip of the tail
    double body_radius = 0.027;
    double neck_radius = 0.015;
    double head_length = 0.066;
    double head_radius = 0.027;  // across the jaws
    double head_depth = 0.0175;
    double tongue_length = 0.044;
    int front_joints = 8;  // from the middle to the neck
    int back_joints = 10;
    double bends = 1.5;  // waves of the serpentine on the body

    Colour back = 0xA8966A;
    Colour side = 0x8B7B56;
    Colour belly = 0xD8CFAE;
    Colour zigzag = 0x33291E;
    Colour head = 0x84744E;
    Colour eye = 0x17110C;
    Colour iris = 0xC8742B;
    Colour tongue = 0x3A1416;
    Colour fang = 0xF2ECDD;
};

// Joint numbers; pairs name the left one, the right one follows.
struct SnakeJoints {
    int root = 0;  // no weights
    int middle = 0;
    std::vector<int> front;  // from the middle to the neck
    std::vector<int> back;   // from the middle to the tail
    int head = 0;
    int jaw = 0;
    int eye = 0;
    int fang = 0;
    std::vector<int> tongue;
};

struct Snake {
    SnakeShape shape;
    SnakeJoints joints;
    Rig rig;
};

// Angles in degrees; ways as parts of the length.
namespace snake_channel {
enum : int {
    body_x,
    body_y,
    body_z,
    body_roll,
    swing,       // of the serpentine: the largest heading away from straight ahead
    coil_front,  // heading gained over the front half, over the back half
    coil_back,
    rear,   // how far the front half stands up
    crest,  // and bows its neck again
    head_pitch,
    head_yaw,
    head_roll,
    jaw,
    fangs,
    tongue,
    tail_lift,
    count
};
}  // namespace snake_channel

Snake snake_of(const SnakeShape& shape);
Mesh snake_mesh(const Snake& animal);

// `phase` moves the body along its serpentine by one wave a cycle when the script travels.
Pose snake_pose(const Snake& animal, const ClipScript& script, double phase);

// Idle, Crawl, Slither, Coil, Rise, Sleep, Strike, Hit, Eat, Die.
std::vector<ClipScript> snake_scripts();

// Way ahead of one wave of a serpentine with this swing, in wave lengths along the body.
double serpentine_advance(double swing_degrees);

Model snake_model(const SnakeShape& shape, const ExportStyle& style, int rate_hz);

}  // namespace posepack::menagerie
