// SPDX-License-Identifier: MIT
#include "animal/unused_bones.hpp"

#include <gtest/gtest.h>

#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

// A chain of five joints; vertices on the second, the third (by its fifth influence alone) and the last.
Animal chain() {
    Animal animal;
    animal.nodes.resize(5);
    for (std::uint32_t b = 0; b < 5; ++b) {
        Bone bone;
        bone.name = std::string(1, static_cast<char>('a' + b));
        bone.node = b;
        bone.parent = b == 0 ? kNone : b - 1;
        bone.weighted = b == 1 || b == 2 || b == 4;
        animal.bones.push_back(bone);
    }
    animal.joint_map = {4, 3, 2, 1, 0};
    animal.vertices.bones = {{4, 1, 3, 0}, {1, 0, 0, 0}};
    animal.vertices.weights = {{0.75f, 0.25f, 0, 0}, {1, 0, 0, 0}};
    animal.reduced.vertices = {1};
    animal.reduced.first = {0};
    animal.reduced.bones = {1, 2};
    animal.reduced.weights = {0.9f, 0.1f};
    return animal;
}

TEST(UnusedBones, AreTakenOut) {
    Animal animal = chain();
    drop_unused_bones(animal);
    ASSERT_EQ(animal.bones.size(), 3u);
    const char* names[] = {"b", "c", "e"};
    const std::uint32_t parents[] = {kNone, 0, 1};
    for (std::size_t b = 0; b < 3; ++b) {
        EXPECT_EQ(animal.bones[b].name, names[b]);
        EXPECT_EQ(animal.bones[b].parent, parents[b]) << "over those that are gone";
    }
    EXPECT_EQ(animal.joint_map, (std::vector<std::uint16_t>{2, kNoBone, 1, 0, kNoBone}));
    EXPECT_EQ(animal.vertices.bones[0], (InfluenceBones{2, 0, 0, 0}));
    EXPECT_EQ(animal.vertices.bones[1], (InfluenceBones{0, 0, 0, 0}));
    EXPECT_EQ(animal.reduced.bones, (std::vector<std::uint16_t>{0, 1}));
}

TEST(UnusedBones, WhereAllAreUsedNothingChanges) {
    Animal animal = chain();
    for (Bone& bone : animal.bones) bone.weighted = true;
    const Animal before = animal;
    drop_unused_bones(animal);
    EXPECT_EQ(animal.bones.size(), 5u);
    EXPECT_EQ(animal.joint_map, before.joint_map);
    EXPECT_EQ(animal.vertices.bones, before.vertices.bones);
}

// A joint that only an influence names which is left out is used: whoever keeps eight needs its bone.
TEST(UnusedBones, ThoseOfInfluencesLeftOutAreUsed) {
    support::ModelSpec spec = support::one_bone();
    for (int n = 1; n <= 5; ++n) {
        spec.nodes.push_back({{"name", "Joint" + std::to_string(n)}});
        spec.skins[0].joints.push_back(n);
    }
    spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    support::GlbBuilder glb = support::builder_of(spec);
    auto& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
    std::vector<std::uint8_t> joints{0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0},
        more{4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    std::vector<float> weights{0.25f, 0.25f, 0.2f, 0.2f, 1, 0, 0, 0, 1, 0, 0, 0};
    std::vector<float> more_weights{0.1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    attributes["JOINTS_0"] = glb.add_values(joints, "VEC4");
    attributes["WEIGHTS_0"] = glb.add_values(weights, "VEC4");
    attributes["JOINTS_1"] = glb.add_values(more, "VEC4");
    attributes["WEIGHTS_1"] = glb.add_values(more_weights, "VEC4");
    Animal animal = support::read_good(glb.build());
    ASSERT_EQ(animal.bones.size(), 6u);
    EXPECT_TRUE(animal.bones[4].weighted);
    EXPECT_FALSE(animal.bones[5].weighted);
    drop_unused_bones(animal);
    EXPECT_EQ(animal.bones.size(), 5u);
    EXPECT_EQ(animal.reduced.bones.size(), 5u);

    const auto eight = read_animal(glb.build(), {.influences = 8});
    ASSERT_TRUE(eight);
    EXPECT_EQ(eight.value().vertices.bones[0], (InfluenceBones{0, 1, 2, 3, 4}));
    EXPECT_FLOAT_EQ(eight.value().vertices.weights[0][4], 0.1f);
    EXPECT_TRUE(eight.value().findings.empty());
    EXPECT_TRUE(eight.value().reduced.vertices.empty());
}

}  // namespace
}  // namespace posepack::animal
