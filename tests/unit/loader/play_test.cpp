// SPDX-License-Identifier: MIT
// The time law, tracks, plays and passed marks, against naive evaluations in long double.
#include "posepack/play.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "changes.hpp"
#include "played.hpp"

namespace posepack::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kDay = 86400.0;

// The law as docs/time.md has it, in long double.
long double naive_phase(std::uint32_t wrap, long double cycles) {
    const auto fract = [](long double x) { return x - std::floor(x); };
    if (wrap == POSEPACK_WRAP_ONCE) return std::clamp(cycles, 0.0L, 1.0L);
    if (wrap == POSEPACK_WRAP_PING_PONG) return 1.0L - std::abs(1.0L - 2.0L * fract(cycles / 2.0L));
    return fract(cycles);
}

posepack_track start(const posepack_view& view, double speed, double phase, double now_s,
                     double clock_s = POSEPACK_CLOCK_S, std::uint32_t clip = kWalkClip) {
    posepack_track track{};
    EXPECT_EQ(posepack_start_track(&view, clip, speed, phase, now_s, clock_s, &track), POSEPACK_OK);
    return track;
}

float phase_at(const posepack_view& view, const posepack_track& track, double time_s) {
    posepack_clip clip{};
    EXPECT_EQ(posepack_get_clip(&view, track.clip, &clip), POSEPACK_OK);
    return posepack_wrap_phase(clip.wrap, posepack_count_cycles(&track, time_s));
}

TEST(TimeLaw, IsTheNaiveOne) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 200000; ++i) {
        const double cycles = unit(random) * std::pow(10.0, 10.0 * unit(random));
        for (const std::uint32_t wrap : kWraps) {
            const auto expected = static_cast<float>(naive_phase(wrap, static_cast<long double>(cycles)));
            const float phase = posepack_wrap_phase(wrap, cycles);
            if (wrap == POSEPACK_WRAP_LOOP) {
                EXPECT_LT(phase, 1.f);
                EXPECT_TRUE(phase == expected || (expected == 1.f && (phase == 0.f || phase > 0.9999999f)))
                    << cycles;
            } else {
                EXPECT_NEAR(phase, expected, 1e-15 + 0x1p-23 * static_cast<double>(expected)) << cycles;
            }
        }
    }
}

TEST(TimeLaw, HasAnAnswerForEveryNumber) {
    struct Answer {
        double cycles;
        float loop, once, ping_pong;
    };
    for (const Answer& a :
         {Answer{kNan, 0.f, 0.f, 0.f}, Answer{-kNan, 0.f, 0.f, 0.f}, Answer{kInf, 0.f, 1.f, 0.f},
          Answer{-kInf, 0.f, 0.f, 0.f}, Answer{0.0, 0.f, 0.f, 0.f}, Answer{-0.0, 0.f, 0.f, 0.f},
          Answer{1.0, 0.f, 1.f, 1.f}, Answer{2.0, 0.f, 1.f, 0.f}, Answer{-1.0, 0.f, 0.f, 1.f},
          Answer{-0.25, 0.75f, 0.f, 0.25f}, Answer{1.25, 0.25f, 1.f, 0.75f}, Answer{-1e-30, 0.f, 0.f, 0.f},
          Answer{1e300, 0.f, 1.f, 0.f}, Answer{-1e300, 0.f, 0.f, 0.f},
          Answer{1.0 - 0x1p-40, 0.99999994f, 1.f, 1.f}, Answer{4503599627370495.5, 0.5f, 1.f, 0.5f}}) {
        EXPECT_EQ(posepack_wrap_phase(POSEPACK_WRAP_LOOP, a.cycles), a.loop) << a.cycles;
        EXPECT_EQ(posepack_wrap_phase(POSEPACK_WRAP_ONCE, a.cycles), a.once) << a.cycles;
        EXPECT_EQ(posepack_wrap_phase(POSEPACK_WRAP_PING_PONG, a.cycles), a.ping_pong) << a.cycles;
        EXPECT_EQ(posepack_wrap_phase(77, a.cycles), a.loop) << a.cycles;
    }
}

