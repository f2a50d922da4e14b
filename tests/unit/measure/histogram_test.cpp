// SPDX-License-Identifier: MIT
#include "measure/histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace posepack::measure {
namespace {

TEST(Histogram, PercentilesLieAtMostABinAboveTheTruth) {
    const std::uint32_t seed = 17;
    std::mt19937 random(seed);
    std::normal_distribution<double> exponent(-12.0, 5.0);
    for (const std::size_t count : {1u, 2u, 7u, 1000u, 50'000u}) {
        Histogram histogram;
        std::vector<float> values;
        for (std::size_t i = 0; i < count; ++i) {
            values.push_back(static_cast<float>(std::exp(exponent(random))));
            histogram.add(values.back());
        }
        std::sort(values.begin(), values.end());
        EXPECT_EQ(histogram.count(), count);
        for (const double share : {0.01, 0.5, 0.9, 0.999, 1.0}) {
            const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
            const float truth = values[std::max<std::size_t>(rank, 1) - 1];
            const float found = histogram.percentile(share);
            EXPECT_GT(found, truth) << "seed " << seed << " share " << share;
            EXPECT_LE(found, truth * 1.016f) << "seed " << seed << " share " << share;
        }
    }
}

TEST(Histogram, NothingAndZeros) {
    Histogram histogram;
    EXPECT_EQ(histogram.percentile(0.5), 0.0f);
    EXPECT_EQ(histogram.count(), 0u);
    EXPECT_EQ(histogram.mean([](double v) { return v; }), 0.0);
    for (int i = 0; i < 1000; ++i) histogram.add(0.0f);
    EXPECT_EQ(histogram.percentile(0.999), 0.0f);
    histogram.add(1.0f);
    EXPECT_EQ(histogram.percentile(0.999), 0.0f);
    EXPECT_GT(histogram.percentile(1.0), 1.0f);
}

TEST(Histogram, TheLargestFloatHasABin) {
    Histogram histogram;
    histogram.add(std::numeric_limits<float>::max());
    EXPECT_EQ(histogram.count(), 1u);
    EXPECT_GE(histogram.percentile(1.0), std::numeric_limits<float>::max());
}

TEST(Histogram, AddsAnotherSeveralTimes) {
    Histogram few, many;
    few.add(1.0f);
    for (int i = 0; i < 3; ++i) many.add(8.0f);
    many.add(few, 5);
    EXPECT_EQ(many.count(), 8u);
    EXPECT_LT(many.percentile(5.0 / 8), 1.02f);
    EXPECT_GT(many.percentile(6.0 / 8), 8.0f);
}

TEST(Histogram, AddsAndClears) {
    Histogram a, b, both;
    for (int i = 1; i < 500; ++i) {
        const float value = static_cast<float>(i) * 0.37f;
        (i % 3 == 0 ? a : b).add(value);
        both.add(value);
    }
    a.add(b);
    EXPECT_EQ(a.count(), both.count());
    for (const double share : {0.1, 0.5, 0.99}) EXPECT_EQ(a.percentile(share), both.percentile(share));
    a.clear();
    EXPECT_EQ(a.count(), 0u);
}

TEST(Histogram, MeanTakesTheMiddleOfEachBin) {
    Histogram histogram;
    double sum = 0.0;
    for (int i = 1; i <= 2000; ++i) {
        histogram.add(static_cast<float>(i));
        sum += std::sqrt(static_cast<double>(i));
    }
    EXPECT_NEAR(histogram.mean([](double v) { return std::sqrt(v); }), sum / 2000, sum / 2000 * 0.004);
}

}  // namespace
}  // namespace posepack::measure
