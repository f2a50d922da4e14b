// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "menagerie/crawler.hpp"
#include "menagerie/skin_builder.hpp"

namespace posepack::menagerie {
namespace {

using Builder = SkinBuilder<Crawler>;

void add_thorax(Builder& out) {
    const CrawlerShape& s = out.shape();
    const CrawlerJoints& j = out.joints();
    const Vec3 middle = out.head_of(j.body);
    const double l = s.thorax_length;
    const double w = s.thorax_radius;
    const double d = s.thorax_depth;
    const Paint coat{s.back, s.side, s.belly};
    const auto at = [&](double along) { return middle + kAxisZ * (along * l); };
    Loft loft;
    loft.segments = 20;
    loft.start_cap = d * 0.15;
    loft.end_cap = d * 0.15;
    loft.sections = {{at(-0.50), w * 0.42, d * 0.50, d * 0.45, j.abdomen[0], coat, 2},
                     {at(-0.34), w * 0.80, d * 0.88, d * 0.80, j.body, coat, 2},
                     {at(-0.02), w, d, d, j.body, coat, 3},
                     {at(0.30), w * 0.82, d * 0.84, d * 0.80, j.body, coat, 2},
                     {at(0.48), w * 0.46, d * 0.55, d * 0.48, j.head, coat, 0}};
    const Mark from = mark(out.mesh);
    add_loft(out.mesh, loft);
    for (const int coxa : j.coxa) {
        for (const int joint : {coxa, coxa + 1})
            attract(out.mesh, from, joint, out.head_of(joint), w * 0.62, 0.5);
    }
}

// Rings of two hues in turn, from tip to waist.
void add_abdomen(Builder& out) {
    const CrawlerShape& s = out.shape();
    const CrawlerJoints& j = out.joints();
    const Vec3 waist = out.head_of(j.abdomen[0]);
    const Vec3 way = (out.head_of(j.abdomen[1]) - waist) * 2.0;
    const double w = s.abdomen_radius;
    const double d = s.abdomen_depth;
    Loft loft;
    loft.segments = 20;
    loft.start_cap = d * 0.10;
    loft.end_cap = d * 0.05;
    constexpr int kRings = 9;
    for (int index = kRings; index >= 0; --index) {
        const double along = static_cast<double>(index) / kRings;
        // Roundest a little behind the middle, small at the waist.
        const double size = 0.16 + 0.84 * sine_of_turns(0.5 * (0.06 + 0.88 * along * (0.7 + 0.3 * along)));
        const Colour hue = index % 2 == 0 ? s.abdomen : s.band;
        const int joint = index == 0 ? j.body : along < 0.5 ? j.abdomen[0] : j.abdomen[1];
        loft.sections.push_back({waist + way * along,
                                 w * size,
                                 d * size,
                                 d * size,
                                 joint,
                                 {hue, hue, s.belly},
                                 index == 0 ? 0 : 2});
    }
    add_loft(out.mesh, loft);
}

void add_head(Builder& out) {
    const CrawlerShape& s = out.shape();
    const CrawlerJoints& j = out.joints();
    const Vec3 neck = out.head_of(j.head);
    const double l = s.head_length;
    const double w = s.head_radius;
    const double d = s.head_depth;
    const Paint skin = plain(s.head);
    const auto at = [&](double along) { return neck + kAxisZ * (along * l); };
    Loft loft;
    loft.segments = 16;
    loft.start_cap = 0.0;
    loft.end_cap = l * 0.06;
    loft.sections = {{at(-0.08), w * 0.55, d * 0.60, d * 0.60, j.body, skin, 2},
                     {at(0.25), w * 0.95, d * 0.95, d * 0.95, j.head, skin, 2},
                     {at(0.60), w, d, d, j.head, skin, 2},
                     {at(0.98), w * 0.55, d * 0.55, d * 0.60, j.head, skin, 0}};
    add_loft(out.mesh, loft);
}

// A tapering rod with a joint for each stretch.
void add_rod(Builder& out, const std::vector<Vec3>& places, const std::vector<int>& joints, double radius,
             double tip_part, Colour hue, Colour tip) {
    Loft loft;
    const Vec3 way = places.back() - places.front();
    loft.side = glm::normalize(glm::cross(kAxisY, way));
    loft.segments = 8;
    loft.start_cap = 0.0;
    loft.end_cap = radius * tip_part;
    for (std::size_t index = 0; index < places.size(); ++index) {
        const double share = static_cast<double>(index) / static_cast<double>(places.size() - 1);
        const double r = radius * (1.0 + (tip_part - 1.0) * share);
        loft.sections.push_back({places[index], r, r, r, joints[index],
                                 plain(index + 1 < places.size() ? hue : tip),
                                 index + 1 < places.size() ? 2 : 0});
    }
    add_loft(out.mesh, loft);
}

void add_leg(Builder& out, int pair) {
    const CrawlerShape& s = out.shape();
    const CrawlerJoints& j = out.joints();
    const Leg& leg = j.legs[static_cast<std::size_t>(pair)];
    const int coxa = j.coxa[static_cast<std::size_t>(pair)];
    const Vec3 root = out.head_of(coxa);
    const Vec3 hip = out.head_of(leg.upper);
    const Vec3 knee = out.head_of(leg.lower);
    const Vec3 hock = out.head_of(leg.cannon);
    const Vec3 foot = out.head_of(leg.foot);
    const Vec3 reach = (foot - hock) * (1.0 / 3.0);
    const Vec3 tip(foot.x + reach.x, s.leg_radius * 0.2, foot.z + reach.z);
    const double r = s.leg_radius;
    const Paint hue = plain(s.leg);
    const Paint end = plain(s.leg_tip);
    Loft loft;
    loft.side = glm::normalize(glm::cross(kAxisY, hip - root + kAxisX * 1e-6));
    loft.segments = 8;
    loft.start_cap = 0.0;
    loft.end_cap = r * 0.2;
    loft.sections = {{root, r * 1.3, r * 1.3, r * 1.3, coxa, hue, 1},
                     {mixed(root, hip, 0.75), r * 1.3, r * 1.3, r * 1.3, coxa, hue, 1},
                     {mixed(hip, knee, 0.25), r * 1.2, r * 1.35, r * 1.35, leg.upper, hue, 2},
                     {mixed(hip, knee, 0.85), r * 1.0, r * 1.0, r * 1.0, leg.upper, hue, 1},
                     {mixed(knee, hock, 0.15), r * 1.0, r * 1.0, r * 1.0, leg.lower, hue, 2},
                     {mixed(knee, hock, 0.85), r * 0.75, r * 0.75, r * 0.75, leg.lower, end, 1},
                     {mixed(hock, foot, 0.20), r * 0.7, r * 0.7, r * 0.7, leg.cannon, end, 2},
                     {mixed(hock, foot, 0.85), r * 0.55, r * 0.55, r * 0.55, leg.cannon, end, 1},
                     {mixed(foot, tip, 0.25), r * 0.5, r * 0.5, r * 0.5, leg.foot, end, 1},
                     {tip, r * 0.2, r * 0.2, r * 0.2, leg.foot, end, 0}};
    add_loft(out.mesh, loft);
}

void add_claw(Builder& out) {
    const CrawlerShape& s = out.shape();
    const std::vector<int>& claw = out.joints().claw;
    if (claw.empty()) return;
    const Vec3 a = out.head_of(claw[0]);
    const Vec3 c = out.head_of(claw[1]);
    const Vec3 d = out.head_of(claw[2]);
    const Vec3 b = a + Vec3(0.34, 0.06, 0.18) * s.claw_length;  // the elbow stands out
    const double r = s.claw_length * 0.085;
    add_rod(out, {a, mixed(a, b, 0.6), b, mixed(b, c, 0.5), c}, {claw[0], claw[0], claw[0], claw[0], claw[1]},
            r, 0.9, s.claw, s.claw);
    const Vec3 way = (d - c) * 2.0;
    const Paint hue{s.claw, s.claw, s.belly};
    Loft hand;
    hand.segments = 12;
    hand.start_cap = 0.0;
    hand.end_cap = 0.0;
    hand.sections = {
        {c - way * 0.05, r * 0.8, r * 0.8, r * 0.8, claw[1], hue, 2},
        {c + way * 0.25, r * 2.0, r * 1.3, r * 1.3, claw[1], hue, 2},
        {c + way * 0.55, r * 1.9, r * 1.3, r * 1.3, claw[1], hue, 2},
        {c + way * 0.95 + kAxisX * (r * 1.2), r * 0.7, r * 0.6, r * 0.6, claw[1], hue, 1},
        {c + way * 1.35 + kAxisX * (r * 0.5), r * 0.12, r * 0.12, r * 0.12, claw[1], plain(s.leg_tip), 0}};
    add_loft(out.mesh, hand);
    const Vec3 finger = d - kAxisX * (r * 0.9);
    add_rod(out, {finger, finger + way * 0.3 - kAxisX * (r * 0.4), finger + way * 0.75 + kAxisX * (r * 0.5)},
            {claw[2], claw[2], claw[2]}, r * 0.75, 0.15, s.claw, s.leg_tip);
}

void add_wing(Builder& out, int joint, double length, double breadth, double sweep) {
    const CrawlerShape& s = out.shape();
    const Vec3 root = out.head_of(joint);
    const double t = breadth * 0.02;
    const Vec3 way(length, 0.0, -sweep * length);
    const Paint skin = plain(s.wing);
    Loft loft;
    loft.side = glm::normalize(glm::cross(way, kAxisY));
    loft.segments = 10;
    loft.start_cap = 0.0;
    loft.end_cap = t;
    loft.sections = {
        {root - way * 0.03, breadth * 0.10, t * 2.0, t * 2.0, out.joints().body, plain(s.back), 2},
        {root + way * 0.30 - kAxisZ * (breadth * 0.16), breadth * 0.36, t, t, joint, skin, 2},
        {root + way * 0.70 - kAxisZ * (breadth * 0.20), breadth * 0.46, t, t, joint, skin, 2},
        {root + way * 1.0 - kAxisZ * (breadth * 0.14), breadth * 0.16, t * 0.6, t * 0.6, joint, skin, 0}};
    add_loft(out.mesh, loft);
}

void add_face_side(Builder& out) {
    const CrawlerShape& s = out.shape();
    const CrawlerJoints& j = out.joints();
    Ellipsoid eye;
    eye.centre = out.head_of(j.eye);
    eye.radii = Vec3(s.eye_radius);
    eye.turn = yaw(40.0);
    eye.colour = s.eye;
    eye.tip_colour = s.eye;
    eye.joint = j.eye;
    add_ellipsoid(out.mesh, eye);
    if (s.eye_stalk > 0.0) {
        const Vec3 top = out.head_of(j.eye);
        add_rod(out, {top - kAxisY * (s.eye_stalk * 1.4) - kAxisZ * (s.eye_stalk * 0.2), top},
                {j.head, j.eye}, s.eye_radius * 0.55, 1.0, s.leg, s.leg);
    }
    const Vec3 jaw = out.head_of(j.jaw);
    const double l = s.jaw_length;
    add_rod(out,
            {jaw - kAxisZ * (l * 0.2), jaw + Vec3(l * 0.12, -l * 0.1, l * 0.5),
             jaw + Vec3(-l * 0.10, -l * 0.25, l)},
            {j.head, j.jaw, j.jaw}, l * 0.20, 0.2, s.jaw, s.jaw);
    if (j.antenna.empty()) return;
    const Vec3 root = out.head_of(j.antenna[0]);
    const Vec3 bend = out.head_of(j.antenna[1]);
    const Vec3 tip = bend + (bend - root) * 0.8 + kAxisZ * (s.antenna_length * 0.16);
    add_rod(out, {root, mixed(root, bend, 0.8), mixed(bend, tip, 0.3), tip},
            {j.antenna[0], j.antenna[0], j.antenna[1], j.antenna[1]}, s.leg_radius * 0.55, 0.5, s.jaw, s.jaw);
}

}  // namespace

Mesh crawler_mesh(const Crawler& animal) {
    Builder out{animal, {}};
    const CrawlerShape& s = animal.shape;
    add_thorax(out);
    add_abdomen(out);
    add_head(out);
    const Mark sides = mark(out.mesh);
    add_face_side(out);
    for (int pair = 0; pair < s.leg_pairs; ++pair) add_leg(out, pair);
    add_claw(out);
    if (s.wing_length > 0.0) {
        add_wing(out, animal.joints.fore_wing, s.wing_length, s.wing_breadth, 0.12);
        add_wing(out, animal.joints.hind_wing, s.wing_length * 0.72, s.wing_breadth * 0.8, 0.35);
    }
    add_mirror_image(out.mesh, animal.rig, sides);
    finish(out.mesh);
    return std::move(out.mesh);
}

}  // namespace posepack::menagerie
