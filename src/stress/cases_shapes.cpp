// SPDX-License-Identifier: MIT
// Bones that are no rotations: shear, stretch, mirrors, vanishing; and rotations whose signs do not close.
#include <array>
#include <cmath>
#include <utility>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

// The node above the body is scaled; the body turns below it.
RawModel turning_under(const Vec3& scale) {
    RawModel model = carried_reed();
    const std::vector<RawChannel> sway = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    model.nodes[0].scale = scale;
    return with_clip(model, {sway.begin() + 1, sway.end()});
}

RawModel shear() {
    return turning_under({1.0, 3.0, 1.0});
}
RawModel anisotropy_1_01() {
    return turning_under({1.0, 1.01, 1.0});
}
RawModel anisotropy_1_0005() {
    return turning_under({1.0, 1.0005, 1.0});
}
RawModel mirror() {
    return turning_under({-1.0, 1.0, 1.0});
}

// One joint's scale over time, while the one above it turns.
RawModel scaled(const std::function<Vec3(double)>& scale) {
    return with_clip(reed(),
                     {turning(1, grid(31, 30.0),
                              [](double time_s) { return turn_about(kAxisX, 25.0 * sine_of_turns(time_s)); }),
                      scaling(2, grid(31, 30.0), scale)});
}

RawModel breathing() {
    return scaled([](double time_s) { return Vec3(1.25 - 0.25 * cosine_of_turns(time_s)); });
}
RawModel squash_and_stretch() {
    return scaled([](double time_s) {
        const double stretch = 1.25 - 0.25 * cosine_of_turns(time_s);
        return Vec3(1.0 / stretch, stretch, 1.0 / stretch);
    });
}
RawModel scale_to_zero() {
    return scaled([](double time_s) { return Vec3(std::abs(1.0 - 2.0 * std::round(time_s * 30.0) / 30.0)); });
}
RawModel scale_through_zero() {
    return scaled([](double time_s) { return Vec3(1.0 - 2.0 * std::round(time_s * 30.0) / 30.0); });
}
RawModel flat_for_a_moment() {
    return scaled(
        [](double time_s) { return Vec3(1.0, 1.0, std::abs(1.0 - 2.0 * std::round(time_s * 30.0) / 30.0)); });
}

// Born a thousandth of its size, as small as the rest pose, and grown by a million.
RawModel growth_of_a_million() {
    RawModel model = reed();
    model.nodes[0].scale = Vec3(1e-3);
    return with_clip(model, {scaling(0, grid(31, 30.0), [](double time_s) {
                         double scale = 1e-3;
                         for (int step = 0; step < std::lround(time_s * 30.0); ++step)
                             scale *= 1.5848931924611136;  // the 30th root of a million
                         return Vec3(scale);
                     })});
}

// Hidden by a scale of 1e-6 in the rest pose, shown at full size in the clip, as props are.
RawModel hidden_at_rest() {
    RawModel model = reed();
    const std::vector<RawChannel> sway = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    model.nodes[3].scale = Vec3(1e-6);
    std::vector<RawChannel> channels = sway;
    channels.push_back(scaling(3, grid(2, 1.0), [](double) { return Vec3(1.0); }));
    return with_clip(model, channels);
}

RawModel turns_in_a_loop(double turns) {
    return with_clip(reed(), {turning(1, grid(31, 30.0), [&](double time_s) {
                         return turn_about(kAxisY, 360.0 * turns * time_s);
                     })});
}
RawModel one_turn_a_loop() {
    return turns_in_a_loop(1.0);
}
RawModel two_turns_a_loop() {
    return turns_in_a_loop(2.0);
}

RawModel alternating_signs() {
    return with_clip(reed(), {turning(1, grid(31, 30.0), [](double time_s) {
                         const Quat q = turn_about(kAxisX, 30.0 * sine_of_turns(time_s));
                         return std::lround(time_s * 30.0) % 2 == 0 ? q : -q;
                     })});
}

