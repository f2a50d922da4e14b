// SPDX-License-Identifier: MIT
// The bodies that stress cases move, and keys from functions of time.
#pragma once

#include <functional>
#include <vector>

#include "menagerie/raw_model.hpp"

namespace posepack::stress {

using menagerie::cosine_of_turns;
using menagerie::Interpolation;
using menagerie::kAxisX;
using menagerie::kAxisY;
using menagerie::kAxisZ;
using menagerie::Quat;
using menagerie::RawChannel;
using menagerie::RawClip;
using menagerie::RawModel;
using menagerie::RawPath;
using menagerie::sine_of_turns;
using menagerie::turn_about;
using menagerie::Vec3;

// A tube of rings along +Y with a chain of joints inside, each turning where its part begins. Neighbouring
// joints share the rings between them.
struct Reed {
    int joints = 4;
    double length = 1.0;     // units
    double thickness = 0.1;  // units: radius of the tube
    int rings = 13;
    Vec3 foot{0.0};  // where the mesh and the first joint stand, units
};
RawModel reed(const Reed& shape = {});

// The same body under node 0, a joint without vertices that the body binds to where it would stand without
// it: its place, turn and scale carry the body away.
RawModel carried_reed(const Reed& shape = {});

// `count` times from `first_s` on, `rate_hz` a second, as floats.
std::vector<float> grid(std::size_t count, double rate_hz, double first_s = 0.0);

// Channels whose values are a function of the time after the first key, in seconds.
RawChannel turning(int node, const std::vector<float>& times_s, const std::function<Quat(double)>& turn);
RawChannel moving(int node, const std::vector<float>& times_s, const std::function<Vec3(double)>& place);
RawChannel scaling(int node, const std::vector<float>& times_s, const std::function<Vec3(double)>& scale);

// exp(-x) for x >= 0, from + - * / alone.
double decayed(double x);

// Every joint of a body swings by `degrees` about its own axis, one cycle in `period_s`, as waves that climb.
std::vector<RawChannel> swaying(const RawModel& model, const std::vector<float>& times_s, double degrees,
                                double period_s);

// The usual motion: a cycle a second, 15 degrees a joint, keys on a grid.
inline constexpr double kSwayDegrees = 15.0;
inline constexpr double kKeyHz = 30.0;

// A body with one clip.
RawModel with_clip(RawModel model, std::vector<RawChannel> channels);

}  // namespace posepack::stress
