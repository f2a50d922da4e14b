// SPDX-License-Identifier: MIT
// Models at the edges through the whole pipeline: what the loader decodes is what a second evaluation of the
// source says, and the measured error is the one that shows between rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bake/bake_animal.hpp"
#include "posepack/loader.h"
#include "support/extreme_models.hpp"
#include "support/naive_pose.hpp"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using base::IssueCode;
using support::Matrix34;
using support::ModelSpec;
using support::Point;
using support::Real;

constexpr double kMetresPerUnit = 0.01;

// Rows at 30 Hz that do not wrap.
recipe::AnimalEntry extreme_entry(recipe::TexelFormat format = recipe::TexelFormat::rgba32f) {
    recipe::AnimalEntry entry;
    entry.id = "extreme";
    entry.model = "extreme.glb";
    entry.canonical_json = "{}";
    entry.metres_per_unit = kMetresPerUnit;
    entry.output.space = recipe::Space::model;  // compared with matrices of the model
    entry.output.texel_format = format;
    entry.output.caps = recipe::Caps::desktop;
    recipe::ClipWish every;
    every.name = "*";
    every.rate_hz = support::kExtremeRateHz;
    every.wrap = recipe::Wrap::once;
    entry.clips = {every};
    return entry;
}

// A baked model, its source and its opened container.
struct Extreme {
    animal::Animal animal;
    BakedAnimal baked;
    posepack_view view;

    explicit Extreme(const ModelSpec& spec, const recipe::AnimalEntry& entry = extreme_entry())
        : animal(support::animal_of(spec)) {
        auto result = bake_animal(entry, support::glb_of(spec), {});
        if (!result) throw std::runtime_error(base::format_issue(result.issue()));
        baked = std::move(result).value();
        if (posepack_open(&view, baked.container.data(), baked.container.size()) != POSEPACK_OK)
            throw std::runtime_error("the loader refuses the container");
    }

    double radius() const { return static_cast<double>(baked.record.radius_m) / kMetresPerUnit; }

    std::vector<Matrix34> decoded(std::uint32_t row) const {
        std::vector<float> numbers(std::size_t{view.header.bone_count} * 12);
        if (posepack_decode_row(&view, row, numbers.data()) != POSEPACK_OK) throw std::runtime_error("row");
        std::vector<Matrix34> bones(view.header.bone_count);
        for (std::size_t b = 0; b < bones.size(); ++b)
            for (std::size_t i = 0; i < 12; ++i) bones[b][i] = static_cast<Real>(numbers[b * 12 + i]);
        return bones;
    }
};

// The time of a row, or of a place between two: rows divide the clip evenly from its first key to its last.
Real row_time_s(const recipe::ClipRecord& clip, Real row) {
    return static_cast<Real>(clip.period_s) * row / static_cast<Real>(clip.row_count - 1);
}

// The largest difference of a decoded number from the second evaluation, relative to the larger of 1 and the
// number, over every `stride`th row of every clip.
double largest_difference(const Extreme& model, std::uint32_t stride = 1) {
    Real largest = 0;
    for (std::size_t c = 0; c < model.animal.clips.size(); ++c) {
        const recipe::ClipRecord& record = model.baked.record.clips[c];
        for (std::uint32_t row = 0; row < record.row_count; row += stride) {
            const auto found = model.decoded(record.first_row + row);
            const auto expected =
                support::naive_bones(model.animal, model.animal.clips[c], row_time_s(record, row));
            if (found.size() != expected.size()) return HUGE_VAL;
            for (std::size_t b = 0; b < found.size(); ++b)
                for (std::size_t i = 0; i < 12; ++i) {
                    const Real scale = std::max<Real>(1, std::fabs(expected[b][i]));
                    const Real d = std::fabs(found[b][i] - expected[b][i]) / scale;
                    if (!(d <= largest)) largest = d;
                }
        }
    }
    return static_cast<double>(largest);
}

