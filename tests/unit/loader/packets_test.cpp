// SPDX-License-Identifier: MIT
// Packets: the laws of shaders, evaluated here in binary32, against the tracks that the packets were made of.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "played.hpp"

namespace posepack::test {
namespace {

using Packet = std::array<float, 8>;
constexpr double kDay = 86400.0;
constexpr float kClock = static_cast<float>(POSEPACK_CLOCK_S);

float fract(float x) {
    return x - std::floor(x);
}

// The law of docs/time.md as a shader has it; every operation rounds to binary32.
float shader_phase(std::uint32_t wrap, float cycles) {
    if (wrap == POSEPACK_WRAP_ONCE) return std::fmin(std::fmax(cycles, 0.f), 1.f);
    if (wrap == POSEPACK_WRAP_PING_PONG) return 1.f - std::fabs(1.f - 2.f * fract(cycles * 0.5f));
    return fract(cycles);
}

float shader_elapsed(float clock, float start) {
    const float elapsed = clock - start;
    return elapsed < 0.f ? elapsed + kClock : elapsed;
}

// The distance of two phases; those of a loop meet at its ends.
double phase_distance(std::uint32_t wrap, double a, double b) {
    const double off = std::abs(a - b);
    return wrap == POSEPACK_WRAP_LOOP ? std::min(off, 1.0 - off) : off;
}

// Bound of docs/time.md: of the clip's time, and of the packet's phase.
double phase_bound(double cycle_hz) {
    return std::abs(cycle_hz) * 3.0 * POSEPACK_CLOCK_S * 0x1p-24 + 0x1p-23;
}

posepack_track start(const Played& palette, double speed, double phase, double now_s,
                     std::uint32_t clip = kWalkClip) {
    posepack_track track{};
    EXPECT_EQ(posepack_start_track(&palette.view, clip, speed, phase, now_s, POSEPACK_CLOCK_S, &track),
              POSEPACK_OK);
    return track;
}

posepack_play play_of(const posepack_track& track) {
    posepack_play play{};
    EXPECT_EQ(posepack_start_play(&play, &track), POSEPACK_OK);
    return play;
}

struct Case {
    double speed, phase, start_s, time_s;
};

// Starts of every day of two months, looked at within the clock behind them or, loops, weeks later.
std::vector<Case> cases(std::uint32_t wrap, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Case> all;
    for (int i = 0; i < 20000; ++i) {
        Case c{6.0 * unit(random) - 3.0, unit(random), 60.0 * kDay * unit(random), 0.0};
        const bool may_stay = wrap != POSEPACK_WRAP_ONCE && i % 2 == 0;
        c.time_s = c.start_s + unit(random) * (may_stay ? 14.0 * kDay : 1000.0);
        all.push_back(c);
    }
    return all;
}

TEST(PlayPacket, GivesAShaderThePhaseOfTheTrack) {
    double worst = 0.0;
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 0.9f));
        for (const Case& c : cases(wrap, 31)) {
            const posepack_play play = play_of(start(palette, c.speed, c.phase, c.start_s));
            Packet p{};
            ASSERT_EQ(posepack_pack_play(&palette.view, &play, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
            EXPECT_EQ(p[0], 1.f);
            EXPECT_EQ(static_cast<double>(p[1]), play.now.cycle_hz);
            EXPECT_EQ(p[4], -1.f);
            const float elapsed = shader_elapsed(posepack_wrap_clock(c.time_s, POSEPACK_CLOCK_S), p[3]);
            const float phase = shader_phase(wrap, p[2] + p[1] * elapsed);
            const double expected = posepack_wrap_phase(wrap, posepack_count_cycles(&play.now, c.time_s));
            const double off = phase_distance(wrap, phase, expected);
            EXPECT_LE(off, phase_bound(play.now.cycle_hz)) << wrap << " " << c.speed << " " << c.time_s;
            worst = std::max(worst, off / std::max(std::abs(play.now.cycle_hz), 0.01));
        }
    }
    RecordProperty("worst_us", static_cast<int>(worst * 1e6));
    EXPECT_GT(worst, 1e-6);  // the bound is one
}

TEST(PlayPacket, CarriesAFade) {
    std::mt19937_64 random(37);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 1.9f));
        for (int i = 0; i < 5000; ++i) {
            const double begin = 30.0 * kDay * unit(random), change = begin + 100.0 * unit(random);
            const double fade_s = 2.0 * unit(random), time_s = change + 3.0 * unit(random);
            posepack_play play = play_of(start(palette, 2.0 * unit(random) - 1.0, unit(random), begin));
            const posepack_track next = start(palette, 2.0 * unit(random), unit(random), change);
            ASSERT_EQ(posepack_fade_play(&play, &next, fade_s), POSEPACK_OK);
            Packet p{};
            ASSERT_EQ(posepack_pack_play(&palette.view, &play, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
            const float elapsed = shader_elapsed(posepack_wrap_clock(time_s, POSEPACK_CLOCK_S), p[3]);
            const float factor = elapsed < p[7] ? elapsed / p[7] : 1.f;
            posepack_moment moment{};
            ASSERT_EQ(posepack_find_moment(&palette.view, &play, time_s, &moment), POSEPACK_OK);
            EXPECT_NEAR(factor, moment.factor, 2e-4 / fade_s);
            EXPECT_LE(phase_distance(wrap, shader_phase(wrap, p[2] + p[1] * elapsed), moment.phase),
                      phase_bound(play.now.cycle_hz));
            if (moment.before == POSEPACK_NONE) continue;
            EXPECT_EQ(p[4], 1.f);
            EXPECT_LE(phase_distance(wrap, shader_phase(wrap, p[6] + p[5] * elapsed), moment.before_phase),
                      phase_bound(play.before.cycle_hz));
        }
    }
}