// Cubic splines of rotations are not turned to the shorter arc: from (0, 0, 0, 1) to (x, 0, 0, -1), straight
// through the middle, where the length is x / 2 and the turn is over in a moment.
RawModel cubic_rotation_through(float x) {
    RawChannel spin{1, RawPath::rotation, Interpolation::cubic, {0.0f, 0.5f, 1.0f}, {}};
    for (const auto& [at, w] : {std::pair{0.0f, 1.0f}, std::pair{x, -1.0f}, std::pair{0.0f, 1.0f}})
        spin.values.insert(spin.values.end(), {0, 0, 0, 0, at, 0, 0, w, 0, 0, 0, 0});
    return with_clip(reed(), {spin});
}
RawModel cubic_rotation_through_zero() {
    return cubic_rotation_through(0.0f);
}
RawModel cubic_rotation_near_zero() {
    return cubic_rotation_through(0.04f);
}

constexpr Start kLoop{.wrap = recipe::Wrap::loop};

constexpr std::array kCases = {
    StressCase{"breathing", "a joint that grows to 1.5 and back", breathing, {kMeets}, kLoop},
    StressCase{"shear", "turns below a scale of (1, 3, 1): bones shear", shear, {kSwitchesForm}},
    StressCase{"squash_and_stretch",
               "a joint stretches to 1.5 and thins by as much",
               squash_and_stretch,
               {kSwitchesForm},
               kLoop},
    StressCase{"anisotropy_1_01", "a stretch of 1 %: 3 mm of a metre", anisotropy_1_01, {kSwitchesForm}},
    StressCase{"anisotropy_1_0005", "a stretch of 0.05 %, which nobody sees", anisotropy_1_0005, {kMeets}},
    StressCase{"mirror", "a mirrored bone: a negative determinant", mirror, {kMeets}},
    StressCase{"scale_to_zero",
               "a joint shrinks to nothing and grows again: a kink, and no rotation there",
               scale_to_zero,
               {kMeets}},
    StressCase{"scale_through_zero",
               "a joint shrinks through nothing to its mirror image",
               scale_through_zero,
               {kMeets}},
    StressCase{"flat_for_a_moment",
               "a joint is flat for a moment: a singular matrix that is not zero",
               flat_for_a_moment,
               {kSwitchesForm}},
    StressCase{"growth_of_a_million",
               "born at a thousandth, grown by a million, R that of the birth",
               growth_of_a_million,
               {refuses(IssueCode::lim_bound)}},
    StressCase{"hidden_at_rest",
               "a part is hidden at rest by a scale of 1e-6 and shown in the clip",
               hidden_at_rest,
               {kMeets}},
    StressCase{
        "alternating_signs", "keys are q and -q in turn, which turn alike", alternating_signs, {kSlots}},
    StressCase{"one_turn_a_loop",
               "one whole turn a loop: it ends at -q, no choice of signs closes it",
               one_turn_a_loop,
               {kMeets},
               kLoop},
    StressCase{"two_turns_a_loop", "two whole turns a loop: signs close", two_turns_a_loop, {kMeets}, kLoop},
    StressCase{"cubic_rotation_through_zero",
               "a cubic spline of rotations through the quaternion 0",
               cubic_rotation_through_zero,
               {kMeets}},
    StressCase{"cubic_rotation_near_zero",
               "the same past 0 at a distance: 355 degrees in a moment",
               cubic_rotation_near_zero,
               {refuses(IssueCode::lim_bound)}},
};

}  // namespace

CaseGroup shape_cases() {
    return {"Shapes and signs",
            "Uniform scales, mirrors and zero fit dual quaternions; stretch and shear do not, and go to "
            "matrices. "
            "Signs of quaternions are aligned along the rows, and a closing row ends an odd number of turns.",
            kCases};
}

}  // namespace posepack::stress
