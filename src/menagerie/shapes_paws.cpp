// SPDX-License-Identifier: MIT
// Four legs with paws, as tables of measures: most start from the wolf's.
#include "menagerie/shape_kit.hpp"
#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

QuadrupedShape wolf_shape() {
    QuadrupedShape s;
    s.name = "Wolf";
    s.hip_height = 0.68;
    s.shoulder_height = 0.70;
    s.body_length = 0.68;
    s.stance_width = 0.082;
    s.chest_radius = 0.135;
    s.chest_depth = 0.235;
    s.belly_radius = 0.125;
    s.belly_depth = 0.185;
    s.rump_radius = 0.115;
    s.neck_length = 0.23;
    s.neck_rise_degrees = 36.0;
    s.neck_radius = 0.102;
    s.neck_base_depth = 0.165;
    s.head_length = 0.29;
    s.head_drop_degrees = 12.0;
    s.head_radius = 0.098;
    s.head_depth = 0.088;
    s.muzzle_radius = 0.041;
    s.muzzle_depth = 0.041;
    s.leg_radius = 0.025;
    s.thigh_radius = 0.082;
    s.ear_length = 0.135;
    s.ear_width = 0.05;
    s.ear_rise_degrees = 72.0;
    s.tail_length = 0.46;
    s.tail_radius = 0.038;
    s.tail_rise_degrees = -58.0;
    s.tail_bush = 0.9;
    s.tail_joints = 5;
    s.foot = Foot::paw;
    s.coat = 0x7E7F80;
    s.back = 0x3E4043;
    s.belly = 0xD8D4CA;
    s.neck = 0x8C8B88;
    s.face = 0x9C9A94;
    s.muzzle = 0xE2DED4;
    s.nose = 0x1E1C1C;
    s.leg = 0xA39C90;
    s.sock = 0xCFC7B8;
    s.hoof = 0xB0A595;
    s.ear = 0x5A5856;
    s.ear_inside = 0xB49A8C;
    s.tail = 0x5C5C5E;
    s.iris = 0xE0C050;
    return s;
}

}  // namespace

Model wolf(const Variation& variation) {
    return built(wolf_shape(), variation, {"AnimalArmature", 100.0, true, false}, 24);
}

Model fox(const Variation& variation) {
    QuadrupedShape s = scaled(wolf_shape(), 0.56);
    s.name = "Fox";
    s.hip_height *= 0.90;
    s.shoulder_height *= 0.90;
    s.neck_radius *= 0.85;
    s.muzzle_radius *= 0.72;
    s.muzzle_depth *= 0.80;
    s.ear_length *= 1.35;
    s.ear_width *= 1.25;
    s.tail_length *= 1.35;
    s.tail_radius *= 1.30;
    s.tail_bush = 1.5;
    s.tail_rise_degrees = -30.0;
    paint(s, 0xC8672C, 0xA9501F, 0xEFE6DA);
    s.leg = 0x5A3524;
    s.sock = 0x2A2120;
    s.hoof = 0x2A2120;
    s.ear = 0x33251F;
    s.ear_inside = 0xE8D6C4;
    return built(s, variation, {"AnimalArmature"}, 24);
}

Model cat(const Variation& variation) {
    QuadrupedShape s = scaled(wolf_shape(), 0.38);
    s.name = "Cat";
    s.hip_height *= 0.92;
    s.shoulder_height *= 0.88;
    s.neck_length *= 0.75;
    s.neck_radius *= 0.82;
    s.chest_depth *= 0.85;
    s.belly_depth *= 1.08;
    s.head_length *= 0.72;
    s.head_radius *= 1.05;
    s.head_depth *= 1.10;
    s.muzzle_radius *= 1.10;
    s.muzzle_depth *= 0.95;
    s.ear_width *= 1.15;
    s.tail_length *= 1.45;
    s.tail_radius *= 0.62;
    s.tail_bush = 0.1;
    s.tail_rise_degrees = 28.0;
    s.tail_joints = 6;
    paint(s, 0xA8865E, 0x6B5238, 0xEADFCB);
    s.tail = 0x7A5F42;
    s.sock = 0xF2ECE0;
    s.hoof = 0xF2ECE0;
    s.nose = 0xC77F76;
    s.iris = 0x9CC25A;
    return built(s, variation, {"Armature", 1.0, false, false, false, Naming::lower_case}, 30);
}

