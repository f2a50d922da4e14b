// SPDX-License-Identifier: MIT
// The bounds that trig.hpp states, against the C library's long double functions.
#include "base/trig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace posepack::base {
namespace {

constexpr int kSamples = 400'000;
constexpr double kRange = 64 * kPi;
constexpr double kSineBound = 4e-16;
constexpr double kArcTangentBound = 3e-16;

double sine_error(double x) {
    return static_cast<double>(std::fabs(sine(x) - std::sin(static_cast<long double>(x))));
}

double cosine_error(double x) {
    return static_cast<double>(std::fabs(cosine(x) - std::cos(static_cast<long double>(x))));
}

double arc_tangent_error(double x) {
    return static_cast<double>(std::fabs(arc_tangent_unit(x) - std::atan(static_cast<long double>(x))));
}

TEST(Sine, KeepsItsBoundOverTheStatedRange) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> angle(-kRange, kRange);
    double worst_sine = 0;
    double worst_cosine = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double x = angle(random);
        worst_sine = std::max(worst_sine, sine_error(x));
        worst_cosine = std::max(worst_cosine, cosine_error(x));
    }
    EXPECT_LT(worst_sine, kSineBound);
    EXPECT_LT(worst_cosine, kSineBound);
}

TEST(Sine, KeepsItsBoundNearEveryQuadrant) {
    for (int quadrant = -128; quadrant <= 128; ++quadrant) {
        for (const double step : {0.0, 1e-16, 1e-12, 1e-8, 1e-4, kPi / 4}) {
            for (const double x : {quadrant * (kPi / 2) - step, quadrant * (kPi / 2) + step}) {
                EXPECT_LT(sine_error(x), kSineBound) << x;
                EXPECT_LT(cosine_error(x), kSineBound) << x;
            }
        }
    }
}

TEST(Sine, IsExactWhereItMust) {
    EXPECT_EQ(sine(0.0), 0.0);
    EXPECT_EQ(cosine(0.0), 1.0);
    EXPECT_EQ(sine(kPi / 2), 1.0);
    EXPECT_EQ(cosine(kPi), -1.0);
}

TEST(ArcTangentUnit, KeepsItsBound) {
    double worst = 0;
    for (int i = 0; i <= kSamples; ++i)
        worst = std::max(worst, arc_tangent_error(static_cast<double>(i) / kSamples));
    EXPECT_LT(worst, kArcTangentBound);
    EXPECT_EQ(arc_tangent_unit(0.0), 0.0);
    EXPECT_EQ(arc_tangent_unit(1.0), kPi / 4);
}

TEST(ArcTangent, KeepsItsBoundBeyondOne) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> exponent(-20.0, 40.0);
    for (int i = 0; i < kSamples; ++i) {
        const double x = std::exp2(exponent(random));
        ASSERT_LT(std::fabs(arc_tangent(x) - std::atan(static_cast<long double>(x))), 6e-16L) << x;
    }
    EXPECT_EQ(arc_tangent(0.0), 0.0);
    EXPECT_EQ(arc_tangent(HUGE_VAL), kPi / 2);
}

}  // namespace
}  // namespace posepack::base
