// SPDX-License-Identifier: MIT
// The birds, as tables of measures and colours.
#include "menagerie/bird_shapes.hpp"
#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

BirdShape bird(const char* name, double size) {
    BirdShape s = scaled(BirdShape{}, size);
    s.name = name;
    return s;
}

}  // namespace

Model built_bird(const BirdShape& shape, const Variation& variation, const ExportStyle& style, int rate_hz) {
    Model model = bird_model(settled(varied(shape, variation)), style, rate_hz);
    keep_above_ground(model);
    return model;
}

BirdShape sparrow_shape() {
    return bird("Sparrow", 1.0);
}

BirdShape crow_shape() {
    BirdShape s = bird("Crow", 2.7);
    s.body_rise_degrees = 24.0;
    s.beak_length *= 1.55;
    s.beak_radius *= 1.25;
    s.wing_length *= 1.18;
    s.wing_chord *= 1.10;
    s.head_radius *= 0.92;
    s.back = s.nape = s.cap = 0x1C1D22;
    s.side = s.cheek = s.bib = 0x24252B;
    s.belly = 0x2A2B31;
    s.wing = 0x1A1B21;
    s.wing_bar = s.feather = s.tail = 0x15161B;
    s.beak = 0x17171A;
    s.leg = 0x202022;
    s.iris = 0x2A1C14;
    return s;
}

BirdShape duck_shape() {
    BirdShape s = bird("Duck", 3.1);
    s.hip_height *= 0.74;
    s.body_length *= 1.25;
    s.body_rise_degrees = 10.0;
    s.body_radius *= 1.15;
    s.body_depth *= 0.98;
    s.stance_width *= 1.25;
    s.neck_length *= 1.35;
    s.neck_rise_degrees = 66.0;
    s.neck_radius *= 0.74;
    s.head_radius *= 0.92;
    s.beak_length *= 1.45;
    s.beak_radius *= 1.45;
    s.wing_length *= 0.98;
    s.tail_length *= 0.50;
    s.toe_length *= 1.15;
    s.leg_radius *= 1.35;
    s.back = 0x6E6258;
    s.side = 0xA39A8E;
    s.belly = 0xC9C2B6;
    s.cap = s.cheek = 0x1F5A3C;
    s.nape = 0x1F5A3C;
    s.bib = 0x2A6A48;
    s.beak = 0xE0A62E;
    s.wing = 0x7C7268;
    s.wing_bar = 0x3F5FA8;
    s.feather = 0x4A423A;
    s.tail = 0xE8E2D6;
    s.leg = 0xDB7A2A;
    return s;
}

BirdShape eagle_shape() {
    BirdShape s = bird("Eagle", 5.4);
    s.body_rise_degrees = 42.0;
    s.neck_rise_degrees = 62.0;
    s.beak_length *= 1.35;
    s.beak_radius *= 1.55;
    s.wing_length *= 1.55;
    s.wing_chord *= 1.30;
    s.tail_length *= 0.90;
    s.head_radius *= 0.82;
    s.leg_radius *= 1.9;
    s.toe_length *= 1.25;
    s.stance_width *= 1.15;
    s.back = 0x3E2A1C;
    s.side = 0x4A3322;
    s.belly = 0x53392A;
    s.cap = s.cheek = s.nape = s.bib = 0xF2EEE4;
    s.beak = 0xE2B12F;
    s.wing = 0x452F1F;
    s.wing_bar = 0x5C4230;
    s.feather = 0x2A1C13;
    s.tail = 0xF0EBDF;
    s.leg = 0xDCA832;
    s.iris = 0xE3C34A;
    return s;
}

BirdShape owl_shape() {
    BirdShape s = bird("Owl", 3.6);
    s.body_rise_degrees = 58.0;
    s.body_length *= 0.92;
    s.body_radius *= 1.12;
    s.body_depth *= 1.12;
    s.neck_length *= 0.62;
    s.neck_rise_degrees = 78.0;
    s.neck_radius *= 1.28;
    s.head_radius *= 1.32;
    s.beak_length *= 0.62;
    s.beak_radius *= 0.85;
    s.wing_length *= 1.15;
    s.wing_chord *= 1.15;
    s.tail_length *= 0.62;
    s.leg_radius *= 1.7;
    s.back = 0x6B5237;
    s.side = 0x9A7D58;
    s.belly = 0xDCCBAA;
    s.cap = s.nape = 0x6E5539;
    s.cheek = s.bib = 0xE6D9BF;
    s.wing = 0x70573A;
    s.wing_bar = 0xB79A70;
    s.feather = 0x4A3826;
    s.tail = 0x60492F;
    s.beak = 0x3A3026;
    s.leg = 0xCDB990;
    s.iris = 0xE59A22;
    return s;
}

Model sparrow(const Variation& variation) {
    return built_bird(sparrow_shape(), variation, {}, 24);
}

Model crow(const Variation& variation) {
    return built_bird(crow_shape(), variation, {"BirdArmature", 1.0, false, false, true, Naming::with_animal},
                      30);
}

Model duck(const Variation& variation) {
    return built_bird(duck_shape(), variation, {"Armature", 1.0, false, false, true, Naming::lower_case}, 30);
}

Model eagle(const Variation& variation) {
    Model model =
        built_bird(eagle_shape(), variation, {"EagleArmature", 1.0, false, false, true, Naming::titled}, 24);
    set_interpolation(model, "Glide", Interpolation::cubic);
    return model;
}

Model owl(const Variation& variation) {
    return built_bird(owl_shape(), variation, {"Armature", 1.0, true, false, true, Naming::numbered}, 24);
}

}  // namespace posepack::menagerie
