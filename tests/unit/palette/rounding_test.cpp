// SPDX-License-Identifier: MIT
// Rounding that knows the vertices: never worse than plain rounding by its own measure, and much better for
// points about one place.
#include "palette/rounding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "format/dualquat.h"
#include "format/half.h"

namespace posepack::palette {
namespace {

using motion::Affine;

constexpr double kLength = 4.0;

struct Sample {
    Affine matrix;
    Similarity target;
    BoneMoment moment;
};

// A limb of a few tens of vertices somewhere in the unit ball, turned and moved.
Sample random_sample(std::mt19937& random, double scale) {
    std::normal_distribution<double> number;
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Sample sample;
    glm::dvec4 q(number(random), number(random), number(random), number(random));
    sample.target = {q / std::sqrt(glm::dot(q, q)), scale, {unit(random), unit(random), unit(random)}};
    sample.matrix = {scale * rotation_matrix(q), sample.target.translation};
    motion::SkinSet points;
    const glm::dvec3 middle(0.7 * unit(random), 0.7 * unit(random), 0.7 * unit(random));
    for (int i = 0; i < 40; ++i) {
        points.vectors.push_back({static_cast<float>(middle.x + 0.1 * unit(random)),
                                  static_cast<float>(middle.y + 0.1 * unit(random)),
                                  static_cast<float>(middle.z + 0.1 * unit(random))});
        points.bones.push_back({0, 0, 0, 0});
        points.weights.push_back({static_cast<float>(0.25 + 0.5 * std::abs(unit(random))), 0, 0, 0});
    }
    points.first = {0, 0, 40, 40, 40, 40};
    sample.moment = bone_moments(points, Spaces{}, 1, 1.0).front();
    return sample;
}

double cost_of(const std::array<float, 12>& found, const Sample& sample) {
    double sum = 0.0;
    for (std::size_t r = 0; r < 3; ++r) {
        std::array<double, 4> d{};
        const int i = static_cast<int>(r);
        for (std::size_t c = 0; c < 3; ++c)
            d[c] = static_cast<double>(found[r * 4 + c]) - sample.matrix.linear[static_cast<int>(c)][i];
        d[3] = static_cast<double>(found[r * 4 + 3]) - sample.matrix.translation[i];
        sum += sample.moment.cost(d);
    }
    return sum;
}

std::array<float, 12> plain_affine(const Sample& sample) {
    std::array<float, 12> out{};
    for (std::size_t e = 0; e < 12; ++e) {
        const int r = static_cast<int>(e / 4);
        const int c = static_cast<int>(e % 4);
        const double value = c < 3 ? sample.matrix.linear[c][r] : sample.matrix.translation[r];
        out[e] = posepack_float_from_half(posepack_half_from_float(static_cast<float>(value)));
    }
    return out;
}

bool is_a_half(float value) {
    return posepack_float_from_half(posepack_half_from_float(value)) == value;
}

std::array<float, 12> decoded(const std::array<float, 8>& rounded) {
    posepack_dualquat row{};
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_TRUE(is_a_half(rounded[c]) && is_a_half(rounded[4 + c]));
        row.real[c] = rounded[c];
        row.dual[c] = rounded[4 + c];
    }
    std::array<float, 12> matrix{};
    posepack_dualquat_decode(&row, static_cast<float>(kLength), matrix.data());
    return matrix;
}

std::array<float, 12> plain_dualquat(const Sample& sample) {
    std::array<double, 8> numbers{};
    dualquat_numbers(sample.target, kLength, numbers);
    std::array<float, 8> rounded{};
    for (std::size_t c = 0; c < 8; ++c)
        rounded[c] = posepack_float_from_half(posepack_half_from_float(static_cast<float>(numbers[c])));
    return decoded(rounded);
}

TEST(Rounding, OfAnAffineIsNeverWorseThanPlain) {
    std::mt19937 random(21);
    double plain = 0.0, chosen = 0.0;
    for (int round = 0; round < 2000; ++round) {
        const Sample sample = random_sample(random, 1.0);
        std::array<float, 12> rounded{};
        round_affine(sample.matrix, sample.moment, Halves::all, rounded);
        const double a = cost_of(plain_affine(sample), sample);
        const double b = cost_of(rounded, sample);
        // By so much the costs are themselves rounded.
        ASSERT_LE(b, a * (1 + 1e-9) + 1e-18) << round;
        plain += a;
        chosen += b;
    }
    EXPECT_LT(chosen, plain / 4) << "half the error at least, in the mean square";
}

TEST(Rounding, OfADualQuaternionIsMuchBetterThanPlain) {
    std::mt19937 random(22);
    for (const double scale : {1.0, 0.5, -1.0, 1.5}) {
        double plain = 0.0, chosen = 0.0;
        for (int round = 0; round < 1000; ++round) {
            const Sample sample = random_sample(random, scale);
            std::array<float, 8> rounded{};
            round_dualquat(sample.matrix, sample.target, sample.moment, kLength, Halves::all, rounded);
            plain += cost_of(plain_dualquat(sample), sample);
            chosen += cost_of(decoded(rounded), sample);
        }
        EXPECT_LT(chosen, plain / 4) << scale;
        EXPECT_LT(std::sqrt(chosen / 1000), 1.2e-3 * std::max(1.0, std::abs(scale - 1.0))) << scale;
    }
}

TEST(Rounding, OfMinusQIsMinusTheHalves) {
    std::mt19937 random(23);
    for (int round = 0; round < 200; ++round) {
        Sample sample = random_sample(random, 1.25);
        std::array<float, 8> one{}, other{};
        round_dualquat(sample.matrix, sample.target, sample.moment, kLength, Halves::normal, one);
        sample.target.rotation = -sample.target.rotation;
        round_dualquat(sample.matrix, sample.target, sample.moment, kLength, Halves::normal, other);
        for (std::size_t c = 0; c < 8; ++c) EXPECT_EQ(one[c], -other[c]) << round;
        EXPECT_EQ(decoded(one), decoded(other)) << "q and -q are one rotation";
    }
}

// The exact numbers, in float: every similarity comes back, a mirror with its sign.
TEST(Rounding, ExactNumbersDecodeToTheMatrix) {
    std::mt19937 random(24);
    for (const double scale : {1.0, 1e-3, 0.0, -1.0, 3.0, -0.2})
        for (int round = 0; round < 500; ++round) {
            const Sample sample = random_sample(random, scale);
            std::array<double, 8> numbers{};
            dualquat_numbers(sample.target, kLength, numbers);
            posepack_dualquat row{};
            for (std::size_t c = 0; c < 4; ++c) {
                row.real[c] = static_cast<float>(numbers[c]);
                row.dual[c] = static_cast<float>(numbers[4 + c]);
            }
            std::array<float, 12> found{};
            posepack_dualquat_decode(&row, static_cast<float>(kLength), found.data());
            for (std::size_t e = 0; e < 12; ++e) {
                const int r = static_cast<int>(e / 4);
                const int c = static_cast<int>(e % 4);
                const double exact = c < 3 ? sample.matrix.linear[c][r] : sample.matrix.translation[r];
                ASSERT_NEAR(static_cast<double>(found[e]), exact, 2e-6) << scale << " " << e;
            }
        }
}

TEST(Rounding, LeavesSubnormalHalvesOutWhereAsked) {
    std::mt19937 random(25);
    std::uniform_real_distribution<double> tiny(-2e-4, 2e-4);
    bool some = false;
    for (int round = 0; round < 500; ++round) {
        Sample sample = random_sample(random, 1.0);
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) sample.matrix.linear[c][r] = tiny(random);
        for (const Halves allowed : {Halves::normal, Halves::all}) {
            std::array<float, 12> rounded{};
            round_affine(sample.matrix, sample.moment, allowed, rounded);
            for (const float number : rounded) {
                EXPECT_TRUE(is_a_half(number));
                const bool is_subnormal = number != 0.0f && std::abs(number) < 0x1p-14f;
                EXPECT_TRUE(allowed == Halves::all || !is_subnormal) << number;
                some = some || is_subnormal;
            }
        }
    }
    EXPECT_TRUE(some) << "the others do occur";
}

