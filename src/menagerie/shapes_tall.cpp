// SPDX-License-Identifier: MIT
// Horse, donkey, giraffe and elephant, as tables of measures that start from the goat's.
#include "menagerie/menagerie.hpp"
#include "menagerie/shape_kit.hpp"
#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

QuadrupedShape equine(const char* name, double size) {
    QuadrupedShape s = hoofed(name, size);
    s.hip_height *= 1.02;
    s.body_length *= 1.06;
    s.chest_depth *= 0.98;
    s.belly_radius *= 0.92;
    s.belly_depth *= 0.92;
    s.rump_radius *= 1.15;
    s.neck_length *= 1.12;
    s.neck_rise_degrees = 46.0;
    s.neck_radius *= 1.10;
    s.neck_base_depth *= 1.20;
    s.head_length *= 1.10;
    s.head_drop_degrees = 36.0;
    s.muzzle_radius *= 1.15;
    s.muzzle_depth *= 1.15;
    s.thigh_radius *= 1.15;
    s.ear_rise_degrees = 74.0;
    s.mane = Mane::crest;
    s.stride = 1.0;
    return s;
}

QuadrupedShape equine_of_toys() {
    QuadrupedShape s = equine("Toy", 2.1);
    s.tail_length = 0.8;
    s.tail_radius = 0.06;
    s.tail_rise_degrees = -60.0;
    s.mane_length = 0.16;
    s.leg_radius *= 1.5;
    paint(s, 0xC8965A, 0xB98448, 0xD8AC74);
    s.hoof = s.mane_colour = s.tail = 0xB03A2E;
    return s;
}

}  // namespace

Model horse(const Variation& variation) {
    QuadrupedShape s = equine("Horse", 2.1);
    s.ear_length *= 0.62;
    s.tail_length = 0.95;
    s.tail_radius = 0.055;
    s.tail_bush = 1.1;
    s.tail_rise_degrees = -64.0;
    s.tail_joints = 5;
    s.mane_length = 0.15;
    paint(s, 0x8A4F2A, 0x6E3D20, 0x7C4726);
    s.sock = 0x2E1E16;
    s.muzzle = 0x5A3824;
    s.tail = s.mane_colour = 0x241812;
    return built(s, variation, {"AnimalArmature"}, 24);
}

Model build_toy() {
    QuadrupedShape s = scaled(equine_of_toys(), 0.16);
    Model model = built(s, {}, {"Armature", 1.0, false, false, false, Naming::lower_case}, 30);
    model.style.rigid = true;
    return model;
}

Model donkey(const Variation& variation) {
    QuadrupedShape s = equine("Donkey", 1.55);
    s.head_length *= 1.06;
    s.head_radius *= 1.05;
    s.belly_radius *= 1.12;
    s.belly_depth *= 1.05;
    s.ear_length *= 1.55;
    s.ear_width *= 1.25;
    s.ear_rise_degrees = 68.0;
    s.tail_length = 0.52;
    s.tail_radius = 0.026;
    s.tail_bush = 0.2;
    s.tail_rise_degrees = -66.0;
    s.tail_joints = 5;
    s.mane_length = 0.065;
    paint(s, 0x8C857C, 0x6A635B, 0xDAD3C6);
    s.mane_colour = 0x2E2A26;
    s.ear_inside = 0xD8C9BA;
    return built(s, variation, {"AnimalArmature", 1.0, false, false, false}, 24);
}

Model giraffe(const Variation& variation) {
    QuadrupedShape s = hoofed("Giraffe", 2.6);
    s.hip_height *= 1.05;
    s.shoulder_height *= 1.20;
    s.body_length *= 0.90;
    s.chest_radius *= 0.90;
    s.belly_radius *= 0.80;
    s.belly_depth *= 0.85;
    s.neck_length = 1.95;
    s.neck_rise_degrees = 62.0;
    s.neck_radius *= 0.80;
    s.neck_base_depth *= 1.15;
    s.head_length *= 0.82;
    s.head_radius *= 0.78;
    s.head_depth *= 0.80;
    s.muzzle_radius *= 0.95;
    s.leg_radius *= 0.95;
    s.ear_length *= 0.62;
    s.ear_width *= 0.80;
    s.ear_rise_degrees = 22.0;
    s.tail_length *= 2.6;
    s.tail_radius *= 0.50;
    s.tail_rise_degrees = -70.0;
    s.tail_joints = 5;
    s.horns = Horns::knobs;
    s.horn_length = 0.16;
    s.mane = Mane::crest;
    s.mane_length = 0.085;
    s.stride = 0.85;
    paint(s, 0xD29A4E, 0x9A5E28, 0xEBDDBE);
    s.mane_colour = 0x7A4420;
    s.sock = 0xEADBB8;
    s.horn = 0xB9803E;
    s.horn_tip = 0x33241A;
    return built(s, variation, {"Armature"}, 30);
}

Model elephant(const Variation& variation) {
    QuadrupedShape s = hoofed("Elephant", 4.0);
    s.hip_height = 2.35;
    s.shoulder_height = 2.55;
    s.body_length = 1.95;
    s.stance_width = 0.42;
    s.chest_radius = 0.72;
    s.chest_depth = 1.00;
    s.belly_radius = 0.85;
    s.belly_depth = 1.05;
    s.rump_radius = 0.66;
    s.neck_length = 0.50;
    s.neck_rise_degrees = 28.0;
    s.neck_radius = 0.46;
    s.neck_base_depth = 0.68;
    s.head_length = 0.85;
    s.head_drop_degrees = 38.0;
    s.head_radius = 0.40;
    s.head_depth = 0.46;
    s.muzzle_radius = 0.19;
    s.muzzle_depth = 0.17;
    s.leg_radius = 0.20;
    s.thigh_radius = 0.42;
    s.ear_length = 1.15;
    s.ear_width = 0.60;
    s.ear_thickness = 0.22;
    s.ear_rise_degrees = -24.0;
    s.tail_length = 1.10;
    s.tail_radius = 0.06;
    s.tail_bush = 0.0;
    s.tail_rise_degrees = -74.0;
    s.tail_joints = 4;
    s.trunk_length = 1.75;
    s.tusk_length = 0.72;
    s.stride = 0.62;
    s.bounce = 0.6;
    s.foot_height = 1.7;
    s.butts = true;
    paint(s, 0x85817C, 0x716D69, 0x8E8983);
    s.nose = 0x7A7570;
    s.hoof = 0xBDB4A4;
    s.ear_inside = 0x9C8A84;
    s.iris = 0x6A4A22;
    return built(s, variation, {"Armature", 1.0, false, false, true, Naming::titled}, 30);
}

}  // namespace posepack::menagerie
