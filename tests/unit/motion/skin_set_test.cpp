// SPDX-License-Identifier: MIT
#include "motion/skin_set.hpp"

#include <gtest/gtest.h>

#include <set>

#include "motion/clip_sampler.hpp"
#include "support/naive_pose.hpp"
#include "support/sample_models.hpp"

namespace posepack::motion {
namespace {

TEST(SkinSet, EqualVerticesAreOneAndGroupedByInfluences) {
    support::ModelSpec spec = support::tail();
    support::MeshSpec again = spec.meshes[0];
    again.name = "Again";
    again.positions[0] += 0.5f;  // one vertex differs
    spec.meshes.push_back(again);
    const animal::Animal animal = support::animal_of(spec);
    const SkinSet set = unique_points(animal);
    EXPECT_EQ(set.size(), 13u);
    EXPECT_EQ(set.first,
              (std::array<std::uint32_t, animal::kMaxInfluences + 2>{0, 0, 5, 9, 13, 13, 13, 13, 13, 13}));
    std::set<std::uint32_t> vertices;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const std::uint32_t v = set.vertices[i];
        EXPECT_TRUE(vertices.insert(v).second);
        EXPECT_TRUE(v <= 12) << "the first of equal vertices";
        EXPECT_EQ(set.vectors[i], animal.vertices.positions[v]);
        EXPECT_EQ(set.weights[i], animal.vertices.weights[v]);
        EXPECT_EQ(set.bones[i], animal.vertices.bones[v]);
    }
}

TEST(SkinSet, NormalsWithoutTheZeros) {
    support::ModelSpec spec = support::tail();
    spec.meshes[0].normals[1] = 0.0f;  // vertex 0 had (0, 1, 0)
    const animal::Animal animal = support::animal_of(spec);
    const SkinSet set = unique_normals(animal);
    EXPECT_EQ(set.size(), 11u);
    EXPECT_EQ(set.first[5], 11u);
    for (const std::uint32_t v : set.vertices) EXPECT_NE(v, 0u);
    EXPECT_EQ(unique_normals(support::animal_of([] {
                  support::ModelSpec bare = support::tail();
                  bare.meshes[0].normals.clear();
                  return bare;
              }()))
                  .size(),
              0u);
}

TEST(SkinSet, MinusZeroIsZero) {
    support::ModelSpec spec = support::one_bone({0, 1, 0, -0.0f, 1, 0, 0, 1, -0.0f});
    spec.clips = support::tail().clips;
    spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    EXPECT_EQ(unique_points(support::animal_of(spec)).size(), 1u);
}

TEST(SkinSet, SkinIsTheWeightedSum) {
    const animal::Animal animal = support::animal_of(support::tail());
    const SkinSet set = unique_points(animal);
    ClipSampler sampler(animal, animal.clips[0]);
    std::vector<Affine> bones(animal.bones.size());
    sampler.sample(0.21, bones);
    std::vector<glm::dvec3> out(set.size());
    skin(set, bones, out);
    const auto exact = support::naive_bones(animal, animal.clips[0], 0.21);
    for (std::size_t i = 0; i < set.size(); ++i) {
        const support::Point p = support::naive_point(animal, set.vertices[i], exact);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(out[i][static_cast<int>(c)], static_cast<double>(p[c]), 1e-14);
    }
}

TEST(Sphere, IsTheBoxCentersAndReachesTheFarthest) {
    EXPECT_EQ(sphere_around({}).radius, 0.0);
    const std::vector<glm::dvec3> one{{1, 2, 3}};
    EXPECT_EQ(sphere_around(one).radius, 0.0);
    EXPECT_EQ(sphere_around(one).center, glm::dvec3(1, 2, 3));
    const std::vector<glm::dvec3> points{{-1, 0, 0}, {3, 0, 0}, {1, 4, 0}, {1, 2, 3}};
    const Sphere sphere = sphere_around(points);
    EXPECT_EQ(sphere.center, glm::dvec3(1, 2, 1.5));
    EXPECT_DOUBLE_EQ(sphere.radius, std::sqrt(4.0 + 4.0 + 2.25));
}

}  // namespace
}  // namespace posepack::motion