TEST(TimeLaw, OfAWrappedClock) {
    EXPECT_EQ(posepack_wrap_clock(0.0, 1024.0), 0.f);
    EXPECT_EQ(posepack_wrap_clock(1025.5, 1024.0), 1.5f);
    EXPECT_EQ(posepack_wrap_clock(-0.5, 1024.0), 1023.5f);
    EXPECT_EQ(posepack_wrap_clock(3600.25, 3600.0), 0.25f);
    EXPECT_EQ(posepack_wrap_clock(1024.0 * (1.0 - 0x1p-40), 1024.0), 0.f);  // as a float it would be 1024
    for (const double bad : {kNan, kInf, -kInf}) EXPECT_EQ(posepack_wrap_clock(bad, 1024.0), 0.f);
    for (const double bad : {kNan, 0.0, -1.0}) EXPECT_EQ(posepack_wrap_clock(3.0, bad), 0.f);
    float last = -1.f;
    for (double t = 30.0 * kDay, end = t + 100.0; t < end; t += 0.013) {  // 30 days: 2531 clocks and 256 s
        const float clock = posepack_wrap_clock(t, 1024.0);
        EXPECT_NEAR(clock, std::fmod(t, 1024.0), 1024.0 * 0x1p-25);
        EXPECT_GE(clock, last);
        last = clock;
    }
}

TEST(Track, RatesAreMultiplesOfOneOverTheClock) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> log_speed(-4.0, 2.5);
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 0.7f));
        for (const double clock_s : {256.0, 1024.0, 3600.0}) {
            const double unit = (wrap == POSEPACK_WRAP_PING_PONG ? 2.0 : 1.0) / clock_s;
            for (int i = 0; i < 5000; ++i) {
                const double speed = std::exp(log_speed(random)) * (i % 2 ? 1.0 : -1.0);
                const double exact = speed / static_cast<double>(0.7f);
                const double hz = start(palette.view, speed, 0.0, 0.0, clock_s).cycle_hz;
                const double steps = std::round(hz / unit);
                EXPECT_NEAR(hz / unit, steps, 1e-9 * std::abs(steps));
                EXPECT_EQ(static_cast<double>(half(static_cast<float>(steps))), steps) << steps;
                EXPECT_NE(steps, 0.0);
                EXPECT_EQ(std::signbit(hz), std::signbit(speed));
                if (std::abs(exact) >= 0.5 * unit) {
                    EXPECT_LE(std::abs(hz - exact),
                              std::max(0.5 * unit, std::abs(exact) * 0x1p-11) * 1.000001);
                }
            }
        }
        EXPECT_EQ(start(palette.view, 1.5, 0.0, 0.0, 0.0).cycle_hz, 1.5 / static_cast<double>(0.7f));
        EXPECT_EQ(start(palette.view, 0.0, 0.0, 0.0).cycle_hz, 0.0);
        const double slowest = (wrap == POSEPACK_WRAP_PING_PONG ? 2.0 : 1.0) / POSEPACK_CLOCK_S;
        EXPECT_EQ(start(palette.view, 1e-6, 0.0, 0.0).cycle_hz, slowest);  // nothing freezes
        EXPECT_EQ(start(palette.view, -1e-6, 0.0, 0.0).cycle_hz, -slowest);
    }
    const Played palette(make_parts());
    EXPECT_EQ(start(palette.view, 3.0, 0.25, 9.0, POSEPACK_CLOCK_S, kIdleClip).cycle_hz, 0.0);  // one row
}

TEST(Track, StartsNow) {
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 1.3f));
        for (int i = 0; i < 1000; ++i) {
            const double now_s = unit(random) * 1e7, phase = unit(random);
            const posepack_track track = start(palette.view, 1.0, phase, now_s);
            EXPECT_EQ(phase_at(palette.view, track, now_s), static_cast<float>(phase));
        }
        EXPECT_EQ(start(palette.view, 1.0, -0.25, 0.0).phase,
                  wrap == POSEPACK_WRAP_LOOP ? 0.75 : (wrap == POSEPACK_WRAP_ONCE ? -0.25 : 1.75));
    }
}

