// SPDX-License-Identifier: MIT
// The times that are looked at, and when quarter points are worth it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure/test_times.hpp"
#include "posepack/format.h"
#include "support/model_spec.hpp"

namespace posepack::measure {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

palette::PaletteClip plan_of(std::uint32_t row_count, double period_s, double duration_s, recipe::Wrap wrap) {
    motion::RowPlan plan;
    plan.row_count = row_count;
    plan.period_s = period_s;
    plan.duration_s = duration_s;
    plan.wrap = wrap;
    palette::PaletteClip clip;
    clip.plan = plan;
    return clip;
}

TEST(TestTimes, AreRowsKeysAndMidpoints) {
    const std::vector<double> keys{0.0, 0.3, 1.0};
    EXPECT_EQ(test_times_s(plan_of(3, 1, 1, recipe::Wrap::once), keys),
              (std::vector<double>{0.0, 0.15, 0.3, 0.4, 0.5, 0.75, 1.0}));
    EXPECT_EQ(test_times_s(plan_of(2, 1, 1, recipe::Wrap::loop), {}),
              (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
    EXPECT_EQ(test_times_s(plan_of(1, 0, 0, recipe::Wrap::once), {}), (std::vector<double>{0.0}));
}

TEST(TestTimes, AreTheRowsOfEveryRun) {
    palette::PaletteClip clip = plan_of(5, 1, 1, recipe::Wrap::once);
    clip.runs.entries = {0u, 2u << POSEPACK_RUN_OFFSET_BITS, 3u << POSEPACK_RUN_OFFSET_BITS};
    const std::vector<double> times = test_times_s(clip, {});
    const std::vector<double> expected{0.0, 1.0 / 6, 1.0 / 3, 5.0 / 12, 0.5, 7.0 / 12, 2.0 / 3, 5.0 / 6, 1.0};
    ASSERT_EQ(times.size(), expected.size());
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-12);
}

TEST(TestTimes, AreTheRowsThatSlotsShow) {
    palette::PaletteClip clip = plan_of(7, 1, 1, recipe::Wrap::once);
    clip.runs.entries = {6u << POSEPACK_RUN_OFFSET_BITS};
    const auto slot = [](std::uint32_t row, std::uint32_t offset, std::uint32_t span) {
        return row | offset << 16 | span << 24;
    };
    // Quarters: two share the first interval, one holds three, one is held.
    clip.runs.slots = {slot(0, 0, 2), slot(0, 1, 2), slot(1, 3, 0), slot(4, 0, 0)};
    const std::vector<double> times = test_times_s(clip, {});
    std::vector<double> rows;
    for (std::size_t i = 0; i < times.size(); i += 2) rows.push_back(times[i]);
    const std::vector<double> expected{0.0, 0.5, 0.5 + 1.0 / 12, 0.5 + 2.0 / 12, 0.75, 1.0};
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_NEAR(rows[i], expected[i], 1e-12);
}

TEST(TestTimes, LeaveTheGapOfAnOpenLoopOut) {
    const std::vector<double> times = test_times_s(plan_of(4, 1, 0.75, recipe::Wrap::loop), {});
    EXPECT_EQ(times.back(), 0.75) << "behind the last key there is no source to compare with";
    EXPECT_EQ(times.size(), 7u);
}

TEST(TestTimes, OfAKeyAndTheRowThatWasMeantForItOne) {
    std::vector<double> keys;
    for (const float t : support::grid(68, 24)) keys.push_back(t);
    const std::vector<double> times =
        test_times_s(plan_of(67, keys.back(), keys.back(), recipe::Wrap::loop), keys);
    EXPECT_EQ(times.size(), 2u * 67 + 1);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GT(times[i] - times[i - 1], 0.4 / 24);
}

TEST(TestTimes, LookAtAJumpFromBothSides) {
    const std::vector<double> times =
        test_times_s(plan_of(3, 1, 1, recipe::Wrap::once), std::vector{0.4}, std::vector{0.4, 0.0, 1.0});
    const auto near = [&times](double jump_s) {
        return std::count_if(times.begin(), times.end(),
                             [jump_s](double t) { return t != jump_s && std::abs(t - jump_s) < 2e-6; });
    };
    EXPECT_EQ(near(0.4), 2);
    EXPECT_EQ(near(0.0), 1) << "nothing lies before the clip";
    EXPECT_EQ(near(1.0), 1) << "nor behind it";
    EXPECT_EQ(times.size(), 7u + 4);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

TEST(TestTimes, QuarterTheSpansWhereAskedTo) {
    EXPECT_EQ(test_times_s(plan_of(2, 1, 1, recipe::Wrap::once), {}, {}, Parts::quarters),
              (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
}

// A turn about Z.
motion::Affine turned(double degrees) {
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    motion::Affine out;
    out.linear[0] = {c, s, 0};
    out.linear[1] = {-s, c, 0};
    return out;
}

// Of a bone whose vertices lie about a point `away` from the axis.
palette::BoneMoment moment_at(double away, double radius) {
    palette::BoneMoment moment;
    moment.centroid = {away, 0, 0};
    moment.radius = radius;
    return moment;
}

// How far a blend of two quaternions, `degrees` apart, is off at the share u, in radians.
double exact_bend(double degrees, double u) {
    const double half = degrees * kDegree / 2;
    return 2 * (std::atan2(u * std::sin(half), 1 - u + u * std::cos(half)) - u * half);
}

TEST(Bend, IsHalfToTwiceWhatItIsOfATurn) {
    for (const double degrees : {1.0, 5.0, 10.0, 20.0, 30.0, 60.0, 90.0, 120.0})
        for (const double away : {0.0, 1.0, 30.0, 1000.0}) {
            const double exact = (away + 0.5) * std::abs(exact_bend(degrees, 0.25));
            const double found = bend_between(turned(0), turned(degrees), moment_at(away, 0.5));
            EXPECT_GT(found, 0.5 * exact) << degrees << " degrees, " << away;
            EXPECT_LT(found, 2.0 * exact) << degrees << " degrees, " << away;
            EXPECT_NEAR(exact_bend(degrees, 0.5), 0.0, 1e-12) << "half way nothing shows";
        }
}

TEST(Bend, IsNothingWithoutATurn) {
    motion::Affine moved = turned(30);
    moved.translation = {100, 0, 0};
    EXPECT_NEAR(bend_between(turned(30), moved, moment_at(1, 1)), 0.0, 1e-12);
    motion::Affine grown = turned(30);
    grown.linear *= 7.0;
    EXPECT_NEAR(bend_between(turned(30), grown, moment_at(1, 1)), 0.0, 1e-12);
    EXPECT_EQ(bend_between({glm::dmat3(0.0), {}}, turned(30), moment_at(1, 1)), 0.0)
        << "of a bone that is nothing";
}

}  // namespace
}  // namespace posepack::measure