TEST(PlayPacket,
     GivesAShaderTheMomentBefore) {  // docs/time.md, section 5: elapsed - frame, or the clip before
    std::mt19937_64 random(53);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double frame_s = 1.0 / 60.0;
    int looked_before = 0;
    for (const std::uint32_t wrap : {POSEPACK_WRAP_LOOP, POSEPACK_WRAP_PING_PONG}) {
        const Played palette(walk_of(wrap, 0.8f));
        for (int i = 0; i < 20000; ++i) {
            const double change = 30.0 * kDay * unit(random), time_s = change + 0.05 * unit(random);
            posepack_play play = play_of(start(palette, 2.0 * unit(random) - 1.0, unit(random), change));
            if (i % 3 != 0) {
                play = play_of(start(palette, 2.0 * unit(random) - 1.0, unit(random), change - 9.0));
                const posepack_track next = start(palette, 2.0 * unit(random) - 1.0, unit(random), change);
                ASSERT_EQ(posepack_fade_play(&play, &next, i % 3 == 1 ? 0.0 : 1.0), POSEPACK_OK);
            }
            Packet p{};
            ASSERT_EQ(posepack_pack_play(&palette.view, &play, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
            const float elapsed = shader_elapsed(posepack_wrap_clock(time_s, POSEPACK_CLOCK_S), p[3]) -
                                  static_cast<float>(frame_s);
            if (std::abs(elapsed) < 1e-4f) continue;  // a unit of the clock: before or after the start
            float phase = shader_phase(wrap, p[2] + p[1] * std::fmax(elapsed, 0.f));
            if (elapsed < 0.f && p[4] >= 0.f) phase = shader_phase(wrap, p[6] + p[5] * elapsed);
            posepack_moment moment{};
            ASSERT_EQ(posepack_find_moment(&palette.view, &play, time_s - frame_s, &moment), POSEPACK_OK);
            EXPECT_LE(phase_distance(wrap, phase, moment.phase),
                      phase_bound(std::max(std::abs(play.now.cycle_hz), std::abs(play.before.cycle_hz))));
            looked_before += elapsed < 0.f ? 1 : 0;
        }
    }
    EXPECT_GT(looked_before, 5000);
}

TEST(PlayPacket, HoldsAClipThatHasEnded) {
    const Played palette(walk_of(POSEPACK_WRAP_ONCE, 1.f));
    posepack_play play = play_of(start(palette, -1.0, 1.0, 10.0));
    const posepack_track next = start(palette, 1.0, 0.0, 400.0);
    ASSERT_EQ(posepack_fade_play(&play, &next, 1.0), POSEPACK_OK);
    Packet p{};
    ASSERT_EQ(posepack_pack_play(&palette.view, &play, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p, (Packet{1.f, 1.f, 0.f, 400.f, 1.f, 0.f, 0.f, 1.f}));
    play.before = start(palette, 1.0, 0.0, 10.0);
    ASSERT_EQ(posepack_pack_play(&palette.view, &play, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p, (Packet{1.f, 1.f, 0.f, 400.f, 1.f, 0.f, 1.f, 1.f}));
}

TEST(PlayPacket, StartsAtZeroWhereTheFloatWouldBeTheWholeClock) {
    const Played palette(walk_of(POSEPACK_WRAP_LOOP, 1.f));
    const double late_s = POSEPACK_CLOCK_S * (1.0 - 0x1p-40);
    const posepack_play play = play_of(start(palette, 1.0, 1.0 - 0x1p-40, late_s));
    Packet p{};
    ASSERT_EQ(posepack_pack_play(&palette.view, &play, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p[3], 0.f);
    EXPECT_LT(p[2], 1.f);
    EXPECT_EQ(posepack_wrap_clock(late_s, POSEPACK_CLOCK_S), 0.f);
}

TEST(HalvesPacket, SurvivesSixteenBits) {
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 0.9f));
        for (const Case& c : cases(wrap, 41)) {
            posepack_play play = play_of(start(palette, c.speed, c.phase, c.start_s));
            const posepack_track next = start(palette, -c.speed, c.phase, c.start_s + 5.0);
            ASSERT_EQ(posepack_fade_play(&play, &next, 3.0), POSEPACK_OK);
            const double time_s = c.time_s + 5.0;
            Packet p{};
            ASSERT_EQ(posepack_pack_halves(&palette.view, &play, time_s, POSEPACK_CLOCK_S, p.data()),
                      POSEPACK_OK);
            for (const float number : p) EXPECT_EQ(half(number), number);
            const float elapsed =
                shader_elapsed(posepack_wrap_clock(time_s, POSEPACK_CLOCK_S), p[3] * (kClock / 2048.f));
            posepack_moment moment{};
            ASSERT_EQ(posepack_find_moment(&palette.view, &play, time_s, &moment), POSEPACK_OK);
            EXPECT_NEAR(p[7], moment.factor, 0x1p-11);
            // Phases in 2048ths; those of once and ping-pong may lie outside 0 to 1, where halves are
            // coarser.
            const double coarse = wrap == POSEPACK_WRAP_LOOP ? 0x1p-12 : 1.5 * 0x1p-11;
            EXPECT_LE(phase_distance(wrap, shader_phase(wrap, p[2] / 2048.f + p[1] * (elapsed / kClock)),
                                     moment.phase),
                      coarse + phase_bound(next.cycle_hz));
            if (moment.before == POSEPACK_NONE) continue;
            EXPECT_EQ(p[4], 1.f);
            EXPECT_LE(phase_distance(wrap, shader_phase(wrap, p[6] / 2048.f + p[5] * (elapsed / kClock)),
                                     moment.before_phase),
                      coarse + phase_bound(next.cycle_hz));
        }
    }
    const Played palette(walk_of(POSEPACK_WRAP_LOOP, 1.f));  // 2047.9 of 2048: the first phase again
    const posepack_play play = play_of(start(palette, 1.0, 0.9999, 0.0));
    Packet p{};
    ASSERT_EQ(posepack_pack_halves(&palette.view, &play, 0.0, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p, (Packet{1.f, 1024.f, 0.f, 0.f, -1.f, 0.f, 0.f, 1.f}));
}

TEST(HalvesPacket, RefusesWhatDoesNotSurvive) {
    RunOptions many = tiny_runs();
    many.clips.resize(2052, many.clips[0]);
    const Played palette(make_run_parts(many));
    Packet p{};
    const auto pack = [&](std::uint32_t clip, std::uint32_t before, double hz) {
        posepack_play play = play_of(start(palette, 1.0, 0.0, 0.0));
        play.before = play.now;
        play.now.clip = clip;
        play.before.clip = before;
        play.now.cycle_hz = hz;
        return posepack_pack_halves(&palette.view, &play, 0.0, POSEPACK_CLOCK_S, p.data());
    };
    EXPECT_EQ(pack(2048, POSEPACK_NONE, 1.0), POSEPACK_OK);
    EXPECT_EQ(pack(2050, POSEPACK_NONE, 1.0), POSEPACK_OK);
    EXPECT_EQ(pack(2049, POSEPACK_NONE, 1.0), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(pack(5, 2049, 1.0), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(pack(5, 6, 2049.0 / 1024.0), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(pack(5, 6, 2048.0 / 1024.0), POSEPACK_OK);
    EXPECT_EQ(pack(5, 6, 65536.0 / 1024.0), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(pack(5, 9999, 1.0), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(pack(9999, 5, 1.0), POSEPACK_ERROR_INDEX);
}

// Rows of the texture that a shader of others shows: two and the share of the second.
struct Shown {
    double row0, row1, factor;
};

Shown published_shader(const Packet& p, float clock) {
    const float row = std::fmod(clock * p[2] + p[3] * p[1], p[1]);
    const float wrapped = row < 0.f ? row + p[1] : row;
    const float whole = std::fmin(std::floor(wrapped), p[1] - 1.f);
    return {static_cast<double>(p[0] + whole), static_cast<double>(p[0] + std::fmod(whole + 1.f, p[1])),
            static_cast<double>(wrapped - whole)};
}

TEST(RowsPacket, ShowsInThePublishedShaderWhatTheLoaderShows) {
    const Played palette(walk_of(POSEPACK_WRAP_LOOP, 0.9f));  // rows 1 to 4 of the texture
    for (const Case& c : cases(POSEPACK_WRAP_LOOP, 43)) {
        const posepack_track track = start(palette, c.speed, c.phase, c.start_s);
        Packet p{};
        ASSERT_EQ(posepack_pack_rows(&palette.view, &track, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
        EXPECT_EQ(p[0], 1.f);
        EXPECT_EQ(p[1], 4.f);
        const Shown shown = published_shader(p, posepack_wrap_clock(c.time_s, POSEPACK_CLOCK_S));
        posepack_place place{};
        ASSERT_EQ(
            posepack_find_place(
                &palette.view, kWalkClip,
                posepack_wrap_phase(POSEPACK_WRAP_LOOP, posepack_count_cycles(&track, c.time_s)), 0, &place),
            POSEPACK_OK);
        const double expected = (static_cast<double>(place.row0) + static_cast<double>(place.factor)) / 4.0;
        EXPECT_LE(phase_distance(POSEPACK_WRAP_LOOP, (shown.row0 - 1.0 + shown.factor) / 4.0, expected),
                  phase_bound(track.cycle_hz) * 4.0);
        EXPECT_EQ(shown.row1, shown.row0 == 4.0 ? 1.0 : shown.row0 + 1.0);
    }
    const posepack_track still = start(palette, 1.0, 0.5, 0.0, kIdleClip);  // one row
    Packet p{};
    ASSERT_EQ(posepack_pack_rows(&palette.view, &still, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p, (Packet{0.f, 1.f, 0.f, 0.f}));
    EXPECT_EQ(published_shader(p, 1000.f).row0, 0.0);
    const Played once(walk_of(POSEPACK_WRAP_ONCE, 0.5f));  // three intervals of four rows
    const posepack_track half_way = start(once, 0.0, 0.5, 0.0);
    ASSERT_EQ(posepack_pack_rows(&once.view, &half_way, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p, (Packet{1.f, 4.f, 0.f, 0.375f}));
}

// Babylon.js counts every row in the first pass, and leaves out the first from the second on.
double babylon_row(const Packet& p, double time_s) {
    const double rows = static_cast<double>(p[1]) - static_cast<double>(p[0]) + 1.0;
    const double passes = time_s * static_cast<double>(p[3]) / rows;
    const double left_out = passes < 1.0 ? 0.0 : 1.0, counted = rows - left_out;
    const double along = (passes - std::floor(passes)) * counted + static_cast<double>(p[2]);
    return std::floor(std::fmod(along, counted)) + static_cast<double>(p[0]) + left_out;
}

TEST(BabylonPacket, ShowsTheRowsOfTheClipInItsPeriod) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    options.closing_row = true;
    const Played closed(walk_of(POSEPACK_WRAP_LOOP, 0.75f, options));  // rows 1 to 3, closed by row 4
    posepack_track track = start(closed, 1.0, 0.0, 0.0);
    Packet p{};
    ASSERT_EQ(posepack_pack_babylon(&closed.view, &track, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p[0], 1.f);
    EXPECT_EQ(p[1], 4.f);
    const double hz = track.cycle_hz;
    for (int pass = 1; pass < 50; ++pass)  // rows 2, 3, 4 = 1
        for (int row = 0; row < 3; ++row)
            EXPECT_EQ(babylon_row(p, (pass + (row + 0.5) / 3.0) / hz), row + 2.0);
    track = start(closed, 1.0, 1.0 / 3.0, 0.0);  // one row further
    ASSERT_EQ(posepack_pack_babylon(&closed.view, &track, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_FLOAT_EQ(p[2], 1.f);
    for (int row = 0; row < 3; ++row)
        EXPECT_EQ(babylon_row(p, (7 + (row + 0.5) / 3.0) / hz), (row + 1) % 3 + 2.0);
    const Played open(walk_of(POSEPACK_WRAP_LOOP, 1.f));
    track = start(open, 2.0, 0.0, 0.0);
    ASSERT_EQ(posepack_pack_babylon(&open.view, &track, POSEPACK_CLOCK_S, p.data()), POSEPACK_OK);
    EXPECT_EQ(p, (Packet{1.f, 4.f, 0.f, 8.f}));
}

// Godot's plugin goes from the first row to the one before the end row, and starts again.
double godot_row(const Packet& p, float fps, double time_s) {
    const double rows = static_cast<double>(p[2]) - 1.0 - static_cast<double>(p[1]);
    const double passes = time_s * static_cast<double>(fps) / rows;
    return static_cast<double>(p[1]) +
           std::fmod((passes - std::floor(passes)) * rows + rows * static_cast<double>(p[0]), rows);
}

TEST(GodotPacket, ShowsTheRowsOfTheClipInItsPeriod) {
    const Played once(walk_of(POSEPACK_WRAP_ONCE, 0.75f));
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    options.closing_row = true;
    const Played closed(walk_of(POSEPACK_WRAP_LOOP, 0.75f, options));
    Packet p{};
    float fps = 0.f;
    for (const Played* palette : {&once, &closed}) {
        const posepack_track track = start(*palette, 1.0, 0.25, 0.0);
        ASSERT_EQ(posepack_pack_godot(&palette->view, &track, POSEPACK_CLOCK_S, p.data(), &fps), POSEPACK_OK);
        for (double t = 0.0; t < 200.0; t += 0.1) {
            const double cycles = posepack_count_cycles(&track, t);
            const double off = std::abs(godot_row(p, fps, t) - 1.0 - 3.0 * (cycles - std::floor(cycles)));
            EXPECT_LT(std::min(off, 3.0 - off), 1e-3) << t;
        }
        EXPECT_EQ(p[3], 1.f);
    }
    const Played open(walk_of(POSEPACK_WRAP_LOOP, 1.f));
    const posepack_track track = start(open, 1.0, 0.25, 0.0);
    ASSERT_EQ(posepack_pack_godot(&open.view, &track, POSEPACK_CLOCK_S, p.data(), &fps), POSEPACK_OK);
    EXPECT_EQ(p, (Packet{0.25f, 1.f, 5.f, 1.f}));
    EXPECT_EQ(fps, 3.f);
}

std::uint32_t breaks_of(const Played& palette, const posepack_play& play, std::uint32_t layout,
                        std::uint32_t float_bits = 32, std::uint32_t max_side = 0) {
    const posepack_limits limits = {float_bits, max_side, POSEPACK_CLOCK_S};
    std::uint32_t breaks = 0xFFFF;
    EXPECT_EQ(posepack_check_packet(&palette.view, &play, layout, &limits, &breaks), POSEPACK_OK);
    return breaks;
}

TEST(Check, NamesWhatALayoutBreaks) {
    TinyOptions mat4;
    mat4.encoding = POSEPACK_ENCODING_MAT4;
    const Played good(walk_of(POSEPACK_WRAP_LOOP, 1.f, mat4));
    const posepack_play play = play_of(start(good, 1.0, 0.25, 0.0));
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_PLAY), 0u);
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_HALVES), 0u);
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_ROWS), 0u);
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_BABYLON),
              std::uint32_t{POSEPACK_BREAK_SEAM | POSEPACK_BREAK_BLEND});
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_GODOT), std::uint32_t{POSEPACK_BREAK_SEAM});
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_ROWS, 32, 12), 0u);
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_ROWS, 32, 11), std::uint32_t{POSEPACK_BREAK_TEXTURE});
    EXPECT_EQ(breaks_of(good, play, POSEPACK_LAYOUT_ROWS, 32, 4), std::uint32_t{POSEPACK_BREAK_TEXTURE});
    EXPECT_EQ(breaks_of(good, play_of(start(good, 1.0, 0.0, 0.0, kIdleClip)), POSEPACK_LAYOUT_BABYLON), 0u);

    for (const TinyOptions& options :
         {TinyOptions{}, TinyOptions{POSEPACK_ENCODING_MAT4, POSEPACK_TEXEL_RGBA16F, POSEPACK_ORDER_PLANAR},
          TinyOptions{POSEPACK_ENCODING_MAT4, POSEPACK_TEXEL_RGBA16F, POSEPACK_ORDER_BONE_MAJOR, 2}}) {
        const Played palette(walk_of(POSEPACK_WRAP_LOOP, 1.f, options));
        EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_ROWS), std::uint32_t{POSEPACK_BREAK_FORM});
    }
    for (const std::uint32_t wrap : {POSEPACK_WRAP_ONCE, POSEPACK_WRAP_PING_PONG}) {
        const Played palette(walk_of(wrap, 1.f, mat4));
        EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_ROWS), std::uint32_t{POSEPACK_BREAK_WRAP});
        EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_GODOT), std::uint32_t{POSEPACK_BREAK_WRAP});
    }
    TinyOptions closing;
    closing.encoding = POSEPACK_ENCODING_DUALQUAT;
    closing.closing_row = true;
    const Played closed(walk_of(POSEPACK_WRAP_LOOP, 1.f, closing));
    EXPECT_EQ(breaks_of(closed, play, POSEPACK_LAYOUT_ROWS),
              std::uint32_t{POSEPACK_BREAK_FORM | POSEPACK_BREAK_SEAM});
    EXPECT_EQ(breaks_of(closed, play, POSEPACK_LAYOUT_GODOT), std::uint32_t{POSEPACK_BREAK_FORM});

    const Played cut(make_parts(mat4));
    const posepack_play cut_play = play_of(start(cut, 1.0, 0.25, 0.0));
    EXPECT_EQ(breaks_of(cut, cut_play, POSEPACK_LAYOUT_ROWS), std::uint32_t{POSEPACK_BREAK_HOLD});
    Parts steps = walk_of(POSEPACK_WRAP_LOOP, 1.f, mat4);
    steps[kClip][kWalk + POSEPACK_CLIP_INTERPOLATION] = POSEPACK_INTERPOLATION_STEP;
    const Played held(steps);
    EXPECT_EQ(breaks_of(held, play, POSEPACK_LAYOUT_ROWS), std::uint32_t{POSEPACK_BREAK_HOLD});
    EXPECT_EQ(breaks_of(held, play, POSEPACK_LAYOUT_BABYLON), std::uint32_t{POSEPACK_BREAK_SEAM});

    const Played runs(make_run_parts(tiny_runs()));
    EXPECT_EQ(breaks_of(runs, play, POSEPACK_LAYOUT_ROWS, 16),
              std::uint32_t{POSEPACK_BREAK_ROWS | POSEPACK_BREAK_FORM});
    EXPECT_EQ(breaks_of(runs, play, POSEPACK_LAYOUT_PLAY, 16), 0u);
    const Played high(make_run_parts(many_runs(2, 500)));  // 9,018 texels in lines of 64
    EXPECT_EQ(breaks_of(high, play, POSEPACK_LAYOUT_PLAY, 32, 100), std::uint32_t{POSEPACK_BREAK_TEXTURE});
    EXPECT_EQ(breaks_of(high, play, POSEPACK_LAYOUT_PLAY, 32, 4096), 0u);

    posepack_play fading = play;
    ASSERT_EQ(posepack_fade_play(&fading, &play.now, 0.0), POSEPACK_OK);
    EXPECT_EQ(breaks_of(good, fading, POSEPACK_LAYOUT_ROWS), 0u);
    fading.fade_s = 1.0;
    EXPECT_EQ(breaks_of(good, fading, POSEPACK_LAYOUT_ROWS), std::uint32_t{POSEPACK_BREAK_FADE});
    EXPECT_EQ(breaks_of(good, fading, POSEPACK_LAYOUT_PLAY), 0u);

    posepack_play odd = play;
    odd.now.cycle_hz = 1.00049;
    EXPECT_EQ(breaks_of(good, odd, POSEPACK_LAYOUT_ROWS), std::uint32_t{POSEPACK_BREAK_RATE});
    const Played once(walk_of(POSEPACK_WRAP_ONCE, 1.f, mat4));
    EXPECT_EQ(breaks_of(once, odd, POSEPACK_LAYOUT_PLAY), 0u);  // it ends before the clock does
    const Played swing(walk_of(POSEPACK_WRAP_PING_PONG, 1.f, mat4));
    odd.now.cycle_hz = 1025.0 / 1024.0;  // half a way to and fro is left over
    EXPECT_EQ(breaks_of(swing, odd, POSEPACK_LAYOUT_PLAY), std::uint32_t{POSEPACK_BREAK_RATE});
}

