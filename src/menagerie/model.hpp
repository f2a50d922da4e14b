// SPDX-License-Identifier: MIT
// A generated animal before it is written: skeleton, skin and clips.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "menagerie/mesh.hpp"
#include "menagerie/rig.hpp"
#include "menagerie/script.hpp"

namespace posepack::menagerie {

struct Clip {
    std::string name;
    int rate_hz = 30;
    Ending ending = Ending::closed;
    double ground_speed_mps = 0.0;  // 0: the clip goes nowhere
    std::vector<Pose> keys;         // at times 0, 1/rate, 2/rate, ...
};

// Habits of the tool that a model pretends to come from.
struct ExportStyle {
    std::string armature = "Armature";  // node above the joints, and prefix of clip names
    double armature_scale = 1.0;        // joints are written in metres / scale
    bool z_up_armature = false;         // a quarter turn about X between the armature and the scene
    bool full_constant_keys = false;    // constant channels carry every key instead of two
};

struct Model {
    std::string name;
    Rig rig;
    Mesh mesh;
    std::vector<Clip> clips;
    ExportStyle style;
};

using Poser = std::function<Pose(const ClipScript& script, double phase)>;

// Plays scripts through a body plan at a rate. The closing key of a closed loop is posed at phase 0, so that
// it equals the first to the bit. `unit_m` is the length that gaits and travels are measured in.
std::vector<Clip> perform(const std::vector<ClipScript>& scripts, int rate_hz, double unit_m,
                          const Poser& pose);

}  // namespace posepack::menagerie