TEST(Track, IsExactAfterDays) {
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 0.9f));
        for (int i = 0; i < 20000; ++i) {
            const double from_s = unit(random) * kDay, time_s = from_s + unit(random) * 60.0 * kDay;
            const posepack_track track = start(palette.view, 2.0 * unit(random) + 0.1, unit(random), from_s);
            const long double cycles =
                static_cast<long double>(track.phase) +
                static_cast<long double>(track.cycle_hz) *
                    (static_cast<long double>(time_s) - static_cast<long double>(from_s));
            const long double off = std::abs(naive_phase(wrap, cycles) -
                                             static_cast<long double>(phase_at(palette.view, track, time_s)));
            // Half a unit of the float phase, and of double at 10^7 cycles; a loop may be seen from both
            // sides.
            EXPECT_LT(std::min(off, 1.0L - off), 0x1p-24L + 4e-9L);
        }
    }
}

TEST(Track, ChangesSpeedWithoutAJump) {
    std::mt19937_64 random(19);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 1.1f));
        posepack_track track = start(palette.view, 1.0, 0.25, 5.0 * kDay);
        double now_s = 5.0 * kDay, cycles = 0.25;
        for (int i = 0; i < 20000; ++i) {  // every frame, for minutes
            const double frame_s = 0.001 + 0.03 * unit(random);
            now_s += frame_s;
            cycles += track.cycle_hz * frame_s;
            if (wrap == POSEPACK_WRAP_ONCE) cycles = std::clamp(cycles, 0.0, 1.0);
            const float before = phase_at(palette.view, track, now_s);
            const double speed = wrap == POSEPACK_WRAP_ONCE && i % 400 < 200 ? -unit(random) : unit(random);
            ASSERT_EQ(posepack_change_speed(&palette.view, speed, now_s, POSEPACK_CLOCK_S, &track),
                      POSEPACK_OK);
            EXPECT_EQ(track.start_s, 5.0 * kDay);
            const double jump = std::abs(static_cast<double>(phase_at(palette.view, track, now_s) - before));
            ASSERT_LT(std::min(jump, 1.0 - jump), 1e-6) << i;
            const double off =
                std::abs(static_cast<double>(naive_phase(wrap, static_cast<long double>(cycles))) -
                         static_cast<double>(phase_at(palette.view, track, now_s)));
            ASSERT_LT(wrap == POSEPACK_WRAP_LOOP ? std::min(off, 1.0 - off) : off, 1e-5) << i;
        }
    }
    const Played palette(walk_of(POSEPACK_WRAP_ONCE, 1.f));
    posepack_track track = start(palette.view, 1.0, 0.0, 100.0);
    ASSERT_EQ(posepack_change_speed(&palette.view, 0.5, 50.0, 0.0, &track), POSEPACK_OK);  // before its start
    EXPECT_EQ(track.phase, 0.0);
    EXPECT_EQ(track.cycle_hz, 0.5);
    ASSERT_EQ(posepack_change_speed(&palette.view, -1.0, 200.0, 0.0, &track), POSEPACK_OK);  // ended: turns
    EXPECT_EQ(phase_at(palette.view, track, 200.25), 0.75f);
}

