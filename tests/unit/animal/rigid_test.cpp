// SPDX-License-Identifier: MIT
// Rigid meshes: one bone a node that draws a mesh, its matrix the global transform of the node. In models
// without any skin all of them, beside skins those that move.
#include <gtest/gtest.h>

#include "animal/read_animal.hpp"
#include "menagerie/glb_writer.hpp"
#include "menagerie/menagerie.hpp"
#include "motion/clip_sampler.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

class Toy : public testing::Test {
 protected:
    void SetUp() override {
        auto read = read_animal(menagerie::write_glb(menagerie::build_toy()));
        ASSERT_TRUE(read) << base::format_issue(read.issue());
        toy_ = std::move(read).value();
    }
    Animal toy_;
};

TEST_F(Toy, EveryMeshHasABoneOfItsOwn) {
    ASSERT_GT(toy_.bones.size(), 10u);
    ASSERT_EQ(toy_.meshes.size(), toy_.bones.size());
    for (std::size_t m = 0; m < toy_.meshes.size(); ++m) {
        EXPECT_EQ(toy_.meshes[m].skin, kNone);
        EXPECT_EQ(toy_.meshes[m].joint_count, 1u);
        EXPECT_EQ(toy_.joint_map[toy_.meshes[m].first_joint], m);
        EXPECT_EQ(toy_.bones[m].node, toy_.meshes[m].node);
        EXPECT_EQ(toy_.bones[m].inverse_bind, glm::dmat4(1.0));
        EXPECT_TRUE(toy_.bones[m].weighted);
    }
}

TEST_F(Toy, EveryVertexFollowsItsMeshsBoneAlone) {
    std::size_t seen = 0;
    for (std::size_t m = 0; m < toy_.meshes.size(); ++m)
        for (std::uint32_t v = 0; v < toy_.meshes[m].vertex_count; ++v, ++seen) {
            const std::size_t vertex = toy_.meshes[m].first_vertex + v;
            EXPECT_EQ(toy_.vertices.bones[vertex][0], m);
            EXPECT_EQ(toy_.vertices.weights[vertex], (InfluenceWeights{1, 0, 0, 0}));
        }
    EXPECT_EQ(seen, toy_.vertices.positions.size());
    EXPECT_GT(seen, 100u);
}

TEST_F(Toy, SomeBoneMovesInEveryClip) {
    ASSERT_GE(toy_.clips.size(), 9u);
    for (const Clip& clip : toy_.clips) {
        motion::ClipSampler sampler(toy_, clip);
        std::vector<motion::Affine> first(toy_.bones.size()), later(toy_.bones.size());
        sampler.sample(0.0, first);
        sampler.sample(clip.duration_s * 0.4, later);
        double largest = 0.0;
        for (std::size_t b = 0; b < first.size(); ++b)
            largest = std::max(largest, glm::length(first[b].translation - later[b].translation));
        EXPECT_GT(largest, 1e-4) << clip.name;
    }
}

// The tail with a rigid mesh at a new node below `parent` (below nothing when negative), or at `parent`
// itself.
Animal tail_with_rigid(int parent, bool at_parent = false) {
    support::GlbBuilder glb = support::builder_of(support::tail());
    const int positions = glb.add_values(std::vector<float>{1, 0, 0, 0, 2, 0, 0, 0, 3}, "VEC3");
    const int mesh =
        glb.add("meshes", {{"name", "Horns"}, {"primitives", {{{"attributes", {{"POSITION", positions}}}}}}});
    if (at_parent) {
        glb.document["nodes"][static_cast<std::size_t>(parent)]["mesh"] = mesh;
    } else {
        const int node = glb.add("nodes", {{"name", "Slot"}, {"mesh", mesh}, {"translation", {0, 0.25, 0}}});
        if (parent >= 0) glb.document["nodes"][static_cast<std::size_t>(parent)]["children"].push_back(node);
    }
    return support::read_good(glb.build());
}

TEST(RigidBesideSkins, UnderAJointHasABoneOfItsOwn) {
    const Animal animal = tail_with_rigid(4);  // the last joint
    ASSERT_EQ(animal.bones.size(), 4u);
    ASSERT_EQ(animal.meshes.size(), 2u);
    const Mesh& horns = animal.meshes[1];
    EXPECT_EQ(horns.name, "Horns");
    EXPECT_EQ(horns.skin, kNone);
    EXPECT_EQ(horns.joint_count, 1u);
    EXPECT_EQ(horns.vertex_count, 3u);
    EXPECT_EQ(animal.joint_map[horns.first_joint], 3);
    EXPECT_EQ(animal.bones[3].node, horns.node);
    EXPECT_EQ(animal.bones[3].name, "Slot");
    EXPECT_EQ(animal.bones[3].parent, 2u) << "the joint that carries it";
    EXPECT_EQ(animal.bones[3].inverse_bind, glm::dmat4(1.0));
    EXPECT_TRUE(animal.bones[3].weighted);
    for (std::uint32_t v = horns.first_vertex; v < horns.first_vertex + 3; ++v)
        EXPECT_EQ(animal.vertices.bones[v][0], 3);
    EXPECT_TRUE(animal.findings.empty());
}

// The skin has bound the joint, the mesh stands in the joint's own space: one matrix apart, so one bone.
TEST(RigidBesideSkins, AtAJointSharesItsBone) {
    const Animal animal = tail_with_rigid(3, true);
    ASSERT_EQ(animal.bones.size(), 3u);
    ASSERT_EQ(animal.meshes.size(), 2u);
    const std::size_t rigid = animal.meshes[0].skin == kNone ? 0 : 1;
    const Mesh& horns = animal.meshes[rigid];
    ASSERT_EQ(horns.fold, 0u);
    EXPECT_EQ(animal.joint_map[horns.first_joint], 1);
    const glm::dmat4 back = animal.bones[1].inverse_bind * animal.folds[0].bind_from_mesh;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_NEAR(back[c][r], c == r ? 1.0 : 0.0, 1e-6);
}

TEST(RigidBesideSkins, UnderAnAnimatedNodeMovesWithIt) {
    const Animal animal = tail_with_rigid(0);  // no joint; "Hop" moves it
    EXPECT_EQ(animal.meshes.size(), 2u);
    EXPECT_EQ(animal.bones.size(), 4u);
}

TEST(RigidBesideSkins, ThatNothingMovesIsLeftOut) {
    const Animal animal = tail_with_rigid(-1);
    EXPECT_EQ(animal.meshes.size(), 1u);
    EXPECT_EQ(animal.bones.size(), 3u);
    ASSERT_EQ(animal.findings.size(), 1u);
    EXPECT_EQ(animal.findings[0].code, base::IssueCode::warn_left_out);
    EXPECT_NE(animal.findings[0].detail.find("Slot"), std::string::npos);
}

}  // namespace
}  // namespace posepack::animal
