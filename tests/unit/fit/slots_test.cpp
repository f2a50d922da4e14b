// SPDX-License-Identifier: MIT
// Slots: rows where the motion is, none where it is straight, a row's end in front of a jump.
#include "fit/slots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fit/polyline.hpp"

namespace posepack::fit {
namespace {

// One bone that moves along x, and one that is still; one vertex each, at the origin.
Tracks tracks_of(const std::function<double(double)>& x, std::uint32_t keys, std::uint32_t per_key,
                 bool loop) {
    Tracks tracks;
    tracks.form = Form::affine;
    tracks.loop = loop;
    tracks.bone_count = 2;
    tracks.key_intervals = keys;
    tracks.interval_count = keys * per_key;
    tracks.known_count = tracks.interval_count + (loop ? 0 : 1);
    tracks.turned.resize(2);
    for (std::uint32_t bone = 0; bone < 2; ++bone)
        for (std::size_t k = 0; k < tracks.sample_count(); ++k) {
            const auto shift = static_cast<float>(bone == 0 ? x(tracks.time_phase(k)) : 0.0);
            const float matrix[12] = {1, 0, 0, shift, 0, 1, 0, 0, 0, 0, 1, 0};
            tracks.numbers.insert(tracks.numbers.end(), matrix, matrix + 12);
            tracks.exact.insert(tracks.exact.end(), matrix, matrix + 12);
        }
    return tracks;
}

std::vector<BonePoints> points_of_two() {
    BonePoints points;
    points.x = points.y = points.z = std::vector<float>(kPointsAtOnce, 0.0f);
    points.weight = {1.0f, 0.0f, 0.0f, 0.0f};
    points.counted = kPointsAtOnce;
    points.share = 1.0;
    return {points, points};
}

// Still for half of the time, then 12 waves an eighth of it, then still again.
double burst(double phase) {
    const double along = (phase - 0.5) * 8.0;
    return along < 0.0 || along > 1.0 ? 0.0 : 0.2 * std::sin(12.0 * 6.283185307179586 * along);
}

TEST(Slots, PutRowsWhereTheMotionIs) {
    const Tracks tracks = tracks_of(burst, 64, 48, false);
    const SlotPlan plan = plan_slots(tracks, points_of_two(), 0.02, 1.0, 2.0, {});
    ASSERT_EQ(plan.slots.size(), 64u);
    EXPECT_FALSE(plan.is_rough);
    std::uint32_t within = 0;
    for (std::size_t slot = 0; slot < 64; ++slot)
        if (slot >= 32 && slot < 40) within += plan.slots[slot].span == 0 ? plan.slots[slot].offset : 1;
    EXPECT_GT(within, 60u) << "rows of the burst";
    EXPECT_LE(plan.interval_count - within, 4u) << "rows beside it";
    EXPECT_EQ(plan.slots[0].span, 32u);
    EXPECT_EQ(plan.slots[31].offset, 31u);
}

TEST(Slots, GoOnWhereTheOneBeforeEnds) {
    Tracks tracks = tracks_of(burst, 64, 48, false);
    bend(tracks, plan_slots(tracks, points_of_two(), 0.02, 1.0, 2.0, {}));
    EXPECT_EQ(tracks.phase(0), 0.0);
    EXPECT_EQ(tracks.phase(tracks.interval_count), 1.0);
    for (std::size_t k = 1; k <= tracks.interval_count; ++k) {
        const double step = (tracks.phase(k) - tracks.phase(k - 1)) * tracks.slots.interval_count;
        EXPECT_GT(step, 0.0) << k;
        EXPECT_LE(step, 1.0) << k;
    }
}

TEST(Slots, MakeLinesThatStayNearTheTracks) {
    Tracks tracks = tracks_of(burst, 64, 48, false);
    const auto points = points_of_two();
    bend(tracks, plan_slots(tracks, points, 0.02, 1.0, 2.0, {}));
    const Polyline line = fit_polyline(tracks, 0, tracks.slots.interval_count);
    EXPECT_LT(profile_of(tracks, line, 0, points[0], 1.0, 1e-4).max, 0.02);
    // As many rows at even times are far from it.
    tracks.bent.clear();
    const Polyline even = fit_polyline(tracks, 0, tracks.slots.interval_count);
    EXPECT_GT(profile_of(tracks, even, 0, points[0], 1.0, 1e-4).max, 0.1);
}

TEST(Slots, SayThatSamplesWereTooFew) {
    const Tracks tracks = tracks_of(burst, 64, 4, false);
    EXPECT_TRUE(plan_slots(tracks, points_of_two(), 1e-3, 1.0, 2.0, {}).is_rough);
}

TEST(Slots, ARowEndsInFrontOfAJump) {
    // A slope, and a jump at key 16 of 32.
    const auto jump = [](double phase) { return phase < 0.5 ? 0.2 * phase : 1.0 - 0.3 * phase; };
    Tracks tracks = tracks_of(jump, 32, 16, false);
    const auto points = points_of_two();
    const SlotPlan plan = plan_slots(tracks, points, 1e-3, 1.0, 4.0, {2.0});
    EXPECT_EQ(plan.interval_count, 3u) << "two slopes, and the interval between them that no slot shows";
    EXPECT_EQ(plan.slots[15].row, 0u);
    EXPECT_EQ(plan.slots[16].row, 2u);
    bend(tracks, plan);
    const Polyline line = fit_polyline(tracks, 0, 3);
    EXPECT_LT(profile_of(tracks, line, 0, points[0], 1.0, 1e-4).max, 1e-3);
    // Where the jump is not known, it takes rows, and stays a slope.
    EXPECT_TRUE(plan_slots(tracks, points, 1e-3, 1.0, 4.0, {}).is_rough);
}

TEST(Slots, AreNoneForOnePose) {
    Tracks still = tracks_of([](double) { return 0.0; }, 8, 8, false);
    still.interval_count = 0;
    EXPECT_TRUE(plan_slots(still, points_of_two(), 1e-3, 1.0, 0.0, {}).slots.empty());
}

}  // namespace
}  // namespace posepack::fit