// The largest distance, in units of the model, of a vertex halfway between two rows from its place on the
// source curve: over every `stride`th row of every clip.
double error_between_rows(const Extreme& model, std::uint32_t stride) {
    Real largest = 0;
    for (std::size_t c = 0; c < model.animal.clips.size(); ++c) {
        const recipe::ClipRecord& record = model.baked.record.clips[c];
        for (std::uint32_t row = 0; row + 1 < record.row_count; row += stride) {
            auto blend = model.decoded(record.first_row + row);
            const auto next = model.decoded(record.first_row + row + 1);
            for (std::size_t b = 0; b < blend.size(); ++b)
                for (std::size_t i = 0; i < 12; ++i) blend[b][i] = (blend[b][i] + next[b][i]) / 2;
            const auto source =
                support::naive_bones(model.animal, model.animal.clips[c], row_time_s(record, row + 0.5L));
            for (std::size_t v = 0; v < model.animal.vertices.positions.size(); ++v) {
                const Point a = support::naive_point(model.animal, v, blend);
                const Point b = support::naive_point(model.animal, v, source);
                largest = std::max(largest, std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
            }
        }
    }
    return static_cast<double>(largest);
}

// The measured error is what shows halfway between rows, where blended rotations are worst (with a stride: at
// least that, and at most twice), and the same in metres.
void expect_sane_error(const Extreme& model, std::uint32_t stride = 1) {
    const recipe::ErrorRecord& error = model.baked.record.error;
    ASSERT_TRUE(error.measured);
    const double shown = error_between_rows(model, stride) / model.radius();
    EXPECT_GT(shown, 0.0);
    EXPECT_GE(static_cast<double>(error.max), shown * (1 - 1e-4) - 1e-7);
    EXPECT_LE(static_cast<double>(error.max), shown * (stride == 1 ? 1.1 : 2.0) + 1e-6);
    EXPECT_LE(error.rms, error.max);
    EXPECT_LE(error.p999, error.max * 1.001f);
    EXPECT_NEAR(static_cast<double>(error.max_m),
                static_cast<double>(error.max * model.baked.record.radius_m),
                1e-6 * static_cast<double>(error.max_m));
    EXPECT_TRUE(std::isfinite(error.normal_max_deg));
}

// Two roundings to single precision: of the stored number, and of what keys and inverse binds were made from.
constexpr double kFloatRounding = 1.3e-7;

TEST(Extremes, TwoHundredFiftySixJoints) {
    const Extreme model(support::many_joints(256));
    EXPECT_EQ(model.view.header.bone_count, 256u);
    EXPECT_LT(largest_difference(model), kFloatRounding);
    expect_sane_error(model);
}

TEST(Extremes, AThousandAndTwentyFourJoints) {
    const Extreme model(support::many_joints(1024));
    EXPECT_EQ(model.view.header.bone_count, 1024u);
    EXPECT_LT(largest_difference(model, 5), kFloatRounding);
    expect_sane_error(model, 7);
}

TEST(Extremes, OneJointMoreIsOverTheLimit) {
    const auto baked = bake_animal(extreme_entry(), support::glb_of(support::many_joints(1025)), {});
    ASSERT_FALSE(baked);
    EXPECT_EQ(baked.issue().code, IssueCode::lim_bones);
    EXPECT_EQ(issue_kind(baked.issue().code).exit_code, base::ExitCode::limit);
    EXPECT_NE(base::format_issue(baked.issue()).find("1024"), std::string::npos) << "the limit is named";
}

TEST(Extremes, AChainOfAHundredTwentyEight) {
    const Extreme model(support::long_chain(128));
    for (std::uint32_t b = 1; b < 128; ++b) EXPECT_EQ(model.animal.bones[b].parent, b - 1);
    EXPECT_LT(largest_difference(model), kFloatRounding);
    expect_sane_error(model);
}

TEST(Extremes, AMirroredJointInsideASkin) {
    const Extreme model(support::mirrored_joint());
    EXPECT_LT(largest_difference(model), kFloatRounding);
    expect_sane_error(model);
}

TEST(Extremes, ScaleThroughZero) {
    const Extreme model(support::scale_through_zero());
    EXPECT_LT(largest_difference(model), kFloatRounding);
    const auto gone = model.decoded(10);
    for (const std::size_t i : {0u, 1u, 2u, 4u, 5u, 6u, 8u, 9u, 10u}) EXPECT_EQ(gone[1][i], 0) << i;
    EXPECT_EQ(gone[1][3], 1) << "all of it at the joint's place";
    expect_sane_error(model);
}

TEST(Extremes, ShearUnderRotation) {
    const Extreme model(support::shear_under_rotation());
    EXPECT_LT(largest_difference(model), kFloatRounding);
    const auto leaning = model.decoded(4);
    const auto& m = leaning[0];
    const Real along = m[0] * m[1] + m[4] * m[5] + m[8] * m[9];
    EXPECT_GT(std::fabs(along), 0.1L) << "the first two axes are no longer at right angles";
    expect_sane_error(model);
}

TEST(Extremes, TwoSkinsShareAJointAtDifferentIndices) {
    const Extreme model(support::shared_joint());
    EXPECT_EQ(model.view.header.bone_count, 3u);
    const std::uint32_t expected[2][3] = {{0, 1, 2}, {2, 0, 0}};
    for (std::uint32_t mesh = 0; mesh < 2; ++mesh)
        for (std::uint32_t joint = 0; joint < (mesh == 0 ? 3u : 2u); ++joint) {
            std::uint32_t bone = 99;
            ASSERT_EQ(posepack_map_joint(&model.view, mesh, joint, &bone), POSEPACK_OK);
            EXPECT_EQ(bone, expected[mesh][joint]) << "mesh " << mesh << " joint " << joint;
        }
    EXPECT_LT(largest_difference(model), kFloatRounding);
    expect_sane_error(model);
}

TEST(Extremes, FiveHundredClips) {
    const Extreme model(support::many_clips(500));
    ASSERT_EQ(model.view.header.clip_count, 500u);
    std::uint32_t rows = 0;
    for (std::uint32_t c = 0; c < 500; ++c) {
        std::uint32_t index = 0;
        posepack_clip clip;
        ASSERT_EQ(posepack_find_clip(&model.view, ("clip " + std::to_string(c)).c_str(), &index),
                  POSEPACK_OK);
        ASSERT_EQ(posepack_get_clip(&model.view, index, &clip), POSEPACK_OK);
        EXPECT_EQ(index, c);
        EXPECT_EQ(clip.first_row, rows);
        EXPECT_EQ(clip.row_count, 2 + c % 5);
        rows += clip.row_count;
    }
    EXPECT_EQ(model.view.header.row_count, rows);
    EXPECT_LT(largest_difference(model), kFloatRounding);
    expect_sane_error(model);
}

TEST(Extremes, TenMinutes) {
    const Extreme model(support::long_clip(600.0));
    EXPECT_EQ(model.baked.record.row_count, 18'001u);
    EXPECT_EQ(model.baked.record.clips[0].period_s, 600.0f);
    // Key times near 600 s are floats 6.1e-5 s apart, and lie up to 3.1e-5 s off the rows: a joint that turns
    // at 111 degrees a second is then off by 6e-5.
    EXPECT_LT(largest_difference(model, 501), kFloatRounding) << "both sides read the same keys";
    expect_sane_error(model, 997);
}

TEST(Extremes, AMomentMoreThanTenMinutesIsOverTheLimit) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Long", {{0, "translation", {0, 600.01f}, {0, 0, 0, 1, 0, 0}}}}};
    const auto baked = bake_animal(extreme_entry(), support::glb_of(spec), {});
    ASSERT_FALSE(baked);
    EXPECT_EQ(baked.issue().code, IssueCode::lim_duration);
}

TEST(Extremes, RootMotionWithTurning) {
    const double radius = 40.0;
    const ModelSpec spec = support::walking_in_circles(radius);
    const Extreme model(spec);
    EXPECT_LT(largest_difference(model), kFloatRounding);
    expect_sane_error(model);
    EXPECT_LT(model.radius(), 3.0) << "R is the animal's own, not that of its walk";
    // Half floats hold places up to 80 units in steps of 1/16: errors of a thirty-second a coordinate.
    const Extreme half(spec, extreme_entry(recipe::TexelFormat::rgba16f));
    const double shift = (static_cast<double>(half.baked.record.error.max) -
                          static_cast<double>(model.baked.record.error.max)) *
                         model.radius();
    EXPECT_GT(shift, 0.0);
    EXPECT_LT(shift, std::sqrt(3.0) * 3 / 32.0);
    // Left to itself the clip plays once: its end is far from its start.
    recipe::AnimalEntry free = extreme_entry();
    free.clips[0].wrap = recipe::Wrap::automatic;
    const Extreme automatic(spec, free);
    EXPECT_EQ(automatic.baked.record.clips[0].wrap, "once");
}

}  // namespace
}  // namespace posepack::bake
