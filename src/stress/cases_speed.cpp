// SPDX-License-Identifier: MIT
// Motion that is fast against the rows.
#include <array>
#include <cmath>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

constexpr double kFineHz = 240.0;  // keys so dense that they follow everything here

// A reed that turns evenly about its foot.
RawModel spinning(double degrees_per_s, double duration_s = 1.0) {
    const auto keys = static_cast<std::size_t>(std::lround(duration_s * kFineHz)) + 1;
    return with_clip(reed(), {turning(0, grid(keys, kFineHz), [&](double time_s) {
                         return turn_about(kAxisX, degrees_per_s * time_s);
                     })});
}

RawModel spin_24() {
    return spinning(240.0);
}
RawModel spin_72() {
    return spinning(720.0);
}
RawModel spin_170() {
    return spinning(1'700.0);
}
RawModel spin_180() {
    return spinning(1'800.0);
}
RawModel spin_360() {
    return spinning(3'600.0);
}

// The keys themselves are a whole turn apart: q and -q, between which glTF's slerp stands still.
RawModel turn_a_key() {
    return with_clip(reed(), {turning(0, grid(31, 30.0), [](double time_s) {
                         return turn_about(kAxisX, 360.0 * 30.0 * time_s);
                     })});
}

// A windmill, keyed at every quarter: half way between two keys a blend of dual quaternions is right.
RawModel quarter_turn_a_key() {
    return with_clip(reed(), {turning(0, grid(17, kKeyHz), [](double time_s) {
                         return turn_about(kAxisX, 90.0 * 30.0 * time_s);
                     })});
}

// Still, then round by 176 degrees from one key to the next, as in a death that was cut short.
RawModel snap_176() {
    return with_clip(reed(), {turning(0, grid(31, 30.0), [](double time_s) {
                         return turn_about(kAxisX, time_s < 0.51 ? 0.0 : 176.0);
                     })});
}

RawModel fluttering(double frequency_hz, double degrees, double key_hz, double duration_s) {
    const auto keys = static_cast<std::size_t>(std::lround(duration_s * key_hz)) + 1;
    return with_clip(reed(), {turning(0, grid(keys, key_hz), [&](double time_s) {
                         return turn_about(kAxisZ, degrees * sine_of_turns(frequency_hz * time_s));
                     })});
}

RawModel flutter_12_hz() {
    return fluttering(12.0, 60.0, kFineHz, 1.0);
}
// Every row at 30 Hz finds the wing at rest.
RawModel strobe_30_hz() {
    return fluttering(30.0, 30.0, kFineHz, 0.5);
}
RawModel buzz_2_khz() {
    return fluttering(2'000.0, 30.0, 32'000.0, 0.05);
}

// The body circles a joint 100 m away.
RawModel orbit_100_m() {
    const Reed shape{.foot = {100.0, 0.0, 0.0}};
    return with_clip(
        carried_reed(shape),
        {turning(0, grid(31, 30.0), [](double time_s) { return turn_about(kAxisY, 200.0 * time_s); })});
}

// Eight joints that all bend by up to 40 degrees, four times a second: their turns add up along the chain.
RawModel whip() {
    const RawModel model = reed({.joints = 8, .rings = 17});
    return with_clip(model, swaying(model, grid(31, 30.0), 40.0, 0.25));
}

// Ten seconds of slow swaying, in which one joint twitches by 40 degrees and back within 20 ms, off the grid.
RawModel twitch_in_a_slow_clip() {
    RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(301, 30.0), 10.0, 10.0);
    const std::vector<float> times_s{0.0f, 3.013f, 3.023f, 3.033f, 10.0f};
    channels[3] = turning(3, times_s, [](double time_s) {
        return turn_about(kAxisX, std::abs(time_s - 3.023) < 1e-4 ? 40.0 : 0.0);
    });
    return with_clip(model, channels);
}

// A joint that is struck at 0.1 s and rings at `frequency_hz` while it dies down within `time_constant_s`.
RawModel spring(double time_constant_s, double frequency_hz, double key_hz, double duration_s) {
    const auto keys = static_cast<std::size_t>(std::lround(duration_s * key_hz)) + 1;
    return with_clip(reed(), {turning(2, grid(keys, key_hz), [&](double time_s) {
                         const double since_s = time_s - 0.1;
                         if (since_s <= 0.0) return menagerie::kNoTurn;
                         return turn_about(kAxisX, 30.0 * decayed(since_s / time_constant_s) *
                                                       sine_of_turns(frequency_hz * since_s));
                     })});
}

RawModel spring_100_ms() {
    return spring(0.1, 5.0, kFineHz, 1.0);
}
RawModel spring_10_ms() {
    return spring(0.01, 40.0, 2'000.0, 0.5);
}
RawModel spring_1_ms() {
    return spring(0.001, 400.0, 20'000.0, 0.15);
}

// A bouncing height: the velocity turns round at once, in the middle between two keys of the grid.
RawModel bounce() {
    RawModel model = reed();
    return with_clip(model, {moving(0, grid(61, 60.0), [](double time_s) {
                         const double phase = time_s * 4.0 - 0.4667 - std::floor(time_s * 4.0 - 0.4667);
                         return Vec3(0.0, 2.0 * phase * (1.0 - phase), 0.0);
                     })});
}

// Two keys of the same value, whose tangents throw the body up by half its length, 1 R, in between.
RawModel cubic_overshoot() {
    RawModel model = reed();
    // h(u) = (u^3 - 2 u^2 + u) - (u^3 - u^2) has its top of 1/4 in the middle: slope x span = 2 units.
    const float slope = 2.0f / 0.1f;
    RawChannel leap{0, RawPath::translation, Interpolation::cubic, {0.0f, 0.3f, 0.4f, 0.7f}, {}};
    for (int key = 0; key < 4; ++key) {
        const float in = key == 2 ? -slope : 0.0f;
        const float out = key == 1 ? slope : 0.0f;
        leap.values.insert(leap.values.end(), {0, in, 0, 0, 0, 0, 0, out, 0});
    }
    return with_clip(model, {leap});
}

// All keys have one value and one slope: the spline crosses the straight line half way between them.
RawModel cubic_s_curve() {
    RawChannel swing{0, RawPath::translation, Interpolation::cubic, grid(31, kKeyHz), {}};
    for (int key = 0; key < 31; ++key) swing.values.insert(swing.values.end(), {0, 20, 0, 0, 0, 0, 0, 20, 0});
    return with_clip(reed(), {swing});
}

constexpr Bound kLoose{2e-2, 2e-2};
constexpr Start kAt10Hz{.rate_hz = 10.0};
constexpr Start kAt30Hz{.rate_hz = 30.0};

constexpr std::array kCases = {
    StressCase{
        "spin_24_a_row", "24 degrees a row: a limb of matrices shrinks by 2 %", spin_24, {kMeets}, kAt10Hz},
    StressCase{"spin_72_a_row",
               "72 degrees a row: a limb of matrices shrinks by a fifth",
               spin_72,
               {kMeets},
               kAt10Hz,
               kLoose},
    StressCase{"spin_170_a_row",
               "170 degrees a row: matrices meet almost at a point",
               spin_170,
               {kAddsRows},
               kAt10Hz},
    StressCase{
        "spin_180_a_row", "180 degrees a row: either way round is as near", spin_180, {kAddsRows}, kAt10Hz},
    StressCase{"spin_360_a_row",
               "a whole turn a row: at the rows nothing moves, and a check there passes",
               spin_360,
               {kAddsRows},
               kAt10Hz},
    StressCase{"turn_a_key", "keys a whole turn apart: by glTF's rule nothing moves", turn_a_key, {kMeets}},
    StressCase{"quarter_turn_a_key",
               "a windmill of 90 degrees a key: half way and at the rows all is right",
               quarter_turn_a_key,
               {kMeets}},
    StressCase{"snap_176", "176 degrees in one key step", snap_176, {kAddsRows}},
    StressCase{
        "flutter_12_hz", "a wing beats 12 times a second by 60 degrees", flutter_12_hz, {kAddsRows}, kAt30Hz},
    StressCase{"strobe_30_hz",
               "a wing beats once a row: every row finds it at rest",
               strobe_30_hz,
               {kAddsRows},
               kAt30Hz},
    StressCase{"buzz_2_khz",
               "2,000 beats a second: faster than 480 rows a second can follow",
               buzz_2_khz,
               {refuses(IssueCode::lim_bound)},
               kAt30Hz},
    StressCase{"orbit_100_m",
               "a body of 1 m circles a point 100 m away at 200 degrees a second",
               orbit_100_m,
               {kSwitchesForm}},
    StressCase{"whip", "eight joints of 40 degrees: turns add up along the chain", whip, {kAddsRows}},
    StressCase{"twitch_in_a_slow_clip",
               "20 ms of twitch, off the grid, in ten slow seconds",
               twitch_in_a_slow_clip,
               {kSlots}},
    StressCase{"spring_100_ms", "a spring of three rows", spring_100_ms, {kSlots}, kAt30Hz},
    StressCase{"spring_10_ms",
               "a spring that is over in a third of a row: 480 rows a second miss it",
               spring_10_ms,
               {refuses(IssueCode::lim_bound), "bone 'joint 3', with 16 rows a key"},
               kAt30Hz},
    StressCase{"spring_1_ms",
               "a spring that is over in a thirtieth of a row",
               spring_1_ms,
               {refuses(IssueCode::lim_bound)},
               kAt30Hz},
    StressCase{"bounce", "velocities that turn round between two rows", bounce, {kMeets}, kAt30Hz},
    StressCase{"cubic_overshoot",
               "a cubic spline leaps by 1 R between two equal keys 0.1 s apart",
               cubic_overshoot,
               {kSlots},
               kAt10Hz},
    StressCase{
        "cubic_s_curve", "splines that cross the blend half way between rows", cubic_s_curve, {kAddsRows}},
};

}  // namespace

CaseGroup speed_cases() {
    return {"Speed",
            "Half floats are not the error here, time is: all texel formats give the same figures. Dual "
            "quaternions "
            "turn along the arc and need fewer rows; where rows run out, the bake is refused.",
            kCases};
}

}  // namespace posepack::stress
