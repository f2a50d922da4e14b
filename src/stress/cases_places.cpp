// SPDX-License-Identifier: MIT
// Places and sizes: what halves, floats and GPUs that drop subnormals make of far, huge and tiny animals.
#include <array>

#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

constexpr double kSwayDegrees = 20.0;

RawModel swaying_reed(const Reed& shape) {
    const RawModel model = reed(shape);
    return with_clip(model, swaying(model, grid(31, 30.0), kSwayDegrees, 1.0));
}

// A reed that node 0 carries away; the carrier itself stands still.
RawModel swaying_reed_at(const Vec3& place, double scale, const Reed& shape = {}) {
    RawModel model = carried_reed(shape);
    const std::vector<RawChannel> sway = swaying(model, grid(31, 30.0), kSwayDegrees, 1.0);
    model.nodes[0].translation = place;
    model.nodes[0].scale = Vec3(scale);
    return with_clip(model, {sway.begin() + 1, sway.end()});
}

RawModel one_metre() {
    return swaying_reed({});
}

RawModel bone_10_km_away() {
    return swaying_reed_at({10'000.0, 0.0, 0.0}, 1.0);
}

RawModel mesh_10_km_away() {
    return swaying_reed({.foot = {10'000.0, 0.0, 0.0}});
}

RawModel travel_10_km() {
    RawModel model = carried_reed();
    std::vector<RawChannel> channels = swaying(model, grid(61, 30.0), kSwayDegrees, 1.0);
    channels[0] =
        moving(0, grid(2, 0.5), [](double time_s) { return Vec3(5'000.0 * time_s, 0.0, 0.0); });
    return with_clip(model, channels);
}

RawModel travel_30_m() {
    RawModel model = carried_reed();
    std::vector<RawChannel> channels = swaying(model, grid(61, 30.0), kSwayDegrees, 1.0);
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

// The first joint stands 70 km beside the body that it turns, so that matrices hold 70,000 at a turn of 60
// degrees: more than a half can.
RawModel far_pivot() {
    constexpr double kAwayM = 70'000.0;
    RawModel model = carried_reed({.length = 2.0});
    model.nodes[0].translation = Vec3(kAwayM, 0.0, 0.0);
    model.nodes[1].translation = Vec3(-kAwayM, 0.0, 0.0);
    bind_at_rest(model);
    return with_clip(model, {turning(0, grid(31, 30.0), [](double time_s) {
                         return turn_about(kAxisY, 60.0 * time_s);
                     })});
}

// As exporters of centimetres and Z up write it.
RawModel armature_of_100() {
    RawModel model = swaying_reed_at(Vec3(0.0), 100.0, {.length = 0.01, .thickness = 0.001});
    model.nodes[0].rotation = turn_about(kAxisX, -90.0);
    return model;
}

RawModel no_size() {
    return swaying_reed({.length = 0.0, .thickness = 0.0});
}

constexpr std::array kCases = {
    StressCase{"one_metre", "nothing: what the others are compared with", one_metre, {}, kUsual, {kMeets}},
    StressCase{"bone_10_km_away", "a bone carries the mesh 10 km away: halves step by 8 m there",
               bone_10_km_away, {}, kUsual, {kMeets}},
    StressCase{"mesh_10_km_away", "the vertices themselves lie at 10 km: floats step by 1 mm there",
               mesh_10_km_away, {}, kUsual, {kMeets}},
    StressCase{"travel_30_m", "the root walks 30 m in the clip, 60 R", travel_30_m, {}, kUsual, {kMeets}},
    StressCase{"travel_10_km", "the root flies 10 km in the clip, 20,000 R", travel_10_km, {}, kUsual,
               {kSwitchesForm}},
    StressCase{"far_pivot", "a turn about a point 70 km away: matrices beyond the largest half", far_pivot,
               {}, kUsual, {kSwitchesForm}},
    StressCase{"insect_1_mm", "halves of millimetres are subnormal, which some GPUs read as zero",
               insect_1_mm, {}, kUsual, {kMeets}},
    StressCase{"mite_10_um", "every half of ten micrometres is subnormal", mite_10_um, {}, kUsual, {kMeets}},
    StressCase{"speck_1e_20", "squares of its errors are below the smallest float", speck_1e_20, {}, kUsual,
               {kMeets}},
    StressCase{"whale_70_m", "a half steps by 16 mm beyond 32 m", whale_70_m, {}, kUsual, {kMeets}},
    StressCase{"giant_1000_km", "no half reaches 65,505", giant_1000_km, {}, kUsual, {kMeets}},
    StressCase{"armature_of_100", "centimetres and Z up under an armature 100 times too large",
               armature_of_100, {}, kUsual, {kMeets}},
    StressCase{"no_size", "all vertices in one point: no R to be a fraction of", no_size, {}, kUsual,
               {refuses(IssueCode::glb_no_extent), "a rest pose with a size"}},
};

}  // namespace

CaseGroup place_cases() {
    return {"Places and sizes",
            "In the normalised space neither a far origin nor any size of the animal costs anything; only a clip "
            "that itself travels thousands of R needs floats.",
            kCases, true};
}

}  // namespace posepack::stress
