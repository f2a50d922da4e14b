// SPDX-License-Identifier: MIT
// The time law in float: loops, clips that end, held rows, cuts, closing rows, and clocks that lost the time.
#include "stress/row_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace posepack::stress {
namespace {

ReaderClip clip_of(std::uint8_t wrap, std::uint32_t row_count, float period_s) {
    ReaderClip clip;
    clip.facts.wrap = wrap;
    clip.facts.first_row = 100;
    clip.facts.row_count = row_count;
    clip.facts.period_s = period_s;
    return clip;
}

void expect_rows(const RowPair& found, std::uint32_t row0, std::uint32_t row1, double factor,
                 const char* what) {
    EXPECT_EQ(found.row0, 100 + row0) << what;
    EXPECT_EQ(found.row1, 100 + row1) << what;
    EXPECT_NEAR(static_cast<double>(found.factor), factor, 1e-6) << what;
}

TEST(RowLaw, OfALoopEndsInItsFirstRow) {
    ReaderClip clip = clip_of(POSEPACK_WRAP_LOOP, 4, 2.0f);
    expect_rows(rows_at(clip, 0.0, {}), 0, 1, 0.0, "the beginning");
    expect_rows(rows_at(clip, 0.75, {}), 1, 2, 0.5, "between");
    expect_rows(rows_at(clip, 1.75, {}), 3, 0, 0.5, "the last interval");
    clip.facts.closing_row = 1;
    expect_rows(rows_at(clip, 1.75, {}), 3, 4, 0.5, "into the closing row");
    EXPECT_EQ(row_time_s(clip, 3), 1.5);
}

TEST(RowLaw, OfAClipThatEndsHoldsTheLastRow) {
    const ReaderClip clip = clip_of(POSEPACK_WRAP_ONCE, 5, 2.0f);
    expect_rows(rows_at(clip, 0.25, {}), 0, 1, 0.5, "between");
    expect_rows(rows_at(clip, 2.0, {}), 4, 4, 0.0, "the end");
    expect_rows(rows_at(clip, 3.0, {}), 4, 4, 0.0, "behind the end");
    EXPECT_EQ(row_time_s(clip, 4), 2.0);
    expect_rows(rows_at(clip_of(POSEPACK_WRAP_ONCE, 1, 0.0f), 0.0, {}), 0, 0, 0.0, "one row");
}

TEST(RowLaw, HoldsStepsAndCuts) {
    ReaderClip clip = clip_of(POSEPACK_WRAP_ONCE, 5, 2.0f);
    clip.cuts = {1, 3};
    expect_rows(rows_at(clip, 0.75, {}), 1, 1, 0.0, "a cut");
    expect_rows(rows_at(clip, 1.25, {}), 2, 3, 0.5, "no cut");
    clip.facts.interpolation = POSEPACK_INTERPOLATION_STEP;
    expect_rows(rows_at(clip, 1.25, {}), 2, 2, 0.0, "a step");
}

TEST(RowLaw, APhaseInDoublePrecisionKeepsTheTimeForDays) {
    const ReaderClip clip = clip_of(POSEPACK_WRAP_LOOP, 4, 2.0f);
    expect_rows(rows_at(clip, 0.75, {.running_s = 1e6}), 1, 2, 0.5, "a loop");
    const ReaderClip once = clip_of(POSEPACK_WRAP_ONCE, 5, 2.0f);
    expect_rows(rows_at(once, 0.25, {.running_s = 1e6}), 0, 1, 0.5, "a clip that ends");
}

// Floats step by 1/128 s from 65,536 s on, and by 1/16 s from 524,288 s on.
TEST(RowLaw, AClockInOneFloatLosesIt) {
    const ReaderClip clip = clip_of(POSEPACK_WRAP_LOOP, 4, 2.0f);
    const Reader day{.running_s = 86'400.0, .has_raw_clock = true};
    expect_rows(rows_at(clip, 0.5 + 1.0 / 128, day), 1, 2, 2.0 / 128, "a time that a float has");
    expect_rows(rows_at(clip, 0.5 + 0.3 / 128, day), 1, 2, 0.0, "one that it has not");
    const Reader days{.running_s = 1e6, .has_raw_clock = true};
    expect_rows(rows_at(clip, 0.54, days), 1, 2, 2.0 / 16, "later");
    const ReaderClip once = clip_of(POSEPACK_WRAP_ONCE, 5, 2.0f);
    expect_rows(rows_at(once, 0.54, days), 1, 2, 2.0 / 16, "a clip that ends");
}

}  // namespace
}  // namespace posepack::stress
