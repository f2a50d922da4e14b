// SPDX-License-Identifier: MIT
// Errors that can be told in advance, and values at the edge of the floats.
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

// Two rows over a turn that dawdles, then hurries: the point is furthest from the chord between the times
// that are looked at first, and a tenth further than at any of them.
TEST(KnownErrors, TheLargestIsFoundBetweenTheTimes) {
    ModelSpec spec = support::one_bone({3, 0, 0, -3, 0, 0, 0, 0.5f, 4});
    spec.clips = {{"Turn",
                   {{0, "rotation", support::grid(3, 24),
                     turns({turn(0, 0, 0, 1), turn(20, 0, 0, 1), turn(170, 0, 0, 1)})}}}};
    const Measured m = measured(spec, support::in_floats(), {12.0, recipe::Wrap::once, {}});
    ASSERT_EQ(m.baked.palette.clips[0].plan.row_count, 2u);
    const auto expected_m = [](double keys) {
        const double turned = (keys <= 1 ? 20 * keys : 20 + 150 * (keys - 1)) * kPi / 180;
        const double u = keys / 2, end = 170 * kPi / 180;
        return 3 *
               std::hypot(1 - u + u * std::cos(end) - std::cos(turned), u * std::sin(end) - std::sin(turned));
    };
    double dense_m = 0, halves_m = 0;
    for (int i = 0; i <= 2000; ++i) dense_m = std::max(dense_m, expected_m(i / 1000.0));
    for (const double keys : {0.5, 1.0, 1.5}) halves_m = std::max(halves_m, expected_m(keys));
    ASSERT_LT(halves_m, 0.91 * dense_m) << "or the closer look would have nothing to find";
    const palette::ClipError& error = m.stats.clips[0];
    EXPECT_NEAR(error.max * m.baked.palette.radius, dense_m, 0.005 * dense_m);
    EXPECT_NEAR(expected_m(error.time_s * 24), error.max * m.baked.palette.radius, 1e-4);
    EXPECT_EQ(m.stats.point_samples % 5, 0u) << "the closer look has no say in the other figures";
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

// Squares of the errors of the smaller ones are below the smallest float, of the larger ones above the
// largest.
TEST(KnownErrors, DoNotDependOnTheSizeOfAnAnimal) {
    float of_one = 0.0f;
    for (const double size : {1.0, 1e-25, 1e-15, 1e15, 1e25}) {
        const auto length = static_cast<float>(size);
        ModelSpec spec = support::one_bone({length, 0, 0, 0, length, 0, 0, 0, length});
        spec.clips = {
            {"Turn", {{0, "rotation", support::grid(2, 1), turns({turn(0, 0, 0, 1), turn(30, 0, 0, 1)})}}}};
        const Measured m = measured(spec, support::in_floats(), {1.0, recipe::Wrap::once, {}});
        if (size == 1.0) of_one = m.stats.pooled.max;
        EXPECT_NEAR(m.stats.pooled.max, of_one, of_one * 1e-4) << size;
        EXPECT_GT(m.stats.pooled.rms, of_one * 0.1) << size;
        EXPECT_GT(m.stats.pooled.p999, of_one * 0.9) << size;
    }
}

// Between the rows before and behind a step the blend is never further off than just before it.
TEST(KnownErrors, AStepAmongCurvesCountsInFull) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Leap",
                   {{0, "translation", {0, 0.5f, 1}, {0, 0, 0, 1, 0, 0, 1, 0, 0}, "STEP"},
                    {0, "rotation", support::grid(31, 30), turns(std::vector(31, turn(0, 0, 0, 1)))}}}};
    spec.clips[0].channels[1].values[7] = 0.99999f;  // so that not all that changes is STEP
    const Measured m = measured(spec, support::in_floats(), {std::nullopt, recipe::Wrap::once, {}});
    ASSERT_FALSE(m.baked.palette.clips[0].plan.step);
    EXPECT_NEAR(m.stats.pooled.max * m.baked.palette.radius, 1.0, 1e-3);
    EXPECT_NEAR(m.stats.pooled.time_s, 0.5, 1e-5);
}

// The row at the jump shows what was before, and the blend leaves it only slowly.
TEST(KnownErrors, AJumpBetweenTwoKeysOfOneTimeCountsInFull) {
    ModelSpec spec = support::one_bone();
    const float jump_s = 0.5f;
    const float next_s = std::nextafter(jump_s, 1.0f);
    spec.clips = {
        {"Leap", {{0, "translation", {0, jump_s, next_s, 1}, {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0}}}}};
    const Measured m = measured(spec, support::in_floats(), {30.0, recipe::Wrap::once, {}});
    EXPECT_NEAR(m.stats.pooled.max * m.baked.palette.radius, 1.0, 1e-3);
}

// A spline that leaves and reaches both keys with one slope crosses the blend half way: u (1 - u) (1 - 2 u).
TEST(KnownErrors, ASplineIsLookedAtBesideItsMiddle) {
    ModelSpec spec = support::one_bone();
    std::vector<float> keys;
    for (int k = 0; k < 5; ++k) keys.insert(keys.end(), {0, 3, 0, 0, 0, 0, 0, 3, 0});
    spec.clips = {{"Swing", {{0, "translation", support::grid(5, 30), keys, "CUBICSPLINE"}}}};
    const Measured m = measured(spec, support::in_floats(), {std::nullopt, recipe::Wrap::once, {}});
    const double largest = 3.0 / 30 * std::sqrt(3.0) / 18;
    EXPECT_GE(m.stats.pooled.max * m.baked.palette.radius, 0.97 * largest);
    EXPECT_LE(m.stats.pooled.max * m.baked.palette.radius, largest * (1 + 1e-5));
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
