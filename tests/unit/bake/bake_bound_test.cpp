// SPDX-License-Identifier: MIT
// Form and rows chosen by a bound: it is kept, by the error that the loader shows; a narrower one never takes
// fewer bytes; what cannot be kept is refused with what was reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "animal/unused_bones.hpp"
#include "bake/bake_animal.hpp"
#include "menagerie/menagerie.hpp"
#include "posepack/loader.h"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

recipe::AnimalEntry entry_of(const std::optional<recipe::ErrorBound>& bound) {
    recipe::AnimalEntry entry;
    entry.id = "animal";
    entry.model = "animal.glb";
    entry.canonical_json = "{}";
    entry.output.bound = bound;
    return entry;
}

recipe::ErrorBound bound_of(double max) {
    return {{max}, recipe::ErrorLimit{0.25 * max}, {}};
}

// Of the goat's clips the slowest, a gait and the fastest.
recipe::AnimalEntry goat_entry(const std::optional<recipe::ErrorBound>& bound) {
    recipe::AnimalEntry entry = entry_of(bound);
    for (const char* name : {"Idle", "Walk", "Attack"}) {
        entry.clips.emplace_back();
        entry.clips.back().name = name;
    }
    return entry;
}

const base::Bytes& goat() {
    static const base::Bytes kGoat = menagerie::generate_glb("goat");
    return kGoat;
}

base::Result<BakedAnimal> bake_goat(const std::optional<recipe::ErrorBound>& bound) {
    return bake_animal(goat_entry(bound), goat(), {});
}

std::uint64_t bytes_of(const recipe::BakeRecord& record) {
    return record.texel_bytes + record.row_table_bytes;
}

TEST(BakeUnderABound, KeepsItAndIsSmaller) {
    const auto plain = bake_goat(std::nullopt);
    const auto chosen = bake_goat(bound_of(2e-2));
    ASSERT_TRUE(plain && chosen) << base::format_issue(chosen.issue());
    const recipe::BakeRecord& record = chosen.value().record;
    EXPECT_EQ(record.row_scheme, "runs");
    for (const recipe::ClipRecord& clip : record.clips) {
        EXPECT_LE(clip.error.max, 2e-2f) << clip.name;
        EXPECT_LE(clip.error.p999, 5e-3f) << clip.name;
        ASSERT_FALSE(clip.tried.empty());
        bool taken = false;
        for (const recipe::TryRecord& one : clip.tried) taken = taken || one.keeps_bound;
        EXPECT_TRUE(taken) << clip.name;
    }
    EXPECT_LT(4 * bytes_of(record), plain.value().record.texel_bytes);
}

TEST(BakeUnderABound, ANarrowerBoundNeverTakesFewerBytes) {
    std::uint64_t before = 0;
    for (const double max : {0.1, 0.05, 0.02, 0.01, 0.005}) {
        const auto baked = bake_goat(bound_of(max));
        ASSERT_TRUE(baked) << max;
        EXPECT_GE(bytes_of(baked.value().record), before) << max;
        before = bytes_of(baked.value().record);
    }
}

TEST(BakeUnderABound, EqualInputsGiveEqualBytes) {
    EXPECT_EQ(bake_goat(bound_of(0.03)).value().container, bake_goat(bound_of(0.03)).value().container);
}

TEST(BakeUnderABound, ALoopEndsWhereItBegan) {
    const auto baked = bake_goat(bound_of(2e-2));
    ASSERT_TRUE(baked);
    posepack_view view;
    const base::Bytes& bytes = baked.value().container;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        posepack_clip clip;
        posepack_get_clip(&view, c, &clip);
        if (clip.wrap != POSEPACK_WRAP_LOOP) continue;
        for (std::uint32_t bone = 0; bone < view.header.bone_count; ++bone) {
            float first[12], last[12];
            posepack_sample_bone(&view, c, 0.0f, bone, first);
            posepack_sample_bone(&view, c, 1.0f, bone, last);
            for (int e = 0; e < 12; ++e) EXPECT_NEAR(first[e], last[e], 1e-6f) << c << " " << bone;
        }
    }
}

