// SPDX-License-Identifier: MIT
#include "format/bytes.h"

#include <gtest/gtest.h>

#include <array>

TEST(Bytes, NumbersAreLittleEndianAtAnyAlignment) {
    const std::array<std::uint8_t, 9> bytes = {0xFF, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x88};
    EXPECT_EQ(posepack_read_u16(&bytes[1]), 0x0201);
    EXPECT_EQ(posepack_read_u32(&bytes[1]), 0x04030201u);
    EXPECT_EQ(posepack_read_u64(&bytes[1]), 0x8807060504030201u);
}

TEST(Bytes, WritingIsTheInverseOfReadingAndTouchesNothingElse) {
    std::array<std::uint8_t, 10> bytes{};
    posepack_write_u64(&bytes[1], 0xF1E2D3C4B5A69788u);
    EXPECT_EQ(posepack_read_u64(&bytes[1]), 0xF1E2D3C4B5A69788u);
    EXPECT_EQ(bytes[0], 0);
    EXPECT_EQ(bytes[9], 0);
    posepack_write_u32(&bytes[3], 0xDEADBEEFu);
    EXPECT_EQ(posepack_read_u32(&bytes[3]), 0xDEADBEEFu);
    posepack_write_u16(&bytes[3], 0x1234);
    EXPECT_EQ(posepack_read_u32(&bytes[3]), 0xDEAD1234u);
}

TEST(Bytes, FloatsKeepTheirBits) {
    std::array<std::uint8_t, 4> bytes{};
    for (const std::uint32_t bits : {0u, 0x80000000u, 1u, 0x3F800000u, 0x7F800000u, 0x7FC00123u}) {
        posepack_write_u32(bytes.data(), bits);
        EXPECT_EQ(posepack_bits_from_float(posepack_read_f32(bytes.data())), bits);
    }
    posepack_write_f32(bytes.data(), -2.5f);
    EXPECT_EQ(posepack_read_u32(bytes.data()), 0xC0200000u);
}
