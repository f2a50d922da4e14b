// SPDX-License-Identifier: MIT
// The clips of every snake, as rows of data. Travel is in wave lengths along the body a cycle.
#include "menagerie/snake.hpp"

namespace posepack::menagerie {
namespace {

using namespace snake_channel;

constexpr double kCrawlSwing = 46.0;
constexpr double kSlitherSwing = 34.0;

// Flicks the tongue out and in, quivering, around a phase.
Track tongue_flick(double at) {
    return {tongue,
            {{0.0, 0},
             {at, 0},
             {at + 0.03, 1},
             {at + 0.06, 0.7},
             {at + 0.09, 1},
             {at + 0.12, 0.75},
             {at + 0.15, 1},
             {at + 0.18, 0},
             {1.0, 0}}};
}

ClipScript idle() {
    ClipScript clip{"Idle", 90, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 40}}},     {rear, {{0.0, 30}}}, {crest, {{0.0, 30}}},
                   {head_pitch, {{0.0, 4}}}, tongue_flick(0.12),  tongue_flick(0.60)};
    clip.waves = {
        {head_yaw, 14.0, 1, 0.0}, {coil_front, 10.0, 1, 0.05}, {rear, 3.0, 2, 0.1}, {tail_lift, 2.0, 2, 0.0}};
    return clip;
}

ClipScript crawl() {
    ClipScript clip{"Crawl", 45, Ending::closed, {}, {}, {}, serpentine_advance(kCrawlSwing)};
    clip.tracks = {{swing, {{0.0, kCrawlSwing}}}, {rear, {{0.0, 6}}}, {crest, {{0.0, 6}}}, tongue_flick(0.4)};
    return clip;
}

// The fast one; one key short of closing.
ClipScript slither() {
    ClipScript clip{"Slither", 19, Ending::open, {}, {}, {}, serpentine_advance(kSlitherSwing)};
    clip.tracks = {{swing, {{0.0, kSlitherSwing}}}, {rear, {{0.0, 8}}}, {crest, {{0.0, 9}}}};
    return clip;
}

ClipScript coil() {
    ClipScript clip{"Coil", 60, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 40}, {0.35, 12}, {0.65, 12}, {1.0, 40}}},
                   {coil_back, {{0.0, 0}, {0.40, -330}, {0.65, -330}, {1.0, 0}}},
                   {coil_front, {{0.0, 0}, {0.40, 130}, {0.65, 130}, {1.0, 0}}},
                   {rear, {{0.0, 30}, {0.40, 46}, {0.65, 46}, {1.0, 30}}},
                   {crest, {{0.0, 30}, {0.40, 66}, {0.65, 66}, {1.0, 30}}},
                   {head_pitch, {{0.0, 4}}},
                   tongue_flick(0.45)};
    return clip;
}

ClipScript rise() {
    ClipScript clip{"Rise", 60, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 40}}},
                   {rear, {{0.0, 30}, {0.35, 68}, {0.70, 68}, {1.0, 30}}},
                   {crest, {{0.0, 30}, {0.35, 62}, {0.70, 62}, {1.0, 30}}},
                   {head_yaw, {{0.0, 0}, {0.40, 0}, {0.48, 32}, {0.56, -30}, {0.66, 0}, {1.0, 0}}},
                   {head_pitch, {{0.0, 4}}},
                   tongue_flick(0.42)};
    return clip;
}

ClipScript sleep() {
    ClipScript clip{"Sleep", 90, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 10}}},     {coil_back, {{0.0, -420}}}, {coil_front, {{0.0, 260}}},
                   {head_yaw, {{0.0, 280}}}, {rear, {{0.0, 5}}},         {crest, {{0.0, 5}}}};
    clip.waves = {{coil_back, 3.0, 2, 0.0}, {coil_front, 2.0, 2, 0.1}};
    return clip;
}

