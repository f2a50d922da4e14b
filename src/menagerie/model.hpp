// SPDX-License-Identifier: MIT
// A generated animal before it is written: skeleton, skin and clips.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "menagerie/mesh.hpp"
#include "menagerie/rig.hpp"
#include "menagerie/script.hpp"

namespace posepack::menagerie {

enum class Interpolation { linear, step, cubic };

struct Clip {
    std::string name;  // as the file spells it
    int rate_hz = 30;
    Ending ending = Ending::closed;
    double ground_speed_mps = 0.0;  // 0: the clip goes nowhere
    std::vector<Pose> keys;         // at times 0, 1/rate, 2/rate, ...
    std::string action;             // what it shows, in the spelling of the scripts: "Walk"
    Interpolation interpolation = Interpolation::linear;
};

// How a clip is spelled: "Walk", "walk", "Goat_Walk"; or as in a file that was copied over: "Attack.001".
enum class Naming { titled, lower_case, with_animal, numbered };

// Habits of the tool that a model pretends to come from.
struct ExportStyle {
    std::string armature = "Armature";  // node above the joints, and prefix of clip names
    double armature_scale = 1.0;        // joints are written in metres / scale
    bool z_up_armature = false;         // a quarter turn about X between the armature and the scene
    bool full_constant_keys = false;    // constant channels carry every key instead of two
    bool prefixed = true;               // clips carry the armature's name and a bar
    Naming naming = Naming::titled;
    bool rigid = false;           // no skin: each joint carries the triangles that follow it most
    bool shared_samplers = true;  // channels with equal values share one; else LINEAR is spelled out too
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

// Spells the names of a model's clips as its style says.
void name_clips(Model& model);

// Sets how the keys of the clip that shows `action` are joined; a model without it stays as it is.
void set_interpolation(Model& model, std::string_view action, Interpolation interpolation);

// Raises the keys of clips that go nowhere, leaps apart, where the skin would sink into the ground: by as
// much as it does, but for one half of a percent of the model's height.
void keep_above_ground(Model& model);

}  // namespace posepack::menagerie
