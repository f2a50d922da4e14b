// SPDX-License-Identifier: MIT
// The rules about clips, their measured errors, and states (C, A).
#include <algorithm>

#include "rules.hpp"

namespace posepack::test {
namespace {

TEST(Rules, ClipTableAndKinds) {
    run({
        {"C1", "shorter than its records", [](Parts& p) { p[kClip].resize(kCuts - 4); }},
        {"C1", "count", u32(kClip, POSEPACK_CLIP_HEAD_COUNT, 1)},
        {"C1", "record size", u32(kClip, POSEPACK_CLIP_HEAD_RECORD_BYTES, 196)},
        {"C1", "reserved word", u32(kClip, POSEPACK_CLIP_HEAD_RESERVED, 1)},
        {"C1", "one cut fewer than stored", u32(kClip, POSEPACK_CLIP_HEAD_CUT_COUNT, 0)},
        {"C1", "cuts past the section", u32(kClip, POSEPACK_CLIP_HEAD_CUT_COUNT, 0x40000001)},
        {"C1", "four bytes behind the cuts", resize(kClip, 4)},
        {"C2", "name", u32(kClip, kIdle + POSEPACK_CLIP_NAME, 11)},
        {"C2", "source name", u32(kClip, kIdle + POSEPACK_CLIP_SOURCE_NAME, POSEPACK_NONE)},
        {"C3", "encoding unlike the header's", u8(kClip, kWalk + POSEPACK_CLIP_ENCODING, 1)},
        {"C3", "texels unlike the header's", u8(kClip, kWalk + POSEPACK_CLIP_TEXELS_PER_BONE, 4)},
        {"C3", "row scheme unlike the header's", u8(kClip, kWalk + POSEPACK_CLIP_ROW_SCHEME, 1)},
        {"C4", "wrap", u8(kClip, kWalk + POSEPACK_CLIP_WRAP, 3)},
        {"C4", "seam", u8(kClip, kWalk + POSEPACK_CLIP_SEAM, 2)},
        {"C4", "interpolation", u8(kClip, kWalk + POSEPACK_CLIP_INTERPOLATION, 2)},
        {"C4", "flags", u8(kClip, kWalk + POSEPACK_CLIP_FLAGS, 3)},
        {"C5", "closing row", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 1)},
        {"C5", "translation box", u32(kClip, kWalk + POSEPACK_CLIP_TRANSLATION_MAX + 8, kOne)},
        {"C5", "root motion", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_ROOT_MOTION, 0)},
        {"C5", "root motion count", u32(kClip, kWalk + POSEPACK_CLIP_ROOT_MOTION_COUNT, 1)},
        {"C5", "reserved word", u32(kClip, kWalk + POSEPACK_CLIP_RESERVED, 1)},
    });
}

TEST(Rules, ClipRowsAndCuts) {
    run({
        {"C6", "the first clip begins at row 1", u32(kClip, kIdle + POSEPACK_CLIP_FIRST_ROW, 1)},
        {"C6", "P26 row_count wraps",
         [](Parts& p) {
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_ROW, 4);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 0xFFFFFFFE);
         }},
        {"C6", "a gap between clips", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_ROW, 2)},
        {"C6", "no row", u32(kClip, kIdle + POSEPACK_CLIP_ROW_COUNT, 0)},
        {"C6", "a row too many", u32(kClip, kWalk + POSEPACK_CLIP_ROW_COUNT, 5)},
        {"C6", "a row of no clip", u32(kClip, kWalk + POSEPACK_CLIP_ROW_COUNT, 3)},
        {"C6", "a clip without rows before one with all",
         [](Parts& p) {
             put_u32(p[kClip], kIdle + POSEPACK_CLIP_ROW_COUNT, 0);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_RATE_HZ, 1.f);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_PERIOD_S, 1.f);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_ROW, 0);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_TEXEL, 0);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 5);
         }},
        {"C6", "the sum of all rows wraps to the right number",
         [](Parts& p) {
             put_u32(p[kClip], kIdle + POSEPACK_CLIP_ROW_COUNT, 0xFFFFFFFF);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_RATE_HZ, 1.f);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_PERIOD_S, 1.f);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_ROW, 0xFFFFFFFF);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_TEXEL, 0xFFFFFFFFu * 9);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 6);
         }},
        {"C6", "first texel", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_TEXEL, 0)},
        {"C7", "first cut", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_CUT, 1)},
        {"C7", "a cut too many", u32(kClip, kWalk + POSEPACK_CLIP_CUT_COUNT, 2)},
        {"C7", "a cut of no clip", u32(kClip, kWalk + POSEPACK_CLIP_CUT_COUNT, 0)},
        {"C7", "cut count wraps", u32(kClip, kWalk + POSEPACK_CLIP_CUT_COUNT, 0xFFFFFFFF)},
        {"C7", "a cut at row_count", u32(kClip, kCuts, 4)},
        {"C7", "two cuts at one row",
         [](Parts& p) {
             put_u32(p[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 2);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 2);
             p[kClip].resize(kCuts + 8);
             put_u32(p[kClip], kCuts + 4, 2);
         }},
        {"C7", "two cuts that rise",
         [](Parts& p) {
             put_u32(p[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 2);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 2);
             p[kClip].resize(kCuts + 8);
             put_u32(p[kClip], kCuts + 4, 3);
         },
         POSEPACK_OK},
    });
}

