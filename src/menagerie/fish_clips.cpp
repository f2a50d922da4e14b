// SPDX-License-Identifier: MIT
// The clips of every fish, as rows of data. Travel is in body lengths a cycle: a fish goes about seven tenths
// of the way its wave goes (Videler, Fish Swimming, 1993), and the wave is one body long.
#include "menagerie/fish.hpp"

namespace posepack::menagerie {
namespace {

using namespace fish_channel;

constexpr double kTravelPerBeat = 0.7;

// The travelling wave with `beats` beats a cycle and this amplitude at the tail.
void add_beats(ClipScript& clip, int beats, double degrees) {
    clip.waves.push_back({wave_sine, degrees, beats, 0.0});
    clip.waves.push_back({wave_cosine, degrees, beats, 0.25});
    clip.waves.push_back({body_yaw, degrees * 0.28, beats, 0.42});
}

ClipScript idle() {
    ClipScript clip{"Idle", 96, Ending::closed, {}, {}, {}, 0.0};
    add_beats(clip, 2, 6.0);
    clip.tracks = {{pectoral_spread, {{0.0, 12}}}};
    clip.waves.insert(clip.waves.end(), {{pectoral_pitch, 24.0, 4, 0.0},
                                         {pectoral_left, 6.0, 2, 0.3},
                                         {body_y, 0.010, 2, 0.0},
                                         {gill, 6.0, 4, 0.0},
                                         {jaw, 3.0, 4, 0.1},
                                         {pelvic_spread, 8.0, 2, 0.2}});
    return clip;
}

ClipScript swim() {
    ClipScript clip{"Swim", 30, Ending::closed, {}, {}, {}, kTravelPerBeat};
    add_beats(clip, 1, 17.0);
    clip.waves.insert(clip.waves.end(), {{body_roll, 3.0, 1, 0.1}, {pectoral_pitch, 5.0, 1, 0.0}});
    clip.tracks = {{pectoral_spread, {{0.0, -14}}}};
    return clip;
}

// One key short of closing.
ClipScript swim_fast() {
    ClipScript clip{"Swim_Fast", 13, Ending::open, {}, {}, {}, kTravelPerBeat};
    add_beats(clip, 1, 24.0);
    clip.waves.push_back({body_roll, 4.0, 1, 0.1});
    clip.tracks = {
        {pectoral_spread, {{0.0, -32}}}, {dorsal_fold, {{0.0, 30}}}, {pelvic_spread, {{0.0, -14}}}};
    return clip;
}

// A C-start: bent double within six key steps, then straight in three.
ClipScript dart() {
    ClipScript clip{"Dart", 24, Ending::closed, {}, {}, {}, 1.6};
    clip.tracks = {{bend, {{0.0, 0}, {0.25, 125}, {0.44, -52}, {0.56, 36}, {0.70, -16}, {0.84, 5}, {1.0, 0}}},
                   {body_yaw, {{0.0, 0}, {0.25, 26}, {0.44, -8}, {0.62, 4}, {1.0, 0}}},
                   {body_roll, {{0.0, 0}, {0.25, -24}, {0.48, 8}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.25, 0.09}, {1.0, 0}}},
                   {pectoral_spread, {{0.0, 0}, {0.12, 25}, {0.25, -34}, {0.70, -34}, {1.0, 0}}},
                   {dorsal_fold, {{0.0, 0}, {0.20, 35}, {0.70, 35}, {1.0, 0}}},
                   {jaw, {{0.0, 0}, {0.12, 10}, {0.40, 0}, {1.0, 0}}}};
    return clip;
}

ClipScript turn() {
    ClipScript clip{"Turn", 45, Ending::closed, {}, {}, {}, 0.0};
    add_beats(clip, 2, 9.0);
    clip.tracks = {{bend, {{0.0, 0}, {0.25, -75}, {0.60, 30}, {1.0, 0}}},
                   {body_yaw, {{0.0, 0}, {0.25, -18}, {0.60, 8}, {1.0, 0}}},
                   {body_roll, {{0.0, 0}, {0.30, -14}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.25, 0.11}, {1.0, 0}}},
                   {pectoral_left, {{0.0, 0}, {0.25, 40}, {0.70, 0}, {1.0, 0}}}};
    return clip;
}

