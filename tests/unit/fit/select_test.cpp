// SPDX-License-Identifier: MIT
// Rows for every bone: none for the still, few for the slow, shared among those that move alike.
#include "fit/select.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wave.hpp"

namespace posepack::fit {
namespace {

constexpr double kFloor = 1e-4;

// One vertex a bone at the origin.
std::vector<BonePoints> single_points(std::size_t bone_count) {
    BonePoints points;
    points.x = points.y = points.z = std::vector<float>(kPointsAtOnce, 0.0f);
    points.weight = {1.0f, 0.0f, 0.0f, 0.0f};
    points.counted = kPointsAtOnce;
    points.share = 1.0;
    return std::vector<BonePoints>(bone_count, points);
}

struct Case {
    Tracks tracks;
    std::vector<BonePoints> points;
    std::optional<Selection> select(const Limits& limits) {
        RowSelector selector(tracks, points, points.size(), 24, 1.0, kFloor, 4);
        return selector.select(limits);
    }
};

Case case_of(const std::vector<double>& waves, bool loop = true) {
    return {wave_tracks(waves, 32, loop), single_points(waves.size())};
}

std::uint32_t rows_of(const Selection& selection) {
    std::uint32_t sum = 0;
    for (const BoneRows& rows : selection.rows)
        if (rows.like == animal::kNone) sum += rows.interval_count + 1;
    return sum;
}

TEST(RowSelector, GivesTheFastMoreRowsThanTheSlowAndTheStillOne) {
    const auto selection = case_of({0.0, 1.0, 3.0}).select({5e-3, 5e-3, HUGE_VAL});
    ASSERT_TRUE(selection);
    EXPECT_EQ(selection->rows[0].interval_count, 0u);
    EXPECT_GT(selection->rows[1].interval_count, 3u);
    EXPECT_GT(selection->rows[2].interval_count, 2 * selection->rows[1].interval_count);
    EXPECT_LE(selection->expected.max, 5e-3);
}

TEST(RowSelector, SharesRowsAmongBonesThatMoveAlike) {
    const auto selection = case_of({2.0, 1.0, 2.0}).select({5e-3, 5e-3, HUGE_VAL});
    ASSERT_TRUE(selection);
    EXPECT_EQ((selection->rows[0].like == 2u) + (selection->rows[2].like == 0u), 1);
    EXPECT_EQ(selection->rows[1].like, animal::kNone);
}

TEST(RowSelector, NarrowerLimitsNeverTakeFewerRows) {
    for (const bool loop : {false, true}) {
        std::uint32_t before = 0;
        for (double limit = 0.2; limit > 1e-3; limit *= 0.7) {
            const auto selection = case_of({0.5, 1.0, 2.0, 3.0}, loop).select({limit, 0.5 * limit, HUGE_VAL});
            ASSERT_TRUE(selection) << limit;
            EXPECT_GE(rows_of(*selection), before) << limit;
            EXPECT_LE(selection->expected.max, limit);
            EXPECT_LE(selection->expected.p999, 0.5 * limit * 1.1);
            before = rows_of(*selection);
        }
    }
}

TEST(RowSelector, KeepsAMeanSquare) {
    const auto wide = case_of({1.0, 2.0}).select({0.1, 0.1, HUGE_VAL});
    const auto narrow = case_of({1.0, 2.0}).select({0.1, 0.1, 2e-3});
    ASSERT_TRUE(wide && narrow);
    EXPECT_LE(narrow->expected.rms, 2e-3);
    EXPECT_GT(wide->expected.rms, 2e-3);
    EXPECT_GT(rows_of(*narrow), rows_of(*wide));
}

TEST(RowSelector, SaysWhenNothingIsFineEnough) {
    EXPECT_FALSE(case_of({30.0}).select({1e-3, 1e-3, HUGE_VAL}));
}

TEST(RowSelector, WithoutAMeansTakesMoreRows) {
    const Limits limits{5e-3, 5e-3, HUGE_VAL};
    const auto rows_with = [&](const Means& means) {
        Case of = case_of({0.0, 1.0, 3.0, 3.0});
        RowSelector selector(of.tracks, of.points, of.points.size(), 24, 1.0, kFloor, 4, means);
        const auto selection = selector.select(limits);
        EXPECT_TRUE(selection);
        return selection ? rows_of(*selection) : 0u;
    };
    const std::uint32_t with_all = rows_with({});
    EXPECT_GT(rows_with({.own_rows = false}), with_all);
    EXPECT_GT(rows_with({.sharing = false}), with_all);
    EXPECT_GT(rows_with({.least_squares = false}), with_all);
}

TEST(Profile, CountsWhatLiesAboveADistance) {
    Profile profile(1e-3);
    for (int i = 0; i < 1000; ++i) {
        const float distance = 1e-3f + 1e-5f * static_cast<float>(i);
        profile.count(distance * distance, 2.0);
    }
    EXPECT_NEAR(profile.count_above(6e-3), 1000.0, 40.0);
    EXPECT_NEAR(profile.count_above(1e-3), 2000.0, 40.0);
    EXPECT_EQ(profile.count_above(1.0), 0.0);
}

}  // namespace
}  // namespace posepack::fit
