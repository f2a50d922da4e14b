// SPDX-License-Identifier: MIT
#include "animal/weights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace posepack::animal {
namespace {

using Bones = InfluenceBones;
using Weights = InfluenceWeights;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Reduced {
    WeightRepairs repairs;
    Vertices out;
    ReducedVertices reduced;
};

// Vertices at x = 0, 1, 2, ...
Reduced reduce(const std::vector<std::uint16_t>& bones, const std::vector<float>& weights,
               std::size_t influences = 4, std::size_t keep = 4) {
    std::vector<std::array<float, 3>> positions;
    for (std::size_t v = 0; v < weights.size() / influences; ++v)
        positions.push_back({static_cast<float>(v), 0, 0});
    Reduced reduced;
    std::uint64_t tests_left = kMaxNeighbourTests;
    reduced.repairs =
        reduce_weights(bones, weights, influences, keep, positions, tests_left, reduced.out, reduced.reduced);
    return reduced;
}

TEST(Weights, GoodOnesStayAndFall) {
    const auto [repairs, out, reduced] = reduce({3, 5, 7, 9}, {0.25f, 0.5f, 0.0f, 0.25f});
    EXPECT_EQ(repairs.bad + repairs.none_left + repairs.sum_not_one + repairs.truncated, 0u);
    EXPECT_EQ(out.bones[0], (Bones{5, 3, 9, 0}));
    EXPECT_EQ(out.weights[0], (Weights{0.5f, 0.25f, 0.25f, 0.0f}));
}

TEST(Weights, BadOnesAreZeroed) {
    for (const float bad : {kNan, kInfinity, -kInfinity, -0.5f}) {
        const auto [repairs, out, reduced] = reduce({1, 2, 3, 4}, {0.5f, bad, 0.25f, 0.0f});
        EXPECT_EQ(repairs.bad, 1u) << bad;
        EXPECT_EQ(repairs.sum_not_one, 0u) << "a bad vertex counts once";
        EXPECT_EQ(out.bones[0], (Bones{1, 3, 0, 0}));
        EXPECT_FLOAT_EQ(out.weights[0][0], 2.0f / 3);
        EXPECT_FLOAT_EQ(out.weights[0][1], 1.0f / 3);
    }
}

TEST(Weights, MinusZeroIsZero) {
    const auto [repairs, out, reduced] = reduce({1, 2, 3, 4}, {1.0f, -0.0f, 0.0f, -0.0f});
    EXPECT_EQ(repairs.bad, 0u);
    EXPECT_EQ(out.weights[0], (Weights{1.0f, 0.0f, 0.0f, 0.0f}));
}

TEST(Weights, SumsAreMadeOne) {
    for (const float sum : {0.18f, 0.9f, 1.76f, 1e-30f, 1e30f}) {
        const auto [repairs, out, reduced] = reduce({1, 2, 3, 4}, {0.75f * sum, 0.25f * sum, 0, 0});
        EXPECT_EQ(repairs.sum_not_one, 1u) << sum;
        EXPECT_FLOAT_EQ(out.weights[0][0], 0.75f);
        EXPECT_FLOAT_EQ(out.weights[0][1], 0.25f);
    }
    const auto [repairs, out, reduced] = reduce({1, 2, 3, 4}, {0.5004f, 0.5f, 0, 0});
    EXPECT_EQ(repairs.sum_not_one, 0u) << "within 1e-3 it is rounding";
    EXPECT_FLOAT_EQ(out.weights[0][0] + out.weights[0][1], 1.0f);
}

TEST(Weights, NoneLeftTakesTheNearestGoodVertex) {
    // Vertices 1 and 4 have nothing; 0 is nearest to 1 (the first of two equally near), 3 to 4.
    const auto [repairs, out, reduced] =
        reduce({1, 0, 0, 0, 9, 9, 9, 9, 2, 0, 0, 0, 3, 4, 0, 0, 9, 9, 9, 9},
               {1, 0, 0, 0, 0, kNan, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(repairs.none_left, 2u);
    EXPECT_EQ(repairs.bad, 1u);
    EXPECT_EQ(out.bones[1], out.bones[0]);
    EXPECT_EQ(out.weights[1], out.weights[0]);
    EXPECT_EQ(out.bones[4], out.bones[3]);
    EXPECT_EQ(out.weights[4], (Weights{0.5f, 0.5f, 0, 0}));
}

TEST(Weights, NoGoodVertexAtAll) {
    const auto [repairs, out, reduced] = reduce({5, 6, 7, 8, 5, 6, 7, 8}, {0, 0, 0, 0, -1, -1, -1, -1});
    EXPECT_EQ(repairs.none_left, 2u);
    for (const Weights& weights : out.weights) EXPECT_EQ(weights, (Weights{1, 0, 0, 0}));
}

TEST(Weights, EqualJointsAreJoined) {
    const auto [repairs, out, reduced] = reduce({4, 2, 4, 2}, {0.125f, 0.25f, 0.5f, 0.125f});
    EXPECT_EQ(out.bones[0], (Bones{4, 2, 0, 0}));
    EXPECT_EQ(out.weights[0], (Weights{0.625f, 0.375f, 0, 0}));
    EXPECT_EQ(repairs.truncated, 0u);
}

TEST(Weights, TheFourLargestOfEightAreKept) {
    const auto [repairs, out, reduced] =
        reduce({0, 1, 2, 3, 4, 5, 6, 7}, {0.05f, 0.3f, 0.05f, 0.2f, 0.1f, 0.15f, 0.05f, 0.1f}, 8);
    EXPECT_EQ(repairs.truncated, 1u);
    EXPECT_NEAR(repairs.truncated_weight_max, 0.25, 1e-6);
    EXPECT_EQ(out.bones[0], (Bones{1, 3, 5, 4})) << "of two equal weights the earlier one";
    EXPECT_FLOAT_EQ(out.weights[0][0], 0.4f);
    EXPECT_FLOAT_EQ(out.weights[0][3], 0.1f / 0.75f);
    EXPECT_EQ(repairs.sum_not_one, 0u);
    EXPECT_EQ(repairs.influences_most, 8u);
    EXPECT_EQ(reduced.vertices, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(reduced.bones, (std::vector<std::uint16_t>{1, 3, 5, 4, 7, 0, 2, 6})) << "all of them, falling";
    EXPECT_FLOAT_EQ(reduced.weights[0], 0.3f);
    EXPECT_EQ(reduced.end_of(0), 8u);
}

TEST(Weights, EightAreKeptWhenAsked) {
    // Vertex 0 has eight, vertex 1 nine.
    std::vector<std::uint16_t> bones;
    std::vector<float> weights;
    for (std::uint16_t i = 0; i < 12; ++i) {
        bones.push_back(i);
        weights.push_back(i < 8 ? 0.125f : 0.0f);
    }
    for (std::uint16_t i = 0; i < 12; ++i) {
        bones.push_back(i);
        weights.push_back(i < 8 ? 0.12f : i == 8 ? 0.04f : 0.0f);
    }
    const auto [repairs, out, reduced] = reduce(bones, weights, 12, 8);
    EXPECT_EQ(repairs.truncated, 1u);
    EXPECT_NEAR(repairs.truncated_weight_max, 0.04, 1e-6);
    EXPECT_EQ(out.bones[0], (Bones{0, 1, 2, 3, 4, 5, 6, 7}));
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_FLOAT_EQ(out.weights[0][i], 0.125f);
        EXPECT_FLOAT_EQ(out.weights[1][i], 0.125f);
    }
    EXPECT_EQ(reduced.vertices, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(reduced.bones.size(), 9u);
    EXPECT_FLOAT_EQ(reduced.weights[8], 0.04f);
}

TEST(Weights, EightInfluencesOfFourJointsAreNotTruncated) {
    const auto [repairs, out, reduced] = reduce(
        {0, 1, 2, 3, 0, 1, 2, 3}, {0.25f, 0.125f, 0.125f, 0.125f, 0.125f, 0.125f, 0.0625f, 0.0625f}, 8);
    EXPECT_EQ(repairs.truncated, 0u);
    EXPECT_EQ(out.weights[0], (Weights{0.375f, 0.25f, 0.1875f, 0.1875f}));
}

TEST(Weights, AppendsToWhatIsThere) {
    Vertices out;
    ReducedVertices reduced;
    const std::vector<std::array<float, 3>> positions{{0, 0, 0}};
    std::uint64_t tests_left = 0;
    for (std::uint16_t bone : {7, 8})
        reduce_weights(std::vector<std::uint16_t>(4, bone), std::vector<float>{1, 0, 0, 0}, 4, 4, positions,
                       tests_left, out, reduced);
    ASSERT_EQ(out.bones.size(), 2u);
    EXPECT_EQ(out.bones[0][0], 7);
    EXPECT_EQ(out.bones[1][0], 8);
}

// All primitives of a file share one number of distances: sixty of them took a minute otherwise.
TEST(Weights, NeighboursAreSoughtWithinABound) {
    Vertices out;
    ReducedVertices reduced;
    const std::vector<std::array<float, 3>> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const std::vector<std::uint16_t> bones{5, 6, 7};
    std::uint64_t tests_left = 3;
    const auto mend = [&](const std::vector<float>& weights) {
        return reduce_weights(bones, weights, 1, 4, positions, tests_left, out, reduced);
    };
    const auto mended = mend({1, 0, 1});
    EXPECT_FALSE(mended.hopeless);
    EXPECT_EQ(mended.none_left, 1u);
    EXPECT_EQ(tests_left, 1u) << "one vertex without weights, two with";
    EXPECT_TRUE(mend({1, 0, 1}).hopeless);
    EXPECT_FALSE(mend({1, 1, 1}).hopeless);
}

// Whatever goes in, what comes out falls, sums to one and names only bones that went in.
TEST(Weights, AnythingEndsGood) {
    const std::uint32_t seed = 20240611;
    std::mt19937 random(seed);
    const float odd[] = {0.0f, kNan, -1.0f, kInfinity, 1e-38f, 3e38f, 1.0f};
    for (int round = 0; round < 200; ++round) {
        std::vector<std::uint16_t> bones(16 * 8);
        std::vector<float> weights(16 * 8);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            bones[i] = static_cast<std::uint16_t>(1 + random() % 6);
            weights[i] =
                random() % 3 == 0 ? odd[random() % 7] : static_cast<float>(random() % 1000) / 1000.0f;
        }
        const auto [repairs, out, reduced] = reduce(bones, weights, 8);
        for (std::size_t v = 0; v < 16; ++v) {
            double sum = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                ASSERT_TRUE(out.weights[v][i] >= 0.0f) << "seed " << seed << " round " << round;
                if (i > 0) {
                    ASSERT_LE(out.weights[v][i], out.weights[v][i - 1]);
                }
                ASSERT_LE(out.bones[v][i], 6);
                sum += out.weights[v][i];
            }
            ASSERT_NEAR(sum, 1.0, 1e-6) << "seed " << seed << " round " << round << " vertex " << v;
        }
    }
}

}  // namespace
}  // namespace posepack::animal
