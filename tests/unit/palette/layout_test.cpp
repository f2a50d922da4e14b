// SPDX-License-Identifier: MIT
#include "palette/layout.hpp"

#include <gtest/gtest.h>

#include "forms.hpp"
#include "posepack/format.h"

namespace posepack::palette {
namespace {

using base::IssueCode;
using recipe::Caps;
using recipe::Encoding;
using recipe::OutputOptions;
using recipe::TexelFormat;

OutputOptions form(Encoding encoding, TexelFormat format, Caps caps = Caps::webgl2) {
    OutputOptions options;
    options.encoding = encoding;
    options.texel_format = format;
    options.caps = caps;
    return options;
}

Layout layout_of(const OutputOptions& options, std::uint32_t bone_count, std::uint32_t row_count) {
    const auto layout = choose_layout(options, bone_count, row_count);
    EXPECT_TRUE(layout) << bone_count << " bones, " << row_count << " rows";
    return layout ? layout.value() : Layout{};
}

// The Goat's 53 bones and 496 rows, to the byte.
TEST(Layout, ThePublishedByteCounts) {
    const Layout full = layout_of(form(Encoding::mat4, TexelFormat::rgba32f), 53, 496);
    EXPECT_EQ(full.texel_payload_bytes(), 1'682'432u);
    EXPECT_EQ(full.pixel_bytes(), 1'682'432u) << "one row a line, tight: the texture is the payload";
    EXPECT_EQ(layout_of(form(Encoding::mat4, TexelFormat::rgba16f), 53, 496).pixel_bytes(), 841'216u);
    EXPECT_EQ(layout_of(form(Encoding::affine, TexelFormat::rgba32f), 53, 496).pixel_bytes(), 1'261'824u);
    EXPECT_EQ(layout_of(form(Encoding::affine, TexelFormat::rgba16f), 53, 496).pixel_bytes(), 630'912u);
}

TEST(Layout, FieldsOfEveryForm) {
    for (const OutputOptions& options : all_forms()) {
        const Layout layout = layout_of(options, 53, 496);
        const bool mat4 = options.encoding == Encoding::mat4;
        const bool half = options.texel_format == TexelFormat::rgba16f;
        EXPECT_EQ(layout.encoding, mat4 ? POSEPACK_ENCODING_MAT4 : POSEPACK_ENCODING_AFFINE);
        EXPECT_EQ(layout.texels_per_bone, mat4 ? 4 : 3);
        EXPECT_EQ(layout.texel_format, half ? POSEPACK_TEXEL_RGBA16F : POSEPACK_TEXEL_RGBA32F);
        EXPECT_EQ(layout.texel_bytes, half ? 8u : 16u);
        EXPECT_EQ(layout.texel_order, options.texel_order == recipe::TexelOrder::planar
                                          ? POSEPACK_ORDER_PLANAR
                                          : POSEPACK_ORDER_BONE_MAJOR);
        EXPECT_EQ(layout.rows_per_line, 1u);
        EXPECT_EQ(layout.texture_width, 53u * layout.texels_per_bone);
        EXPECT_EQ(layout.texture_height, 496u);
        const std::uint32_t tight = layout.texture_width * layout.texel_bytes;
        if (options.row_pitch == recipe::RowPitch::tight) {
            EXPECT_EQ(layout.row_pitch_bytes, tight);
        } else {
            EXPECT_EQ(layout.row_pitch_bytes % 256, 0u);
            EXPECT_GE(layout.row_pitch_bytes, tight);
            EXPECT_LT(layout.row_pitch_bytes, tight + 256);
        }
    }
}

TEST(Layout, RowsGoSideBySideOnlyWhereTheHeightForcesIt) {
    struct Row {
        Caps caps;
        std::uint32_t row_count, rows_per_line, height;
    };
    const Row rows[] = {
        {Caps::webgl2, 1, 1, 1},
        {Caps::webgl2, 4096, 1, 4096},
        {Caps::webgl2, 4097, 2, 2049},
        {Caps::webgl2, 8192, 2, 4096},
        {Caps::webgl2, 8193, 3, 2731},
        {Caps::webgl2, 65'536, 16, 4096},
        {Caps::desktop, 16'384, 1, 16'384},
        {Caps::desktop, 16'385, 2, 8193},
        {Caps::desktop, 65'536, 4, 16'384},
    };
    for (const Row& row : rows) {
        const Layout layout =
            layout_of(form(Encoding::affine, TexelFormat::rgba16f, row.caps), 10, row.row_count);
        EXPECT_EQ(layout.rows_per_line, row.rows_per_line) << row.row_count;
        EXPECT_EQ(layout.texture_height, row.height) << row.row_count;
        EXPECT_EQ(layout.texture_width, 30u * row.rows_per_line) << row.row_count;
        EXPECT_EQ(layout.texel_payload_bytes(), std::uint64_t{8} * 30 * row.row_count);
    }
}

TEST(Layout, WhatFitsNoTexture) {
    struct Row {
        OutputOptions options;
        std::uint32_t bone_count, row_count;
        bool fits;
    };
    const Row rows[] = {
        {form(Encoding::mat4, TexelFormat::rgba16f), 1024, 100, true},  // 4,096 texels: just the cap
        {form(Encoding::affine, TexelFormat::rgba16f), 1024, 4096, true},
        {form(Encoding::affine, TexelFormat::rgba16f), 1024, 4097, false},  // two rows a line: 6,144 texels
        {form(Encoding::affine, TexelFormat::rgba16f), 682, 4097, true},    // 4,092
        {form(Encoding::affine, TexelFormat::rgba16f), 683, 4097, false},   // 4,098
        {form(Encoding::mat4, TexelFormat::rgba16f, Caps::desktop), 1024, 4097, true},
    };
    for (const Row& row : rows) {
        const auto layout = choose_layout(row.options, row.bone_count, row.row_count);
        EXPECT_EQ(static_cast<bool>(layout), row.fits)
            << row.bone_count << " bones, " << row.row_count << " rows";
        if (layout) {
            const std::uint32_t cap = row.options.caps == Caps::webgl2 ? 4096 : 16'384;
            EXPECT_LE(layout.value().texture_width, cap);
            EXPECT_LE(layout.value().texture_height, cap);
        } else {
            EXPECT_EQ(layout.issue().code, IssueCode::lim_texture);
        }
    }
}

TEST(Layout, WhatFitsNoContainer) {
    const OutputOptions options = form(Encoding::mat4, TexelFormat::rgba32f, Caps::desktop);
    const auto layout = choose_layout(options, 1000, 16'384);  // 4,000 x 16,384 x 16 bytes: a gigabyte
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.issue().code, IssueCode::lim_container);
    EXPECT_TRUE(choose_layout(options, 1000, 4'000));
}

}  // namespace
}  // namespace posepack::palette
