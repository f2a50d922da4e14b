// SPDX-License-Identifier: MIT
// Rules of dual quaternions: header values, closing rows, real parts.
#include "rules.hpp"

namespace posepack::test {
namespace {

TEST(Rules, HeaderValuesOfDualQuaternions) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    run({{"H5", "three texels", header_u8(POSEPACK_HDR_TEXELS_PER_BONE, 3)},
         {"H9", "length 0", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, 0)},
         {"H9", "length minus zero", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kMinusZero)},
         {"H9", "negative length", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kMinusOne)},
         {"H9", "infinite length", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kInfinity)},
         {"H9", "length NaN", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kNaN)},
         {"H9", "another length", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kOne), POSEPACK_OK}},
        options);
}

TEST(Rules, ClosingRows) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    options.closing_row = true;
    const std::size_t last_row = 4 * 48;  // bytes of three bones of two RGBA16F texels, four rows before it
    run({{"C5", "closing_row 2", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 2)},
         {"C5", "of a clip that ends", u8(kClip, kWalk + POSEPACK_CLIP_WRAP, POSEPACK_WRAP_ONCE)},
         {"C6", "no place is left for it", u32(kClip, kWalk + POSEPACK_CLIP_ROW_COUNT, 4)},
         {"C6", "a row that belongs to no clip", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 0)},
         {"C7", "a cut at the closing row", u32(kClip, kCuts, 3)},
         {"X7", "another number", u16(kPixl, last_row + 8, 0x3C00)},
         {"X7", "one sign turned", u8(kPixl, last_row + 1, 0x80)},
         {"X7", "one sign turned back, of a bone that is turned", u8(kPixl, last_row + 16 + 7, 0x3A)}},
        options);
    for (const bool planar : {false, true})
        for (const bool floats : {false, true}) {
            options.texel_order = planar ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
            options.texel_format = floats ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
            run({{"X7", "the last number", [&](Parts& p) { p[kPixl].back() ^= 1; }}}, options);
        }
    run({{"C5", "of another encoding", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 1)}});
}

TEST(Rules, RealPartsOfDualQuaternions) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    // Bone 1 of row 3 in both orders: texel 0 is its real part.
    for (const bool planar : {false, true}) {
        options.texel_order = planar ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
        const std::size_t half_real = 3 * 48 + (planar ? 8 : 16);
        const auto halves = [&](std::uint16_t x) {
            return [=](Parts& p) {
                for (std::size_t c = 0; c < 4; ++c) put_u16(p[kPixl], half_real + 2 * c, c == 2 ? x : 0);
            };
        };
        options.texel_format = POSEPACK_TEXEL_RGBA16F;
        run({{"X6", "zero", halves(0)},
             {"X6", "just below a quarter", halves(0x33FF)},
             {"X6", "just above two", halves(0x4001)},
             {"X6", "a quarter", halves(0x3400), POSEPACK_OK},
             {"X6", "minus two", halves(0xC000), POSEPACK_OK}},
            options);
        options.texel_format = POSEPACK_TEXEL_RGBA32F;
        const std::size_t float_real = 2 * half_real;
        const auto floats = [&](std::uint32_t x) {
            return [=](Parts& p) {
                for (std::size_t c = 0; c < 4; ++c) put_u32(p[kPixl], float_real + 4 * c, c == 2 ? x : 0);
            };
        };
        run({{"X6", "just below a quarter", floats(0x3E7FFFFF)},
             {"X6", "just above two", floats(0x40000001)},
             {"X6", "minus a quarter", floats(0xBE800000), POSEPACK_OK},
             {"X6", "two", floats(0x40000000), POSEPACK_OK}},
            options);
    }
}

}  // namespace
}  // namespace posepack::test
