// SPDX-License-Identifier: MIT
// Birds, fish, the snake, and what walks on six legs or more, as tables of measures.
#include <algorithm>

#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

Model grounded(Model model) {
    keep_above_ground(model);
    return model;
}

Model built(const BirdShape& shape, const Variation& variation, const ExportStyle& style, int rate_hz) {
    return grounded(bird_model(settled(varied(shape, variation)), style, rate_hz));
}

Model built(const CrawlerShape& shape, const Variation& variation, const ExportStyle& style, int rate_hz) {
    return grounded(crawler_model(varied(shape, variation), style, rate_hz));
}

// Raised or lowered until its lowest fin meets y = 0.
FishShape settled(FishShape shape) {
    double lowest = 1e9;
    for (const Vertex& vertex : fish_mesh(fish_of(shape)).vertices)
        lowest = std::min(lowest, vertex.position.y);
    shape.swim_height -= lowest;
    return shape;
}

BirdShape bird(const char* name, double size) {
    BirdShape s = scaled(BirdShape{}, size);
    s.name = name;
    return s;
}

}  // namespace

Model sparrow(const Variation& variation) {
    return built(bird("Sparrow", 1.0), variation, {}, 24);
}

Model crow(const Variation& variation) {
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
    return built(s, variation, {"BirdArmature", 1.0, false, false, true, Naming::with_animal}, 30);
}

Model duck(const Variation& variation) {
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
    return built(s, variation, {"Armature", 1.0, false, false, true, Naming::lower_case}, 30);
}

Model eagle(const Variation& variation) {
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
    Model model = built(s, variation, {"EagleArmature", 1.0, false, false, true, Naming::titled}, 24);
    set_interpolation(model, "Glide", Interpolation::cubic);
    return model;
}

Model owl(const Variation& variation) {
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
    return built(s, variation, {"Armature", 1.0, true, false, true, Naming::numbered}, 24);
}

Model trout(const Variation& variation) {
    FishShape s;
    s.name = "Trout";
    if (!variation.is_published()) s = settled(varied(s, variation));
    ExportStyle style{"Fish_Armature", 1.0, false, false};
    style.shared_samplers = false;
    return grounded(fish_model(s, style, 30));
}

Model shark(const Variation& variation) {
    FishShape s = scaled(FishShape{}, 6.4);
    s.name = "Shark";
    s.body_radius *= 1.15;
    s.body_depth *= 0.88;
    s.tail_depth *= 0.78;
    s.tail_fin_length *= 1.25;
    s.tail_fin_spread *= 1.35;
    s.dorsal_height *= 1.45;
    s.dorsal_length *= 0.85;
    s.pectoral_length *= 1.55;
    s.pelvic_length *= 0.80;
    s.back = 0x55616B;
    s.side = 0x74818B;
    s.band = 0x7D8A94;
    s.belly = 0xE8EBEA;
    s.spot = 0x58646E;
    s.fin = 0x5B6770;
    s.fin_tip = 0x3E484F;
    s.iris = 0x1A1C1E;
    ExportStyle style{"Fish_Armature", 1.0, true, false};
    style.shared_samplers = false;
    return grounded(fish_model(settled(varied(s, variation)), style, 30));
}

Model viper(const Variation& variation) {
    SnakeShape s;
    s.name = "Viper";
    ExportStyle style{"SnakeArmature", 100.0, true, true};
    style.shared_samplers = false;
    return grounded(snake_model(varied(s, variation), style, 24));
}

Model bee(const Variation& variation) {
    CrawlerShape s = scaled(CrawlerShape{}, 0.62);
    s.name = "Bee";
    s.leg_pairs = 3;
    s.body_height *= 0.92;
    s.thorax_length *= 0.78;
    s.thorax_radius *= 1.05;
    s.thorax_depth *= 1.35;
    s.abdomen_radius *= 0.85;
    s.abdomen_depth *= 0.85;
    s.abdomen_rise_degrees = -10.0;
    s.head_radius *= 1.25;
    s.head_depth *= 1.35;
    s.leg_span *= 0.62;
    s.leg_arch *= 0.40;
    s.leg_radius *= 0.95;
    s.jaw_length *= 0.6;
    s.antenna_length = 0.0050;
    s.wing_length = 0.0125;
    s.wing_breadth = 0.0062;
    s.eye_radius *= 1.9;
    s.flies = true;
    s.back = 0xC9912E;
    s.side = 0xB9822A;
    s.belly = 0x8A6524;
    s.abdomen = 0x241A12;
    s.band = 0xE8B22E;
    s.head = 0x2E2218;
    s.leg = 0x2A1F16;
    return built(s, variation, {"MonsterArmature"}, 30);
}

Model spider(const Variation& variation) {
    CrawlerShape s;
    s.name = "Spider";
    Model model = built(s, variation, {"SpiderArmature", 1.0, false, false, true, Naming::with_animal}, 24);
    set_interpolation(model, "Hit", Interpolation::step);
    return model;
}

Model crab(const Variation& variation) {
    CrawlerShape s = scaled(CrawlerShape{}, 5.0);
    s.name = "Crab";
    s.body_height = 0.052;
    s.thorax_length = 0.095;
    s.thorax_radius = 0.070;
    s.thorax_depth = 0.028;
    s.abdomen_length = 0.022;
    s.abdomen_radius = 0.036;
    s.abdomen_depth = 0.016;
    s.head_length = 0.016;
    s.head_radius = 0.034;
    s.head_depth = 0.014;
    s.leg_span = 0.095;
    s.leg_arch = 0.034;
    s.leg_radius = 0.0062;
    s.leg_fan_degrees = 34.0;
    s.jaw_length = 0.009;
    s.claw_length = 0.085;
    s.eye_radius = 0.0058;
    s.eye_stalk = 0.014;
    s.back = 0xC4482A;
    s.side = 0xD8653C;
    s.belly = 0xEBC9A4;
    s.abdomen = s.band = 0xD0583A;
    s.head = 0xCC5434;
    s.leg = 0xC9502F;
    s.leg_tip = 0x6A2A1C;
    s.claw = 0xD2482C;
    return built(s, variation, {"MonsterArmature", 1.0, false, false, false, Naming::titled}, 30);
}

}  // namespace posepack::menagerie
