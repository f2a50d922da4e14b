// SPDX-License-Identifier: MIT
// Nodes, bones and meshes: hierarchies, several skins in one palette, missing inverse binds.
#include <gtest/gtest.h>

#include <set>

#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using support::Json;
using support::Matrix16;
using support::ModelSpec;

constexpr Matrix16 kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix16 moved(float x) {
    Matrix16 m = kIdentity;
    m[12] = x;
    return m;
}

support::MeshSpec mesh_of(const char* name, int skin, std::vector<std::uint16_t> joints) {
    support::MeshSpec mesh{name, skin, {}, {}, {}, {}};
    for (const std::uint16_t joint : joints) {
        mesh.positions.insert(mesh.positions.end(), {static_cast<float>(joint), 0, 0});
        mesh.joints.insert(mesh.joints.end(), {joint, 0, 0, 0});
        mesh.weights.insert(mesh.weights.end(), {1, 0, 0, 0});
    }
    return mesh;
}

// Three joints, and two skins that share two of them.
ModelSpec two_skins() {
    ModelSpec spec;
    spec.nodes = {{{"name", "A"}, {"children", {1, 2}}}, {{"name", "B"}}, {{"name", "C"}}};
    spec.skins = {{{0, 1}, {moved(1), moved(2)}}, {{2, 1, 0, 1}, {moved(3), moved(2), moved(9), moved(2)}}};
    spec.meshes = {mesh_of("Body", 0, {0, 1}), mesh_of("Cloth", 1, {0, 1, 2, 3})};
    spec.clips = {{"Turn", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    return spec;
}

TEST(Skins, EqualPairsOfJointAndInverseBindAreOneBone) {
    const Animal animal = support::animal_of(two_skins());
    // (A, 1) (B, 2) of the first skin, then (C, 3) and (A, 9): another inverse bind, another bone.
    ASSERT_EQ(animal.bones.size(), 4u);
    const std::uint32_t nodes[] = {0, 1, 2, 0};
    const double binds[] = {1, 2, 3, 9};
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_EQ(animal.bones[b].node, nodes[b]);
        EXPECT_EQ(animal.bones[b].inverse_bind[3][0], binds[b]);
        EXPECT_EQ(animal.bones[b].name, animal.nodes[nodes[b]].name);
        EXPECT_TRUE(animal.bones[b].weighted);
    }
    EXPECT_EQ(animal.joint_map, (std::vector<std::uint16_t>{0, 1, 2, 1, 3, 1}));
    ASSERT_EQ(animal.meshes.size(), 2u);
    EXPECT_EQ(animal.meshes[1].name, "Cloth");
    EXPECT_EQ(animal.meshes[1].skin, 1u);
    EXPECT_EQ(animal.meshes[1].first_joint, 2u);
    EXPECT_EQ(animal.meshes[1].joint_count, 4u);
    EXPECT_EQ(animal.meshes[1].first_vertex, 2u);
    EXPECT_EQ(animal.meshes[1].vertex_count, 4u);
    const std::uint16_t first_bone_of[] = {0, 1, 2, 1, 3, 1};
    for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(animal.vertices.bones[v][0], first_bone_of[v]);
}

TEST(Skins, ASkinOfTwoMeshesIsReadOnce) {
    ModelSpec spec = two_skins();
    spec.meshes.push_back(mesh_of("Hat", 0, {1}));
    const Animal animal = support::animal_of(spec);
    EXPECT_EQ(animal.joint_map.size(), 6u);
    EXPECT_EQ(animal.meshes[2].first_joint, animal.meshes[0].first_joint);
    EXPECT_EQ(animal.vertices.bones[6][0], 1);
}

TEST(Skins, ASkinThatNoMeshUsesGivesNoBones) {
    ModelSpec spec = two_skins();
    spec.meshes.pop_back();
    EXPECT_EQ(support::animal_of(spec).bones.size(), 2u);
}

TEST(Skins, MissingInverseBindsAreIdentity) {
    ModelSpec spec = two_skins();
    spec.skins[0].inverse_binds.clear();
    const Animal animal = support::animal_of(spec);
    EXPECT_EQ(animal.bones[0].inverse_bind, glm::dmat4(1.0));
    EXPECT_EQ(animal.bones[1].inverse_bind, glm::dmat4(1.0));
}

TEST(Skins, MoreInverseBindsThanJointsAreIgnored) {
    ModelSpec spec = two_skins();
    spec.skins[0].inverse_binds.push_back(moved(5));
    EXPECT_EQ(support::animal_of(spec).bones.size(), 4u);
}

TEST(Skins, ABoneWithoutWeightsIsKeptAndMarked) {
    ModelSpec spec = two_skins();
    spec.meshes = {mesh_of("Body", 0, {1})};
    const Animal animal = support::animal_of(spec);
    ASSERT_EQ(animal.bones.size(), 2u);
    EXPECT_FALSE(animal.bones[0].weighted);
    EXPECT_TRUE(animal.bones[1].weighted);
}

TEST(Skins, ParentsPassOverPlainNodes) {
    const Animal animal = support::animal_of(support::tail());
    ASSERT_EQ(animal.bones.size(), 3u);
    EXPECT_EQ(animal.bones[0].parent, kNone);
    EXPECT_EQ(animal.bones[1].parent, 0u) << "over the node between them";
    EXPECT_EQ(animal.bones[2].parent, 1u);
}

TEST(Nodes, ParentsComeBeforeChildrenWhateverTheirOrder) {
    ModelSpec spec = support::one_bone();
    spec.nodes = {{{"name", "Leaf"}},
                  {{"name", "Middle"}, {"children", {0, 3}}},
                  {{"name", "Top"}, {"children", {1}}},
                  {{"name", "Other"}}};
    spec.clips = {{"Move", {{2, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    const Animal animal = support::animal_of(spec);
    ASSERT_EQ(animal.node_order.size(), animal.nodes.size());
    std::set<std::uint32_t> seen;
    for (const std::uint32_t node : animal.node_order) {
        const std::uint32_t parent = animal.nodes[node].parent;
        EXPECT_TRUE(parent == kNone || seen.contains(parent)) << node;
        EXPECT_TRUE(seen.insert(node).second);
    }
    EXPECT_EQ(animal.nodes[0].parent, 1u);
    EXPECT_EQ(animal.nodes[2].parent, kNone);
}

TEST(Nodes, TransformsAndMatrices) {
    ModelSpec spec = support::one_bone();
    spec.nodes = {
        {{"name", "Bone"}, {"translation", {1, 2, 3}}, {"scale", {4, 5, 6}}, {"rotation", {0, 0.6, 0, 0.8}}},
        {{"matrix", {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1}}}};
    spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    const Animal animal = support::animal_of(spec);
    EXPECT_EQ(animal.nodes[0].rest.translation, glm::dvec3(1, 2, 3));
    EXPECT_EQ(animal.nodes[0].rest.scale, glm::dvec3(4, 5, 6));
    EXPECT_NEAR(animal.nodes[0].rest.rotation.y, 0.6, 1e-15);
    EXPECT_FALSE(animal.nodes[0].has_matrix);
    EXPECT_TRUE(animal.nodes[1].has_matrix);
    EXPECT_EQ(animal.nodes[1].name, "node_1") << "a node without a name";
    EXPECT_EQ(animal.nodes[1].matrix[1][1], 3.0);
    EXPECT_EQ(animal.nodes[1].matrix[3][2], 7.0);
}

TEST(Nodes, FourThousandDeepIsRead) {
    ModelSpec spec = support::one_bone();
    for (int n = 1; n <= 4000; ++n) {
        spec.nodes.push_back(Json::object());
        spec.nodes[static_cast<std::size_t>(n - 1)]["children"] = {n};
    }
    spec.clips = {{"Move", {{4000, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    EXPECT_EQ(support::animal_of(spec).nodes[4000].parent, 3999u);
}

}  // namespace
}  // namespace posepack::animal
