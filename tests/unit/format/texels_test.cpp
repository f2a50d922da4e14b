// SPDX-License-Identifier: MIT
#include "format/texels.h"

#include <gtest/gtest.h>

#include <set>

#include "posepack/format.h"

namespace {

posepack_texel_layout layout(std::uint32_t order, std::uint32_t rows_per_line, std::uint32_t pitch_bytes) {
    posepack_texel_layout result{};
    result.bone_count = 5;
    result.texels_per_bone = 3;
    result.texel_order = order;
    result.texel_bytes = 8;
    result.rows_per_line = rows_per_line;
    result.row_pitch_bytes = pitch_bytes;
    return result;
}

}  // namespace

TEST(Texels, SizesOfFormatsAndEncodings) {
    EXPECT_EQ(posepack_texel_bytes(POSEPACK_TEXEL_RGBA16F), 8u);
    EXPECT_EQ(posepack_texel_bytes(POSEPACK_TEXEL_RGBA32F), 16u);
    EXPECT_EQ(posepack_texel_bytes(POSEPACK_TEXEL_RGBA32UI), 16u);
    EXPECT_EQ(posepack_texel_bytes(POSEPACK_TEXEL_RG32UI), 8u);
    EXPECT_EQ(posepack_texel_bytes(0), 0u);
    EXPECT_EQ(posepack_texel_bytes(5), 0u);
    EXPECT_EQ(posepack_encoding_texels(POSEPACK_ENCODING_MAT4), 4u);
    EXPECT_EQ(posepack_encoding_texels(POSEPACK_ENCODING_AFFINE), 3u);
    EXPECT_EQ(posepack_encoding_texels(POSEPACK_ENCODING_LOCAL), 2u);
    EXPECT_EQ(posepack_encoding_texels(POSEPACK_ENCODING_PACKED), 1u);
    EXPECT_EQ(posepack_encoding_texels(POSEPACK_ENCODING_DUALQUAT), 2u);
    EXPECT_EQ(posepack_encoding_texels(POSEPACK_MIXED), 0u);
}

TEST(Texels, LinearIndexFollowsTheFormulas) {
    const posepack_texel_layout bone_major = layout(POSEPACK_ORDER_BONE_MAJOR, 1, 120);
    const posepack_texel_layout planar = layout(POSEPACK_ORDER_PLANAR, 1, 120);
    EXPECT_EQ(posepack_texel_index(&bone_major, 7, 2, 1), (7u * 5 + 2) * 3 + 1);
    EXPECT_EQ(posepack_texel_index(&planar, 7, 2, 1), (7u * 3 + 1) * 5 + 2);
}

TEST(Texels, WithATightPitchBothAddressesAreOnePlace) {
    for (const std::uint32_t order : {POSEPACK_ORDER_BONE_MAJOR, POSEPACK_ORDER_PLANAR}) {
        for (const std::uint32_t rows_per_line : {1u, 2u, 3u, 7u}) {
            const posepack_texel_layout tight = layout(order, rows_per_line, rows_per_line * 15 * 8);
            std::set<std::uint64_t> places;
            for (std::uint32_t i = 0; i < 21 * 15; ++i) {
                const std::uint32_t row = i / 15, bone = i % 15 / 3, k = i % 3;
                const std::uint64_t index = posepack_texel_index(&tight, row, bone, k);
                EXPECT_EQ(posepack_texel_offset(&tight, row, bone, k), 8 * index);
                places.insert(index);
            }
            EXPECT_EQ(places.size(), 21u * 15);         // every place once,
            EXPECT_EQ(*places.rbegin(), 21u * 15 - 1);  // and no place left out
        }
    }
}

TEST(Texels, RowsLieSideBySideAndLinesAPitchApart) {
    const posepack_texel_layout padded = layout(POSEPACK_ORDER_PLANAR, 2, 256);
    EXPECT_EQ(posepack_texel_offset(&padded, 0, 4, 2), (2u * 5 + 4) * 8);
    EXPECT_EQ(posepack_texel_offset(&padded, 1, 4, 2), (15u + 2 * 5 + 4) * 8);
    EXPECT_EQ(posepack_texel_offset(&padded, 5, 4, 2), 2u * 256 + (15 + 2 * 5 + 4) * 8);
}

TEST(Texels, TheLargestPaletteDoesNotOverflow) {
    posepack_texel_layout large = layout(POSEPACK_ORDER_BONE_MAJOR, 1, 0xFFFFFF00u);
    large.bone_count = POSEPACK_MAX_BONES;
    large.texels_per_bone = 4;
    EXPECT_EQ(posepack_texel_index(&large, POSEPACK_MAX_ROWS - 1, 1023, 3), 268435455u);
    EXPECT_EQ(posepack_texel_offset(&large, POSEPACK_MAX_ROWS - 1, 0, 0),
              65535u * std::uint64_t{0xFFFFFF00u});
}
