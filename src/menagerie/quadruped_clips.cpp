// SPDX-License-Identifier: MIT
// The clips of every quadruped, as rows of data. Their lengths sum to 496 rows at 30 Hz: the closing key of a
// closed loop is no row of its own, the last key of the other clips is.
#include <algorithm>

#include "menagerie/quadruped.hpp"

namespace posepack::menagerie {
namespace {

using namespace quadruped_channel;

// Channel of a foot: 0 left front, 1 right front, 2 left back, 3 right back.
constexpr int of_foot(int channel, int foot) {
    return channel + 5 * foot;
}

ClipScript idle() {
    ClipScript clip{"Idle", 120, Ending::closed, {}, {}, {}};
    clip.waves = {{body_y, 0.006, 2, 0.0},    {spine_pitch, 1.2, 2, 0.1}, {neck_pitch, 2.5, 2, 0.3},
                  {head_pitch, 2.0, 2, 0.55}, {tail_yaw, 14.0, 4, 0.0},   {body_x, 0.008, 1, 0.0},
                  {jaw, 1.5, 2, 0.0}};
    clip.tracks = {{neck_yaw, {{0.0, 0}, {0.30, 0}, {0.40, 22}, {0.62, 22}, {0.72, 0}, {1.0, 0}}},
                   {head_yaw, {{0.0, 0}, {0.28, 0}, {0.38, 16}, {0.62, 16}, {0.70, 0}, {1.0, 0}}},
                   {ear_flick_left, {{0.0, 0}, {0.12, 0}, {0.14, 48}, {0.17, -10}, {0.20, 0}, {1.0, 0}}},
                   {ear_flick_right, {{0.0, 0}, {0.50, 0}, {0.52, 48}, {0.55, -10}, {0.58, 0}, {1.0, 0}}}};
    return clip;
}

ClipScript walk() {
    ClipScript clip{"Walk", 28, Ending::closed, {}, {}, Gait{0.62, 0.62, 0.085, {0.75, 0.25, 0.0, 0.5}}};
    clip.tracks = {{body_y, {{0.0, -0.020}}}};
    clip.waves = {{body_y, 0.010, 2, 0.10},  {body_x, 0.012, 1, 0.0},    {body_roll, 2.0, 1, 0.0},
                  {body_yaw, 3.0, 1, 0.20},  {spine_yaw, -5.0, 1, 0.2},  {body_pitch, 0.8, 2, 0.3},
                  {neck_pitch, 5.0, 2, 0.0}, {head_pitch, -3.5, 2, 0.0}, {tail_yaw, 12.0, 1, 0.3},
                  {ear_pitch, 5.0, 2, 0.2},  {beard, 8.0, 2, 0.25}};
    return clip;
}

ClipScript trot() {
    ClipScript clip{"Trot", 20, Ending::closed, {}, {}, Gait{0.42, 0.66, 0.15, {0.0, 0.5, 0.5, 0.0}}};
    clip.tracks = {{body_y, {{0.0, -0.025}}}, {neck_pitch, {{0.0, -6}}}, {tail_pitch, {{0.0, 14}}}};
    clip.waves = {{body_y, 0.026, 2, 0.62},   {body_roll, 1.5, 1, 0.0},   {body_yaw, 2.0, 1, 0.0},
                  {spine_yaw, -3.5, 1, 0.0},  {neck_pitch, 4.0, 2, 0.10}, {head_pitch, -3.0, 2, 0.15},
                  {tail_pitch, 9.0, 2, 0.35}, {ear_pitch, 13.0, 2, 0.4},  {beard, 16.0, 2, 0.4}};
    return clip;
}

// One key short of closing: the last key and the first are neighbours, as in most gallops from modelling
// tools.
ClipScript gallop() {
    ClipScript clip{"Gallop", 15, Ending::open, {}, {}, Gait{0.27, 0.82, 0.24, {0.50, 0.60, 0.0, 0.90}}};
    clip.tracks = {{body_y, {{0.0, -0.035}}},
                   {neck_pitch, {{0.0, 16}}},
                   {head_pitch, {{0.0, -8}}},
                   {tail_pitch, {{0.0, 22}}}};
    clip.waves = {{body_y, 0.045, 1, 0.20},    {body_pitch, 8.0, 1, 0.80},  {spine_pitch, 15.0, 1, 0.05},
                  {neck_pitch, 11.0, 1, 0.35}, {head_pitch, -7.0, 1, 0.35}, {tail_pitch, 18.0, 1, 0.5},
                  {ear_pitch, 20.0, 1, 0.5},   {beard, 24.0, 1, 0.5},       {body_roll, 1.5, 1, 0.0}};
    return clip;
}

ClipScript eat(const QuadrupedShape& shape) {
    ClipScript clip{"Eat", 108, Ending::closed, {}, {}, {}};
    const double low = shape.eat_pitch_degrees;
    clip.tracks = {
        {neck_pitch, {{0.0, low}, {0.62, low}, {0.72, low - 17.0}, {0.86, low - 17.0}, {1.0, low}}},
        {head_pitch, {{0.0, -62}, {0.62, -62}, {0.72, -50}, {0.86, -50}, {1.0, -62}}},
        {neck_yaw, {{0.0, -10}, {0.30, -10}, {0.45, 14}, {0.65, 14}, {0.80, -10}, {1.0, -10}}},
        {beard, {{0.0, -50}}},
        {body_pitch, {{0.0, 6}}},
        {spine_pitch, {{0.0, 8}}},
        {body_y, {{0.0, -0.02}}},
        {of_foot(foot_z, 0), {{0.0, 0.13}}},
        {of_foot(foot_z, 1), {{0.0, -0.10}}},
        {ear_flick_right, {{0.0, 0}, {0.75, 0}, {0.77, 42}, {0.80, -8}, {0.83, 0}, {1.0, 0}}}};
    clip.waves = {{jaw, 7.0, 9, 0.0},      {jaw, 6.0, 18, 0.1},      {head_pitch, 3.0, 9, 0.25},
                  {head_yaw, 4.0, 3, 0.0}, {tail_yaw, 18.0, 5, 0.0}, {neck_pitch, 2.0, 3, 0.0},
                  {beard, 7.0, 9, 0.1}};
    return clip;
}

// How far the body sinks until belly or chest lies on the ground, as a part of the hip's height.
double lying_drop(const QuadrupedShape& shape) {
    const double belly = shape.hip_height * 0.985 - shape.belly_depth;
    const double chest = shape.shoulder_height * 0.95 - shape.chest_depth * 1.05;
    return std::min(belly, chest) / shape.hip_height;
}

ClipScript sleep(const QuadrupedShape& shape) {
    ClipScript clip{"Sleep", 96, Ending::closed, {}, {}, {}};
    clip.tracks = {{body_y, {{0.0, -lying_drop(shape)}}},
                   {body_roll, {{0.0, -7}}},
                   {neck_yaw, {{0.0, 62}}},
                   {neck_pitch, {{0.0, shape.sleep_pitch_degrees}}},
                   {head_yaw, {{0.0, 28}}},
                   {head_pitch, {{0.0, -6}}},
                   {spine_yaw, {{0.0, 14}}},
                   {tail_yaw, {{0.0, 45}}},
                   {ear_pitch, {{0.0, -22}}},
                   {tail_pitch, {{0.0, -1.5 * shape.tail_rise_degrees - 5.0}}},
                   {shoulder_lift, {{0.0, 0.10}}}};
    for (const int foot : {0, 1}) {  // folded under the chest
        clip.tracks.push_back({of_foot(foot_y, foot), {{0.0, -0.045}}});
        clip.tracks.push_back({of_foot(foot_z, foot), {{0.0, -0.06}}});
        clip.tracks.push_back({of_foot(foot_x, foot), {{0.0, foot == 0 ? 0.045 : -0.045}}});
        clip.tracks.push_back({of_foot(cannon_pitch, foot), {{0.0, 92}}});
        clip.tracks.push_back({of_foot(foot_pitch, foot), {{0.0, 120}}});
    }
    for (const int foot : {2, 3}) {  // tucked beside the belly
        clip.tracks.push_back({of_foot(foot_y, foot), {{0.0, -0.045}}});
        clip.tracks.push_back({of_foot(foot_z, foot), {{0.0, 0.27}}});
        clip.tracks.push_back({of_foot(foot_x, foot), {{0.0, foot == 2 ? 0.10 : -0.10}}});
        clip.tracks.push_back({of_foot(cannon_pitch, foot), {{0.0, -78}}});
        clip.tracks.push_back({of_foot(foot_pitch, foot), {{0.0, -48}}});
    }
    clip.waves = {{spine_pitch, 2.0, 2, 0.0},
                  {neck_pitch, 2.5, 2, 0.15},
                  {head_pitch, -1.5, 2, 0.2},
                  {body_y, 0.004, 2, 0.0}};
    return clip;
}

// Rears, then slams its forehead down within five key steps; the ears are quicker.
ClipScript butt() {
    ClipScript clip{"Attack", 36, Ending::closed, {}, {}, {}};
    clip.tracks = {
        {body_pitch, {{0.0, 0}, {0.36, -34}, {0.44, -36}, {0.60, 7}, {0.68, 5}, {1.0, 0}}},
        {body_y, {{0.0, 0}, {0.16, -0.10}, {0.36, -0.06}, {0.56, -0.08}, {0.70, -0.05}, {1.0, 0}}},
        {body_z, {{0.0, 0}, {0.36, -0.06}, {0.47, -0.04}, {0.57, 0.20}, {0.68, 0.17}, {1.0, 0}}},
        {front_follow, {{0.0, 0}, {0.20, 1}, {0.48, 1}, {0.56, 0}, {1.0, 0}}},
        {spine_pitch, {{0.0, 0}, {0.36, -9}, {0.44, -9}, {0.60, 12}, {0.72, 8}, {1.0, 0}}},
        {neck_pitch, {{0.0, 0}, {0.36, -8}, {0.46, -14}, {0.62, 62}, {0.68, 56}, {1.0, 0}}},
        {head_pitch, {{0.0, 0}, {0.36, 34}, {0.49, -14}, {0.61, 44}, {0.70, 32}, {1.0, 0}}},
        {ear_pitch, {{0.0, 0}, {0.30, -20}, {0.52, -40}, {0.56, 90}, {0.62, -46}, {0.74, 10}, {1.0, 0}}},
        {beard, {{0.0, 0}, {0.50, -30}, {0.57, 55}, {0.64, -45}, {0.75, 12}, {1.0, 0}}},
        {tail_pitch, {{0.0, 0}, {0.30, 25}, {0.48, 30}, {0.55, -35}, {0.70, 10}, {1.0, 0}}},
        {jaw, {{0.0, 0}, {0.40, 10}, {0.52, 0}, {1.0, 0}}}};
    for (const int foot : {0, 1}) {
        const double late = foot == 0 ? 0.0 : 0.03;
        clip.tracks.push_back(
            {of_foot(foot_y, foot), {{0.0, 0}, {0.24 + late, 0.16}, {0.46, 0.16}, {0.56, 0}, {1.0, 0}}});
        clip.tracks.push_back(
            {of_foot(foot_z, foot),
             {{0.0, 0}, {0.30, 0.03}, {0.47, 0.05}, {0.56, 0.16}, {0.72, 0.16}, {0.86, 0}, {1.0, 0}}});
        clip.tracks.push_back(
            {of_foot(cannon_pitch, foot), {{0.0, 0}, {0.24 + late, 75}, {0.46, 70}, {0.56, 0}, {1.0, 0}}});
        clip.tracks.push_back(
            {of_foot(foot_pitch, foot), {{0.0, 0}, {0.22, 70}, {0.46, 60}, {0.56, 0}, {1.0, 0}}});
    }
    return clip;
}

// Crouches, lunges, snaps and shakes.
ClipScript bite() {
    ClipScript clip{"Attack", 36, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {
        {body_y, {{0.0, 0}, {0.28, -0.16}, {0.44, -0.02}, {0.70, -0.08}, {1.0, 0}}},
        {body_z, {{0.0, 0}, {0.28, -0.16}, {0.44, 0.24}, {0.70, 0.14}, {1.0, 0}}},
        {body_pitch, {{0.0, 0}, {0.28, 6}, {0.42, -12}, {0.52, 4}, {1.0, 0}}},
        {spine_pitch, {{0.0, 0}, {0.28, 12}, {0.42, -8}, {1.0, 0}}},
        {neck_pitch, {{0.0, 0}, {0.28, 44}, {0.42, 4}, {0.50, 28}, {0.72, 26}, {1.0, 0}}},
        {head_pitch, {{0.0, 0}, {0.28, -30}, {0.40, -34}, {0.46, 22}, {0.70, 4}, {1.0, 0}}},
        {jaw, {{0.0, 0}, {0.30, 12}, {0.40, 40}, {0.455, 3}, {0.74, 4}, {1.0, 0}}},
        {head_yaw,
         {{0.0, 0}, {0.50, 0}, {0.56, 34}, {0.62, -34}, {0.68, 30}, {0.74, -20}, {0.82, 0}, {1.0, 0}}},
        {head_roll, {{0.0, 0}, {0.50, 0}, {0.56, -16}, {0.62, 18}, {0.68, -14}, {0.80, 0}, {1.0, 0}}},
        {ear_pitch, {{0.0, 0}, {0.25, -32}, {0.80, -20}, {1.0, 0}}},
        {tail_pitch, {{0.0, 0}, {0.30, 24}, {0.46, 46}, {1.0, 0}}}};
    for (const int foot : {0, 1}) {
        clip.tracks.push_back(
            {of_foot(foot_y, foot),
             {{0.0, 0}, {0.30, 0}, {0.38, 0.16}, {0.46, 0}, {0.80, 0}, {0.88, 0.08}, {0.96, 0}}});
        clip.tracks.push_back(
            {of_foot(foot_z, foot), {{0.0, 0}, {0.30, 0}, {0.46, 0.22}, {0.80, 0.22}, {0.96, 0}}});
        clip.tracks.push_back(
            {of_foot(cannon_pitch, foot), {{0.0, 0}, {0.30, 0}, {0.38, 50}, {0.46, 0}, {1.0, 0}}});
    }
    return clip;
}

ClipScript hit() {
    ClipScript clip{"Hit", 26, Ending::closed, {}, {}, {}};
    clip.tracks = {{body_z, {{0.0, 0}, {0.16, -0.09}, {0.45, -0.06}, {1.0, 0}}},
                   {body_x, {{0.0, 0}, {0.16, -0.07}, {0.5, -0.03}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.22, -0.09}, {0.55, -0.02}, {1.0, 0}}},
                   {body_roll, {{0.0, 0}, {0.16, 9}, {0.45, -3}, {1.0, 0}}},
                   {spine_yaw, {{0.0, 0}, {0.16, -16}, {0.5, 4}, {1.0, 0}}},
                   {neck_yaw, {{0.0, 0}, {0.13, -38}, {0.45, 8}, {1.0, 0}}},
                   {neck_pitch, {{0.0, 0}, {0.13, -18}, {0.45, 10}, {1.0, 0}}},
                   {head_roll, {{0.0, 0}, {0.13, 24}, {0.40, -8}, {1.0, 0}}},
                   {head_pitch, {{0.0, 0}, {0.13, -20}, {0.45, 6}, {1.0, 0}}},
                   {jaw, {{0.0, 0}, {0.13, 20}, {0.45, 4}, {1.0, 0}}},
                   {ear_pitch, {{0.0, 0}, {0.10, 42}, {0.30, -28}, {0.6, 6}, {1.0, 0}}},
                   {tail_pitch, {{0.0, 0}, {0.14, -30}, {0.5, 8}, {1.0, 0}}}};
    return clip;
}

// Sinks on its front legs, rolls onto its right side and lies still.
ClipScript die(const QuadrupedShape& shape) {
    ClipScript clip{"Die", 45, Ending::once, {}, {}, {}};
    const double drop = shape.side_drop;
    const double late = shape.settles ? 0.5 : 1.0;  // short legs let go early, or they would be drawn under
    clip.tracks = {
        {body_y, {{0.0, 0}, {0.22, -0.16}, {0.40, -0.34}, {0.60, -drop}, {0.66, 0.02 - drop}, {0.72, -drop}}},
        {body_x, {{0.0, 0}, {0.60, -0.30}}},
        {body_pitch, {{0.0, 0}, {0.24, 10}, {0.60, 0}}},
        {body_roll, {{0.0, 0}, {0.22, 4}, {0.60, 86}, {0.66, 81}, {0.72, 86}}},
        {front_follow, {{0.0, 0}, {0.10 * late, 0}, {0.40 * late, 1}}},
        {back_follow, {{0.0, 0}, {0.16 * late, 0}, {0.46 * late, 1}}},
        {spine_pitch, {{0.0, 0}, {0.24, 12}, {0.70, -5}}},
        {neck_pitch, {{0.0, 0}, {0.20, -22}, {0.45, 30}, {0.70, 26}}},
        {neck_yaw, {{0.0, 0}, {0.30, 14}, {0.62, -14}, {0.74, -6}}},
        {head_pitch, {{0.0, 0}, {0.20, -16}, {0.55, 8}}},
        {head_yaw, {{0.0, 0}, {0.55, 10}, {0.68, -7}, {0.80, -4}}},
        {jaw, {{0.0, 0}, {0.25, 16}, {0.80, 9}}},
        {ear_pitch, {{0.0, 0}, {0.20, 25}, {0.66, -18}}},
        {tail_pitch, {{0.0, 0}, {0.30, 30}, {0.70, -35}}}};
    for (const int foot : {0, 1, 2, 3}) {
        const double lag = 0.03 * (foot % 2);
        clip.tracks.push_back(
            {of_foot(foot_y, foot), {{0.0, 0}, {0.30 + lag, 0.20}, {0.43, 0.30}, {0.66, 0.05}}});
        clip.tracks.push_back({of_foot(foot_z, foot), {{0.0, 0}, {0.62, foot % 2 == 0 ? 0.10 : -0.06}}});
        clip.tracks.push_back({of_foot(cannon_pitch, foot), {{0.0, 0}, {0.34, 38}, {0.70, 14}}});
        clip.tracks.push_back({of_foot(foot_pitch, foot), {{0.0, 0}, {0.34, 45}, {0.75, 30}}});
    }
    return clip;
}

// Leaps on the spot: crouches flat, flies up tall, lands flat.
ClipScript jump() {
    ClipScript clip{"Jump", 24, Ending::closed, {}, {}, {}};
    clip.tracks = {{front_follow, {{0.0, 1}}},
                   {back_follow, {{0.0, 1}}},
                   {squash, {{0.0, 0}, {0.22, 0.30}, {0.36, -0.22}, {0.58, -0.06}, {0.76, 0.26}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.28, 0}, {0.50, 0.75}, {0.72, 0}, {1.0, 0}}},
                   {body_pitch, {{0.0, 0}, {0.34, -14}, {0.62, 12}, {0.80, 0}, {1.0, 0}}},
                   {ear_pitch, {{0.0, 0}, {0.30, -20}, {0.50, 24}, {0.76, -30}, {1.0, 0}}},
                   {tail_pitch, {{0.0, 0}, {0.30, -20}, {0.55, 30}, {1.0, 0}}}};
    return clip;
}

// Takes the pitch out of body and spine, for a long body on short legs.
void soften(ClipScript& clip, double share) {
    const auto pitches = [](int channel) { return channel == body_pitch || channel == spine_pitch; };
    for (Track& track : clip.tracks) {
        if (!pitches(track.channel)) continue;
        for (Stop& stop : track.stops) stop.value *= share;
    }
    for (Wave& wave : clip.waves) {
        if (pitches(wave.channel)) wave.amplitude *= share;
    }
}

// A trunk swings along with everything, gathers food in Eat and is raised in Attack.
void move_trunk(ClipScript& clip) {
    if (clip.name == "Eat") {
        clip.tracks.push_back({trunk_curl, {{0.0, 0}, {0.25, 20}, {0.50, 210}, {0.68, 215}, {1.0, 0}}});
    } else if (clip.name == "Attack") {
        clip.tracks.push_back({trunk_curl, {{0.0, 0}, {0.34, -130}, {0.48, -125}, {0.80, 20}, {1.0, 0}}});
    } else if (clip.name == "Sleep" || clip.name == "Die") {
        clip.tracks.push_back({trunk_curl, {{0.0, clip.name == "Die" ? 0.0 : 70.0}, {0.5, 70}}});
    } else {
        clip.waves.push_back({trunk_curl, clip.name == "Idle" ? 24.0 : 14.0, 2, 0.1});
        clip.tracks.push_back({trunk_curl, {{0.0, clip.name == "Gallop" ? 40.0 : 10.0}}});
    }
}

}  // namespace

std::vector<ClipScript> quadruped_scripts(const QuadrupedShape& shape) {
    const bool butts = shape.butts || (shape.horns != Horns::none && shape.horns != Horns::knobs);
    std::vector<ClipScript> scripts = {
        idle(), walk(),    trot(), gallop(), eat(shape), sleep(shape), butts ? butt() : bite(),
        hit(),  die(shape)};
    if (shape.leaps) scripts.push_back(jump());
    for (ClipScript& script : scripts) {
        if (script.gait) script.gait->stroke *= shape.stride;
        if (script.gait) script.gait->lift *= shape.stride;
        soften(script, shape.bounce);
        if (shape.trunk_length > 0.0) move_trunk(script);
    }
    return scripts;
}

}  // namespace posepack::menagerie
