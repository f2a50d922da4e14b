// SPDX-License-Identifier: MIT
#include "vat/vram.hpp"

#include <gtest/gtest.h>

#include <set>

namespace posepack::vat {
namespace {

const Form& form(std::string_view name) {
    for (const Form& form : kForms)
        if (form.name == name) return form;
    throw std::invalid_argument(std::string(name));
}

// The published Goat: 496 rows, 53 bones, 2,500 vertices.
std::uint64_t goat_bytes(std::string_view name) {
    return texture_bytes(form(name), 496, 53, 2500);
}

TEST(Vram, ThePublishedGoat) {
    EXPECT_EQ(goat_bytes("mat4 RGBA32F"), 1'682'432u);
    EXPECT_EQ(goat_bytes("mat4 RGBA16F"), 841'216u);
    EXPECT_EQ(goat_bytes("affine RGBA32F"), 1'261'824u);
    EXPECT_EQ(goat_bytes("affine RGBA16F"), 630'912u);
    EXPECT_EQ(goat_bytes("VAT RGB32F position"), 14'880'000u);
    EXPECT_EQ(goat_bytes("VAT RGBA32F position + normal"), 39'680'000u);
    EXPECT_EQ(goat_bytes("VAT RGBA16F position + normal"), 19'840'000u);
}

TEST(Vram, ThirtyGoats) {
    EXPECT_EQ(30 * goat_bytes("mat4 RGBA32F"), 50'472'960u);
    EXPECT_EQ(30 * goat_bytes("VAT RGB32F position"), 446'400'000u);
}

TEST(Vram, LargeCountsDoNotOverflow) {
    EXPECT_EQ(texture_bytes(form("mat4 RGBA32F"), 65'536, 1'024, 0), std::uint64_t{1} << 32);
    EXPECT_EQ(texture_bytes(form("VAT RGBA32F position + normal"), 65'536, 0, 1u << 24),
              std::uint64_t{1} << 45);
}

// Two rows, and for a palette the texels of each influence.
TEST(Vram, TexelReadsOfAVertex) {
    EXPECT_EQ(texel_reads(form("mat4 RGBA16F"), 4), 32u);
    EXPECT_EQ(texel_reads(form("affine RGBA16F"), 4), 24u);
    EXPECT_EQ(texel_reads(form("affine RGBA32F"), 2), 12u);
    EXPECT_EQ(texel_reads(form("VAT RGB32F position"), 4), 2u);
    EXPECT_EQ(texel_reads(form("VAT RGBA16F position + normal"), 4), 4u);
}

TEST(Vram, FormsHaveNamesOfTheirOwn) {
    std::set<std::string_view> names;
    for (const Form& form : kForms) EXPECT_TRUE(names.insert(form.name).second) << form.name;
    EXPECT_EQ(names.size(), kFormCount);
}

}  // namespace
}  // namespace posepack::vat
