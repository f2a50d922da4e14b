// SPDX-License-Identifier: MIT
// Goat, cattle, deer, sheep and pig, as tables of measures: most start from the goat's.
#include "menagerie/shape_kit.hpp"
#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

QuadrupedShape goat_shape() {
    QuadrupedShape s;
    s.name = "Goat";
    s.horns = Horns::swept_back;
    s.horn_length = 0.26;
    s.beard_length = 0.12;
    return s;
}

// The measures that cow and bull have in common, all that a skeleton is made of among them.
QuadrupedShape cattle(const char* name) {
    QuadrupedShape s = hoofed(name, 2.0);
    s.body_length *= 1.22;
    s.stance_width *= 1.25;
    s.chest_radius *= 1.15;
    s.chest_depth *= 1.10;
    s.belly_radius *= 1.28;
    s.belly_depth *= 1.18;
    s.rump_radius *= 1.45;
    s.neck_length *= 0.80;
    s.neck_rise_degrees = 16.0;
    s.neck_radius *= 1.45;
    s.neck_base_depth *= 1.35;
    s.head_length *= 1.02;
    s.head_radius *= 1.20;
    s.head_depth *= 1.10;
    s.muzzle_radius *= 1.85;
    s.muzzle_depth *= 1.45;
    s.leg_radius *= 1.45;
    s.thigh_radius *= 1.35;
    s.ear_length *= 0.85;
    s.ear_width *= 1.20;
    s.ear_rise_degrees = -4.0;
    s.tail_length *= 3.6;
    s.tail_radius *= 0.55;
    s.tail_bush = 0.0;
    s.tail_rise_degrees = -72.0;
    s.tail_joints = 5;
    s.horns = Horns::bull;
    s.nose = 0xC79A90;
    return s;
}

QuadrupedShape deer_like(const char* name) {
    QuadrupedShape s = hoofed(name, 1.42);
    s.hip_height *= 1.04;
    s.shoulder_height *= 1.03;
    s.body_length *= 0.98;
    s.chest_radius *= 0.86;
    s.chest_depth *= 0.92;
    s.belly_radius *= 0.80;
    s.belly_depth *= 0.82;
    s.rump_radius *= 0.95;
    s.neck_length *= 1.10;
    s.neck_rise_degrees = 58.0;
    s.neck_radius *= 0.88;
    s.neck_base_depth *= 0.88;
    s.head_length *= 0.95;
    s.head_radius *= 0.88;
    s.head_depth *= 0.88;
    s.muzzle_radius *= 0.86;
    s.leg_radius *= 0.82;
    s.ear_length *= 1.05;
    s.ear_width *= 1.25;
    s.ear_rise_degrees = 30.0;
    s.tail_length *= 0.75;
    s.tail_rise_degrees = -30.0;
    paint(s, 0xA5713F, 0x855630, 0xEADFCF);
    s.hoof = 0x241C18;
    s.nose = 0x231C1A;
    return s;
}

}  // namespace

// The published Goat is exactly this; others of its kind settle by their own measures.
Model goat(const Variation& variation) {
    const QuadrupedShape shape = goat_shape();
    return variation.is_published() ? quadruped_model(shape, {}, 30) : built(shape, variation, {}, 30);
}

Model cow(const Variation& variation) {
    QuadrupedShape s = cattle("Cow");
    s.horn_length = 0.20;
    paint(s, 0xEFE9DF, 0x4A3428, 0xE6C9BA);
    s.neck = 0x54392A;
    s.face = 0xF2ECE2;
    s.horn = 0xD8CDB4;
    s.horn_tip = 0x8E806A;
    s.ear = 0x54392A;
    s.tail = 0xD9CFC0;
    return built(s, variation, {"AnimalArmature"}, 24);
}

