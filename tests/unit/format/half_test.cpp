// SPDX-License-Identifier: MIT
#include "format/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "format/bytes.h"

namespace {

// The value of a half by its definition (IEEE 754-2019, binary16), in double precision.
double value_of(std::uint32_t half) {
    const double sign = (half & 0x8000u) != 0 ? -1.0 : 1.0;
    const int exponent = static_cast<int>((half >> 10) & 31u);
    const double fraction = static_cast<double>(half & 0x3FFu);
    if (exponent == 0) return sign * std::ldexp(fraction, -24);
    return sign * std::ldexp(1024.0 + fraction, exponent - 25);
}

bool is_finite(std::uint32_t half) {
    return (half & 0x7C00u) != 0x7C00u;
}

}  // namespace

TEST(Half, AllValuesWidenExactlyAndComeBack) {
    int compared = 0;
    for (std::uint32_t bits = 0; bits < 65536; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        const float value = posepack_float_from_half(half);
        if (is_finite(bits)) {
            ASSERT_EQ(static_cast<double>(value), value_of(bits)) << bits;
            ASSERT_EQ(std::signbit(value), (bits & 0x8000u) != 0) << bits;
        } else {
            ASSERT_EQ(std::isinf(value), (bits & 0x3FFu) == 0) << bits;
            ASSERT_EQ(std::isnan(value), (bits & 0x3FFu) != 0) << bits;
        }
        // A signalling NaN comes back quiet; everything else comes back as it was.
        const std::uint32_t expected = is_finite(bits) || (bits & 0x3FFu) == 0 ? bits : bits | 0x200u;
        ASSERT_EQ(posepack_half_from_float(value), expected) << bits;
        ++compared;
    }
    EXPECT_EQ(compared, 65536);
}

TEST(Half, RoundsToNearestAndTiesToEven) {
    // Between each pair of neighbours, infinity standing for 65536: the midpoint, and the floats about it.
    for (std::uint32_t low = 0; low < 0x7C00u; ++low) {
        const double high_value = low + 1 == 0x7C00u ? 65536.0 : value_of(low + 1);
        const auto middle = static_cast<float>((value_of(low) + high_value) / 2.0);
        const std::uint32_t even = (low & 1u) == 0 ? low : low + 1;
        ASSERT_EQ(posepack_half_from_float(middle), even) << low;
        ASSERT_EQ(posepack_half_from_float(std::nextafter(middle, 0.0f)), low) << low;
        ASSERT_EQ(posepack_half_from_float(std::nextafter(middle, 1e30f)), low + 1) << low;
        ASSERT_EQ(posepack_half_from_float(-middle), even | 0x8000u) << low;
    }
}

TEST(Half, EdgesOfTheRange) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(posepack_half_from_float(1.0f), POSEPACK_HALF_ONE);
    EXPECT_EQ(posepack_half_from_float(POSEPACK_HALF_MAX), 0x7BFFu);
    EXPECT_EQ(posepack_half_from_float(65519.996f), 0x7BFFu);
    EXPECT_EQ(posepack_half_from_float(65520.0f), 0x7C00u);
    EXPECT_EQ(posepack_half_from_float(infinity), 0x7C00u);
    EXPECT_EQ(posepack_half_from_float(-3e38f), 0xFC00u);
    EXPECT_EQ(posepack_half_from_float(-0.0f), 0x8000u);
    EXPECT_EQ(posepack_half_from_float(std::numeric_limits<float>::denorm_min()), 0u);
    EXPECT_EQ(posepack_half_from_float(0x1p-25f), 0u);
    EXPECT_EQ(posepack_half_from_float(0x1.000002p-25f), 1u);
    // A NaN stays a NaN even if only the low bits of its payload are set.
    EXPECT_EQ(posepack_half_from_float(posepack_float_from_bits(0x7F800001u)), 0x7E00u);
    EXPECT_EQ(posepack_half_from_float(posepack_float_from_bits(0xFFC02000u)), 0xFE01u);
}
