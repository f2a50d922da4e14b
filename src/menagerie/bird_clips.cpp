// SPDX-License-Identifier: MIT
// The clips of every bird, as rows of data.
#include "menagerie/bird.hpp"

namespace posepack::menagerie {
namespace {

using namespace bird_channel;

constexpr int of_foot(int channel, int side) {
    return channel + 4 * side;
}

// Feet drawn up under the belly, for flight.
void tuck_feet(ClipScript& clip) {
    clip.tracks.push_back({follow, {{0.0, 1}}});
    for (const int side : {0, 1}) {
        clip.tracks.push_back({of_foot(foot_y, side), {{0.0, 0.36}}});
        clip.tracks.push_back({of_foot(foot_z, side), {{0.0, -0.55}}});
        clip.tracks.push_back({of_foot(foot_pitch, side), {{0.0, 75}}});
    }
}

ClipScript idle() {
    ClipScript clip{"Idle", 90, Ending::closed, {}, {}, {}, 0.0};
    clip.waves = {{puff, 0.05, 3, 0.0}, {body_pitch, 1.5, 3, 0.1}, {tail_pitch, 5.0, 3, 0.3}};
    // Birds look about in jerks.
    clip.tracks = {{head_yaw,
                    {{0.0, 0},
                     {0.10, 0},
                     {0.14, 42},
                     {0.34, 42},
                     {0.38, -12},
                     {0.55, -12},
                     {0.59, -48},
                     {0.80, -48},
                     {0.84, 0},
                     {1.0, 0}}},
                   {head_roll, {{0.0, 0}, {0.34, 0}, {0.38, 20}, {0.55, 20}, {0.59, 0}, {1.0, 0}}},
                   {neck_pitch, {{0.0, 0}, {0.55, 0}, {0.59, -12}, {0.80, -12}, {0.84, 0}, {1.0, 0}}}};
    return clip;
}

ClipScript hop() {
    ClipScript clip{"Hop", 15, Ending::closed, {}, {}, Gait{0.50, 0.95, 0.34, {0.0, 0.0}}, 0.0};
    clip.tracks = {{body_y, {{0.0, -0.12}, {0.30, -0.16}, {0.75, 0.30}, {1.0, -0.12}}},
                   {body_pitch, {{0.0, 4}, {0.30, 8}, {0.60, -10}, {1.0, 4}}},
                   {tail_pitch, {{0.0, -4}, {0.50, 16}, {1.0, -4}}},
                   {neck_pitch, {{0.0, 6}, {0.55, -12}, {1.0, 6}}}};
    return clip;
}

ClipScript fly() {
    ClipScript clip{"Fly", 30, Ending::closed, {}, {}, {}, 96.0};
    clip.tracks = {{wing_open, {{0.0, 1}}},    {body_pitch, {{0.0, 26}}}, {neck_pitch, {{0.0, 8}}},
                   {head_pitch, {{0.0, -30}}}, {tail_pitch, {{0.0, -4}}}, {tail_fan, {{0.0, 10}}},
                   {body_y, {{0.0, 0.9}}},     {flap, {{0.0, 8}}},        {wing_sweep, {{0.0, 6}}}};
    clip.waves = {{flap, 46.0, 4, 0.0},       {flap_bend, 28.0, 4, 0.72}, {wing_sweep, 14.0, 4, 0.25},
                  {wing_tilt, 18.0, 4, 0.25}, {body_y, 0.14, 4, 0.55},    {tail_pitch, 6.0, 4, 0.4}};
    tuck_feet(clip);
    return clip;
}

ClipScript glide() {
    ClipScript clip{"Glide", 60, Ending::closed, {}, {}, {}, 210.0};
    clip.tracks = {{wing_open, {{0.0, 1}}},    {body_pitch, {{0.0, 24}}}, {neck_pitch, {{0.0, 6}}},
                   {head_pitch, {{0.0, -28}}}, {tail_fan, {{0.0, 22}}},   {body_y, {{0.0, 0.9}}},
                   {flap, {{0.0, 10}}},        {flap_bend, {{0.0, -8}}}};
    clip.waves = {{body_roll, 9.0, 1, 0.0},
                  {flap, 2.5, 4, 0.0},
                  {tail_yaw, 8.0, 1, 0.3},
                  {head_roll, -7.0, 1, 0.0},
                  {body_y, 0.05, 2, 0.0}};
    tuck_feet(clip);
    return clip;
}

ClipScript peck() {
    ClipScript clip{"Peck", 60, Ending::closed, {}, {}, {}, 0.0};
    const std::vector<Stop> stoop = {{0.0, 0},    {0.12, 0.9}, {0.18, 1}, {0.24, 0.8}, {0.30, 1},
                                     {0.36, 0.8}, {0.44, 1},   {0.60, 0}, {1.0, 0}};
    const auto scaled = [&stoop](int channel, double amount) {
        Track track{channel, stoop};
        for (Stop& stop : track.stops) stop.value *= amount;
        return track;
    };
    clip.tracks = {scaled(body_pitch, 44),
                   scaled(neck_pitch, 28),
                   scaled(head_pitch, -6),
                   scaled(body_y, -0.18),
                   scaled(tail_pitch, 12),
                   {beak,
                    {{0.0, 0},
                     {0.16, 18},
                     {0.19, 0},
                     {0.28, 18},
                     {0.31, 0},
                     {0.64, 14},
                     {0.68, 0},
                     {0.72, 12},
                     {0.76, 0},
                     {1.0, 0}}},
                   {head_yaw, {{0.0, 0}, {0.66, 0}, {0.70, 34}, {0.86, 34}, {0.90, 0}, {1.0, 0}}}};
    return clip;
}

ClipScript drink() {
    ClipScript clip{"Drink", 75, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{body_pitch, {{0.0, 0}, {0.20, 42}, {0.36, 42}, {0.55, -10}, {0.80, -10}, {1.0, 0}}},
                   {neck_pitch, {{0.0, 0}, {0.20, 28}, {0.36, 28}, {0.55, -25}, {0.80, -25}, {1.0, 0}}},
                   {head_pitch, {{0.0, 0}, {0.36, -6}, {0.55, -38}, {0.80, -38}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.20, -0.18}, {0.36, -0.18}, {0.55, 0}, {1.0, 0}}}};
    clip.waves = {{beak, 5.0, 8, 0.0}};
    clip.tracks.push_back({beak, {{0.0, 5}}});
    return clip;
}

ClipScript sleep() {
    ClipScript clip{"Sleep", 90, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{body_y, {{0.0, -0.34}}}, {body_pitch, {{0.0, 10}}}, {neck_pitch, {{0.0, 26}}},
                   {neck_yaw, {{0.0, 60}}},  {head_yaw, {{0.0, 70}}},   {head_pitch, {{0.0, 16}}},
                   {puff, {{0.0, 0.22}}},    {tail_pitch, {{0.0, -8}}}};
    clip.waves = {{puff, 0.06, 2, 0.0}, {body_y, 0.015, 2, 0.0}};
    return clip;
}

ClipScript attack() {
    ClipScript clip{"Attack", 30, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {
        {wing_open, {{0.0, 0}, {0.25, 1}, {0.75, 1}, {1.0, 0}}},
        {flap, {{0.0, 0}, {0.25, 58}, {0.40, -30}, {0.55, 55}, {0.70, -25}, {0.85, 10}, {1.0, 0}}},
        {flap_bend, {{0.0, 0}, {0.30, -20}, {0.42, 20}, {0.56, -20}, {0.72, 15}, {1.0, 0}}},
        {body_pitch, {{0.0, 0}, {0.25, -22}, {0.38, 44}, {0.48, -8}, {0.60, 44}, {0.72, 10}, {1.0, 0}}},
        {body_z, {{0.0, 0}, {0.25, -0.15}, {0.38, 0.30}, {0.60, 0.35}, {1.0, 0}}},
        {neck_pitch, {{0.0, 0}, {0.25, -30}, {0.36, 46}, {0.48, -20}, {0.58, 46}, {0.75, 0}, {1.0, 0}}},
        {beak, {{0.0, 0}, {0.22, 30}, {0.36, 32}, {0.40, 0}, {0.48, 30}, {0.60, 0}, {1.0, 0}}},
        {tail_fan, {{0.0, 0}, {0.25, 24}, {0.75, 24}, {1.0, 0}}}};
    return clip;
}

ClipScript hit() {
    ClipScript clip{"Hit", 20, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{wing_open, {{0.0, 0}, {0.20, 0.8}, {0.50, 0.5}, {1.0, 0}}},
                   {flap, {{0.0, 0}, {0.20, 40}, {0.60, 5}, {1.0, 0}}},
                   {body_roll, {{0.0, 0}, {0.18, 22}, {0.55, -6}, {1.0, 0}}},
                   {body_z, {{0.0, 0}, {0.20, -0.22}, {1.0, 0}}},
                   {neck_yaw, {{0.0, 0}, {0.15, -50}, {0.60, 8}, {1.0, 0}}},
                   {beak, {{0.0, 0}, {0.15, 28}, {0.60, 0}, {1.0, 0}}},
                   {tail_pitch, {{0.0, 0}, {0.20, 26}, {1.0, 0}}}};
    return clip;
}

ClipScript die() {
    ClipScript clip{"Die", 36, Ending::once, {}, {}, {}, 0.0};
    clip.tracks = {{body_roll, {{0.0, 0}, {0.20, 14}, {0.55, 172}, {0.64, 164}, {0.72, 170}}},
                   {body_y, {{0.0, 0}, {0.28, 0.70}, {0.55, -0.34}, {0.60, -0.30}, {0.66, -0.34}}},
                   {follow, {{0.0, 0}, {0.15, 0}, {0.40, 1}}},
                   {wing_open, {{0.0, 0}, {0.18, 0.9}, {0.36, 0.1}, {0.70, 0.3}}},
                   {flap, {{0.0, 0}, {0.12, 45}, {0.24, -30}, {0.36, 40}, {0.60, 0}}},
                   {body_pitch, {{0.0, 0}, {0.25, 0}, {0.60, 28}}},
                   {neck_pitch, {{0.0, 0}, {0.20, -20}, {0.55, 34}}},
                   {head_yaw, {{0.0, 0}, {0.25, 30}, {0.75, 24}}},
                   {beak, {{0.0, 0}, {0.20, 26}, {0.80, 10}}}};
    for (const int side : {0, 1}) {
        clip.tracks.push_back({of_foot(foot_y, side), {{0.0, 0}, {0.40, 0.25}, {0.80, 0.20}}});
        clip.tracks.push_back(
            {of_foot(foot_pitch, side), {{0.0, 0}, {0.50, 60}, {0.80, side == 0 ? 45.0 : 62.0}}});
    }
    return clip;
}

}  // namespace

std::vector<ClipScript> bird_scripts(const BirdShape& shape) {
    std::vector<ClipScript> scripts = {idle(),  hop(),   fly(),    glide(), peck(),
                                       drink(), sleep(), attack(), hit(),   die()};
    for (ClipScript& clip : scripts) {
        if (clip.name != "Peck" && clip.name != "Drink" && clip.name != "Attack") continue;
        for (Track& track : clip.tracks) {
            if (track.channel != body_pitch && track.channel != neck_pitch) continue;
            for (Stop& stop : track.stops) stop.value *= shape.bow;
        }
    }
    return scripts;
}

BirdShape settled(BirdShape shape) {
    constexpr std::size_t kPeck = 4;
    constexpr double kDeepestPhase = 0.18;  // of Peck
    const auto clearance = [&shape](double bow) {
        shape.bow = bow;
        const Bird animal = bird_of(shape);
        const Placement placed =
            place(animal.rig, bird_pose(animal, bird_scripts(shape)[kPeck], kDeepestPhase));
        return placed.heads[static_cast<std::size_t>(animal.joints.head + 1)].y - shape.beak_radius * 0.3;
    };
    double least = 0.2;
    double most = 1.5;
    for (int step = 0; step < 20; ++step) {
        const double bow = (least + most) / 2;
        (clearance(bow) >= 0.0 ? least : most) = bow;
    }
    shape.bow = least;
    return shape;
}

}  // namespace posepack::menagerie