ClipScript eat() {
    ClipScript clip{"Eat", 60, Ending::closed, {}, {}, {}, 0.0};
    add_beats(clip, 3, 7.0);
    clip.tracks = {{body_pitch, {{0.0, 0}, {0.25, -26}, {0.60, -26}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.25, 0.33}, {0.60, 0.33}, {1.0, 0}}},
                   {jaw,
                    {{0.0, 0},
                     {0.22, 0},
                     {0.27, 34},
                     {0.33, 0},
                     {0.42, 30},
                     {0.48, 0},
                     {0.56, 22},
                     {0.62, 0},
                     {1.0, 0}}},
                   {gill, {{0.0, 0}, {0.27, 20}, {0.36, 0}, {0.44, 18}, {0.54, 0}, {1.0, 0}}},
                   {body_z, {{0.0, 0}, {0.27, 0.08}, {0.60, 0.02}, {1.0, 0}}},
                   {pectoral_spread, {{0.0, 10}, {0.27, 40}, {0.60, 20}, {1.0, 10}}}};
    clip.waves.push_back({pectoral_pitch, 16.0, 4, 0.0});
    return clip;
}

ClipScript sleep() {
    ClipScript clip{"Sleep", 90, Ending::closed, {}, {}, {}, 0.0};
    add_beats(clip, 1, 2.5);
    clip.tracks = {{body_roll, {{0.0, 7}}},
                   {pectoral_spread, {{0.0, 26}}},
                   {dorsal_fold, {{0.0, 38}}},
                   {pelvic_spread, {{0.0, 22}}}};
    clip.waves.insert(clip.waves.end(), {{gill, 5.0, 3, 0.0}, {jaw, 2.0, 3, 0.1}});
    return clip;
}

ClipScript attack() {
    ClipScript clip{"Attack", 30, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {
        {bend, {{0.0, 0}, {0.20, 74}, {0.38, -50}, {0.50, 50}, {0.62, -40}, {0.78, 14}, {1.0, 0}}},
        {body_z, {{0.0, 0}, {0.24, -0.10}, {0.40, 0.28}, {0.62, 0.20}, {1.0, 0}}},
        {head_yaw, {{0.0, 0}, {0.40, 0}, {0.47, 26}, {0.54, -28}, {0.61, 22}, {0.70, 0}, {1.0, 0}}},
        {jaw, {{0.0, 0}, {0.22, 8}, {0.36, 44}, {0.41, 2}, {0.60, 6}, {1.0, 0}}},
        {gill, {{0.0, 0}, {0.34, 26}, {0.45, 0}, {1.0, 0}}},
        {pectoral_spread, {{0.0, 0}, {0.22, 30}, {0.36, -30}, {0.60, 40}, {1.0, 0}}},
        {tail_spread, {{0.0, 0}, {0.24, 14}, {0.40, -10}, {1.0, 0}}}};
    return clip;
}

ClipScript hit() {
    ClipScript clip{"Hit", 20, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{bend, {{0.0, 0}, {0.18, -95}, {0.42, 40}, {0.70, -12}, {1.0, 0}}},
                   {body_roll, {{0.0, 0}, {0.20, 38}, {0.60, -8}, {1.0, 0}}},
                   {body_x, {{0.0, 0}, {0.22, -0.10}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.22, 0.10}, {0.60, 0.06}, {1.0, 0}}},
                   {jaw, {{0.0, 0}, {0.15, 26}, {0.60, 0}, {1.0, 0}}},
                   {pectoral_spread, {{0.0, 0}, {0.18, 44}, {1.0, 0}}}};
    return clip;
}

// Turns belly up and drifts upwards.
ClipScript die() {
    ClipScript clip{"Die", 54, Ending::once, {}, {}, {}, 0.0};
    clip.tracks = {{bend, {{0.0, 0}, {0.14, -45}, {0.28, 40}, {0.42, -22}, {0.60, 14}, {0.90, 22}}},
                   {body_roll, {{0.0, 0}, {0.30, 30}, {0.75, 172}, {0.90, 166}}},
                   {body_pitch, {{0.0, 0}, {0.45, 10}, {0.90, 5}}},
                   {body_y, {{0.0, 0}, {0.40, 0.12}, {1.0, 0.30}}},
                   {body_x, {{0.0, 0}, {0.20, 0}, {1.0, 0.22}}},
                   {jaw, {{0.0, 0}, {0.20, 24}, {0.40, 8}, {0.90, 18}}},
                   {gill, {{0.0, 0}, {0.20, 20}, {0.60, 4}, {0.90, 10}}},
                   {pectoral_spread, {{0.0, 0}, {0.20, 40}, {0.80, 18}}},
                   {dorsal_fold, {{0.0, 0}, {0.70, 34}}}};
    return clip;
}

}  // namespace

std::vector<ClipScript> fish_scripts() {
    return {idle(), swim(), swim_fast(), dart(), turn(), eat(), sleep(), attack(), hit(), die()};
}

}  // namespace posepack::menagerie