TEST(Check, NamesWhatSixteenBitsBreak) {
    TinyOptions mat4;
    mat4.encoding = POSEPACK_ENCODING_MAT4;
    const Played palette(walk_of(POSEPACK_WRAP_LOOP, 1.f, mat4));
    posepack_play play = play_of(start(palette, 1.0, 0.25, 0.0));
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_ROWS, 16), 0u);
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_PLAY, 16), 0u);
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_GODOT, 16), std::uint32_t{POSEPACK_BREAK_SEAM});
    play.now.start_s = 1000.3;  // a quarter of a second off
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_PLAY, 16), std::uint32_t{POSEPACK_BREAK_PHASE});
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_HALVES, 16), 0u);
    play.now.cycle_hz = 8.0 / 1024.0;  // a clip so slow that it does not matter
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_PLAY, 16), 0u);
    play.now.start_s = 0.0;
    play.now.cycle_hz = 1025.0 / 1024.0;  // survives; times four rows as well
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_ROWS, 16), 0u);
    play.now.cycle_hz = 2049.0 / 1024.0;
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_ROWS, 32), 0u);
    for (const std::uint32_t layout : {POSEPACK_LAYOUT_ROWS, POSEPACK_LAYOUT_PLAY, POSEPACK_LAYOUT_HALVES})
        EXPECT_EQ(breaks_of(palette, play, layout, 16), std::uint32_t{POSEPACK_BREAK_RATE});
    EXPECT_EQ(breaks_of(palette, play, POSEPACK_LAYOUT_HALVES, 32), std::uint32_t{POSEPACK_BREAK_RATE});
    EXPECT_TRUE(breaks_of(palette, play, POSEPACK_LAYOUT_BABYLON, 16) & POSEPACK_BREAK_RATE);

    // Bytes that change once they are open: a clip of other rows, which nobody samples here.
    Played tall(walk_of(POSEPACK_WRAP_LOOP, 1.f, mat4));
    const std::size_t walk = section_offset(tall.bytes, kClip) + kWalk;
    posepack_play quick = play_of(start(tall, 1.0, 0.9, 0.0));
    for (const auto& [row, breaks] : {std::pair{2048u, 0u}, std::pair{2049u, POSEPACK_BREAK_INDEX},
                                      std::pair{2050u, 0u}, std::pair{4097u, POSEPACK_BREAK_INDEX}}) {
        put_u32(tall.bytes, walk + POSEPACK_CLIP_FIRST_ROW, row);
        EXPECT_EQ(breaks_of(tall, quick, POSEPACK_LAYOUT_ROWS, 16), breaks) << row;
        EXPECT_EQ(breaks_of(tall, quick, POSEPACK_LAYOUT_ROWS, 32), 0u) << row;
        EXPECT_EQ(breaks_of(tall, quick, POSEPACK_LAYOUT_PLAY, 16), 0u) << row;
    }
    put_u32(tall.bytes, walk + POSEPACK_CLIP_FIRST_ROW, 0);
    put_u32(tall.bytes, walk + POSEPACK_CLIP_ROW_COUNT, 1024);  // a quarter of a row off, and more
    EXPECT_EQ(breaks_of(tall, quick, POSEPACK_LAYOUT_ROWS, 16), std::uint32_t{POSEPACK_BREAK_PHASE});
    EXPECT_EQ(breaks_of(tall, quick, POSEPACK_LAYOUT_HALVES, 16), std::uint32_t{POSEPACK_BREAK_PHASE});
    EXPECT_EQ(breaks_of(tall, quick, POSEPACK_LAYOUT_BABYLON, 16),
              std::uint32_t{POSEPACK_BREAK_PHASE | POSEPACK_BREAK_SEAM | POSEPACK_BREAK_BLEND});
}