Model lion(const Variation& variation) {
    QuadrupedShape s = scaled(wolf_shape(), 1.45);
    s.name = "Lion";
    s.hip_height *= 0.88;
    s.shoulder_height *= 0.90;
    s.body_length *= 1.05;
    s.chest_radius *= 1.10;
    s.head_length *= 0.95;
    s.head_radius *= 1.08;
    s.head_depth *= 1.15;
    s.muzzle_radius *= 1.45;
    s.muzzle_depth *= 1.35;
    s.leg_radius *= 1.30;
    s.thigh_radius *= 1.12;
    s.ear_length *= 0.62;
    s.ear_width *= 0.95;
    s.ear_rise_degrees = 48.0;
    s.tail_length *= 1.30;
    s.tail_radius *= 0.55;
    s.tail_bush = 0.0;
    s.tail_rise_degrees = -35.0;
    s.foot_height = 1.35;
    s.mane = Mane::ruff;
    s.mane_length = 0.135;
    paint(s, 0xC79A5B, 0xA97E45, 0xE8D5AE);
    s.mane_colour = 0x6B3F1E;
    s.tail = 0x9A6E3C;
    s.hoof = 0xB98E55;
    return built(s, variation, {"LionArmature", 1.0, false, false, true, Naming::with_animal}, 30);
}

Model bear(const Variation& variation) {
    QuadrupedShape s = scaled(wolf_shape(), 1.45);
    s.name = "Bear";
    s.hip_height *= 0.86;
    s.shoulder_height *= 0.90;
    s.stance_width *= 1.65;
    s.chest_radius *= 1.62;
    s.chest_depth *= 1.22;
    s.belly_radius *= 1.90;
    s.belly_depth *= 1.45;
    s.rump_radius *= 1.75;
    s.neck_length *= 0.80;
    s.neck_rise_degrees = 20.0;
    s.neck_radius *= 1.18;
    s.neck_base_depth *= 1.35;
    s.head_length *= 1.05;
    s.head_radius *= 1.12;
    s.head_depth *= 1.12;
    s.muzzle_radius *= 1.25;
    s.muzzle_depth *= 1.15;
    s.leg_radius *= 2.1;
    s.thigh_radius *= 1.70;
    s.ear_length *= 0.52;
    s.ear_width *= 0.95;
    s.ear_rise_degrees = 55.0;
    s.tail_length *= 0.22;
    s.tail_joints = 3;
    s.stride = 0.85;
    s.bounce = 0.7;
    s.foot_height = 1.9;
    paint(s, 0x5C3D28, 0x4A3020, 0x65452F);
    s.muzzle = 0xA98A66;
    s.hoof = 0x2A1F18;
    return built(s, variation, {"Armature"}, 30);
}

Model mouse(const Variation& variation) {
    QuadrupedShape s = scaled(wolf_shape(), 0.078);
    s.name = "Mouse";
    s.hip_height *= 0.62;
    s.shoulder_height *= 0.52;
    s.body_length *= 0.85;
    s.stance_width *= 1.25;
    s.chest_radius *= 1.05;
    s.chest_depth *= 0.95;
    s.belly_radius *= 1.45;
    s.belly_depth *= 1.15;
    s.rump_radius *= 1.40;
    s.neck_length *= 0.42;
    s.neck_rise_degrees = 12.0;
    s.head_length *= 0.95;
    s.head_radius *= 0.95;
    s.muzzle_radius *= 0.75;
    s.muzzle_depth *= 0.75;
    s.leg_radius *= 0.85;
    s.thigh_radius *= 0.85;
    s.ear_length *= 1.25;
    s.ear_width *= 1.70;
    s.ear_rise_degrees = 52.0;
    s.tail_length *= 1.70;
    s.tail_radius *= 0.36;
    s.tail_bush = 0.0;
    s.tail_taper = 0.55;
    s.tail_rise_degrees = -6.0;
    s.tail_joints = 6;
    s.stride = 0.75;
    s.bounce = 0.5;
    s.foot_height = 1.3;
    paint(s, 0x8A7A6C, 0x6A5B50, 0xC9BEB2);
    s.leg = s.sock = s.hoof = 0xD9A79A;
    s.tail = 0xCB9C90;
    s.ear = 0xB08A7E;
    s.ear_inside = 0xE2B4A6;
    s.nose = 0xD98C86;
    s.iris = 0x1A1412;
    return built(s, variation, {"RatArmature", 1.0, false, false, true, Naming::with_animal}, 30);
}

