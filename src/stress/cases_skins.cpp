// SPDX-License-Identifier: MIT
// Skins: long chains, and matrices that fold.
#include <array>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

// A wave that runs along a chain of 2 m and curls it.
RawModel wave_on(int joints) {
    const RawModel model =
        reed({.joints = joints, .length = 2.0, .thickness = 0.05, .rings = 2 * joints + 1});
    return with_clip(model, swaying(model, grid(31, kKeyHz), 160.0 / joints, 1.0));
}
RawModel wave_on_8() {
    return wave_on(8);
}
RawModel wave_on_32() {
    return wave_on(32);
}
RawModel wave_on_128() {
    return wave_on(128);
}

RawModel swaying_reed(const Vec3& foot = Vec3(0.0)) {
    const RawModel model = reed({.foot = foot});
    return with_clip(model, swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0));
}

// One bone draws its part of the body flat, as for a shadow: legal, and without an inverse.
RawModel singular_inverse_bind() {
    RawModel model = swaying_reed();
    for (const std::size_t column : {0u, 1u, 2u, 3u}) model.inverse_binds[2][column * 4 + 2] = 0.0f;
    return model;
}
constexpr std::array kCases = {
    StressCase{"wave_on_8_joints", "a wave on a chain of 2 m", wave_on_8, {kMeets}},
    StressCase{"wave_on_32_joints",
               "the same on 32 joints: errors must not add up along the chain",
               wave_on_32,
               {kMeets}},
    StressCase{"wave_on_128_joints", "the same on 128 joints", wave_on_128, {kMeets}},
    StressCase{"singular_inverse_bind",
               "an inverse bind that flattens: legal, and no similarity",
               singular_inverse_bind,
               {kSwitchesForm}},
};

}  // namespace

CaseGroup skin_cases() {
    return {"Skins", "Rows hold whole skinning matrices, so errors do not add up along a chain.", kCases};
}

}  // namespace posepack::stress
