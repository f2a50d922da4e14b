// SPDX-License-Identifier: MIT
// What the tests of playing share: opened containers, and a walk of any wrap and period.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "changes.hpp"
#include "format/half.h"
#include "posepack/play.h"
#include "runs_builder.hpp"

namespace posepack::test {

inline constexpr std::uint32_t kIdleClip = 0, kWalkClip = 1;
inline constexpr std::array<std::uint32_t, 3> kWraps = {POSEPACK_WRAP_LOOP, POSEPACK_WRAP_ONCE,
                                                        POSEPACK_WRAP_PING_PONG};

// A container that stays in memory as long as its view.
struct Played {
    explicit Played(const Parts& parts) : bytes(assemble(parts)) {
        EXPECT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    }

    Bytes bytes;
    posepack_view view{};
};

// The tiny container, its walk of another wrap and period, without its cut.
inline Parts walk_of(std::uint32_t wrap, float period_s, const TinyOptions& options = {}) {
    Parts parts = make_parts(options);
    Bytes& clips = parts[kClip];
    clips[kWalk + POSEPACK_CLIP_WRAP] = static_cast<std::uint8_t>(wrap);
    const std::uint32_t rows = get_u32(clips, kWalk + POSEPACK_CLIP_ROW_COUNT);
    const std::uint32_t intervals = wrap == POSEPACK_WRAP_LOOP ? rows : rows - 1;
    put_f32(clips, kWalk + POSEPACK_CLIP_PERIOD_S, period_s);
    put_f32(clips, kWalk + POSEPACK_CLIP_RATE_HZ, static_cast<float>(intervals) / period_s);
    put_u32(clips, POSEPACK_CLIP_HEAD_CUT_COUNT, 0);
    put_u32(clips, kWalk + POSEPACK_CLIP_CUT_COUNT, 0);
    clips.resize(kCuts);
    return parts;
}

// What a 16-bit float makes of a number.
inline float half(float x) {
    return posepack_float_from_half(posepack_half_from_float(x));
}

}  // namespace posepack::test