TEST(Track, RefusesWhatIsNoNumber) {
    const Played palette(make_parts());
    posepack_track track = start(palette.view, 1.0, 0.0, 0.0);
    const auto begin = [&](double speed, double phase, double now_s, double clock_s) {
        return posepack_start_track(&palette.view, kWalkClip, speed, phase, now_s, clock_s, &track);
    };
    for (const double bad : {kNan, kInf, -kInf}) {
        EXPECT_EQ(begin(bad, 0, 0, 0), POSEPACK_ERROR_ARG);
        EXPECT_EQ(begin(1, bad, 0, 0), POSEPACK_ERROR_ARG);
        EXPECT_EQ(begin(1, 0, bad, 0), POSEPACK_ERROR_ARG);
        EXPECT_EQ(begin(1, 0, 0, bad), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_change_speed(&palette.view, bad, 0, 0, &track), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_change_speed(&palette.view, 1, bad, 0, &track), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_change_speed(&palette.view, 1, 0, bad, &track), POSEPACK_ERROR_ARG);
    }
    EXPECT_EQ(begin(1, 0, 0, -1), POSEPACK_ERROR_ARG);
    // Walk takes 1 / 6 s: a million cycles a second, and more.
    EXPECT_EQ(begin(166666.0, 0, 0, 1024), POSEPACK_OK);
    for (const double fast : {166667.0, -166667.0, 1e308}) {
        EXPECT_EQ(begin(fast, 0, 0, 1024), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_change_speed(&palette.view, fast, 0, 0, &track), POSEPACK_ERROR_ARG);
    }
    EXPECT_EQ(begin(1, 0, 0, kInf), POSEPACK_ERROR_ARG);
    EXPECT_EQ(begin(6, 0, 0, 1e308), POSEPACK_ERROR_ARG);  // so long a clock
    EXPECT_EQ(posepack_start_track(&palette.view, kIdleClip, kNan, 0, 0, 0, &track), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_start_track(&palette.view, 2, 1, 0, 0, 0, &track), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_start_track(&palette.view, 0, 1, 0, 0, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_start_track(nullptr, 0, 1, 0, 0, 0, &track), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_change_speed(&palette.view, 1, 0, 0, nullptr), POSEPACK_ERROR_ARG);
    track.clip = 2;
    EXPECT_EQ(posepack_change_speed(&palette.view, 1, 0, 0, &track), POSEPACK_ERROR_INDEX);
}

TEST(Track, FollowsTheGround) {
    Parts parts = make_parts();
    put_f32(parts[kClip], kIdle + POSEPACK_CLIP_SPEED_MPS, 0.f);
    const Played palette(parts);
    double speed = 7.0;
    ASSERT_EQ(posepack_match_speed(&palette.view, kWalkClip, 2.5, &speed), POSEPACK_OK);  // 1.25 m/s
    EXPECT_EQ(speed, 2.0);
    ASSERT_EQ(posepack_match_speed(&palette.view, kWalkClip, -1.25, &speed), POSEPACK_OK);
    EXPECT_EQ(speed, -1.0);
    EXPECT_EQ(posepack_match_speed(&palette.view, kIdleClip, 2.5, &speed), POSEPACK_ERROR_NOT_FOUND);
    EXPECT_EQ(speed, 1.0);
    EXPECT_EQ(posepack_match_speed(&palette.view, kWalkClip, kNan, &speed), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_match_speed(&palette.view, kWalkClip, 1.0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_match_speed(&palette.view, 2, 1.0, &speed), POSEPACK_ERROR_INDEX);
}

TEST(Herd, IsNeverInLockstep) {
    std::vector<bool> taken(1u << 24);
    for (std::uint32_t i = 0; i < 1u << 19; ++i) {
        const float phase = posepack_spread_phase(i);
        ASSERT_TRUE(phase >= 0.f && phase < 1.f);
        const auto place = static_cast<std::size_t>(phase * 16777216.f);
        ASSERT_FALSE(taken[place]) << i;
        taken[place] = true;
    }
    for (const std::uint32_t first : {0u, 123456u, 4294967000u}) {
        std::vector<double> phases;
        for (std::uint32_t i = 0; i < 3000; ++i) {
            const double phase = posepack_spread_phase(first + i);
            phases.insert(std::upper_bound(phases.begin(), phases.end(), phase), phase);
            if (i < 2 || i % 37 != 0) continue;
            double smallest = phases.front() + 1.0 - phases.back(), largest = smallest;
            for (std::size_t k = 1; k < phases.size(); ++k) {
                smallest = std::min(smallest, phases[k] - phases[k - 1]);
                largest = std::max(largest, phases[k] - phases[k - 1]);
            }
            EXPECT_LT(largest, 2.7 * smallest) << i;
        }
    }
}

TEST(Herd, OfOneFlockMovesAsOne) {
    const Played palette(walk_of(POSEPACK_WRAP_LOOP, 1.7f));
    const posepack_track leader = start(palette.view, 1.0, posepack_spread_phase(5), 12.0);
    const posepack_track member = start(palette.view, 1.0, posepack_spread_phase(5), 12.0);
    for (double t = 12.0; t < 3.0 * kDay; t += 977.7)
        EXPECT_EQ(phase_at(palette.view, leader, t), phase_at(palette.view, member, t));
    // Another clock of the shader later, one that joins copies the track; all packets stay equal.
    posepack_play a{}, b{};
    ASSERT_EQ(posepack_start_play(&a, &leader), POSEPACK_OK);
    ASSERT_EQ(posepack_start_play(&b, &member), POSEPACK_OK);
    std::array<float, 8> first{}, second{};
    ASSERT_EQ(posepack_pack_play(&palette.view, &a, POSEPACK_CLOCK_S, first.data()), POSEPACK_OK);
    ASSERT_EQ(posepack_pack_play(&palette.view, &b, POSEPACK_CLOCK_S, second.data()), POSEPACK_OK);
    EXPECT_EQ(first, second);
}

struct Fading {
    posepack_track idle{}, walk{};
    posepack_play play{};
};

// Walk from 10 s on, through 2 s, over idle.
Fading fading(const posepack_view& view) {
    Fading out;
    out.idle = start(view, 1.0, 0.0, 0.0, 0.0, kIdleClip);
    out.walk = start(view, 1.0, 0.125, 10.0, 0.0, kWalkClip);
    EXPECT_EQ(posepack_start_play(&out.play, &out.idle), POSEPACK_OK);
    EXPECT_EQ(posepack_fade_play(&out.play, &out.walk, 2.0), POSEPACK_OK);
    return out;
}

posepack_moment moment_at(const posepack_view& view, const posepack_play& play, double time_s) {
    posepack_moment moment{};
    EXPECT_EQ(posepack_find_moment(&view, &play, time_s, &moment), POSEPACK_OK);
    return moment;
}

TEST(Play, FadesFromWhatWasShown) {
    const Played palette(make_run_parts(tiny_runs()));  // periods of 0.5 s
    const Fading f = fading(palette.view);
    posepack_moment m = moment_at(palette.view, f.play, 9.75);  // a frame before: idle alone
    EXPECT_EQ(m.clip, kIdleClip);
    EXPECT_EQ(m.before, POSEPACK_NONE);
    EXPECT_EQ(m.factor, 1.f);
    EXPECT_EQ(m.phase, phase_at(palette.view, f.idle, 9.75));
    m = moment_at(palette.view, f.play, 10.0);  // factor 0
    EXPECT_EQ(m.clip, kIdleClip);
    EXPECT_EQ(m.before, POSEPACK_NONE);
    m = moment_at(palette.view, f.play, 10.5);
    EXPECT_EQ(m.clip, kWalkClip);
    EXPECT_EQ(m.before, kIdleClip);
    EXPECT_EQ(m.factor, 0.25f);
    EXPECT_EQ(m.phase, 0.125f);
    EXPECT_EQ(m.before_phase, phase_at(palette.view, f.idle, 10.5));
    for (const double t : {12.0, 12.5, 1e6}) {
        m = moment_at(palette.view, f.play, t);
        EXPECT_EQ(m.clip, kWalkClip);
        EXPECT_EQ(m.before, POSEPACK_NONE);
        EXPECT_EQ(m.factor, 1.f);
    }
    m = moment_at(palette.view, f.play, 12.0 - 1e-12);  // so near the end that the factor is 1 as a float
    EXPECT_EQ(m.before, POSEPACK_NONE);
    EXPECT_EQ(m.factor, 1.f);
    EXPECT_EQ(moment_at(palette.view, f.play, kNan).clip, kIdleClip);
}

TEST(Play, ShowsItsFirstPoseBeforeItsStart) {
    const Played palette(make_run_parts(tiny_runs()));
    const posepack_track walk = start(palette.view, 1.0, 0.125, 10.0);
    posepack_play play{};
    ASSERT_EQ(posepack_start_play(&play, &walk), POSEPACK_OK);
    for (const double t : {kNan, -kInf, -5.0, 9.99, 10.0})
        EXPECT_EQ(moment_at(palette.view, play, t).phase, 0.125f) << t;
    EXPECT_EQ(moment_at(palette.view, play, 10.1).phase, phase_at(palette.view, walk, 10.1));
}

TEST(Play, CutsAtOnceWithoutAFade) {
    const Played palette(make_run_parts(tiny_runs()));
    Fading f = fading(palette.view);
    ASSERT_EQ(posepack_start_play(&f.play, &f.idle), POSEPACK_OK);
    ASSERT_EQ(posepack_fade_play(&f.play, &f.walk, 0.0), POSEPACK_OK);
    EXPECT_EQ(moment_at(palette.view, f.play, 10.0).clip, kWalkClip);
    EXPECT_EQ(moment_at(palette.view, f.play, 10.0).phase, 0.125f);
    EXPECT_EQ(moment_at(palette.view, f.play, 10.0 - 1.0 / 60.0).clip, kIdleClip);  // for motion vectors
}

TEST(Play, KeepsTheLargerShareWhereAFadeMeetsAnother) {
    const Played palette(make_run_parts(tiny_runs()));
    for (const auto& [time_s, before] : {std::pair{10.9, kIdleClip}, std::pair{11.1, kWalkClip}}) {
        Fading f = fading(palette.view);
        const posepack_track again = start(palette.view, 1.0, 0.5, time_s, 0.0, kWalkClip);
        ASSERT_EQ(posepack_fade_play(&f.play, &again, 1.0), POSEPACK_OK);
        EXPECT_EQ(f.play.before.clip, before);
        EXPECT_EQ(f.play.now.start_s, time_s);
    }
}

TEST(Play, SettlesASecondAfterItsEnd) {
    const Played palette(walk_of(POSEPACK_WRAP_ONCE, 4.f));
    for (const double speed : {1.0, -1.0}) {
        posepack_play play = fading(palette.view).play;
        play.now.cycle_hz = speed / 4.0;
        play.now.phase = speed > 0.0 ? 0.0 : 1.0;
        std::uint32_t changed = 7;
        for (const double t : {9.0, 10.5, 12.9, 12.9, 13.5, 14.9, 15.1, 16.0, 99.0}) {
            posepack_play before = play;
            ASSERT_EQ(posepack_settle_play(&palette.view, t, &play, &changed), POSEPACK_OK);
            EXPECT_EQ(changed, t == 13.5 || t == 15.1 ? 1u : 0u) << t;
            const posepack_moment a = moment_at(palette.view, before, t),
                                  b = moment_at(palette.view, play, t);
            EXPECT_EQ(a.clip, b.clip);
            EXPECT_EQ(a.phase, b.phase);
            EXPECT_EQ(a.before, b.before);
        }
        EXPECT_EQ(play.before.clip, POSEPACK_NONE);
        EXPECT_EQ(play.now.cycle_hz, 0.0);
        EXPECT_EQ(play.now.phase, speed > 0.0 ? 1.0 : 0.0);
    }
    const Played loop(walk_of(POSEPACK_WRAP_LOOP, 4.f));
    posepack_play play{};
    const posepack_track track = start(loop.view, 1.0, 0.0, 0.0);
    ASSERT_EQ(posepack_start_play(&play, &track), POSEPACK_OK);
    std::uint32_t changed = 7;
    ASSERT_EQ(posepack_settle_play(&loop.view, 1e6, &play, &changed), POSEPACK_OK);
    EXPECT_EQ(changed, 0u);
}

TEST(Play, RefusesWrongArguments) {
    const Played palette(make_parts());
    Fading f = fading(palette.view);
    posepack_moment moment{};
    std::uint32_t changed = 0;
    EXPECT_EQ(posepack_start_play(nullptr, &f.walk), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_start_play(&f.play, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_fade_play(nullptr, &f.walk, 1.0), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_fade_play(&f.play, nullptr, 1.0), POSEPACK_ERROR_ARG);
    for (const double bad : {kNan, kInf, -1.0})
        EXPECT_EQ(posepack_fade_play(&f.play, &f.walk, bad), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_moment(nullptr, &f.play, 0, &moment), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_moment(&palette.view, nullptr, 0, &moment), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_moment(&palette.view, &f.play, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_settle_play(&palette.view, 0, nullptr, &changed), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_settle_play(&palette.view, 0, &f.play, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_settle_play(nullptr, 0, &f.play, &changed), POSEPACK_ERROR_ARG);
    posepack_play bad = f.play;
    bad.now.clip = 2;
    EXPECT_EQ(posepack_find_moment(&palette.view, &bad, 11.0, &moment), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_settle_play(&palette.view, 0, &bad, &changed), POSEPACK_ERROR_INDEX);
    bad = f.play;
    bad.before.clip = 2;
    EXPECT_EQ(posepack_find_moment(&palette.view, &bad, 11.0, &moment), POSEPACK_ERROR_INDEX);
}

// Every mark one by one: the times at which it is passed, by the definition.
std::uint64_t naive_passes(std::uint32_t wrap, const posepack_track& track, double mark, double from_s,
                           double to_s, bool* is_near) {
    const auto hz = static_cast<long double>(track.cycle_hz);
    const long double low = std::floor(static_cast<long double>(posepack_count_cycles(&track, from_s)));
    const long double high = std::floor(static_cast<long double>(posepack_count_cycles(&track, to_s)));
    std::uint64_t count = 0;
    for (long double k = std::min(low, high) - 2; k <= std::max(low, high) + 2; ++k) {
        if (wrap == POSEPACK_WRAP_ONCE && k != 0) continue;
        // Whole cycle k of ping-pong goes to and fro by turns.
        const bool back = wrap == POSEPACK_WRAP_PING_PONG && std::fmod(std::abs(k), 2.0L) == 1.0L;
        if (back && (mark == 0.0 || mark == 1.0)) continue;  // an end belongs to the way to
        if (wrap == POSEPACK_WRAP_LOOP && mark == 1.0) break;
        const long double cycles =
            k + (back ? 1.0L - static_cast<long double>(mark) : static_cast<long double>(mark));
        const long double t =
            static_cast<long double>(track.start_s) + (cycles - static_cast<long double>(track.phase)) / hz;
        for (const double edge : {from_s, to_s, track.start_s})
            if (std::abs(t - static_cast<long double>(edge)) < 1e-7L) *is_near = true;
        if (t > static_cast<long double>(from_s) && t <= static_cast<long double>(to_s) &&
            t >= static_cast<long double>(track.start_s))
            ++count;
    }
    return count;
}

std::uint64_t passes(const posepack_view& view, const posepack_track& track, double mark, double from_s,
                     double to_s) {
    std::uint64_t count = 99;
    EXPECT_EQ(posepack_count_passes(&view, &track, mark, from_s, to_s, &count), POSEPACK_OK);
    return count;
}

TEST(Passes, AreThoseFoundOneByOne) {
    std::mt19937_64 random(23);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int looked = 0;
    for (const std::uint32_t wrap : kWraps) {
        const Played palette(walk_of(wrap, 0.8f));
        for (int i = 0; i < 20000; ++i) {
            const double speed = 4.0 * unit(random) - 2.0, begin = unit(random) * kDay;
            const posepack_track track = start(palette.view, speed, unit(random), begin);
            const double from_s = begin + 6.0 * unit(random) - 3.0;
            const double to_s = from_s + std::pow(10.0, 4.0 * unit(random) - 2.0);  // hitches of up to 100 s
            const double mark =
                i % 5 == 0 ? 0.0 : (i % 7 == 0 && wrap != POSEPACK_WRAP_LOOP ? 1.0 : unit(random));
            bool is_near = false;
            const std::uint64_t expected = naive_passes(wrap, track, mark, from_s, to_s, &is_near);
            if (is_near) continue;
            ++looked;
            EXPECT_EQ(passes(palette.view, track, mark, from_s, to_s), expected)
                << wrap << " " << track.cycle_hz << " " << mark;
            // Frame by frame it is the same, with no frame that loses or doubles one.
            std::uint64_t sum = 0;
            double at = from_s;
            while (at < to_s) {
                const double next = std::min(to_s, at + (to_s - from_s) * 0.11 * unit(random) + 1e-3);
                sum += passes(palette.view, track, mark, at, next);
                at = next;
            }
            EXPECT_EQ(sum, expected);
        }
    }
    EXPECT_GT(looked, 50000);
}

TEST(Passes, BeginAtTheStart) {
    const Played loop(walk_of(POSEPACK_WRAP_LOOP, 1.f)), once(walk_of(POSEPACK_WRAP_ONCE, 1.f));
    const Played swing(walk_of(POSEPACK_WRAP_PING_PONG, 1.f));
    for (const double speed : {1.0, -1.0}) {
        const posepack_track track = start(loop.view, speed, 0.25, 100.0, 0.0);
        EXPECT_EQ(passes(loop.view, track, 0.25, 99.0, 100.0), 1u);  // where it starts
        EXPECT_EQ(passes(loop.view, track, 0.25, 100.0, 101.0), 1u);
        EXPECT_EQ(passes(loop.view, track, 0.25, 99.0, 101.0), 2u);
        EXPECT_EQ(passes(loop.view, track, 0.25, 0.0, 99.5), 0u);
        EXPECT_EQ(passes(loop.view, track, 0.5, 0.0, 100.0), 0u);
        EXPECT_EQ(passes(loop.view, track, 0.0, 0.0, 1e6), 999900u);
        EXPECT_EQ(passes(loop.view, track, 1.0, 0.0, 1e6), 999900u);
        EXPECT_EQ(passes(once.view, track, 0.25, 0.0, 1e6), 1u);
        EXPECT_EQ(passes(once.view, track, 0.5, 0.0, 1e6), speed > 0.0 ? 1u : 0u);
        EXPECT_EQ(passes(swing.view, track, 0.5, 100.0, 110.0), 10u);
        EXPECT_EQ(passes(swing.view, track, 0.0, 100.0, 110.0), 5u);
        EXPECT_EQ(passes(swing.view, track, 1.0, 100.0, 110.0), 5u);
    }
}

TEST(Passes, AreNoneWhereNothingMoves) {
    const Played palette(walk_of(POSEPACK_WRAP_LOOP, 1.f));
    posepack_track track = start(palette.view, 1.0, 0.25, 0.0, 0.0);
    EXPECT_EQ(passes(palette.view, track, 0.5, 5.0, 5.0), 0u);
    EXPECT_EQ(passes(palette.view, track, 0.5, 5.0, 4.0), 0u);
    EXPECT_EQ(passes(palette.view, track, 0.5, kNan, 4.0), 0u);
    EXPECT_EQ(passes(palette.view, track, 0.5, 1.0, kNan), 0u);
    EXPECT_EQ(passes(palette.view, track, 0.5, 1.0, kInf), 0u);
    EXPECT_EQ(passes(palette.view, track, 0.5, -kInf, 3.0), 3u);
    EXPECT_EQ(passes(palette.view, track, 0.5, 1.0, 1e300), std::uint64_t{1} << 53);
    track.start_s = -kInf;
    EXPECT_EQ(passes(palette.view, track, 0.5, 1.0, 3.0), 0u);
    track = start(palette.view, 0.0, 0.5, 0.0);
    EXPECT_EQ(passes(palette.view, track, 0.5, -1.0, 1e6), 0u);
    track = start(palette.view, 1.0, 0.5, 0.0, 0.0, kIdleClip);  // one row
    EXPECT_EQ(passes(palette.view, track, 0.5, -1.0, 1e6), 0u);
    std::uint64_t count = 0;
    for (const double bad : {kNan, -0.1, 1.1})
        EXPECT_EQ(posepack_count_passes(&palette.view, &track, bad, 0, 1, &count), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_count_passes(&palette.view, &track, 0, 0, 1, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_count_passes(&palette.view, nullptr, 0, 0, 1, &count), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_count_passes(nullptr, &track, 0, 0, 1, &count), POSEPACK_ERROR_ARG);
    track.clip = 2;
    EXPECT_EQ(posepack_count_passes(&palette.view, &track, 0, 0, 1, &count), POSEPACK_ERROR_INDEX);
}

}  // namespace
}  // namespace posepack::test
