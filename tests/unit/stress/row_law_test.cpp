// SPDX-License-Identifier: MIT
// The reader's part of the time law, in float: loops, clips that end, and clocks that lost the time.
#include "stress/row_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bake/bake_animal.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

posepack_clip clip_of(std::uint8_t wrap, float period_s) {
    posepack_clip clip{};
    clip.wrap = wrap;
    clip.period_s = period_s;
    return clip;
}

TEST(PhaseAt, IsTheShareOfThePeriod) {
    const posepack_clip loop = clip_of(POSEPACK_WRAP_LOOP, 2.0f);
    const posepack_clip once = clip_of(POSEPACK_WRAP_ONCE, 2.0f);
    for (const posepack_clip& clip : {loop, once}) {
        EXPECT_EQ(phase_at(clip, 0.0, {}), 0.0f);
        EXPECT_EQ(phase_at(clip, 0.75, {}), 0.375f);
    }
    EXPECT_EQ(phase_at(loop, 2.5, {}), 0.25f);
    EXPECT_EQ(phase_at(once, 2.5, {}), 1.0f);
    EXPECT_EQ(phase_at(clip_of(POSEPACK_WRAP_ONCE, 0.0f), 0.5, {}), 0.0f) << "a clip without length";
}

TEST(PhaseAt, InDoublePrecisionKeepsTheTimeForDays) {
    EXPECT_NEAR(phase_at(clip_of(POSEPACK_WRAP_LOOP, 2.0f), 0.7531, {.running_s = 1e6}), 0.37655f, 1e-7f);
    EXPECT_NEAR(phase_at(clip_of(POSEPACK_WRAP_ONCE, 2.0f), 0.7531, {.running_s = 1e6}), 0.37655f, 1e-7f);
}

// Floats step by 1/128 s from 65,536 s on, and by 1/16 s from 524,288 s on.
TEST(PhaseAt, OfAClockInOneFloatLosesIt) {
    const posepack_clip loop = clip_of(POSEPACK_WRAP_LOOP, 2.0f);
    const Reader day{.running_s = 86'400.0, .has_raw_clock = true};
    EXPECT_EQ(phase_at(loop, 0.5 + 1.0 / 128, day), 0.25f + 1.0f / 256) << "a time that a float has";
    EXPECT_EQ(phase_at(loop, 0.5 + 0.3 / 128, day), 0.25f) << "one that it has not";
    const Reader days{.running_s = 1e6, .has_raw_clock = true};
    EXPECT_EQ(phase_at(loop, 0.54, days), 0.25f + 1.0f / 32) << "later";
    EXPECT_EQ(phase_at(clip_of(POSEPACK_WRAP_ONCE, 2.0f), 0.54, days), 0.25f + 1.0f / 32)
        << "a clip that ends";
}

// Halves step by 1/2,048 between a half and 1.
TEST(PhaseAt, InAHalfLosesIt) {
    const posepack_clip loop = clip_of(POSEPACK_WRAP_LOOP, 1.0f);
    EXPECT_EQ(phase_at(loop, 0.75 + 0.4 / 2048, {.has_half_phase = true}), 0.75f);
    EXPECT_EQ(phase_at(loop, 0.75 + 0.6 / 2048, {.has_half_phase = true}), 0.75f + 1.0f / 2048);
}

std::vector<double> times_of(std::string_view name, bool is_bounded) {
    for (const CaseGroup& group : case_groups())
        for (const StressCase& stress_case : group.cases) {
            if (stress_case.name != name) continue;
            recipe::AnimalEntry entry = entry_of(stress_case);
            if (is_bounded) entry = under_bound(entry, stress_case.bound);
            const auto baked = bake::bake_animal(entry, write_glb(stress_case.build()), {});
            posepack_view view;
            if (!baked || posepack_open(&view, baked.value().container.data(),
                                        baked.value().container.size()) != POSEPACK_OK)
                throw std::runtime_error(std::string(name));
            return row_times_s(view, 0);
        }
    throw std::invalid_argument(std::string(name));
}

TEST(RowTimes, OfUniformRowsAreEvenAndEndWithThePeriod) {
    const std::vector<double> times_s = times_of("one_metre", false);
    ASSERT_EQ(times_s.size(), 31u);
    for (std::size_t row = 0; row < 31; ++row) EXPECT_NEAR(times_s[row], static_cast<double>(row) / 30, 1e-7);
    EXPECT_EQ(times_of("breathing", false).size(), 31u) << "a loop of 30 rows, and its end";
}

TEST(RowTimes, OfRunsAreThoseOfEveryBone) {
    std::vector<double> times_s = times_of("one_metre", true);
    EXPECT_EQ(std::count(times_s.begin(), times_s.end(), 0.0), 4) << "four bones of different runs";
    EXPECT_EQ(*std::max_element(times_s.begin(), times_s.end()), 1.0);
}

// The twitch lasts from 3.013 to 3.033 s of ten.
TEST(RowTimes, OfSlotsAreCloseWhereTheMotionIsFast) {
    std::vector<double> times_s = times_of("twitch_in_a_slow_clip", true);
    std::sort(times_s.begin(), times_s.end());
    times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
    const auto within = [&](double first_s, double last_s) {
        return std::count_if(times_s.begin(), times_s.end(),
                             [&](double time_s) { return time_s > first_s && time_s < last_s; });
    };
    EXPECT_GT(within(3.0, 3.034), 10);
    EXPECT_LT(within(6.0, 6.034), 3);
}

}  // namespace
}  // namespace posepack::stress
