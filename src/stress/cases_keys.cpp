// SPDX-License-Identifier: MIT
// Key times that are legal but awkward: steps, jumps, late keys, loops that do not meet.
#include <array>
#include <cmath>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

constexpr double kJump = 0.5;  // units: 1 R of a reed

// The body stands at 0, then at 1 R, from `jump_s` on.
RawChannel leap(Interpolation interpolation, const std::vector<float>& times_s, double jump_s) {
    RawChannel channel =
        moving(0, times_s, [&](double time_s) { return Vec3(time_s < jump_s ? 0.0 : kJump, 0.0, 0.0); });
    channel.interpolation = interpolation;
    return channel;
}

RawModel step_on_the_grid() {
    return with_clip(reed(), {leap(Interpolation::step, grid(31, kKeyHz), 0.49)});
}
RawModel step_off_the_grid() {
    return with_clip(reed(), {leap(Interpolation::step, {0.0f, 0.4789f, 1.0f}, 0.4)});
}
// A step among curves: the clip as a whole is blended.
RawModel step_among_curves() {
    RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    channels.push_back(leap(Interpolation::step, {0.0f, 0.5f, 1.0f}, 0.4));
    return with_clip(model, channels);
}
RawModel step_of_90_degrees() {
    RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    channels[0] = turning(0, {0.0f, 0.4789f, 1.0f},
                          [](double time_s) { return turn_about(kAxisX, time_s < 0.4 ? 0.0 : 90.0); });
    channels[0].interpolation = Interpolation::step;
    return with_clip(model, channels);
}

RawModel single_key() {
    return with_clip(reed(), {turning(1, {0.5f}, [](double) { return turn_about(kAxisX, 30.0); })});
}
RawModel keys_at_one_time() {
    return with_clip(reed(),
                     {turning(1, {0.5f, 0.5f, 0.5f}, [](double) { return turn_about(kAxisX, 30.0); })});
}

// A jump between keys that are nearer than any clock can tell.
RawModel keys_1e_8_apart() {
    return with_clip(
        reed(), {leap(Interpolation::linear, {0.0f, 0.1f, std::nextafter(0.1f, 1.0f), 0.2f}, 0.100000005)});
}
// The same at the beginning, where floats tell 1e-8 s and far less.
RawModel keys_1e_40_apart() {
    return with_clip(reed(), {leap(Interpolation::linear, {0.0f, 1e-40f, 0.2f}, 1e-41)});
}
RawModel keys_2_us_apart() {
    return with_clip(reed(), {leap(Interpolation::linear, {0.0f, 0.05f, 0.050002f, 0.1f}, 0.050001)});
}