TEST(Packets, RefuseWrongArguments) {
    const Played palette(make_parts());
    const posepack_view& view = palette.view;
    const posepack_track track = start(palette, 1.0, 0.0, 0.0);
    const posepack_play play = play_of(track);
    Packet p{};
    float fps = 0.f;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double clock_s : {0.0, -1.0, nan, infinity}) {
        EXPECT_EQ(posepack_pack_play(&view, &play, clock_s, p.data()), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_pack_halves(&view, &play, 0, clock_s, p.data()), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_pack_rows(&view, &track, clock_s, p.data()), POSEPACK_ERROR_ARG);
    }
    EXPECT_EQ(posepack_pack_play(nullptr, &play, 1, p.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_pack_play(&view, nullptr, 1, p.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_pack_play(&view, &play, 1, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_pack_halves(nullptr, &play, 0, 1, p.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_pack_halves(&view, nullptr, 0, 1, p.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_pack_halves(&view, &play, 0, 1, nullptr), POSEPACK_ERROR_ARG);
    for (const auto pack : {posepack_pack_rows, posepack_pack_babylon}) {
        EXPECT_EQ(pack(nullptr, &track, 1, p.data()), POSEPACK_ERROR_ARG);
        EXPECT_EQ(pack(&view, nullptr, 1, p.data()), POSEPACK_ERROR_ARG);
        EXPECT_EQ(pack(&view, &track, 1, nullptr), POSEPACK_ERROR_ARG);
    }
    EXPECT_EQ(posepack_pack_godot(&view, &track, 1, p.data(), nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_pack_godot(&view, &track, 1, nullptr, &fps), POSEPACK_ERROR_ARG);
    const Played runs(make_run_parts(tiny_runs()));
    EXPECT_EQ(posepack_pack_rows(&runs.view, &track, 1, p.data()), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(posepack_pack_babylon(&runs.view, &track, 1, p.data()), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(posepack_pack_godot(&runs.view, &track, 1, p.data(), &fps), POSEPACK_ERROR_UNSUPPORTED);
    posepack_play bad = play;
    bad.before.clip = 2;
    EXPECT_EQ(posepack_pack_play(&view, &bad, 1, p.data()), POSEPACK_ERROR_INDEX);
    bad.now.clip = 2;
    EXPECT_EQ(posepack_pack_play(&view, &bad, 1, p.data()), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_pack_rows(&view, &bad.now, 1, p.data()), POSEPACK_ERROR_INDEX);

    posepack_limits limits = {32, 0, 1024.0};
    std::uint32_t breaks = 0;
    const auto check = [&](const posepack_play* of, std::uint32_t layout) {
        return posepack_check_packet(&view, of, layout, &limits, &breaks);
    };
    EXPECT_EQ(check(&play, POSEPACK_LAYOUT_GODOT), POSEPACK_OK);
    EXPECT_EQ(check(&play, POSEPACK_LAYOUT_GODOT + 1), POSEPACK_ERROR_ARG);
    EXPECT_EQ(check(nullptr, 0), POSEPACK_ERROR_ARG);
    EXPECT_EQ(check(&bad, 0), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_check_packet(&view, &play, 0, nullptr, &breaks), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_check_packet(&view, &play, 0, &limits, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_check_packet(nullptr, &play, 0, &limits, &breaks), POSEPACK_ERROR_ARG);
    limits.float_bits = 24;
    EXPECT_EQ(check(&play, 0), POSEPACK_ERROR_ARG);
    limits = {16, 0, 0.0};
    EXPECT_EQ(check(&play, 0), POSEPACK_ERROR_ARG);
}

}  // namespace
}  // namespace posepack::test
