// SPDX-License-Identifier: MIT
// The clips of insects, spiders and crabs, as rows of data.
#include <algorithm>

#include "menagerie/crawler.hpp"

namespace posepack::menagerie {
namespace {

using namespace crawler_channel;

// Every second leg of a side steps with the other side's between: three or four feet always stand.
Gait alternating(const CrawlerShape& shape, double duty, double stroke, double lift) {
    Gait gait{duty, stroke * shape.stride, lift, {}};
    for (int pair = 0; pair < shape.leg_pairs; ++pair) {
        for (int side = 0; side < 2; ++side) {
            gait.offsets.push_back((pair + side) % 2 * 0.5 + 0.03 * pair);
        }
    }
    return gait;
}

ClipScript idle() {
    ClipScript clip{"Idle", 96, Ending::closed, {}, {}, {}, 0.0};
    clip.waves = {{body_y, 0.012, 2, 0.0},       {abdomen_pitch, 4.0, 2, 0.2}, {jaw, 5.0, 4, 0.0},
                  {antenna_pitch, 12.0, 3, 0.0}, {antenna_yaw, 14.0, 2, 0.3},  {claw_lift, 5.0, 2, 0.1},
                  {claw_open, 6.0, 4, 0.0}};
    clip.tracks = {{head_yaw, {{0.0, 0}, {0.3, 0}, {0.36, 14}, {0.55, 14}, {0.62, -8}, {0.8, 0}, {1.0, 0}}},
                   {front_left_y, {{0.0, 0}, {0.66, 0}, {0.72, 0.16}, {0.80, 0}, {1.0, 0}}}};
    return clip;
}

ClipScript walk(const CrawlerShape& shape) {
    ClipScript clip{"Walk", 24, Ending::closed, {}, {}, alternating(shape, 0.62, 0.30, 0.12), 0.0};
    clip.waves = {{body_y, 0.012, 2, 0.1},  {body_yaw, 2.5, 1, 0.0},      {abdomen_yaw, -6.0, 1, 0.1},
                  {head_yaw, -2.0, 1, 0.0}, {antenna_pitch, 9.0, 2, 0.0}, {claw_lift, 4.0, 2, 0.0}};
    return clip;
}

// One key short of closing.
ClipScript run(const CrawlerShape& shape) {
    ClipScript clip{"Run", 11, Ending::open, {}, {}, alternating(shape, 0.52, 0.38, 0.18), 0.0};
    clip.tracks = {{body_pitch, {{0.0, -3}}}, {antenna_pitch, {{0.0, -22}}}, {claw_lift, {{0.0, 14}}}};
    clip.waves = {{body_y, 0.022, 2, 0.1}, {body_yaw, 4.0, 1, 0.0}, {abdomen_yaw, -9.0, 1, 0.1}};
    return clip;
}

ClipScript eat() {
    ClipScript clip{"Eat", 72, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{body_pitch, {{0.0, 0}, {0.2, 9}, {0.8, 9}, {1.0, 0}}},
                   {head_pitch, {{0.0, 0}, {0.2, 16}, {0.8, 16}, {1.0, 0}}},
                   {claw_swing, {{0.0, 0}, {0.2, -12}, {0.5, -24}, {0.8, -12}, {1.0, 0}}}};
    clip.waves = {{jaw, 16.0, 9, 0.0},
                  {antenna_pitch, 14.0, 6, 0.0},
                  {claw_lift, -9.0, 3, 0.25},
                  {claw_open, 12.0, 6, 0.0}};
    return clip;
}

ClipScript threaten() {
    ClipScript clip{"Threaten", 48, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{body_pitch, {{0.0, 0}, {0.25, -22}, {0.75, -22}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.25, 0.10}, {0.75, 0.10}, {1.0, 0}}},
                   {abdomen_pitch, {{0.0, 0}, {0.25, 18}, {0.75, 18}, {1.0, 0}}},
                   {front_y, {{0.0, 0}, {0.22, 0.55}, {0.78, 0.55}, {1.0, 0}}},
                   {front_z, {{0.0, 0}, {0.22, 0.08}, {0.78, 0.08}, {1.0, 0}}},
                   {jaw, {{0.0, 0}, {0.25, 30}, {0.75, 30}, {1.0, 0}}},
                   {claw_lift, {{0.0, 0}, {0.25, 58}, {0.75, 58}, {1.0, 0}}},
                   {claw_open, {{0.0, 0}, {0.25, 30}, {0.75, 30}, {1.0, 0}}},
                   {wing_spread, {{0.0, 0}, {0.25, 0.6}, {0.75, 0.6}, {1.0, 0}}}};
    clip.waves = {{body_yaw, 4.0, 3, 0.0}, {claw_swing, 7.0, 4, 0.0}};
    return clip;
}

ClipScript sleep() {
    ClipScript clip{"Sleep", 90, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{body_y, {{0.0, -0.14}}},
                   {head_pitch, {{0.0, 12}}},
                   {abdomen_pitch, {{0.0, -6}}},
                   {antenna_pitch, {{0.0, 30}}},
                   {claw_lift, {{0.0, -8}}}};
    clip.waves = {{abdomen_pitch, 2.5, 2, 0.0}, {body_y, 0.006, 2, 0.1}};
    return clip;
}

// Rears, then strikes within three key steps.
ClipScript attack() {
    ClipScript clip{"Attack", 30, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{body_pitch, {{0.0, 0}, {0.30, -24}, {0.42, 14}, {0.60, 8}, {1.0, 0}}},
                   {body_z, {{0.0, 0}, {0.30, -0.14}, {0.42, 0.22}, {0.60, 0.16}, {1.0, 0}}},
                   {front_y, {{0.0, 0}, {0.28, 0.55}, {0.42, 0.06}, {0.50, 0}, {1.0, 0}}},
                   {front_z, {{0.0, 0}, {0.28, 0.02}, {0.42, 0.22}, {0.75, 0.22}, {1.0, 0}}},
                   {jaw, {{0.0, 0}, {0.30, 46}, {0.40, 44}, {0.46, -14}, {0.60, 6}, {1.0, 0}}},
                   {abdomen_pitch, {{0.0, 0}, {0.30, 16}, {0.42, -34}, {0.60, -20}, {1.0, 0}}},
                   {claw_lift, {{0.0, 0}, {0.28, 52}, {0.40, -12}, {0.60, 0}, {1.0, 0}}},
                   {claw_swing, {{0.0, 0}, {0.28, 24}, {0.40, -26}, {0.60, -10}, {1.0, 0}}},
                   {claw_open, {{0.0, 0}, {0.28, 62}, {0.38, 60}, {0.43, -4}, {1.0, 0}}},
                   {antenna_pitch, {{0.0, 0}, {0.28, -50}, {0.40, 40}, {0.60, 0}, {1.0, 0}}},
                   {wing_spread, {{0.0, 0}, {0.28, 1}, {0.60, 0.6}, {1.0, 0}}}};
    return clip;
}

ClipScript hit() {
    ClipScript clip{"Hit", 20, Ending::closed, {}, {}, {}, 0.0};
    clip.tracks = {{body_x, {{0.0, 0}, {0.18, -0.12}, {0.55, -0.03}, {1.0, 0}}},
                   {body_y, {{0.0, 0}, {0.20, -0.08}, {0.55, 0.02}, {1.0, 0}}},
                   {body_roll, {{0.0, 0}, {0.18, 14}, {0.50, -4}, {1.0, 0}}},
                   {body_yaw, {{0.0, 0}, {0.18, -12}, {0.55, 4}, {1.0, 0}}},
                   {abdomen_yaw, {{0.0, 0}, {0.18, 22}, {0.55, -6}, {1.0, 0}}},
                   {jaw, {{0.0, 0}, {0.16, 34}, {0.6, 0}, {1.0, 0}}},
                   {antenna_pitch, {{0.0, 0}, {0.14, -62}, {0.45, 22}, {1.0, 0}}},
                   {claw_lift, {{0.0, 0}, {0.16, 30}, {0.6, 0}, {1.0, 0}}}};
    return clip;
}

// Tips onto its back and draws its legs in.
ClipScript die(const CrawlerShape& shape) {
    ClipScript clip{"Die", 45, Ending::once, {}, {}, {}, 0.0};
    const double drop = (shape.body_height - shape.abdomen_depth * 1.05) / shape.leg_span;
    const double low = -std::max(0.0, drop);
    clip.tracks = {{body_roll, {{0.0, 0}, {0.18, 16}, {0.55, 176}, {0.66, 168}, {0.76, 174}}},
                   {body_y, {{0.0, 0}, {0.28, 0.30}, {0.58, low}, {0.64, low + 0.02}, {0.70, low}}},
                   {body_z, {{0.0, 0}, {0.50, -0.06}}},
                   {follow, {{0.0, 0}, {0.12, 0}, {0.32, 1}}},
                   {legs_curl, {{0.0, 0}, {0.45, 0.1}, {0.60, 0.35}, {0.78, 1}, {0.84, 0.9}, {0.92, 1}}},
                   {abdomen_pitch, {{0.0, 0}, {0.40, -14}, {0.80, 8}}},
                   {antenna_pitch, {{0.0, 0}, {0.40, -30}, {0.80, 24}}},
                   {jaw, {{0.0, 0}, {0.25, 30}, {0.80, 12}}},
                   {claw_lift, {{0.0, 0}, {0.40, 40}, {0.80, -16}}}};
    return clip;
}

ClipScript fly() {
    ClipScript clip{"Fly", 24, Ending::closed, {}, {}, {}, 14.0};
    clip.tracks = {{wing_spread, {{0.0, 1}}},  {body_y, {{0.0, 1.4}}},    {follow, {{0.0, 1}}},
                   {legs_curl, {{0.0, 0.55}}}, {body_pitch, {{0.0, 10}}}, {antenna_pitch, {{0.0, -16}}}};
    clip.waves = {{wing_flap, 52.0, 6, 0.0}, {body_y, 0.05, 1, 0.0}, {abdomen_pitch, 5.0, 1, 0.2}};
    return clip;
}

}  // namespace

std::vector<ClipScript> crawler_scripts(const CrawlerShape& shape) {
    std::vector<ClipScript> scripts = {idle(),  walk(shape), run(shape), eat(),     threaten(),
                                       sleep(), attack(),    hit(),      die(shape)};
    if (shape.flies) scripts.push_back(fly());
    return scripts;
}

}  // namespace posepack::menagerie
