// SPDX-License-Identifier: MIT
// The processor's conversions and ours give the same bits.
#include "palette/half_rows.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

namespace posepack::palette {
namespace {

void expect_same(const std::vector<float>& values) {
    std::vector<float> fast = values, slow = values;
    std::vector<std::uint16_t> fast_halves(values.size()), slow_halves(values.size());
    round_to_halves(fast, fast_halves);
    round_to_halves_in_software(slow, slow_halves);
    ASSERT_EQ(fast_halves, slow_halves);
    for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(fast[i]), std::bit_cast<std::uint32_t>(slow[i])) << values[i];
}

// A sample of all floats: every exponent, both signs, mantissas that tie and nearly tie.
TEST(HalfRows, HardwareAndSoftwareAgree) {
    const std::uint32_t seed = 23;
    std::mt19937 random(seed);
    std::vector<float> values;
    for (std::uint32_t exponent = 0; exponent < 255; ++exponent)
        for (const std::uint32_t sign : {0u, 0x80000000u}) {
            for (const std::uint32_t mantissa :
                 {0u, 1u, 0x0FFFu, 0x1000u, 0x1001u, 0x2FFFu, 0x3000u, 0x7FEFFFu, 0x7FF000u, 0x7FFFFFu})
                values.push_back(std::bit_cast<float>(sign | exponent << 23 | mantissa));
            for (int i = 0; i < 40; ++i)
                values.push_back(std::bit_cast<float>(sign | exponent << 23 |
                                                      (static_cast<std::uint32_t>(random()) & 0x7FFFFFu)));
        }
    values.push_back(HUGE_VALF);
    values.push_back(-HUGE_VALF);
    expect_same(values);
}

TEST(HalfRows, EveryLengthIsDoneToItsEnd) {
    for (std::size_t count = 0; count <= 33; ++count) {
        std::vector<float> values;
        for (std::size_t i = 0; i < count; ++i) values.push_back(0.1f * static_cast<float>(i + 1));
        expect_same(values);
    }
}

}  // namespace
}  // namespace posepack::palette
