// SPDX-License-Identifier: MIT
// Which rows a clip gets: its own keys, its exact period, its seam, and what a catalog may wish instead.
#include "motion/row_plan.hpp"

#include "sampled.hpp"

namespace posepack::motion {
namespace {

using recipe::Seam;
using recipe::Wrap;

// A point that goes once around a circle of radius 1: `key_count` keys, `last` of a turn at the last key.
animal::Animal circle(std::size_t key_count, double rate_hz, double last,
                      const std::string& interpolation = "LINEAR", double start_s = 0.0) {
    std::vector<float> values;
    for (std::size_t k = 0; k < key_count; ++k) {
        const double turn = last * static_cast<double>(k) / static_cast<double>(key_count - 1);
        const double angle = 2 * 3.14159265358979323846 * turn;
        values.insert(values.end(),
                      {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0f});
    }
    return one_channel("translation", support::grid(key_count, rate_hz, start_s), values, interpolation);
}

RowPlan plan_of(const animal::Animal& animal, const RowWish& wish = {}, double radius = 1.0) {
    ClipSampler sampler(animal, animal.clips[0]);
    return plan_rows(animal, animal.clips[0], sampler, unique_points(animal), radius, wish);
}

// Ends a whole number of key steps short of the full turn: `missing` steps.
animal::Animal nearly_round(double missing) {
    return circle(25, 24, 24.0 / (24.0 + missing));
}

TEST(RowPlan, AClosedLoopHasARowForEveryKeyButTheLast) {
    const RowPlan plan = plan_of(circle(25, 24, 1.0));
    EXPECT_EQ(plan.wrap, Wrap::loop);
    EXPECT_EQ(plan.seam, Seam::closed);
    EXPECT_EQ(plan.row_count, 24u);
    EXPECT_DOUBLE_EQ(plan.period_s, 1.0);
    EXPECT_DOUBLE_EQ(plan.rate_hz, 24.0);
    EXPECT_TRUE(plan.on_key_grid);
    EXPECT_FALSE(plan.step);
    EXPECT_LT(plan.seam_gap, 1e-6);
    EXPECT_TRUE(plan.remarks.empty());
}

// 67 steps of 1/24 s in float32 are a hair longer than 67/24 s: 67 rows, never 68.
TEST(RowPlan, RowsAreRoundedNeverRaised) {
    for (std::size_t steps = 2; steps < 400; ++steps)
        for (const double rate_hz : {24.0, 25.0, 30.0}) {
            const RowPlan plan = plan_of(circle(steps + 1, rate_hz, 1.0, "LINEAR", 0.0), {}, 1.0);
            ASSERT_EQ(plan.row_count, steps) << rate_hz << " Hz";
        }
    const animal::Animal whale = circle(68, 24, 1.0);
    EXPECT_GT(whale.clips[0].duration_s, 67.0 / 24) << "what float32 makes of it";
    EXPECT_EQ(plan_of(whale).row_count, 67u);
    EXPECT_EQ(plan_of(whale).period_s, whale.clips[0].duration_s) << "the exact period of the file";
}

TEST(RowPlan, APopStaysClosedWithARemark) {
    const RowPlan plan = plan_of(nearly_round(0.2));
    EXPECT_EQ(plan.wrap, Wrap::loop);
    EXPECT_EQ(plan.seam, Seam::closed);
    EXPECT_EQ(plan.row_count, 24u);
    ASSERT_EQ(plan.remarks.size(), 1u);
    EXPECT_EQ(plan.remarks[0].code, base::IssueCode::warn_seam);
    EXPECT_EQ(plan.remarks[0].where, "Clip");
    EXPECT_GT(plan.seam_gap, 0.01);
}

TEST(RowPlan, AMissingStepIsAnOpenSeam) {
    const RowPlan plan = plan_of(nearly_round(1.0));
    EXPECT_EQ(plan.wrap, Wrap::loop);
    EXPECT_EQ(plan.seam, Seam::open);
    EXPECT_EQ(plan.row_count, 25u) << "the last key is a pose of its own";
    EXPECT_DOUBLE_EQ(plan.duration_s, 1.0);
    EXPECT_NEAR(plan.period_s, 25.0 / 24, 1e-12);
    EXPECT_NEAR(plan.rate_hz, 24.0, 1e-9);
    EXPECT_TRUE(plan.on_key_grid);
    EXPECT_TRUE(plan.remarks.empty());
    EXPECT_NEAR(plan.seam_gap, 2 * std::sin(3.14159265358979323846 / 25), 1e-6);
}

TEST(RowPlan, EndsThatHaveNothingToDoWithEachOtherPlayOnce) {
    const RowPlan plan = plan_of(nearly_round(3.0));
    EXPECT_EQ(plan.wrap, Wrap::once);
    EXPECT_EQ(plan.row_count, 25u);
    EXPECT_DOUBLE_EQ(plan.period_s, 1.0);
    EXPECT_NEAR(plan.rate_hz, 24.0, 1e-9);
    EXPECT_TRUE(plan.remarks.empty());
}

TEST(RowPlan, ASingleKeyIsOneRow) {
    const RowPlan plan = plan_of(one_channel("translation", {1.5f}, {1, 2, 3}));
    EXPECT_EQ(plan.row_count, 1u);
    EXPECT_EQ(plan.rate_hz, 0.0);
    EXPECT_EQ(plan.period_s, 0.0);
    EXPECT_TRUE(plan.remarks.empty());
    EXPECT_EQ(plan.rows_at(0.0).row0, 0u);
}

TEST(RowPlan, KeysAtOneTimeAreOneRow) {
    const RowPlan plan = plan_of(one_channel("translation", {1, 1}, {1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(plan.row_count, 1u);
    EXPECT_EQ(plan.duration_s, 0.0);
}

TEST(RowPlan, StepClipsAreMarked) {
    const RowPlan plan = plan_of(circle(25, 24, 1.0, "STEP"));
    EXPECT_TRUE(plan.step);
    EXPECT_EQ(plan.row_count, 24u);
}

TEST(RowPlan, KeysOnNoGridGetThirtyHertzAndARemark) {
    const RowPlan plan = plan_of(one_channel("translation", {0, 0.1234f, 0.2871f, 0.3333f, 0.8f, 1.0f},
                                             {0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0, 0.5f, 0, 0, 0, 0, 0}));
    EXPECT_EQ(plan.wrap, Wrap::loop);
    EXPECT_EQ(plan.row_count, 30u);
    EXPECT_FALSE(plan.on_key_grid);
    ASSERT_EQ(plan.remarks.size(), 1u);
    EXPECT_EQ(plan.remarks[0].code, base::IssueCode::warn_rate);
}

TEST(RowPlan, AStillClipSaysNothing) {
    const RowPlan plan = plan_of(one_channel("translation", {0, 1}, {1, 2, 3, 1, 2, 3}));
    EXPECT_TRUE(plan.remarks.empty());
    EXPECT_EQ(plan.wrap, Wrap::loop);
    EXPECT_EQ(plan.seam, Seam::closed);
}

TEST(RowPlan, WishesOverrideWhatIsMeasured) {
    struct Row {
        const char* what;
        double missing;
        RowWish wish;
        Wrap wrap;
        Seam seam;
        std::uint32_t row_count;
        std::size_t remarks;
    };
    const Row rows[] = {
        {"closed, played once",
         0,
         {std::nullopt, Wrap::once, Seam::automatic},
         Wrap::once,
         Seam::closed,
         25,
         0},
        {"closed, there and back",
         0,
         {std::nullopt, Wrap::ping_pong, Seam::automatic},
         Wrap::ping_pong,
         Seam::closed,
         25,
         0},
        {"closed, called open",
         0,
         {std::nullopt, Wrap::automatic, Seam::open},
         Wrap::loop,
         Seam::open,
         25,
         0},
        {"open, called closed",
         1,
         {std::nullopt, Wrap::automatic, Seam::closed},
         Wrap::loop,
         Seam::closed,
         24,
         1},
        {"once, made to loop", 3, {std::nullopt, Wrap::loop, Seam::automatic}, Wrap::loop, Seam::open, 25, 0},
        {"once, looped and closed",
         3,
         {std::nullopt, Wrap::loop, Seam::closed},
         Wrap::loop,
         Seam::closed,
         24,
         1},
        {"closed, half the rows",
         0,
         {12.0, Wrap::automatic, Seam::automatic},
         Wrap::loop,
         Seam::closed,
         12,
         0},
        {"closed, more rows", 0, {60.0, Wrap::automatic, Seam::automatic}, Wrap::loop, Seam::closed, 60, 0},
        {"closed, a rate off the grid",
         0,
         {17.3, Wrap::automatic, Seam::automatic},
         Wrap::loop,
         Seam::closed,
         17,
         0},
        {"closed, hardly any", 0, {0.1, Wrap::automatic, Seam::automatic}, Wrap::loop, Seam::closed, 1, 0},
        {"once, a rate off the grid",
         3,
         {10.4, Wrap::automatic, Seam::automatic},
         Wrap::once,
         Seam::closed,
         11,
         0},
        {"once, hardly any", 3, {0.1, Wrap::automatic, Seam::automatic}, Wrap::once, Seam::closed, 2, 0},
    };
    for (const Row& row : rows) {
        const RowPlan plan = plan_of(nearly_round(row.missing), row.wish);
        EXPECT_EQ(plan.wrap, row.wrap) << row.what;
        EXPECT_EQ(plan.seam, row.seam) << row.what;
        EXPECT_EQ(plan.row_count, row.row_count) << row.what;
        EXPECT_EQ(plan.remarks.size(), row.remarks) << row.what;
        const double intervals = plan.wrap == Wrap::loop ? plan.row_count : plan.row_count - 1;
        EXPECT_NEAR(plan.rate_hz, plan.row_count == 1 ? 0.0 : intervals / plan.period_s, 1e-9) << row.what;
    }
}

// An open seam keeps its period at every rate: the missing step is one of the keys, not of the rows.
TEST(RowPlan, AnOpenSeamKeepsItsPeriodAtOtherRates) {
    for (const double rate_hz : {10.0, 24.0, 60.0}) {
        const RowPlan plan = plan_of(nearly_round(1.0), {rate_hz, Wrap::automatic, Seam::automatic});
        EXPECT_EQ(plan.seam, Seam::open);
        EXPECT_NEAR(plan.period_s, 25.0 / 24, 1e-12);
        EXPECT_EQ(plan.row_count, static_cast<std::uint32_t>(std::lround(rate_hz * 25.0 / 24)));
    }
}

TEST(RowPlan, RowsBehindTheLastKeyOfAnOpenLoopAreBlended) {
    const animal::Animal animal = nearly_round(1.0);
    const RowPlan plan = plan_of(animal, {48.0, Wrap::automatic, Seam::automatic});
    ASSERT_EQ(plan.row_count, 50u);
    ClipSampler sampler(animal, animal.clips[0]);
    std::vector<Affine> bones(1);
    sample_row(sampler, plan, 49, bones);
    const glm::dvec3 last = bones_at(animal, 0, 1.0)[0].translation;
    const glm::dvec3 first = bones_at(animal, 0, 0.0)[0].translation;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(bones[0].translation[c], 0.5 * (last[c] + first[c]), 1e-12);
    sample_row(sampler, plan, 48, bones);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(bones[0].translation[c], last[c], 1e-12) << "the last key itself";
}

TEST(RowPlan, TheLeadInIsNoPartOfTheClip) {
    const RowPlan plan = plan_of(circle(25, 24, 1.0, "LINEAR", 2.0));
    EXPECT_EQ(plan.row_count, 24u);
    EXPECT_NEAR(plan.period_s, 1.0, 1e-6);
    EXPECT_TRUE(plan.on_key_grid);
}

}  // namespace
}  // namespace posepack::motion
