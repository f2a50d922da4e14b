// SPDX-License-Identifier: MIT
// Broken files: what is repaired with a remark, and what is refused by name.
#include <array>
#include <limits>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

RawModel swaying_reed(const Reed& shape) {
    const RawModel model = reed(shape);
    return with_clip(model, swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0));
}

// Without repair these draw the body a part of the way to the origin.
RawModel weights_of(float sum) {
    RawModel model = swaying_reed({.foot = {10.0, 0.0, 0.0}});
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
    RawModel model = swaying_reed({});
    model.weights[4 * 17] = std::numeric_limits<float>::quiet_NaN();
    return model;
}

RawModel quaternions_of_length(float length) {
    RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    for (RawChannel& channel : channels)
        for (std::size_t i = 20; i < 24; ++i) channel.values[i] *= length;
    return with_clip(model, channels);
}

RawModel quaternion_of_0_9() {
    return quaternions_of_length(0.9f);
}

RawModel quaternion_of_0() {
    return quaternions_of_length(0.0f);
}

RawModel position_is_nan() {
    RawModel model = swaying_reed({});
    model.positions[3 * 17] = std::numeric_limits<float>::quiet_NaN();
    return model;
}

RawModel position_is_infinite() {
    RawModel model = swaying_reed({});
    model.positions[3 * 17 + 1] = std::numeric_limits<float>::infinity();
    return model;
}

RawModel inverse_bind_is_nan() {
    RawModel model = swaying_reed({});
    model.inverse_binds[2][12] = std::numeric_limits<float>::quiet_NaN();
    return model;
}

RawModel key_is_nan() {
    RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    channels[1].values[10] = std::numeric_limits<float>::quiet_NaN();
    return with_clip(model, channels);
}

RawModel key_time_is_infinite() {
    RawModel model = reed();
    std::vector<float> times_s = grid(31, kKeyHz);
    times_s.back() = std::numeric_limits<float>::infinity();
    return with_clip(model, {moving(0, times_s, [](double) { return Vec3(0.0); })});
}

RawModel keys_before_zero() {
    return with_clip(reed(), {moving(0, {-0.1f, 0.0f, 0.1f}, [](double) { return Vec3(0.0); })});
}

RawModel falling_keys() {
    return with_clip(reed(),
                     {turning(1, {0.0f, 0.2f, 0.1f, 0.3f}, [](double) { return menagerie::kNoTurn; })});
}

RawModel no_size() {
    return swaying_reed({.length = 0.0, .thickness = 0.0});
}

RawModel of_minutes(double minutes, double key_hz) {
    const RawModel model = reed({.joints = 2, .rings = 3});
    const auto keys = static_cast<std::size_t>(60.0 * minutes * key_hz) + 1;
    return with_clip(model, swaying(model, grid(keys, key_hz), 10.0, 60.0));
}
RawModel five_minutes_of_240_hz() {
    return of_minutes(5.0, 240.0);
}
RawModel clip_of_eleven_minutes() {
    return of_minutes(11.0, 1.0);
}

constexpr Start kAt1Hz{.rate_hz = 1.0};

constexpr std::array kCases = {
    StressCase{"weights_of_0_98",
               "weights that sum to 0.98, 10 m out: unrepaired 0.4 R",
               weights_of_0_98,
               {kMeets, "", IssueCode::warn_weights}},
    StressCase{"weights_of_0_18",
               "weights that sum to 0.18, as one real file has them",
               weights_of_0_18,
               {kMeets, "", IssueCode::warn_weights}},
    StressCase{
        "weight_is_nan", "a weight that is no number", weight_is_nan, {kMeets, "", IssueCode::warn_weights}},
    StressCase{"quaternion_of_0_9",
               "rotation keys of length 0.9",
               quaternion_of_0_9,
               {kMeets, "", IssueCode::warn_quat}},
    StressCase{"quaternion_of_0",
               "rotation keys of length 0: no rotation",
               quaternion_of_0,
               {refuses(IssueCode::glb_quat), "expected unit quaternions"}},
    StressCase{
        "position_is_nan", "a position that is no number", position_is_nan, {refuses(IssueCode::glb_number)}},
    StressCase{"position_is_infinite",
               "a position at infinity",
               position_is_infinite,
               {refuses(IssueCode::glb_number)}},
    StressCase{"inverse_bind_is_nan",
               "an inverse bind that is no number",
               inverse_bind_is_nan,
               {refuses(IssueCode::glb_number)}},
    StressCase{"key_is_nan", "a key value that is no number", key_is_nan, {refuses(IssueCode::glb_number)}},
    StressCase{
        "key_time_is_infinite", "a key at no time", key_time_is_infinite, {refuses(IssueCode::glb_number)}},
    StressCase{"keys_before_zero",
               "key times below 0 s",
               keys_before_zero,
               {refuses(IssueCode::glb_times), "expected key times from 0 s on"}},
    StressCase{"falling_keys",
               "key times that fall",
               falling_keys,
               {refuses(IssueCode::glb_times), "expected rising key times"}},
    StressCase{"no_size",
               "all vertices in one point: no R to be a fraction of",
               no_size,
               {refuses(IssueCode::glb_no_extent), "a rest pose with a size"}},
    StressCase{"clip_of_eleven_minutes",
               "660 s",
               clip_of_eleven_minutes,
               {refuses(IssueCode::lim_duration), "at most 600 s"},
               kAt1Hz},
    StressCase{"five_minutes_of_240_hz",
               "72,001 keys on a grid: more rows than a palette has",
               five_minutes_of_240_hz,
               {refuses(IssueCode::lim_rows)}},
};

}  // namespace

CaseGroup fault_cases() {
    return {"Broken files",
            "Weights and rotations that are a little off are repaired, counted and remarked; what is no "
            "motion at all, or "
            "more than a palette holds, is refused with its place before anything is baked.",
            kCases};
}

}  // namespace posepack::stress