TEST(BakeUnderABound, BoundsOfAClipHoldEveryPose) {
    const auto baked = bake_goat(bound_of(5e-2));
    ASSERT_TRUE(baked);
    posepack_view view;
    const base::Bytes& bytes = baked.value().container;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    posepack_space space;
    posepack_get_space(&view, &space);
    posepack_mesh mesh;
    posepack_get_mesh(&view, 0, &mesh);
    auto animal = support::read_good(goat());
    animal::drop_unused_bones(animal);  // as the bake does, so that indices are the same
    std::vector<float> pose(view.header.bone_count * std::size_t{12});
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        posepack_clip clip;
        posepack_get_clip(&view, c, &clip);
        for (int step = 0; step <= 40; ++step) {
            posepack_sample_pose(&view, c, static_cast<float>(step) / 40.0f, pose.data());
            for (std::size_t v = 0; v < animal.vertices.positions.size(); v += 7) {
                const auto& p = animal.vertices.positions[v];
                double entered[3], posed[3] = {0, 0, 0};
                for (int r = 0; r < 3; ++r) {
                    const float* m = &mesh.palette_from_mesh[4 * r];
                    entered[r] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
                }
                for (std::size_t i = 0; i < animal::kMaxInfluences; ++i)
                    for (int r = 0; r < 3; ++r) {
                        const float* m = &pose[animal.vertices.bones[v][i] * std::size_t{12} + 4 * r];
                        posed[r] += animal.vertices.weights[v][i] *
                                    (m[0] * entered[0] + m[1] * entered[1] + m[2] * entered[2] + m[3]);
                    }
                for (int r = 0; r < 3; ++r) {
                    EXPECT_GE(posed[r], clip.box_min[r] - 1e-5) << c;
                    EXPECT_LE(posed[r], clip.box_max[r] + 1e-5) << c;
                }
            }
        }
    }
}

// A hop that stretches is no dual quaternion: that clip is of matrices, the others are not.
TEST(BakeUnderABound, ClipsHaveTheirOwnForms) {
    auto spec = support::tail();
    const auto baked = bake_animal(entry_of(bound_of(2e-2)), support::glb_of(spec), {});
    ASSERT_TRUE(baked) << base::format_issue(baked.issue());
    for (const recipe::ClipRecord& clip : baked.value().record.clips)
        EXPECT_TRUE(clip.encoding == "dualquat" || clip.encoding == "affine") << clip.name;
    EXPECT_TRUE(baked.value().record.encoding == "mixed" || baked.value().record.encoding == "affine" ||
                baked.value().record.encoding == "dualquat");
}

// Two seconds of stillness about an eighth of a second of shaking.
support::ModelSpec shaking() {
    support::ModelSpec spec = support::one_bone({1, 0, 0, 0, 1, 0, 0, 0, 1});
    support::ChannelSpec channel;
    channel.times = support::grid(65, 32);
    std::vector<std::array<float, 4>> rotations;
    for (int key = 0; key < 65; ++key)
        rotations.push_back(
            support::turn(key >= 30 && key < 36 ? (key % 2 == 0 ? 50.0 : -50.0) : 0.0, 0, 0, 1));
    channel.values = support::turns(rotations);
    spec.clips.push_back({"Shake", {channel}});
    return spec;
}

TEST(BakeUnderABound, BurstsGetSlots) {
    const auto baked = bake_animal(entry_of(bound_of(2e-2)), support::glb_of(shaking()), {});
    ASSERT_TRUE(baked) << base::format_issue(baked.issue());
    const recipe::ClipRecord& clip = baked.value().record.clips.front();
    EXPECT_EQ(clip.row_scheme, "slots");
    EXPECT_LE(clip.error.max, 2e-2f);
    std::uint64_t least_of_runs = UINT64_MAX;
    for (const recipe::TryRecord& one : clip.tried)
        if (one.row_scheme == "runs" && one.keeps_bound) least_of_runs = std::min(least_of_runs, one.bytes);
    EXPECT_LT(2 * bytes_of(baked.value().record), least_of_runs);
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, baked.value().container.data(), baked.value().container.size()),
              POSEPACK_OK);
    posepack_clip stored;
    ASSERT_EQ(posepack_get_clip(&view, 0, &stored), POSEPACK_OK);
    EXPECT_EQ(stored.slot_count, 64u);
}

// A channel that is held beside one that turns evenly: the pose jumps, and is right on both sides.
TEST(BakeUnderABound, RowsEndInFrontOfJumps) {
    support::ModelSpec spec = support::one_bone({1, 0, 0, 0, 1, 0, 0, 0, 1});
    support::ChannelSpec turning, held;
    turning.times = held.times = support::grid(33, 32);
    held.path = "translation";
    held.interpolation = "STEP";
    std::vector<std::array<float, 4>> rotations;
    for (int key = 0; key < 33; ++key) {
        rotations.push_back(support::turn(2.0 * key, 0, 0, 1));
        held.values.insert(held.values.end(), {key < 11 ? 0.0f : key < 20 ? 0.5f : 0.2f, 0.0f, 0.0f});
    }
    turning.values = support::turns(rotations);
    spec.clips.push_back({"Step", {turning, held}});
    recipe::AnimalEntry entry = entry_of(bound_of(2e-2));
    recipe::ClipWish wish;
    wish.name = "*";
    wish.wrap = recipe::Wrap::once;
    entry.clips = {wish};
    const auto baked = bake_animal(entry, support::glb_of(spec), {});
    ASSERT_TRUE(baked) << base::format_issue(baked.issue());
    EXPECT_EQ(baked.value().record.clips.front().row_scheme, "slots");
    EXPECT_LE(baked.value().record.clips.front().error.max, 2e-2f);
}