TEST(Rules, ClipTimeAndBounds) {
    run({
        {"C8", "a rate for one row", u32(kClip, kIdle + POSEPACK_CLIP_RATE_HZ, kOne)},
        {"C8", "no rate for four rows", u32(kClip, kWalk + POSEPACK_CLIP_RATE_HZ, 0)},
        {"C8", "a negative rate", u32(kClip, kWalk + POSEPACK_CLIP_RATE_HZ, kMinusOne)},
        {"C8", "an infinite rate", u32(kClip, kWalk + POSEPACK_CLIP_RATE_HZ, kInfinity)},
        {"C8", "no period for four rows", u32(kClip, kWalk + POSEPACK_CLIP_PERIOD_S, 0)},
        {"C8", "a negative period", u32(kClip, kIdle + POSEPACK_CLIP_PERIOD_S, kMinusOne)},
        {"C9", "start", u32(kClip, kWalk + POSEPACK_CLIP_START_S, kNaN)},
        {"C9", "speed", u32(kClip, kWalk + POSEPACK_CLIP_SPEED_MPS, kInfinity)},
        {"C9", "negative speed", u32(kClip, kWalk + POSEPACK_CLIP_SPEED_MPS, kMinusOne)},
        {"C9", "stride phase", u32(kClip, kWalk + POSEPACK_CLIP_STRIDE_PHASE, kNaN)},
        {"C9", "seam gap", u32(kClip, kWalk + POSEPACK_CLIP_SEAM_GAP, kNaN)},
        {"C9", "negative seam gap", u32(kClip, kWalk + POSEPACK_CLIP_SEAM_GAP, kMinusOne)},
        {"C10", "box", u32(kClip, kWalk + POSEPACK_CLIP_BOX_MIN, kNaN)},
        {"C10", "box_min above box_max", u32(kClip, kWalk + POSEPACK_CLIP_BOX_MAX + 8, 0xC1000000u)},
        {"C10", "sphere centre", u32(kClip, kWalk + POSEPACK_CLIP_SPHERE_CENTER + 8, kInfinity)},
        {"C10", "sphere radius", u32(kClip, kWalk + POSEPACK_CLIP_SPHERE_RADIUS, kMinusOne)},
        {"C10", "infinite sphere", u32(kClip, kWalk + POSEPACK_CLIP_SPHERE_RADIUS, kInfinity)},
    });
}

TEST(Rules, ClipErrors) {
    for (const std::size_t error : {POSEPACK_CLIP_ERROR_MAX, POSEPACK_CLIP_NORMAL_MAX_DEG}) {
        const std::size_t at = kWalk + error;
        run({
            {"C11", "max", u32(kClip, at, kMinusOne)},
            {"C11", "p99.9", u32(kClip, at + 4, kNaN)},
            {"C11", "rms", u32(kClip, at + 8, kInfinity)},
            {"C11", "time", u32(kClip, at + 12, kNaN)},
            {"C11", "mesh", u32(kClip, at + 16, 2)},
            {"C11", "vertex", u32(kClip, at + 20, 40)},
            {"C11", "a vertex of no mesh", u32(kClip, at + 16, POSEPACK_NONE)},
            {"C11", "bone", u32(kClip, at + 24, 3)},
            {"C11", "the last vertex of the second mesh",
             [at](Parts& p) {
                 put_u32(p[kClip], at + 16, 1);
                 put_u32(p[kClip], at + 20, 11);
             },
             POSEPACK_OK},
            {"C11", "a worst place nobody found",
             [at](Parts& p) {
                 for (std::size_t i = 16; i < 28; i += 4) put_u32(p[kClip], at + i, POSEPACK_NONE);
             },
             POSEPACK_OK},
        });
        TinyOptions unmeasured;
        unmeasured.measured = false;
        run({{"C12", "an amount", u32(kClip, at + 8, kOne)},
             {"C12", "a time", u32(kClip, at + 12, kMinusZero)},
             {"C12", "a mesh", u32(kClip, at + 16, 0)},
             {"C12", "a vertex", u32(kClip, at + 20, 0)},
             {"C12", "a bone", u32(kClip, at + 24, 0)}},
            unmeasured);
    }
}

TEST(Rules, MeasuredFeatureBit) {
    TinyOptions unmeasured;
    unmeasured.measured = false;
    run({{"C13", "not all clips are measured",
          [](Parts& p) {
              const Parts other = make_parts({.measured = false});
              const Bytes& clips = other.sections[0].bytes;
              std::copy(clips.begin() + kIdle, clips.begin() + kWalk, p[kClip].begin() + kIdle);
          }},
         {"C13", "all clips are measured, the bit is clear", header_u32(POSEPACK_HDR_OPTIONAL_FEATURES, 0)}});
    run({{"C13", "no clip is measured, the bit is set",
          header_u32(POSEPACK_HDR_OPTIONAL_FEATURES, POSEPACK_OPTIONAL_ERROR_MEASURED)}},
        unmeasured);
}

TEST(Rules, States) {
    run({
        {"A1", "four bytes", [](Parts& p) { p[kStat].resize(4); }},
        {"A1", "longer than its records", resize(kStat, 8)},
        {"A1", "2^32 - 1 states", u32(kStat, 0, 0xFFFFFFFF)},
        {"A2", "the default state", u32(kStat, 4, 2)},
        {"A2", "no default state", u32(kStat, 4, POSEPACK_NONE), POSEPACK_OK},
        {"A3", "name", u32(kStat, 16, 11)},
        {"A3", "not sorted", u32(kStat, 16, 0)},
        {"A3", "twice the same", u32(kStat, 16, 8)},
        {"A4", "clip", u32(kStat, 20, 2)},
        {"A1", "no state at all",
         [](Parts& p) {
             p[kStat] = Bytes(8);
             put_u32(p[kStat], 4, POSEPACK_NONE);
         },
         POSEPACK_OK},
    });
}

}  // namespace
}  // namespace posepack::test