RawModel swaying_from(double first_s, double rate_hz, std::size_t keys, double period_s = 1.0) {
    const RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(keys, rate_hz), kSwayDegrees, period_s);
    // Values as they were meant, times as floats have them.
    for (RawChannel& channel : channels) channel.times_s = grid(keys, rate_hz, first_s);
    return with_clip(model, channels);
}
// Floats step by 7.8 ms at 1e5 s: a quarter of a key step.
RawModel keys_at_1e5_s() {
    return swaying_from(1e5, 30.0, 31);
}
RawModel keys_at_1_hour() {
    return swaying_from(3'600.0, 30.0, 31);
}
// Floats step by 1 s: thirty keys at one time.
RawModel keys_at_1e7_s() {
    return swaying_from(1e7, 30.0, 91, 1.3);
}
RawModel keys_at_23_976_hz() {
    return swaying_from(0.0, 24'000.0 / 1'001.0, 25);
}

// Keys up to a fifth of a step off their grid, as in a file that was retimed.
RawModel jittered_keys() {
    RawModel model = reed();
    std::vector<float> times_s = grid(31, kKeyHz);
    for (std::size_t key = 1; key + 1 < times_s.size(); ++key)
        times_s[key] += 0.2f / 30.0f * static_cast<float>(sine_of_turns(0.37 * static_cast<double>(key)));
    return with_clip(model, swaying(model, times_s, kSwayDegrees, 1.0));
}

// A loop without its last key, and one whose ends are 3 cm apart.
RawModel open_loop() {
    return swaying_from(0.0, 30.0, 30);
}
RawModel loop_with_a_pop() {
    RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    channels.push_back(moving(0, grid(2, 1.0), [](double time_s) { return Vec3(0.03 * time_s, 0.0, 0.0); }));
    return with_clip(model, channels);
}

RawModel clip_of_10_us() {
    return with_clip(reed(), {leap(Interpolation::linear, {0.0f, 1e-5f}, 5e-6)});
}
RawModel clip_of_ten_minutes() {
    const RawModel model = reed({.joints = 2, .rings = 3});
    return with_clip(model, swaying(model, grid(601, 1.0), 10.0, 60.0));
}

constexpr Bound kLoose{2e-2, 1e-2};
constexpr Start kClosedLoop{.wrap = recipe::Wrap::loop, .seam = recipe::Seam::closed};
constexpr Start kAutomatic{.wrap = recipe::Wrap::automatic};
constexpr Start kAt1Hz{.rate_hz = 1.0};

constexpr std::array kCases = {
    StressCase{"step_on_the_grid", "STEP keys alone, on the grid: rows are held", step_on_the_grid, {kMeets}},
    StressCase{"step_off_the_grid",
               "a STEP of 1 R off the grid: no row lies at it",
               step_off_the_grid,
               {refuses(IssueCode::lim_bound)}},
    StressCase{"step_among_curves",
               "a STEP of 1 R on the grid among curves: rows blend across it",
               step_among_curves,
               {kCuts}},
    StressCase{"step_of_90_degrees",
               "a STEP of 90 degrees off the grid among curves",
               step_of_90_degrees,
               {refuses(IssueCode::lim_bound), "at 0.4789 s, bone 'joint 3'"}},
    StressCase{"single_key", "one key: no duration to divide by", single_key, {kMeets}},
    StressCase{"keys_at_one_time",
               "three keys at one time: no duration either",
               keys_at_one_time,
               {kMeets, "", IssueCode::warn_times}},
    StressCase{"keys_1e_8_apart",
               "a jump of 1 R between keys 1e-8 s apart",
               keys_1e_8_apart,
               {kCuts, "", IssueCode::warn_times}},
    StressCase{"keys_1e_40_apart",
               "keys a subnormal second apart",
               keys_1e_40_apart,
               {kMeets, "", IssueCode::warn_times}},
    StressCase{"keys_2_us_apart",
               "1 R in two microseconds, just not a jump",
               keys_2_us_apart,
               {refuses(IssueCode::lim_bound)}},
    StressCase{"keys_at_1_hour", "keys from an hour on: floats step by 0.24 ms", keys_at_1_hour, {kMeets}},
    StressCase{"keys_at_1e5_s",
               "keys from a day on: floats step by 7.8 ms, a quarter of a key step",
               keys_at_1e5_s,
               {kMeets},
               {},
               kLoose},
    StressCase{"keys_at_1e7_s",
               "keys from 1e7 s on: floats step by a second, thirty keys at one time",
               keys_at_1e7_s,
               {refuses(IssueCode::lim_bound), "", IssueCode::warn_times}},
    StressCase{"keys_at_23_976_hz", "keys on the grid of film: 24,000/1,001 Hz", keys_at_23_976_hz, {kMeets}},
    StressCase{"jittered_keys",
               "keys up to a fifth of a step off any grid",
               jittered_keys,
               {kMeets, "", IssueCode::warn_rate}},
    StressCase{"open_loop", "a loop without its last key", open_loop, {kMeets}, kAutomatic},
    StressCase{"loop_with_a_pop",
               "a loop whose ends are 0.06 R apart: the pop is in the source",
               loop_with_a_pop,
               {refuses(IssueCode::lim_bound), "", IssueCode::warn_seam},
               kClosedLoop},
    StressCase{"clip_of_ten_minutes",
               "600 s: the longest clip; phases in one float",
               clip_of_ten_minutes,
               {kMeets},
               kAt1Hz},
    StressCase{"clip_of_10_us", "a whole clip within 10 us", clip_of_10_us, {kMeets}},
};

}  // namespace

CaseGroup key_cases() {
    return {"Keys and times",
            "Times are taken from the first key in double precision at once. Rows end in front of a jump "
            "that lies "
            "on the key grid; a clip that jumps elsewhere is refused rather than smeared.",
            kCases};
}

}  // namespace posepack::stress
