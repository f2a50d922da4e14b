// SPDX-License-Identifier: MIT
// What must not change the picture: the order of joints, the place of the model.
#include <numeric>
#include <random>

#include "motion/skin_set.hpp"
#include "sampled.hpp"

namespace posepack::motion {
namespace {

using support::ModelSpec;

// Every vertex of the model at one time, in file order.
std::vector<glm::dvec3> posed_vertices(const animal::Animal& animal, std::size_t clip, double time_s) {
    const std::vector<Affine> bones = bones_at(animal, clip, time_s);
    std::vector<glm::dvec3> out;
    for (std::size_t v = 0; v < animal.vertices.positions.size(); ++v) {
        const auto& p = animal.vertices.positions[v];
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < animal::kMaxInfluences; ++i)
            sum += static_cast<double>(animal.vertices.weights[v][i]) *
                   (bones[animal.vertices.bones[v][i]] * glm::dvec3(p[0], p[1], p[2]));
        out.push_back(sum);
    }
    return out;
}

TEST(Properties, TheOrderOfJointsDoesNotMatter) {
    const std::uint32_t seed = 99;
    std::mt19937 random(seed);
    const ModelSpec plain = support::tail();
    const animal::Animal expected = support::animal_of(plain);
    std::vector<std::uint16_t> order{0, 1, 2};
    for (int round = 0; round < 6; ++round) {
        std::shuffle(order.begin(), order.end(), random);
        ModelSpec spec = plain;
        for (std::size_t j = 0; j < 3; ++j) {
            spec.skins[0].joints[order[j]] = plain.skins[0].joints[j];
            spec.skins[0].inverse_binds[order[j]] = plain.skins[0].inverse_binds[j];
        }
        for (std::uint16_t& joint : spec.meshes[0].joints) joint = order[joint];
        const animal::Animal animal = support::animal_of(spec);
        for (std::size_t clip = 0; clip < animal.clips.size(); ++clip)
            for (const double time_s : {0.0, 0.13, 0.31})
                EXPECT_EQ(posed_vertices(animal, clip, time_s), posed_vertices(expected, clip, time_s))
                    << "seed " << seed << " round " << round;
    }
}

TEST(Properties, AMotionOfTheRootMovesEveryVertexWithIt) {
    ModelSpec spec = support::tail();
    const animal::Animal plain = support::animal_of(spec);
    spec.nodes.push_back({{"name", "World"},
                          {"translation", {3, -2, 5}},
                          {"rotation", support::turn(77, 1, 2, -1)},
                          {"children", {0}}});
    const animal::Animal moved = support::animal_of(spec);
    const animal::Node& world = moved.nodes[5];
    ASSERT_EQ(world.name, "World");
    const Affine motion = affine_of(world.rest);
    for (std::size_t clip = 0; clip < plain.clips.size(); ++clip) {
        const auto before = posed_vertices(plain, clip, 0.17);
        const auto after = posed_vertices(moved, clip, 0.17);
        for (std::size_t v = 0; v < before.size(); ++v)
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(after[v][c], (motion * before[v])[c], 1e-14);
    }
}

}  // namespace
}  // namespace posepack::motion
