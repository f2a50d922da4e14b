// SPDX-License-Identifier: MIT
// Whole bakes with more than four influences, and with bones that nothing uses.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "bake/bake_animal.hpp"
#include "posepack/loader.h"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using base::IssueCode;

// Six joints in a row of which the last moves nothing. Vertex 0 hangs on five; the fifth of them turns by a
// quarter from one key to the next.
support::Bytes five_influences() {
    support::ModelSpec spec = support::one_bone({2, 0, 0, -1, 0, 0, 0, 1, 0});
    for (int n = 1; n < 6; ++n) {
        spec.nodes.push_back({{"name", "Joint" + std::to_string(n)}});
        spec.nodes[static_cast<std::size_t>(n - 1)]["children"] = {n};
        spec.skins[0].joints.push_back(n);
    }
    spec.clips = {{"Turn",
                   {{4, "rotation", support::grid(3, 24),
                     support::turns({support::turn(0, 0, 0, 1), support::turn(90, 0, 0, 1),
                                     support::turn(0, 0, 0, 1)})}}}};
    support::GlbBuilder glb = support::builder_of(spec);
    auto& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] =
        glb.add_values(std::vector<std::uint8_t>{0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    attributes["WEIGHTS_0"] =
        glb.add_values(std::vector<float>{0.3f, 0.2f, 0.2f, 0.2f, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    attributes["JOINTS_1"] =
        glb.add_values(std::vector<std::uint8_t>{4, 5, 5, 5, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    attributes["WEIGHTS_1"] =
        glb.add_values(std::vector<float>{0.1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    return glb.build();
}

BakedAnimal bake(const support::Bytes& glb, const recipe::OutputOptions& output, bool measure = true) {
    recipe::AnimalEntry entry;
    entry.id = "animal";
    entry.model = "animal.glb";
    entry.output = output;
    entry.output.texel_format = recipe::TexelFormat::rgba32f;
    entry.canonical_json = "{}";
    AnimalOptions options;
    options.measure = measure;
    auto result = bake_animal(entry, glb, options);
    if (!result) throw std::runtime_error(base::format_issue(result.issue()));
    return std::move(result).value();
}

TEST(Influences, OfFiveFourAreKeptAndTheCostIsMeasured) {
    const BakedAnimal animal = bake(five_influences(), {});
    ASSERT_EQ(animal.findings.size(), 1u);
    EXPECT_EQ(animal.findings[0].code, IssueCode::warn_influences);
    EXPECT_NE(animal.findings[0].detail.find("moves 1 vertex of the model by at most"), std::string::npos);
    const recipe::ReductionRecord& reduction = animal.record.reduction;
    ASSERT_TRUE(reduction.measured);
    EXPECT_EQ(reduction.vertex_count, 1u);
    EXPECT_EQ(reduction.influences_most, 5u);
    // At the middle key a tenth of the vertex is at (0, 2, 0) instead of (2, 0, 0).
    EXPECT_NEAR(reduction.max_m, 0.1f * std::sqrt(8.0f), 1e-5f);
    EXPECT_NEAR(reduction.max, reduction.max_m / animal.record.radius_m, 1e-5f);
    EXPECT_GT(reduction.rms, 0.0f);
    EXPECT_LT(reduction.rms, reduction.max);
    EXPECT_EQ(reduction.clip, "Turn");
    EXPECT_LT(animal.record.error.max, 1e-6f) << "what was kept does not move";
    EXPECT_FALSE(bake(five_influences(), {}, false).record.reduction.measured);
}

TEST(Influences, OfFiveAllAreKeptWhenAskedAndTheErrorIsThatOfAll) {
    recipe::OutputOptions output;
    output.influences = 8;
    const BakedAnimal animal = bake(five_influences(), output);
    EXPECT_TRUE(animal.findings.empty());
    EXPECT_FALSE(animal.record.reduction.measured);
    // Half way between the keys a straight line is 2 (1 - cos 45 degrees) off for the fifth joint, which has
    // a tenth of the vertex.
    EXPECT_NEAR(animal.record.error.max_m, 0.1f * 2.0f * (1.0f - std::sqrt(0.5f)), 1e-5f);
    EXPECT_EQ(animal.record.error.vertex, 0u);
    EXPECT_EQ(animal.record.error.bone, "Joint4");
}

TEST(UnusedBones, AreKeptUnlessAsked) {
    const BakedAnimal kept = bake(five_influences(), {});
    EXPECT_EQ(kept.record.bone_count, 6u);
    recipe::OutputOptions output;
    output.unused_bones = recipe::UnusedBones::drop;
    const BakedAnimal dropped = bake(five_influences(), output);
    EXPECT_EQ(dropped.record.bone_count, 5u);
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, dropped.container.data(), dropped.container.size()), POSEPACK_OK);
    for (std::uint32_t joint = 0; joint < 6; ++joint) {
        std::uint32_t bone = 77;
        const posepack_result result = posepack_map_joint(&view, 0, joint, &bone);
        EXPECT_EQ(result, joint < 5 ? POSEPACK_OK : POSEPACK_ERROR_NOT_FOUND) << joint;
        EXPECT_EQ(bone, joint < 5 ? joint : POSEPACK_NONE) << joint;
    }
    EXPECT_EQ(dropped.record.error.max, kept.record.error.max);
    EXPECT_EQ(dropped.record.reduction.max, kept.record.reduction.max);
}

// Where a bound chooses the form, a bone that moves nothing is not part of it, unless somebody wants it.
TEST(UnusedBones, AreLeftOutUnderABound) {
    recipe::OutputOptions output;
    output.bound = recipe::ErrorBound{{2e-2}, recipe::ErrorLimit{5e-3}, {}};
    const BakedAnimal chosen = bake(five_influences(), output);
    EXPECT_EQ(chosen.record.bone_count, 5u);
    EXPECT_LE(chosen.record.error.max, 2e-2f);
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, chosen.container.data(), chosen.container.size()), POSEPACK_OK);
    std::uint32_t bone = 0;
    EXPECT_EQ(posepack_map_joint(&view, 0, 5, &bone), POSEPACK_ERROR_NOT_FOUND);
    output.unused_bones = recipe::UnusedBones::keep;
    const BakedAnimal kept = bake(five_influences(), output);
    EXPECT_EQ(kept.record.bone_count, 6u);
    ASSERT_EQ(posepack_open(&view, kept.container.data(), kept.container.size()), POSEPACK_OK);
    EXPECT_EQ(posepack_map_joint(&view, 0, 5, &bone), POSEPACK_OK);
    EXPECT_EQ(bone, 5u);
}

// Nothing that is drawn changes: the matrices of the bones that are left, by name.
TEST(UnusedBones, LeaveTheOthersAsTheyAre) {
    support::ModelSpec spec = support::tail();
    spec.nodes.push_back({{"name", "Target"}, {"translation", {0, 0, 9}}});
    spec.nodes.push_back({{"name", "Pole"}, {"translation", {0, 9, 0}}});
    spec.nodes[1]["children"].push_back(6);
    spec.skins[0].joints = {6, 1, 5, 3, 4};
    spec.skins[0].inverse_binds = support::inverse_binds_of(spec.nodes, spec.skins[0].joints);
    for (std::uint16_t& joint : spec.meshes[0].joints) joint = joint == 0 ? 1 : joint == 1 ? 3 : 4;
    for (const recipe::Encoding encoding : {recipe::Encoding::mat4, recipe::Encoding::affine}) {
        recipe::OutputOptions output;
        output.encoding = encoding;
        const BakedAnimal kept = bake(support::glb_of(spec), output);
        output.unused_bones = recipe::UnusedBones::drop;
        const BakedAnimal dropped = bake(support::glb_of(spec), output);
        ASSERT_EQ(dropped.record.bone_count + 2, kept.record.bone_count);
        posepack_view whole, small;
        ASSERT_EQ(posepack_open(&whole, kept.container.data(), kept.container.size()), POSEPACK_OK);
        ASSERT_EQ(posepack_open(&small, dropped.container.data(), dropped.container.size()), POSEPACK_OK);
        for (const char* name : {"Hips", "Tail", "Tip"}) {
            std::uint32_t a = 0, b = 0;
            ASSERT_EQ(posepack_find_bone(&whole, name, &a), POSEPACK_OK);
            ASSERT_EQ(posepack_find_bone(&small, name, &b), POSEPACK_OK);
            for (std::uint32_t row = 0; row < whole.header.row_count; ++row) {
                float m[12], n[12];
                ASSERT_EQ(posepack_decode_bone(&whole, row, a, m), POSEPACK_OK);
                ASSERT_EQ(posepack_decode_bone(&small, row, b, n), POSEPACK_OK);
                for (int i = 0; i < 12; ++i) EXPECT_EQ(m[i], n[i]) << name << row;
            }
        }
        EXPECT_EQ(dropped.record.error.max, kept.record.error.max);
    }
}

}  // namespace
}  // namespace posepack::bake