Model rabbit(const Variation& variation) {
    QuadrupedShape s = scaled(wolf_shape(), 0.27);
    s.name = "Rabbit";
    s.hip_height *= 0.92;
    s.shoulder_height *= 0.70;
    s.body_length *= 0.72;
    s.stance_width *= 1.1;
    s.belly_radius *= 1.35;
    s.belly_depth *= 1.05;
    s.chest_depth *= 0.85;
    s.rump_radius *= 1.45;
    s.neck_length *= 0.62;
    s.head_length *= 0.82;
    s.head_radius *= 0.95;
    s.head_depth *= 1.05;
    s.muzzle_radius *= 1.10;
    s.muzzle_depth *= 1.10;
    s.thigh_radius *= 1.35;
    s.ear_length *= 2.3;
    s.ear_width *= 0.95;
    s.ear_rise_degrees = 78.0;
    s.tail_length *= 0.22;
    s.tail_radius *= 1.25;
    s.tail_rise_degrees = 35.0;
    s.tail_joints = 3;
    s.stride = 0.75;
    s.leaps = true;
    paint(s, 0x9C8468, 0x7C664E, 0xE6DCCB);
    s.tail = 0xF4F0E8;
    s.ear_inside = 0xDDAF9E;
    s.iris = 0x3A2418;
    return built(s, variation, {"Armature", 1.0, false, false, false}, 24);
}

Model crocodile(const Variation& variation) {
    QuadrupedShape s = scaled(wolf_shape(), 1.0);
    s.name = "Crocodile";
    s.hip_height = 0.36;
    s.shoulder_height = 0.34;
    s.body_length = 1.15;
    s.stance_width = 0.25;
    s.chest_radius = 0.22;
    s.chest_depth = 0.15;
    s.belly_radius = 0.26;
    s.belly_depth = 0.17;
    s.rump_radius = 0.20;
    s.neck_length = 0.26;
    s.neck_rise_degrees = 4.0;
    s.neck_radius = 0.125;
    s.neck_base_depth = 0.12;
    s.head_length = 0.66;
    s.head_drop_degrees = 3.0;
    s.head_radius = 0.135;
    s.head_depth = 0.075;
    s.muzzle_radius = 0.075;
    s.muzzle_depth = 0.05;
    s.leg_radius = 0.042;
    s.thigh_radius = 0.085;
    s.ear_length = 0.03;
    s.ear_width = 0.02;
    s.ear_rise_degrees = 60.0;
    s.tail_length = 1.55;
    s.tail_radius = 0.165;
    s.tail_bush = 0.0;
    s.tail_taper = 0.75;
    s.tail_rise_degrees = -7.0;
    s.tail_joints = 7;
    s.stride = 0.72;
    s.bounce = 0.2;
    s.foot_height = 2.6;
    paint(s, 0x5E6B3E, 0x3C4728, 0xB9B48A);
    s.muzzle = 0x6C774A;
    s.nose = 0x2E3620;
    s.hoof = 0x3A4028;
    s.ear_inside = 0x4A5434;
    s.iris = 0xD8B23A;
    return built(s, variation, {"CrocArmature", 1.0, true, false, true, Naming::titled}, 24);
}

}  // namespace posepack::menagerie
