// SPDX-License-Identifier: MIT
// Errors that can be told in advance, the times that are looked at, and values at the edge of the floats.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "measure/decode_cost.hpp"
#include "measure/measure_error.hpp"
#include "measure/skin_difference.hpp"
#include "posepack/format.h"
#include "support/baked.hpp"
#include "support/sample_models.hpp"

namespace posepack::measure {
namespace {

using support::ModelSpec;
using support::turn;
using support::turns;

constexpr double kPi = 3.14159265358979323846;

struct Measured {
    support::Baked baked;
    ErrorStats stats;
};

Measured measured(const ModelSpec& spec, const recipe::OutputOptions& output = support::in_floats(),
                  const motion::RowWish& wish = {}) {
    const animal::Animal animal = support::animal_of(spec);
    Measured out{support::bake_all(animal, output, std::vector<motion::RowWish>(spec.clips.size(), wish)),
                 {}};
    auto stats = measure_error(animal, out.baked.palette, out.baked.container, motion::unique_points(animal),
                               motion::unique_normals(animal));
    if (!stats) throw std::runtime_error(base::format_issue(stats.issue()));
    out.stats = std::move(stats).value();
    return out;
}

// A bone that turns by the same angle between its rows: halfway, a blend of matrices draws the chord.
TEST(KnownErrors, ARotationCutsItsCorner) {
    for (const double step_deg : {2.0, 10.0, 20.0, 45.0}) {
        ModelSpec spec = support::one_bone({3, 0, 0, -3, 0, 0, 0, 0.5f, 4});
        std::vector<std::array<float, 4>> rotations;
        for (int k = 0; k < 9; ++k) rotations.push_back(turn(step_deg * k, 0, 0, 1));
        spec.clips = {{"Turn", {{0, "rotation", support::grid(9, 24), turns(rotations)}}}};
        const Measured m = measured(spec, support::in_floats(), {std::nullopt, recipe::Wrap::once, {}});
        const palette::ClipError& error = m.stats.clips[0];
        const double half = step_deg * kPi / 360;
        const double expected_m = 3 * (1 - std::cos(half));
        EXPECT_NEAR(error.max * m.baked.palette.radius, expected_m, expected_m * 1e-3 + 1e-6) << step_deg;
        EXPECT_NEAR(expected_m, 3 * std::pow(2 * half, 2) / 8, expected_m * 0.03) << "r theta^2 / 8";
        EXPECT_NE(error.vertex, 2u) << "the vertex nearest to the axis";
        EXPECT_EQ(error.bone, 0u);
        const double rows = error.time_s * 24;
        EXPECT_NEAR(rows - std::floor(rows), 0.5, 1e-4) << "at a midpoint";
    }
}

// At half the keys' rate the blend does not know what lies between: 10 degrees shown, 4 degrees meant.
TEST(KnownErrors, NormalsTurnWithTheBlend) {
    ModelSpec spec = support::one_bone({1, 0, 0, -1, 0, 0});
    spec.meshes[0].normals = {1, 0, 0, 1, 0, 0};
    spec.clips = {{"Turn",
                   {{0, "rotation", support::grid(3, 24),
                     turns({turn(0, 0, 0, 1), turn(4, 0, 0, 1), turn(20, 0, 0, 1)})}}}};
    const Measured m = measured(spec, support::in_floats(), {12.0, recipe::Wrap::once, {}});
    ASSERT_EQ(m.baked.palette.clips[0].plan.row_count, 2u);
    const palette::ClipError& error = m.stats.clips[0];
    EXPECT_NEAR(error.normal_max_deg, 6.0, 1e-4);
    EXPECT_NEAR(error.normal_time_s, 1.0 / 24, 1e-6);
    EXPECT_EQ(error.normal_vertex, 0u);
}

TEST(KnownErrors, AStillPoseInFloatsHasNone) {
    ModelSpec spec = support::tail();
    spec.clips = {{"Still", {{1, "rotation", {0, 1}, turns({turn(31, 1, 2, 3), turn(31, 1, 2, 3)})}}}};
    const Measured floats = measured(spec);
    EXPECT_LT(floats.stats.pooled.max, 2e-7);
    EXPECT_GT(floats.stats.pooled.max, 0.0f);
    EXPECT_LT(floats.stats.pooled.normal_max_deg, 1e-4);
    const Measured halves = measured(spec, {});
    EXPECT_GT(halves.stats.pooled.max, 1e-5) << "halves round";
    EXPECT_LT(halves.stats.pooled.max, 2e-3);
}

TEST(KnownErrors, StepClipsHaveOnlyRounding) {
    ModelSpec spec = support::tail();
    spec.clips = {spec.clips[2]};
    EXPECT_LT(measured(spec, support::in_floats(), {std::nullopt, recipe::Wrap::once, {}}).stats.pooled.max,
              2e-7)
        << "held poses are held, not blended";
}

TEST(KnownErrors, AStepLoopHasOnlyRounding) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Blink", {{0, "translation", {0, 0.25f, 0.5f}, {0, 0, 0, 1, 0, 0, 0, 0, 0}, "STEP"}}}};
    const Measured m = measured(spec);
    ASSERT_EQ(m.baked.palette.clips[0].plan.wrap, recipe::Wrap::loop);
    ASSERT_TRUE(m.baked.palette.clips[0].plan.step);
    EXPECT_LT(m.stats.pooled.max, 2e-7) << "the end of the loop is its first pose";
}

// The picture does not change when the animal stands elsewhere, and so its error does not.
TEST(KnownErrors, AMotionOfTheRootLeavesThemUnchanged) {
    const motion::RowWish wish{10.0, {}, {}};
    const Measured plain = measured(support::tail(), support::in_floats(), wish);
    ModelSpec spec = support::tail();
    spec.nodes.push_back({{"name", "World"},
                          {"translation", {1, -2, 0.5}},
                          {"rotation", turn(77, 1, 2, -1)},
                          {"children", {0}}});
    const Measured moved = measured(spec, support::in_floats(), wish);
    EXPECT_NEAR(plain.baked.palette.radius, moved.baked.palette.radius, plain.baked.palette.radius * 0.5);
    for (std::size_t c = 0; c < 3; ++c) {
        const double before = plain.stats.clips[c].max * plain.baked.palette.radius;
        const double after = moved.stats.clips[c].max * moved.baked.palette.radius;
        EXPECT_NEAR(after, before, before * 1e-4 + 1e-6) << c;
        EXPECT_NEAR(moved.stats.clips[c].normal_max_deg, plain.stats.clips[c].normal_max_deg,
                    plain.stats.clips[c].normal_max_deg * 1e-3 + 1e-4);
    }
}

TEST(KnownErrors, TheWorstPlaceNamesMeshAndVertexWithinIt) {
    ModelSpec spec = support::one_bone({0, 0, 0.1f, 0, 0, 0.2f});
    support::MeshSpec far = spec.meshes[0];
    far.name = "Far";
    far.positions = {0, 0, 0.3f, 9, 0, 0};
    spec.meshes.push_back(far);
    spec.clips = {{"Still", {{0, "translation", {0, 1}, {0, 0, 0, 0, 0, 0}}}},
                  {"Turn", {{0, "rotation", {0, 1}, turns({turn(0, 0, 0, 1), turn(90, 0, 0, 1)})}}}};
    const Measured m = measured(spec, support::in_floats(), {1.0, recipe::Wrap::once, {}});
    EXPECT_EQ(m.stats.worst_clip, 1u);
    EXPECT_EQ(m.stats.pooled.mesh, 1u);
    EXPECT_EQ(m.stats.pooled.vertex, 1u);
    EXPECT_EQ(m.stats.pooled.time_s, 0.5f);
    EXPECT_EQ(m.stats.clips[0].max, 0.0f);
}

TEST(KnownErrors, WithoutNormalsThereIsNoAngle) {
    ModelSpec spec = support::tail();
    spec.meshes[0].normals.clear();
    const Measured m = measured(spec);
    EXPECT_EQ(m.stats.normal_samples, 0u);
    EXPECT_EQ(m.stats.pooled.normal_max_deg, 0.0f);
    EXPECT_EQ(m.stats.pooled.normal_vertex, animal::kNone);
    EXPECT_GT(m.stats.pooled.max, 0.0f);
}

TEST(KnownErrors, BytesThatAreNoContainerAreRefused) {
    const animal::Animal animal = support::animal_of(support::tail());
    support::Baked baked = support::bake_all(animal);
    baked.container[200] ^= 1;
    const auto stats = measure_error(animal, baked.palette, baked.container, motion::unique_points(animal),
                                     motion::unique_normals(animal));
    ASSERT_FALSE(stats);
    EXPECT_EQ(stats.issue().code, base::IssueCode::internal);
}

// Differences whose square no float holds: the measurement must neither read nor write beyond its bins.
TEST(KnownErrors, HugeDifferencesAreNoAccident) {
    for (const float far : {1e18f, 1e20f, 1e30f}) {
        ModelSpec spec = support::one_bone();
        spec.meshes[0].normals = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        spec.clips = {{"Leap",
                       {{0, "translation", {0, 0.5f, 1}, {0, 0, 0, far, far, far, 0, 0, 0}},
                        {0, "scale", {0, 0.5f, 1}, {1, 1, 1, far, -far, far, 1, 1, 1}}}}};
        const animal::Animal animal = support::animal_of(spec);
        const support::Baked baked =
            support::bake_all(animal, support::in_floats(), {{1.0, recipe::Wrap::once, {}}});
        const auto stats = measure_error(animal, baked.palette, baked.container,
                                         motion::unique_points(animal), motion::unique_normals(animal));
        if (!stats) {
            EXPECT_EQ(stats.issue().code, base::IssueCode::lim_float_range) << far;
            continue;
        }
        const palette::ClipError& error = stats.value().clips[0];
        for (const float value : {error.max, error.p999, error.rms}) EXPECT_TRUE(std::isfinite(value)) << far;
        EXPECT_GE(error.max * baked.palette.radius, far) << "the error is not hidden either";
    }
}

TEST(Normals, AnglesRiseToTheStraightOne) {
    motion::SkinSet set;
    set.vectors = {{0, 0, 1}};
    set.bones = {{0, 0, 0, 0}};
    set.weights = {{1, 0, 0, 0}};
    set.first = {0, 0, 1, 1, 1, 1};
    LaneMatrices difference, exact;
    difference.values.resize(12 * kLanes);
    exact.values.resize(9 * kLanes);
    // E is the identity; its difference turns the normal (lane 0), halves it (1), flips it (2), wipes it out
    // (3), turns it by a right angle (4) and by 135 degrees (5).
    const float change[6][3] = {{1, 0, 0}, {0, 0, -0.5f}, {0, 0, -2}, {0, 0, -1}, {1, 0, -1}, {1, 0, -2}};
    for (std::size_t lane = 0; lane < 6; ++lane)
        for (std::size_t r = 0; r < 3; ++r) {
            exact.values[r * 4 * kLanes + lane] = 1;
            difference.values[(r * 4 + 2) * kLanes + lane] = change[lane][r];
        }
    Histogram histogram;
    const LaneWorst worst = measure_normals(set, difference, exact, 6, histogram);
    const auto degrees = [&](std::size_t lane) {
        return 2 * std::atan(std::sqrt(static_cast<double>(worst.value[lane]))) * 180 / std::numbers::pi;
    };
    EXPECT_NEAR(degrees(0), 45.0, 1e-5);
    EXPECT_NEAR(degrees(4), 90.0, 1e-5);
    EXPECT_NEAR(degrees(5), 135.0, 1e-5);
    EXPECT_EQ(worst.value[1], 0.0f);
    EXPECT_EQ(worst.value[2], kStraightAngle);
    EXPECT_EQ(worst.value[3], kStraightAngle);
    EXPECT_EQ(histogram.count(), 6u) << "only the lanes asked for";
}

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

TEST(DecodeCost, IsATimeOrNothing) {
    const animal::Animal animal = support::animal_of(support::tail());
    const support::Baked baked = support::bake_all(animal);
    const motion::SkinSet points = motion::unique_points(animal);
    EXPECT_GT(decode_cost_ns(baked.container, points), 0.0);
    EXPECT_EQ(decode_cost_ns({}, points), 0.0);
    EXPECT_EQ(decode_cost_ns(baked.container, {}), 0.0);
}

}  // namespace
}  // namespace posepack::measure
