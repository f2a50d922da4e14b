// SPDX-License-Identifier: MIT
// Fish, the snake, and what walks on six legs or more, as tables of measures.
#include <algorithm>

#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

Model grounded(Model model) {
    keep_above_ground(model);
    return model;
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

}  // namespace

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
