// SPDX-License-Identifier: MIT
// Models without any skin: one bone a node that draws a mesh, its matrix the global transform of the node.
#include <gtest/gtest.h>

#include "animal/read_animal.hpp"
#include "menagerie/glb_writer.hpp"
#include "menagerie/menagerie.hpp"
#include "motion/clip_sampler.hpp"

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
            EXPECT_EQ(toy_.vertices.weights[vertex], (std::array<float, 4>{1, 0, 0, 0}));
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

}  // namespace
}  // namespace posepack::animal
