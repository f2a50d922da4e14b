// SPDX-License-Identifier: MIT
#include "palette/similarity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace posepack::palette {
namespace {

glm::dvec4 random_rotation(std::mt19937& random) {
    std::normal_distribution<double> number;
    const glm::dvec4 q(number(random), number(random), number(random), number(random));
    return q / std::sqrt(glm::dot(q, q));
}

double largest_difference(const glm::dmat3& a, const glm::dmat3& b) {
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
    return largest;
}

TEST(Similarity, ComesBackWithItsSign) {
    std::mt19937 random(5);
    for (const double scale : {1.0, 0.01, 300.0, -1.0, -2.5, 1e-6})
        for (int round = 0; round < 200; ++round) {
            const glm::dvec4 q = random_rotation(random);
            const motion::Affine map{scale * rotation_matrix(q), {1, 2, 3}};
            const Similarity found = nearest_similarity(map, {0, 0, 0, 1});
            EXPECT_NEAR(found.scale / scale, 1.0, 1e-12);
            EXPECT_NEAR(std::abs(glm::dot(found.rotation, q)), 1.0, 1e-12) << scale;
            EXPECT_EQ(found.translation, map.translation);
        }
}

TEST(Similarity, OfHalfTurnsAboutEveryAxis) {
    for (const glm::dvec4 q : {glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0)}) {
        const Similarity found = nearest_similarity({rotation_matrix(q), {}}, {0, 0, 0, 1});
        EXPECT_NEAR(std::abs(glm::dot(found.rotation, q)), 1.0, 1e-12);
    }
}

TEST(Similarity, OfAStretchedMapIsTheOrthogonalPart) {
    std::mt19937 random(6);
    for (int round = 0; round < 100; ++round) {
        const glm::dvec4 q = random_rotation(random);
        glm::dmat3 stretch(1.0);
        stretch[0][0] = 2.0;
        stretch[1][1] = 0.7;
        // rotation x (a symmetric stretch): the polar decomposition is known.
        const glm::dmat3 turn = rotation_matrix(random_rotation(random));
        const glm::dmat3 symmetric = turn * stretch * glm::transpose(turn);
        const Similarity found = nearest_similarity({rotation_matrix(q) * symmetric, {}}, {0, 0, 0, 1});
        EXPECT_LT(largest_difference(rotation_matrix(found.rotation), rotation_matrix(q)), 1e-9);
        const Stretch sizes = stretch_of(rotation_matrix(q) * symmetric);
        EXPECT_NEAR(sizes.largest, 2.0, 1e-12);
        EXPECT_NEAR(sizes.smallest, 0.7, 1e-12);
    }
}

TEST(Similarity, KeepsTheFallbackWhereThereIsNoRotation) {
    const glm::dvec4 kept(0, 0.6, 0, 0.8);
    glm::dmat3 flat(1.0);
    flat[2][2] = 0.0;
    for (const glm::dmat3& linear : {glm::dmat3(0.0), flat})
        EXPECT_EQ(nearest_similarity({linear, {}}, kept).rotation, kept);
    EXPECT_EQ(nearest_similarity({glm::dmat3(0.0), {}}, kept).scale, 0.0);
    EXPECT_EQ(stretch_of(glm::dmat3(0.0)).largest, 0.0);
    EXPECT_EQ(stretch_of(flat).ratio(), HUGE_VAL);
}

}  // namespace
}  // namespace posepack::palette
