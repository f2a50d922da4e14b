// SPDX-License-Identifier: MIT
// What the encoder writes, the shipped loader reads back: every value is the nearest half or float.
#include "palette/encode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "format/half.h"
#include "forms.hpp"
#include "palette/container_writer.hpp"
#include "posepack/loader.h"
#include "support/sample_models.hpp"

namespace posepack::palette {
namespace {

using motion::Affine;

std::vector<Affine> random_bones(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    std::vector<Affine> bones(count);
    for (Affine& bone : bones)
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) bone.linear[c][r] = number(random);
            bone.translation[r] = 1000 * number(random);
        }
    return bones;
}

double element(const Affine& bone, int r, int c) {
    return c < 3 ? bone.linear[c][r] : bone.translation[r];
}

// An animal of `bone_count` bones with one clip, for the tables around the texels.
animal::Animal animal_with(std::size_t bone_count) {
    support::ModelSpec spec = support::one_bone();
    spec.nodes.clear();
    spec.skins[0].joints.clear();
    for (std::size_t b = 0; b < bone_count; ++b) {
        spec.nodes.push_back({{"name", "Bone " + std::to_string(b)}});
        spec.skins[0].joints.push_back(static_cast<int>(b));
    }
    spec.clips = {{"Clip", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    return support::animal_of(spec);
}

// Encodes rows of random matrices, and reads all of them through the loader.
void expect_read_back(const recipe::OutputOptions& form, std::uint32_t bone_count, std::uint32_t row_count) {
    SCOPED_TRACE(name_of_form(form) + std::to_string(row_count) + " rows");
    const animal::Animal animal = animal_with(bone_count);
    Palette palette;
    palette.layout = choose_layout(form, bone_count, row_count).value();
    palette.radius = 1;
    PaletteClip clip;
    clip.plan.row_count = row_count;
    clip.plan.wrap = recipe::Wrap::loop;
    clip.plan.rate_hz = row_count == 1 ? 0.0 : 30.0;
    clip.plan.period_s = row_count == 1 ? 0.0 : row_count / 30.0;
    palette.clips = {clip};
    RowEncoder encoder(palette.layout);
    std::mt19937 random(row_count);
    std::vector<float> stored(bone_count * 12), expected;
    for (std::uint32_t row = 0; row < row_count; ++row) {
        const std::vector<Affine> bones = random_bones(random, bone_count);
        ASSERT_EQ(encoder.encode(row, bones, stored), bone_count);
        for (const Affine& bone : bones)
            for (int e = 0; e < 12; ++e) {
                const auto value = static_cast<float>(element(bone, e / 4, e % 4));
                const bool half = form.texel_format == recipe::TexelFormat::rgba16f;
                expected.push_back(half ? posepack_float_from_half(posepack_half_from_float(value)) : value);
            }
        EXPECT_TRUE(
            std::equal(stored.begin(), stored.end(), expected.end() - static_cast<long>(stored.size())));
    }
    palette.pixels = encoder.finish();
    const std::vector<std::uint8_t> container = write_container(animal, palette, "{}");
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, container.data(), container.size()), POSEPACK_OK);
    std::size_t next = 0;
    std::vector<float> decoded(bone_count * 12);
    for (std::uint32_t row = 0; row < row_count; ++row, next += decoded.size()) {
        ASSERT_EQ(posepack_decode_row(&view, row, decoded.data()), POSEPACK_OK);
        ASSERT_TRUE(std::equal(decoded.begin(), decoded.end(), expected.begin() + static_cast<long>(next)))
            << row;
        float bone[12];
        ASSERT_EQ(posepack_decode_bone(&view, row, bone_count - 1, bone), POSEPACK_OK);
        ASSERT_TRUE(std::equal(bone, bone + 12, decoded.end() - 12)) << row;
    }
}

TEST(Encode, EveryFormReadsBackToTheBit) {
    for (const recipe::OutputOptions& form : all_forms())
        for (const std::uint32_t row_count : {1u, 7u}) expect_read_back(form, 5, row_count);
}

TEST(Encode, RowsSideBySideReadBackToo) {
    for (const recipe::OutputOptions& form : all_forms()) expect_read_back(form, 3, 4099);
}

// Places of the last line that no row needs hold its last row, so that a filter meets no garbage.
TEST(Encode, TheLastLineIsFilledWithItsLastRow) {
    for (const recipe::OutputOptions& form : all_forms()) {
        SCOPED_TRACE(name_of_form(form));
        const Layout layout = choose_layout(form, 2, 8193).value();  // three rows a line: 2,731 lines exactly
        EXPECT_EQ(layout.rows_per_line * layout.texture_height, 8193u);
        const Layout ragged = choose_layout(form, 2, 8195).value();  // the last line has two of three
        RowEncoder encoder(ragged);
        std::vector<float> stored(24);
        for (std::uint32_t row = 0; row < 8195; ++row) {
            std::vector<Affine> bones(2);
            bones[0].translation.x = row % 100;
            bones[1].translation.y = -static_cast<double>(row % 77);
            encoder.encode(row, bones, stored);
        }
        const std::vector<std::uint8_t> pixels = encoder.finish();
        ASSERT_EQ(pixels.size(), ragged.pixel_bytes());
        const std::size_t row_bytes = std::size_t{2} * ragged.texels_per_bone * ragged.texel_bytes;
        const auto last_line = pixels.end() - ragged.row_pitch_bytes;
        const auto second = last_line + static_cast<long>(row_bytes);
        EXPECT_TRUE(
            std::equal(second, second + static_cast<long>(row_bytes), second + static_cast<long>(row_bytes)));
        EXPECT_FALSE(std::equal(last_line, second, second)) << "the rows themselves differ";
        for (auto fill = last_line + static_cast<long>(3 * row_bytes); fill != pixels.end(); ++fill)
            ASSERT_EQ(*fill, 0) << "pitch";
    }
}

TEST(Encode, WhatTheFormatCannotHoldNamesTheBone) {
    struct Row {
        recipe::TexelFormat format;
        double value;
        bool fits;
    };
    const Row rows[] = {
        {recipe::TexelFormat::rgba16f, 65504, true},
        {recipe::TexelFormat::rgba16f, 65519.9, true},
        {recipe::TexelFormat::rgba16f, 65520, false},
        {recipe::TexelFormat::rgba16f, -70000, false},
        {recipe::TexelFormat::rgba32f, 70000, true},
        {recipe::TexelFormat::rgba32f, 3.4e38, true},
        {recipe::TexelFormat::rgba32f, 1e39, false},
        {recipe::TexelFormat::rgba32f, -HUGE_VAL, false},
        {recipe::TexelFormat::rgba16f, std::nan(""), false},
        {recipe::TexelFormat::rgba32f, std::nan(""), false},
    };
    for (const recipe::Encoding encoding : {recipe::Encoding::mat4, recipe::Encoding::affine})
        for (const Row& row : rows) {
            recipe::OutputOptions form;
            form.encoding = encoding;
            form.texel_format = row.format;
            RowEncoder encoder(choose_layout(form, 4, 1).value());
            std::vector<Affine> bones(4);
            bones[2].linear[1][0] = row.value;
            std::vector<float> stored(48);
            EXPECT_EQ(encoder.encode(0, bones, stored), row.fits ? 4u : 2u) << row.value;
            const std::vector<std::uint8_t> pixels = encoder.finish();
            const bool blank =
                std::all_of(pixels.begin(), pixels.end(), [](std::uint8_t b) { return b == 0; });
            EXPECT_EQ(blank, !row.fits) << "nothing is written of a row that does not fit";
        }
}

}  // namespace
}  // namespace posepack::palette
