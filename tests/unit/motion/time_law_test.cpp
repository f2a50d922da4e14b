// SPDX-License-Identifier: MIT
// RowPlan as a clock: which rows show a time, and at which time a row was taken.
#include <gtest/gtest.h>

#include "motion/row_plan.hpp"

namespace posepack::motion {
namespace {

using recipe::Wrap;

RowPlan plan_of(Wrap wrap, std::uint32_t row_count, double period_s, bool step = false) {
    RowPlan plan;
    plan.wrap = wrap;
    plan.row_count = row_count;
    plan.period_s = plan.duration_s = period_s;
    plan.step = step;
    return plan;
}

void expect_blend(const RowPlan& plan, double time_s, std::uint32_t row0, std::uint32_t row1, double factor) {
    const RowBlend blend = plan.rows_at(time_s);
    EXPECT_EQ(blend.row0, row0) << time_s << " s";
    EXPECT_EQ(blend.row1, row1) << time_s << " s";
    EXPECT_NEAR(blend.factor, factor, 1e-9) << time_s << " s";
}

TEST(TimeLaw, Loop) {
    const RowPlan plan = plan_of(Wrap::loop, 4, 2.0);
    EXPECT_EQ(plan.row_time_s(0), 0.0);
    EXPECT_EQ(plan.row_time_s(3), 1.5);
    expect_blend(plan, 0.0, 0, 1, 0.0);
    expect_blend(plan, 0.25, 0, 1, 0.5);
    expect_blend(plan, 0.5, 1, 2, 0.0);
    expect_blend(plan, 1.75, 3, 0, 0.5);
    expect_blend(plan, 2.0, 3, 0, 1.0);  // the end is row 0 again
    expect_blend(plan, -1.0, 0, 1, 0.0);
    expect_blend(plan, 9.0, 3, 0, 1.0);
}

TEST(TimeLaw, OnceAndPingPong) {
    for (const Wrap wrap : {Wrap::once, Wrap::ping_pong}) {
        const RowPlan plan = plan_of(wrap, 5, 2.0);
        EXPECT_EQ(plan.row_time_s(4), 2.0);
        expect_blend(plan, 0.0, 0, 1, 0.0);
        expect_blend(plan, 0.75, 1, 2, 0.5);
        expect_blend(plan, 1.5, 3, 4, 0.0);
        expect_blend(plan, 2.0, 3, 4, 1.0);
        expect_blend(plan, 9.0, 3, 4, 1.0);
    }
}

TEST(TimeLaw, StepHolds) {
    const RowPlan once = plan_of(Wrap::once, 5, 2.0, true);
    expect_blend(once, 0.0, 0, 0, 0.0);
    expect_blend(once, 0.49, 0, 0, 0.0);
    expect_blend(once, 0.5, 1, 1, 0.0);
    expect_blend(once, 1.99, 3, 3, 0.0);
    expect_blend(once, 2.0, 4, 4, 0.0);
    const RowPlan loop = plan_of(Wrap::loop, 4, 2.0, true);
    expect_blend(loop, 0.74, 1, 1, 0.0);
    expect_blend(loop, 1.99, 3, 3, 0.0);
}

TEST(TimeLaw, AStepLoopEndsWhereItBegins) {
    expect_blend(plan_of(Wrap::loop, 4, 2.0, true), 2.0, 0, 0, 0.0);
}

TEST(TimeLaw, OneRow) {
    for (const Wrap wrap : {Wrap::loop, Wrap::once}) {
        expect_blend(plan_of(wrap, 1, 0.0), 0.0, 0, 0, 0.0);
        expect_blend(plan_of(wrap, 1, 0.5), 0.3, 0, 0, 0.0);
        EXPECT_EQ(plan_of(wrap, 1, 0.5).row_time_s(0), 0.0);
    }
}

// A row asked for at its own time is that row alone, for awkward periods and many rows.
TEST(TimeLaw, RowsShowThemselves) {
    std::size_t looked_at = 0;
    for (const double period_s : {67.0 / 24, 2.7916667461395264, 1.0 / 3, 599.9, 1e-3})
        for (const std::uint32_t row_count : {2u, 3u, 67u, 496u, 18'000u})
            for (const Wrap wrap : {Wrap::loop, Wrap::once})
                for (const bool step : {false, true}) {
                    const RowPlan plan = plan_of(wrap, row_count, period_s, step);
                    for (std::uint32_t row = 0; row<row_count; row += row_count> 1000 ? 97 : 1, ++looked_at) {
                        const RowBlend blend = plan.rows_at(plan.row_time_s(row));
                        const std::uint32_t shown = blend.factor > 0.5 ? blend.row1 : blend.row0;
                        ASSERT_EQ(shown, row) << period_s << " s, " << row_count << " rows";
                        ASSERT_TRUE(blend.factor < 1e-8 || blend.factor > 1 - 1e-8);
                    }
                }
    EXPECT_GT(looked_at, 10'000u);
}

}  // namespace
}  // namespace posepack::motion
