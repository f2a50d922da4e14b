// SPDX-License-Identifier: MIT
// Where the baker says that a valid model is too much, and what stands at the edge.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/bake_animal.hpp"
#include "posepack/loader.h"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using base::IssueCode;
using support::ModelSpec;

recipe::AnimalEntry entry_in(recipe::TexelFormat format = recipe::TexelFormat::rgba16f) {
    recipe::AnimalEntry entry;
    entry.id = "limit";
    entry.model = "limit.glb";
    entry.output.texel_format = format;
    entry.output.space = recipe::Space::model;  // limits in the numbers of the model
    entry.canonical_json = "{}";
    return entry;
}

ModelSpec moving_to(float x) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Leap", {{0, "translation", {0, 1}, {0, 0, 0, x, 0, 0}}}}};
    return spec;
}

void expect_issue(const base::Result<BakedAnimal>& baked, IssueCode code, const std::string& what) {
    ASSERT_FALSE(baked) << what;
    EXPECT_EQ(baked.issue().code, code) << what << ": " << base::format_issue(baked.issue());
}

TEST(Limits, HalfRangeNamesClipBoneAndRow) {
    const auto baked = bake_animal(entry_in(), support::glb_of(moving_to(70'000)), {});
    expect_issue(baked, IssueCode::lim_half_range, "half");
    const std::string line = base::format_issue(baked.issue());
    for (const char* part : {"limit", "Leap", "'Bone'", "row 23"})
        EXPECT_NE(line.find(part), std::string::npos) << part << " in " << line;
    EXPECT_TRUE(bake_animal(entry_in(recipe::TexelFormat::rgba32f), support::glb_of(moving_to(70'000)), {}));
    EXPECT_TRUE(bake_animal(entry_in(), support::glb_of(moving_to(65'504)), {}));
}

TEST(Limits, FloatRange) {
    ModelSpec spec = moving_to(3e38f);
    spec.nodes = {{{"name", "Bone"}}, {{"name", "Giant"}, {"scale", {1e10, 1e10, 1e10}}, {"children", {0}}}};
    expect_issue(bake_animal(entry_in(recipe::TexelFormat::rgba32f), support::glb_of(spec), {}),
                 IssueCode::lim_float_range, "float");
}

// Every value fits a float, but their products do not: an error by name, or a container that the loader
// takes.
TEST(Limits, BoundsBeyondTheFloatsAreAnErrorByName) {
    ModelSpec spec = support::one_bone({1e30f, 0, 0, 0, 1e30f, 0});
    spec.clips = {{"Grow", {{0, "scale", {0, 1}, {1, 1, 1, 1e30f, 1e30f, 1e30f}}}}};
    const auto baked = bake_animal(entry_in(recipe::TexelFormat::rgba32f), support::glb_of(spec), {});
    expect_issue(baked, IssueCode::lim_float_range, "bounds");
}

TEST(Limits, HugeMotionsAreMeasuredOrRefusedByName) {
    for (const float far : {1e19f, 1e20f, 1e30f}) {
        ModelSpec spec = support::one_bone();
        spec.clips = {{"Leap", {{0, "translation", {0, 0.5f, 1}, {0, 0, 0, far, far, far, 0, 0, 0}}}}};
        recipe::AnimalEntry entry = entry_in(recipe::TexelFormat::rgba32f);
        entry.rate_hz = 1.0;
        const auto baked = bake_animal(entry, support::glb_of(spec), {});
        if (baked) {
            EXPECT_GT(baked.value().record.error.max, far * 0.5f);
        } else {
            EXPECT_EQ(baked.issue().code, IssueCode::lim_float_range) << base::format_issue(baked.issue());
        }
    }
}

TEST(Limits, Rows) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Long", {{0, "translation", {0, 600}, {0, 0, 0, 1, 0, 0}}}}};
    recipe::AnimalEntry entry = entry_in();
    entry.rate_hz = 110.0;
    expect_issue(bake_animal(entry, support::glb_of(spec), {}), IssueCode::lim_rows, "66,001 rows");
    entry.rate_hz = 240.0;
    for (int i = 0; i < 3; ++i) spec.clips.push_back(spec.clips[0]);
    expect_issue(bake_animal(entry, support::glb_of(spec), {}), IssueCode::lim_rows, "several clips");
}

TEST(Limits, Texture) {
    ModelSpec spec = support::one_bone();
    for (int n = 1; n < 700; ++n) {
        spec.nodes.push_back({{"name", "n"}});
        spec.skins[0].joints.push_back(n);
    }
    spec.clips = {{"Long", {{0, "translation", {0, 150}, {0, 0, 0, 1, 0, 0}}}}};
    recipe::AnimalEntry entry = entry_in();
    entry.rate_hz = 30.0;
    expect_issue(bake_animal(entry, support::glb_of(spec), {}), IssueCode::lim_texture,
                 "4,501 rows of 2,100 texels");
}

// Two clips of one long name: the second gets an ending, and must still be a name that a container can hold.
TEST(Limits, LongNamesStayWithinTheFormatWhenMadeUnique) {
    ModelSpec spec = moving_to(1);
    spec.clips.push_back(spec.clips[0]);
    for (support::ClipSpec& clip : spec.clips) clip.name = std::string(255, 'n');
    const auto baked = bake_animal(entry_in(), support::glb_of(spec), {});
    if (!baked) {
        EXPECT_EQ(baked.issue().code, IssueCode::lim_string) << base::format_issue(baked.issue());
        return;
    }
    EXPECT_LE(baked.value().record.clips[1].name.size(), 255u);
    EXPECT_NE(baked.value().record.clips[1].name, baked.value().record.clips[0].name);
}

TEST(Limits, AModelWithoutExtentIsRefusedByName) {
    ModelSpec spec = support::one_bone({0, 1, 0});
    spec.clips = moving_to(1).clips;
    expect_issue(bake_animal(entry_in(), support::glb_of(spec), {}), IssueCode::glb_no_extent, "one vertex");
}

TEST(Limits, MissingClipsAndStates) {
    recipe::AnimalEntry entry = entry_in();
    entry.clips.push_back({});
    entry.clips[0].name = "Swim";
    expect_issue(bake_animal(entry, support::glb_of(moving_to(1)), {}), IssueCode::cat_clip_missing, "clip");
    entry = entry_in();
    entry.default_state = "swim";
    expect_issue(bake_animal(entry, support::glb_of(moving_to(1)), {}), IssueCode::cat_state_missing,
                 "state");
    expect_issue(bake_animal(entry, support::Bytes{}, {}), IssueCode::glb_truncated, "no bytes");
}

TEST(Limits, AClipOfOneKeyIsOneRow) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Pose", {{0, "translation", {1}, {1, 2, 3}}}}};
    const auto baked = bake_animal(entry_in(), support::glb_of(spec), {});
    ASSERT_TRUE(baked);
    EXPECT_EQ(baked.value().record.row_count, 1u);
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, baked.value().container.data(), baked.value().container.size()),
              POSEPACK_OK);
    float matrix[12];
    ASSERT_EQ(posepack_decode_bone(&view, 0, 0, matrix), POSEPACK_OK);
    EXPECT_EQ(matrix[3], 1.0f);
    EXPECT_EQ(matrix[7], 2.0f);
    EXPECT_EQ(matrix[11], 3.0f);
}

}  // namespace
}  // namespace posepack::bake
