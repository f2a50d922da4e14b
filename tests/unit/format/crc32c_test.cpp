// SPDX-License-Identifier: MIT
#include "format/crc32c.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace {

struct KnownVector {
    const char* name;
    std::vector<std::uint8_t> bytes;
    std::uint32_t crc;
};

std::vector<std::uint8_t> counting(int first, int step) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 32; ++i) bytes.push_back(static_cast<std::uint8_t>(first + i * step));
    return bytes;
}

// RFC 3720, appendix B.4, and the check value of the algorithm.
const std::vector<KnownVector> kVectors = {
    {"nothing", {}, 0u},
    {"32 zero bytes", std::vector<std::uint8_t>(32, 0x00), 0x8A9136AAu},
    {"32 bytes of ones", std::vector<std::uint8_t>(32, 0xFF), 0x62A8AB43u},
    {"32 rising bytes", counting(0, 1), 0x46DD794Eu},
    {"32 falling bytes", counting(31, -1), 0x113FDB5Cu},
    {"123456789", {'1', '2', '3', '4', '5', '6', '7', '8', '9'}, 0xE3069283u},
};

std::vector<std::uint8_t> noise(std::size_t size) {
    std::vector<std::uint8_t> bytes(size);
    std::uint32_t state = 12345;
    for (std::uint8_t& byte : bytes) {
        state = state * 1664525u + 1013904223u;
        byte = static_cast<std::uint8_t>(state >> 24);
    }
    return bytes;
}

}  // namespace

TEST(Crc32c, KnownVectors) {
    for (const KnownVector& vector : kVectors) {
        EXPECT_EQ(posepack_crc32c(0, vector.bytes.data(), vector.bytes.size()), vector.crc) << vector.name;
        EXPECT_EQ(posepack_crc32c_table(0, vector.bytes.data(), vector.bytes.size()), vector.crc)
            << vector.name;
    }
    EXPECT_EQ(posepack_crc32c(0, nullptr, 0), 0u);
}

TEST(Crc32c, HardwareEqualsTableAtEveryLengthAndAlignment) {
    const std::vector<std::uint8_t> bytes = noise(1100);
    for (std::size_t start = 0; start < 8; ++start) {
        for (std::size_t size = 0; start + size <= bytes.size(); ++size) {
            ASSERT_EQ(posepack_crc32c(7, &bytes[start], size), posepack_crc32c_table(7, &bytes[start], size))
                << "start " << start << " size " << size;
        }
    }
}

TEST(Crc32c, ContinuesFromItsOwnResult) {
    const std::vector<std::uint8_t> bytes = noise(3000);
    const std::uint32_t whole = posepack_crc32c(0, bytes.data(), bytes.size());
    for (const std::size_t cut : {0u, 1u, 511u, 512u, 1500u, 2999u, 3000u}) {
        const std::uint32_t front = posepack_crc32c(0, bytes.data(), cut);
        EXPECT_EQ(posepack_crc32c(front, bytes.data() + cut, bytes.size() - cut), whole) << cut;
    }
}

TEST(Crc32c, EveryBitOfALongMessageMatters) {
    std::vector<std::uint8_t> bytes = noise(600);
    const std::uint32_t whole = posepack_crc32c(0, bytes.data(), bytes.size());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        ASSERT_NE(posepack_crc32c(0, bytes.data(), bytes.size()), whole) << bit;
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    }
}
