// SPDX-License-Identifier: MIT
// Skins: long chains, weights that do not sum to one, numbers that are none, matrices that fold.
#include <array>
#include <limits>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

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

// Without repair these draw the body a part of the way to the origin.
RawModel weights_of(float sum) {
    RawModel model = swaying_reed({10.0, 0.0, 0.0});
    for (float& weight : model.weights) weight *= sum;
    return model;
}
RawModel weights_of_0_98() {
    return weights_of(0.98f);
}
RawModel weights_of_0_18() {
    return weights_of(0.18f);
}
RawModel weight_is_nan() {
    RawModel model = swaying_reed();
    model.weights[4 * 17] = std::numeric_limits<float>::quiet_NaN();
    return model;
}
RawModel position_is_nan() {
    RawModel model = swaying_reed();
    model.positions[3 * 17] = std::numeric_limits<float>::quiet_NaN();
    return model;
}
RawModel position_is_infinite() {
    RawModel model = swaying_reed();
    model.positions[3 * 17 + 1] = std::numeric_limits<float>::infinity();
    return model;
}

// One bone draws its part of the body flat, as for a shadow: legal, and without an inverse.
RawModel singular_inverse_bind() {
    RawModel model = swaying_reed();
    for (const std::size_t column : {0u, 1u, 2u, 3u}) model.inverse_binds[2][column * 4 + 2] = 0.0f;
    return model;
}
RawModel inverse_bind_is_nan() {
    RawModel model = swaying_reed();
    model.inverse_binds[2][12] = std::numeric_limits<float>::quiet_NaN();
    return model;
}

constexpr std::array kCases = {
    StressCase{"wave_on_8_joints", "a wave on a chain of 2 m", wave_on_8, {}, kUsual, {kMeets}},
    StressCase{"wave_on_32_joints",
               "the same on 32 joints: errors must not add up along the chain",
               wave_on_32,
               {},
               kUsual,
               {kMeets}},
    StressCase{"wave_on_128_joints", "the same on 128 joints", wave_on_128, {}, kUsual, {kMeets}},
    StressCase{"weights_of_0_98",
               "weights that sum to 0.98, 10 m out: unrepaired 0.4 R",
               weights_of_0_98,
               {},
               kUsual,
               {kMeets, "", IssueCode::warn_weights}},
    StressCase{"weights_of_0_18",
               "weights that sum to 0.18, as one real file has them",
               weights_of_0_18,
               {},
               kUsual,
               {kMeets, "", IssueCode::warn_weights}},
    StressCase{"weight_is_nan",
               "a weight that is no number",
               weight_is_nan,
               {},
               kUsual,
               {kMeets, "", IssueCode::warn_weights}},
    StressCase{"position_is_nan",
               "a position that is no number",
               position_is_nan,
               {},
               kUsual,
               {refuses(IssueCode::glb_number)}},
    StressCase{"position_is_infinite",
               "a position at infinity",
               position_is_infinite,
               {},
               kUsual,
               {refuses(IssueCode::glb_number)}},
    StressCase{"singular_inverse_bind",
               "an inverse bind that flattens: legal, and no similarity",
               singular_inverse_bind,
               {},
               kUsual,
               {kSwitchesForm}},
    StressCase{"inverse_bind_is_nan",
               "an inverse bind that is no number",
               inverse_bind_is_nan,
               {},
               kUsual,
               {refuses(IssueCode::glb_number)}},
};

}  // namespace

CaseGroup skin_cases() {
    return {
        "Skins",
        "Rows hold whole skinning matrices, so errors do not add up along a chain. Weights are repaired and "
        "counted; what has no repair is refused with its place.",
        kCases};
}

}  // namespace posepack::stress