TEST(Rounding, WhatNoHalfHoldsIsInfinite) {
    std::mt19937 random(26);
    Sample sample = random_sample(random, 1.0);
    sample.matrix.translation.y = 70000;
    sample.target.translation.y = 70000 * 4;
    std::array<float, 12> affine{};
    round_affine(sample.matrix, sample.moment, Halves::normal, affine);
    EXPECT_GE(affine[7], 65520.0f);
    std::array<float, 8> dual{};
    sample.matrix.translation.y = 70000 * 4;
    round_dualquat(sample.matrix, sample.target, sample.moment, kLength, Halves::normal, dual);
    EXPECT_TRUE(
        std::any_of(dual.begin(), dual.end(), [](float number) { return std::abs(number) >= 65520.0f; }));
}

TEST(Moments, AreThoseOfTheVertices) {
    motion::SkinSet points;
    points.vectors = {{1, 0, 0}, {3, 0, 0}};
    points.bones = {{0, 0, 0, 0}, {0, 1, 0, 0}};
    points.weights = {{1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}};
    points.first = {0, 0, 1, 2, 2, 2};
    const auto moments = bone_moments(points, Spaces{}, 3, 2.0);
    EXPECT_NEAR(moments[0].centroid.x, (1.0 + 0.25 * 3) / 1.25, 1e-12) << "weighted by the square";
    EXPECT_NEAR(moments[0].radius, 3 - 1.4, 1e-12);
    EXPECT_EQ(moments[1].centroid, glm::dvec3(3, 0, 0));
    EXPECT_EQ(moments[1].radius, 0.0);
    EXPECT_EQ(moments[2].centroid, glm::dvec3(0.0)) << "no vertices: a ball about the origin";
    EXPECT_NEAR(moments[2].cost({1, 0, 0, 0}), 0.2, 1e-12);
}

}  // namespace
}  // namespace posepack::palette
