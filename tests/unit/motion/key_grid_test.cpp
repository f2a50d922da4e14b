// SPDX-License-Identifier: MIT
#include "motion/key_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace posepack::motion {
namespace {

// Times as they come from a file: rounded to float32, counted from the first.
std::vector<double> keys(std::size_t count, double rate_hz, double start_s = 0.0) {
    std::vector<double> times;
    for (std::size_t k = 0; k < count; ++k)
        times.push_back(static_cast<double>(static_cast<float>(start_s + static_cast<double>(k) / rate_hz)));
    const double first = times.front();
    for (double& t : times) t -= first;
    return times;
}

struct Row {
    const char* what;
    std::vector<double> times_s;
    double rate_hz;  // expected
};

TEST(KeyGrid, FindsTheRateOfUniformKeys) {
    const Row rows[] = {
        {"24 Hz", keys(49, 24), 24},
        {"25 Hz", keys(50, 25), 25},
        {"30 Hz", keys(61, 30), 30},
        {"30 Hz, ten seconds in", keys(61, 30, 10), 30},
        {"60 Hz", keys(61, 60), 60},
        {"120 Hz", keys(121, 120), 120},
        {"23.976 Hz", keys(120, 24000.0 / 1001), 24000.0 / 1001},
        {"29.97 Hz", keys(120, 30000.0 / 1001), 30000.0 / 1001},
        {"240 Hz", keys(500, 240), 240},
        {"a long clip at 30 Hz", keys(15'000, 30), 30},
        {"48 Hz", keys(49, 48), 48},
        {"33 Hz: none of the usual", keys(100, 33), 33},
        {"12 Hz: a finer grid, so that rows are not far apart", keys(25, 12), 24},
        {"10 Hz", keys(25, 10), 30},
        {"two keys a second apart", {0, 1}, 24},
        {"keys at 0, 2 and 4 s", {0, 2, 4}, 24},
        {"only some frames of 30 Hz", {0, 1.0 / 30, 7.0 / 30, 31.0 / 30}, 30},
    };
    for (const Row& row : rows) {
        const auto step_s = key_step_s(row.times_s);
        ASSERT_TRUE(step_s) << row.what;
        EXPECT_NEAR(1.0 / *step_s, row.rate_hz, row.rate_hz * 1e-6) << row.what;
    }
}

TEST(KeyGrid, HasNoneForWhatHasNone) {
    EXPECT_FALSE(key_step_s({}));
    const std::vector<double> one{0.0};
    EXPECT_FALSE(key_step_s(one));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-0.004, 0.004);
    std::vector<double> jittered = keys(60, 30);
    for (std::size_t k = 1; k < jittered.size(); ++k) jittered[k] += jitter(random);
    EXPECT_FALSE(key_step_s(jittered));
    EXPECT_FALSE(key_step_s(keys(100, 250))) << "finer than 240 Hz";
    std::vector<double> irrational;
    for (int k = 0; k < 40; ++k) irrational.push_back(std::sqrt(2.0) * k * k / 40);
    EXPECT_FALSE(key_step_s(irrational));
}

TEST(KeyGrid, ToleratesTwoPercentOfStrays) {
    for (const int strays : {1, 2, 3}) {
        std::vector<double> times = keys(100, 30);
        for (int s = 0; s < strays; ++s) times[static_cast<std::size_t>(20 + 7 * s)] += 0.0102;
        const auto step_s = key_step_s(times);
        if (strays <= 2) {
            ASSERT_TRUE(step_s) << strays;
            EXPECT_DOUBLE_EQ(*step_s, 1.0 / 30);
        } else {
            EXPECT_FALSE(step_s) << "3 of 100";
        }
    }
}

TEST(KeyGrid, ToleratesAThousandthOfAStep) {
    std::vector<double> near = keys(60, 30);
    for (std::size_t k = 1; k < near.size(); k += 2) near[k] += 0.9e-3 / 30;
    ASSERT_TRUE(key_step_s(near));
    EXPECT_DOUBLE_EQ(*key_step_s(near), 1.0 / 30);
    std::vector<double> far = keys(60, 30);
    for (std::size_t k = 1; k < far.size(); k += 2) far[k] += 1.2e-3 / 30;
    EXPECT_FALSE(key_step_s(far));
}

// The span at 24 Hz stays 24 Hz however many keys there are: no drift towards 23.976.
TEST(KeyGrid, TellsTwentyFourFromItsNtscNeighbour) {
    for (std::size_t count = 4; count < 200; ++count) {
        EXPECT_NEAR(1.0 / *key_step_s(keys(count, 24)), 24.0, 1e-9) << count << " keys";
        EXPECT_NEAR(1.0 / *key_step_s(keys(count, 24000.0 / 1001)), 24000.0 / 1001, 1e-9) << count << " keys";
    }
}

}  // namespace
}  // namespace posepack::motion
