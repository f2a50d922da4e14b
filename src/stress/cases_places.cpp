// SPDX-License-Identifier: MIT
// Places and sizes: what halves, floats and GPUs that drop subnormals make of far, huge and tiny animals.
#include <array>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

RawModel swaying_reed(const Reed& shape) {
    const RawModel model = reed(shape);
    return with_clip(model, swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0));
}

// A reed that node 0 carries away; the carrier itself stands still.
RawModel swaying_reed_at(const Vec3& place, double scale, const Reed& shape = {}) {
    RawModel model = carried_reed(shape);
    const std::vector<RawChannel> sway = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    model.nodes[0].translation = place;
    model.nodes[0].scale = Vec3(scale);
    return with_clip(model, {sway.begin() + 1, sway.end()});
}

RawModel one_metre() {
    return swaying_reed({});
}

// No multiple of eight: 10,000 is a half.
RawModel bone_10_km_away() {
    return swaying_reed_at({10'003.0, 0.0, 0.0}, 1.0);
}

RawModel mesh_10_km_away() {
    return swaying_reed({.foot = {10'000.0, 0.0, 0.0}});
}

RawModel travel_10_km() {
    RawModel model = carried_reed();
    std::vector<RawChannel> channels = swaying(model, grid(61, kKeyHz), kSwayDegrees, 1.0);
    channels[0] = moving(0, grid(2, 0.5), [](double time_s) { return Vec3(5'000.0 * time_s, 0.0, 0.0); });
    return with_clip(model, channels);
}

RawModel travel_30_m() {
    RawModel model = carried_reed();
    std::vector<RawChannel> channels = swaying(model, grid(61, kKeyHz), kSwayDegrees, 1.0);
    channels[0] = moving(0, grid(2, 0.5), [](double time_s) { return Vec3(15.0 * time_s, 0.0, 0.0); });
    return with_clip(model, channels);
}

RawModel insect_1_mm() {
    return swaying_reed({.length = 1e-3, .thickness = 1e-4});
}

RawModel mite_10_um() {
    return swaying_reed({.length = 1e-5, .thickness = 1e-6});
}

RawModel speck_1e_20() {
    return swaying_reed({.length = 1e-20, .thickness = 1e-21});
}

RawModel whale_70_m() {
    return swaying_reed({.length = 70.0, .thickness = 7.0});
}

RawModel giant_1000_km() {
    return swaying_reed({.length = 1e6, .thickness = 1e5});
}

// The first joint stands far beside the body that it turns.
RawModel far_pivot(double away_m) {
    RawModel model = carried_reed({.length = 2.0});
    model.nodes[0].translation = Vec3(away_m, 0.0, 0.0);
    model.nodes[1].translation = Vec3(-away_m, 0.0, 0.0);
    bind_at_rest(model);
    return with_clip(model, {turning(0, grid(31, kKeyHz),
                                     [](double time_s) { return turn_about(kAxisY, 60.0 * time_s); })});
}
RawModel far_pivot_1_km() {
    return far_pivot(1'000.0);
}
// Matrices hold 87,000 at the end: more than a half can, and floats step by 8 mm there.
RawModel far_pivot_100_km() {
    return far_pivot(100'000.0);
}

// The last joint shoots 100 m away from the rest.
RawModel arrow_100_m() {
    RawModel model = reed();
    std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    channels.push_back(
        moving(3, grid(2, 1.0), [](double time_s) { return Vec3(100.0 * time_s, 0.25, 0.0); }));
    return with_clip(model, channels);
}

// A joint that no vertex follows flies off 1,000 km and its child comes back: the body stays where it is.
RawModel unseen_joint_flies_off() {
    RawModel model = carried_reed();
    std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
    channels[0] = moving(0, grid(2, 1.0), [](double time_s) { return Vec3(1e6 * time_s, 0.0, 0.0); });
    channels.push_back(moving(1, grid(2, 1.0), [](double time_s) { return Vec3(-1e6 * time_s, 0.0, 0.0); }));
    return with_clip(model, channels);
}

// Two scales that cancel.
RawModel scales_that_cancel() {
    RawModel model = swaying_reed_at(Vec3(0.0), 1e3);
    model.nodes[1].scale = Vec3(1e-3);
    return model;
}

// As exporters of centimetres and Z up write it.
RawModel armature_of_100() {
    RawModel model = swaying_reed_at(Vec3(0.0), 100.0, {.length = 0.01, .thickness = 0.001});
    model.nodes[0].rotation = turn_about(kAxisX, -90.0);
    return model;
}

constexpr std::array kCases = {
    StressCase{"one_metre", "nothing: what the others are compared with", one_metre, {kMeets}},
    StressCase{"bone_10_km_away",
               "a bone carries the mesh 10 km away: halves step by 8 m there",
               bone_10_km_away,
               {kMeets}},
    StressCase{"mesh_10_km_away",
               "the vertices themselves lie at 10 km: floats step by 1 mm there",
               mesh_10_km_away,
               {kMeets}},
    StressCase{"travel_30_m", "the root walks 30 m in the clip, 60 R", travel_30_m, {kSwitchesForm}},
    StressCase{"travel_10_km", "the root flies 10 km in the clip, 20,000 R", travel_10_km, {kSwitchesForm}},
    StressCase{"arrow_100_m", "one joint shoots 100 m away, 200 R", arrow_100_m, {kSwitchesAndAddsRows}},
    StressCase{"far_pivot_1_km", "a turn about a point 1 km away", far_pivot_1_km, {kSwitchesForm}},
    StressCase{"far_pivot_100_km",
               "a turn about a point 100 km away: beyond halves, and floats step by 8 mm",
               far_pivot_100_km,
               {refuses(IssueCode::lim_bound)}},
    StressCase{"unseen_joint_flies_off",
               "a joint without vertices leaves the range of halves",
               unseen_joint_flies_off,
               {kMeets}},
    StressCase{"scales_that_cancel", "a scale of 1,000 above one of 0.001", scales_that_cancel, {kMeets}},
    StressCase{"insect_1_mm",
               "halves of millimetres are subnormal, which some GPUs read as zero",
               insect_1_mm,
               {kMeets}},
    StressCase{"mite_10_um", "every half of ten micrometres is subnormal", mite_10_um, {kMeets}},
    StressCase{"speck_1e_20", "squares of its errors are below the smallest float", speck_1e_20, {kMeets}},
    StressCase{"whale_70_m", "a half steps by 16 mm beyond 32 m", whale_70_m, {kMeets}},
    StressCase{"giant_1000_km", "no half reaches 65,505", giant_1000_km, {kMeets}},
    StressCase{"armature_of_100",
               "centimetres and Z up under an armature 100 times too large",
               armature_of_100,
               {kMeets}},
};

}  // namespace

CaseGroup place_cases() {
    return {
        "Places and sizes",
        "In the normalised space neither a far origin nor any size of the animal costs anything; only a clip "
        "that itself travels thousands of R needs floats.",
        kCases, true};
}

}  // namespace posepack::stress