// As many bytes, and the same errors but for `rounding`.
void expect_alike(const support::ModelSpec& one, const support::ModelSpec& other, float rounding) {
    const auto a = bake_animal(entry_of(bound_of(2e-2)), support::glb_of(one), {});
    const auto b = bake_animal(entry_of(bound_of(2e-2)), support::glb_of(other), {});
    ASSERT_TRUE(a && b) << base::format_issue(a ? b.issue() : a.issue());
    EXPECT_EQ(bytes_of(a.value().record), bytes_of(b.value().record));
    for (std::size_t c = 0; c < a.value().record.clips.size(); ++c) {
        const recipe::ClipRecord& clip = a.value().record.clips[c];
        EXPECT_NEAR(clip.error.max, b.value().record.clips[c].error.max, rounding) << clip.name;
        EXPECT_NEAR(clip.error.rms, b.value().record.clips[c].error.rms, rounding) << clip.name;
    }
}

TEST(BakeUnderABound, TheOrderOfJointsDoesNotMatter) {
    support::ModelSpec turned = support::tail();
    std::reverse(turned.skins[0].joints.begin(), turned.skins[0].joints.end());
    std::reverse(turned.skins[0].inverse_binds.begin(), turned.skins[0].inverse_binds.end());
    for (std::uint16_t& joint : turned.meshes[0].joints) joint = static_cast<std::uint16_t>(2 - joint);
    expect_alike(support::tail(), turned, 3e-4f);  // ties in rounding are broken in the bones' order
}

TEST(BakeUnderABound, ThePlaceOfTheModelDoesNotMatter) {
    support::ModelSpec moved = support::tail();
    moved.nodes.push_back({{"name", "World"},
                           {"translation", {300, -20, 7}},
                           {"rotation", support::turn(40, 0.2, 1, 0)},
                           {"children", {0}}});
    expect_alike(support::tail(), moved, 3e-4f);
}

TEST(BakeUnderABound, FloatsHoldWhatHalvesDoNot) {
    recipe::AnimalEntry entry = entry_of(bound_of(2e-4));
    recipe::ClipWish wish;
    wish.name = "Walk";
    entry.clips = {wish};
    const auto baked = bake_animal(entry, goat(), {});
    ASSERT_TRUE(baked) << base::format_issue(baked.issue());
    EXPECT_EQ(baked.value().record.texel_format, "rgba32f");
    EXPECT_LE(baked.value().record.error.max, 2e-4f);
    bool warned = false;
    for (const base::Issue& finding : baked.value().findings)
        warned = warned || finding.code == base::IssueCode::warn_floats;
    EXPECT_TRUE(warned);
    const auto wider = bake_goat(bound_of(2e-2));
    ASSERT_TRUE(wider);
    EXPECT_EQ(wider.value().record.texel_format, "rgba16f");
}

TEST(BakeUnderABound, WhatCannotBeKeptIsRefused) {
    const auto baked = bake_goat(bound_of(1e-6));
    ASSERT_FALSE(baked);
    EXPECT_EQ(baked.issue().code, base::IssueCode::lim_bound);
    EXPECT_NE(base::format_issue(baked.issue()).find("rows a key"), std::string::npos);
}

// Pixels and millimetres need the animal's size.
TEST(BakeUnderABound, LimitsInMetresScaleWithTheAnimal) {
    recipe::ErrorBound bound;
    bound.max = {0.02, true};
    recipe::AnimalEntry entry = goat_entry(bound);
    const auto large = bake_animal(entry, goat(), {});
    entry.metres_per_unit = 0.2;
    const auto small = bake_animal(entry, goat(), {});
    ASSERT_TRUE(large && small);
    EXPECT_LE(large.value().record.error.max_m, 0.02f);
    EXPECT_LE(small.value().record.error.max_m, 0.02f);
    EXPECT_LT(bytes_of(small.value().record), bytes_of(large.value().record));
}

}  // namespace
}  // namespace posepack::bake