Model bull(const Variation& variation) {
    QuadrupedShape s = cattle("Bull");
    s.horn_length = 0.40;
    s.chest_radius *= 1.18;
    s.chest_depth *= 1.08;
    s.neck_radius *= 1.22;
    s.neck_base_depth *= 1.22;
    s.thigh_radius *= 1.12;
    s.leg_radius *= 1.10;
    paint(s, 0x5A3220, 0x3A2016, 0x7A4A30);
    s.neck = 0x43251A;
    s.face = 0x54301F;
    s.muzzle = 0xB08A70;
    s.horn = 0xE0D4B8;
    s.horn_tip = 0x3A322A;
    s.tail = 0x3A2016;
    return built(s, variation, {"AnimalArmature"}, 24);
}

Model deer(const Variation& variation) {
    return built(deer_like("Deer"), variation, {"AnimalArmature"}, 24);
}

Model stag(const Variation& variation) {
    QuadrupedShape s = deer_like("Stag");
    s.horns = Horns::antlers;
    s.horn_length = 0.62;
    s.chest_radius *= 1.12;
    s.neck_radius *= 1.30;
    s.neck_base_depth *= 1.25;
    s.thigh_radius *= 1.08;
    s.coat = 0x8A5A34;
    s.back = 0x6A4226;
    s.neck = 0x5C3B25;
    s.horn = 0x7A6048;
    s.horn_tip = 0xD8CBB0;
    return built(s, variation, {"AnimalArmature"}, 24);
}

Model sheep(const Variation& variation) {
    QuadrupedShape s = hoofed("Sheep", 1.06);
    s.stance_width *= 1.25;
    s.chest_radius *= 1.50;
    s.chest_depth *= 1.12;
    s.belly_radius *= 1.45;
    s.belly_depth *= 1.12;
    s.rump_radius *= 1.55;
    s.neck_length *= 0.70;
    s.neck_radius *= 1.45;
    s.neck_base_depth *= 1.30;
    s.muzzle_radius *= 1.15;
    s.thigh_radius *= 1.25;
    s.ear_length *= 0.80;
    s.ear_rise_degrees = -12.0;
    s.tail_rise_degrees = -50.0;
    s.tail_radius *= 1.5;
    s.horns = Horns::curled;
    s.horn_length = 0.17;
    paint(s, 0xECE6D8, 0xF4EFE4, 0xDDD5C4);
    s.face = s.muzzle = 0x3C332E;
    s.leg = s.sock = 0x3A312C;
    s.ear = 0x453A34;
    s.horn = 0xB59A70;
    s.horn_tip = 0x7E6848;
    return built(s, variation, {"Armature", 1.0, false, false, true, Naming::numbered}, 30);
}

Model pig(const Variation& variation) {
    QuadrupedShape s = hoofed("Pig", 1.0);
    s.hip_height = 0.50;
    s.shoulder_height = 0.50;
    s.body_length = 0.72;
    s.stance_width = 0.12;
    s.chest_radius = 0.19;
    s.chest_depth = 0.24;
    s.belly_radius = 0.23;
    s.belly_depth = 0.245;
    s.rump_radius = 0.19;
    s.neck_length = 0.17;
    s.neck_rise_degrees = 8.0;
    s.neck_radius = 0.135;
    s.neck_base_depth = 0.19;
    s.head_length = 0.31;
    s.head_drop_degrees = 16.0;
    s.head_radius = 0.11;
    s.head_depth = 0.115;
    s.muzzle_radius = 0.058;
    s.muzzle_depth = 0.062;
    s.leg_radius = 0.032;
    s.thigh_radius = 0.11;
    s.ear_length = 0.13;
    s.ear_width = 0.062;
    s.ear_rise_degrees = 50.0;
    s.tail_length = 0.16;
    s.tail_radius = 0.012;
    s.tail_bush = 0.0;
    s.tail_rise_degrees = 20.0;
    s.tail_joints = 4;
    s.stride = 0.8;
    s.bounce = 0.55;
    s.foot_height = 1.25;
    s.butts = true;
    paint(s, 0xE2A69A, 0xD08F84, 0xEDBDB2);
    s.nose = 0xC4766E;
    s.hoof = 0x6A4A42;
    s.ear_inside = 0xC98880;
    s.iris = 0x3A2A22;
    return built(s, variation, {"Armature", 1.0, false, false, false, Naming::titled}, 30);
}

}  // namespace posepack::menagerie