// Draws its neck into an S, then throws the head forward within two key steps.
ClipScript strike() {
    ClipScript clip{"Strike", 36, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 40}, {0.30, 74}, {0.42, 78}, {0.50, 8}, {0.60, 14}, {1.0, 40}}},
                   {rear, {{0.0, 30}, {0.30, 62}, {0.42, 64}, {0.50, 20}, {0.62, 24}, {1.0, 30}}},
                   {crest, {{0.0, 30}, {0.30, 74}, {0.42, 78}, {0.50, 22}, {0.62, 24}, {1.0, 30}}},
                   {jaw, {{0.0, 0}, {0.36, 4}, {0.46, 66}, {0.52, 12}, {0.64, 4}, {1.0, 0}}},
                   {head_pitch, {{0.0, 4}, {0.36, 2}, {0.46, -34}, {0.53, 8}, {1.0, 4}}},
                   {fangs, {{0.0, 0}, {0.38, 0}, {0.46, 70}, {0.58, 40}, {0.72, 0}, {1.0, 0}}},
                   {tail_lift, {{0.0, 0}, {0.30, -10}, {0.42, -10}, {0.60, 0}, {1.0, 0}}}};
    clip.waves = {};
    return clip;
}

ClipScript hit() {
    ClipScript clip{"Hit", 20, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 40}, {0.20, 64}, {0.60, 36}, {1.0, 40}}},
                   {rear, {{0.0, 30}, {0.20, 10}, {0.60, 36}, {1.0, 30}}},
                   {crest, {{0.0, 30}, {0.20, 22}, {1.0, 30}}},
                   {coil_front, {{0.0, 0}, {0.18, -70}, {0.55, 18}, {1.0, 0}}},
                   {head_yaw, {{0.0, 0}, {0.18, -95}, {0.55, 20}, {1.0, 0}}},
                   {jaw, {{0.0, 0}, {0.15, 34}, {0.60, 0}, {1.0, 0}}},
                   {head_pitch, {{0.0, 4}, {0.15, -16}, {1.0, 4}}},
                   {coil_back, {{0.0, 0}, {0.25, 50}, {1.0, 0}}}};
    return clip;
}

// Swallows: the jaws walk over the prey, side by side.
ClipScript eat() {
    ClipScript clip{"Eat", 75, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 40}}}, {rear, {{0.0, 12}}}, {crest, {{0.0, 14}}}, {jaw, {{0.0, 20}}}};
    clip.waves = {{jaw, 14.0, 5, 0.0},
                  {head_yaw, 12.0, 5, 0.25},
                  {head_roll, 12.0, 5, 0.25},
                  {body_z, 0.006, 5, 0.0},
                  {coil_front, 6.0, 5, 0.3}};
    return clip;
}

// Writhes, rolls over and lies with its belly up.
ClipScript die() {
    ClipScript clip{"Die", 48, Ending::once, {}, {}, {}, 0.0};
    clip.tracks = {{swing, {{0.0, 40}, {0.20, 70}, {0.45, 20}, {0.80, 30}}},
                   {coil_back, {{0.0, 0}, {0.22, 160}, {0.45, -140}, {0.80, -60}}},
                   {coil_front, {{0.0, 0}, {0.22, -120}, {0.45, 140}, {0.80, 70}}},
                   {rear, {{0.0, 30}, {0.20, 48}, {0.60, 0}}},
                   {crest, {{0.0, 30}, {0.20, 40}, {0.60, 0}}},
                   {body_roll, {{0.0, 0}, {0.45, 40}, {0.80, 176}}},
                   {body_y, {{0.0, 0}, {0.20, 0.02}, {0.60, 0.03}, {0.80, 0.0}}},
                   {head_yaw, {{0.0, 0}, {0.22, -90}, {0.45, 110}, {0.80, 84}}},
                   {jaw, {{0.0, 0}, {0.20, 40}, {0.45, 8}, {0.85, 22}}}};
    return clip;
}

}  // namespace

std::vector<ClipScript> snake_scripts() {
    return {idle(), crawl(), slither(), coil(), rise(), sleep(), strike(), hit(), eat(), die()};
}

}  // namespace posepack::menagerie
