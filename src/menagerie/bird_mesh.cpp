// SPDX-License-Identifier: MIT
// The skin of a bird. Feathers are flat closed bodies that turn on joints of their own, so that a folded wing
// is not a crumpled sheet.
#include <glm/geometric.hpp>

#include "menagerie/bird.hpp"
#include "menagerie/skin_builder.hpp"

namespace posepack::menagerie {
namespace {

using Builder = SkinBuilder<Bird>;

void add_trunk(Builder& out) {
    const BirdShape& s = out.shape();
    const BirdJoints& j = out.joints();
    const Vec3 hip = out.head_of(j.body);
    const Vec3 chest = out.head_of(j.neck[0]);
    const Vec3 head = out.head_of(j.head);
    const Vec3 tail = out.head_of(j.tail[0]);
    const double w = s.body_radius;
    const double d = s.body_depth;
    const double n = s.neck_radius;
    const Paint coat{s.back, s.side, s.belly};
    const Paint neck{s.nape, s.cheek, s.bib};
    Loft loft;
    loft.segments = 18;
    loft.start_cap = 0.001;
    loft.end_cap = 0.0;
    loft.sections = {
        {mixed(hip, tail, 1.35), w * 0.26, d * 0.16, d * 0.18, j.tail[0], coat, 2},
        {mixed(hip, tail, 0.80), w * 0.55, d * 0.42, d * 0.48, j.tail[0], coat, 2},
        {hip, w * 0.90, d * 0.78, d * 0.88, j.body, coat, 2},
        {mixed(hip, chest, 0.35), w, d * 0.92, d * 1.0, j.spine, coat, 2},
        {mixed(hip, chest, 0.75), w * 0.95, d * 0.88, d * 0.98, j.chest, coat, 2},
        {mixed(chest, head, 0.10), w * 0.72, d * 0.70, d * 0.74, j.neck[0], {s.back, s.side, s.bib}, 2},
        {mixed(chest, head, 0.50), n * 1.02, n, n, j.neck[1], neck, 2},
        {mixed(chest, head, 0.80), n * 0.92, n * 0.90, n * 0.90, j.neck[2], neck, 2},
        {mixed(chest, head, 1.05), n * 0.75, n * 0.75, n * 0.75, j.head, neck, 0}};
    const Mark from = mark(out.mesh);
    add_loft(out.mesh, loft);
    for (const int thigh : {j.leg.upper, j.leg.upper + 1})
        attract(out.mesh, from, thigh, out.head_of(thigh), d * 0.95, 0.4);
    attract(out.mesh, from, j.breast, out.head_of(j.breast) + Vec3(0.0, -d * 0.45, d * 0.2), d * 1.25, 0.8);
}

void add_head(Builder& out) {
    const BirdShape& s = out.shape();
    const BirdJoints& j = out.joints();
    const Vec3 c = out.head_of(j.head);
    const double r = s.head_radius;
    const Paint skull{s.cap, s.cheek, s.bib};
    const auto at = [&](double z, double y) { return c + Vec3(0.0, y * r, z * r); };
    Loft loft;
    loft.segments = 16;
    loft.start_cap = r * 0.10;
    loft.end_cap = r * 0.12;
    loft.sections = {{at(-0.92, 0.10), r * 0.34, r * 0.36, r * 0.34, j.head, {s.nape, s.nape, s.cheek}, 1},
                     {at(-0.62, 0.10), r * 0.76, r * 0.78, r * 0.76, j.head, {s.cap, s.nape, s.cheek}, 1},
                     {at(-0.15, 0.10), r * 0.98, r * 0.98, r * 0.96, j.head, skull, 2},
                     {at(0.40, 0.05), r * 0.88, r * 0.86, r * 0.84, j.head, skull, 2},
                     {at(0.80, -0.02), r * 0.50, r * 0.52, r * 0.48, j.head, {s.cap, s.bib, s.bib}, 1},
                     {at(0.96, -0.05), r * 0.28, r * 0.30, r * 0.26, j.head, plain(s.bib), 0}};
    add_loft(out.mesh, loft);
    const double b = s.beak_radius;
    const double l = s.beak_length;
    const Vec3 gape = out.head_of(j.beak);
    const Paint horn = plain(s.beak);
    loft.segments = 8;
    loft.start_cap = 0.0;
    loft.end_cap = b * 0.2;
    loft.sections = {{gape + Vec3(0.0, b * 0.05, 0.0), b * 0.95, b * 0.95, b * 0.05, j.head, horn, 2},
                     {gape + Vec3(0.0, b * 0.05, l * 0.50), b * 0.62, b * 0.62, b * 0.06, j.head, horn, 2},
                     {gape + Vec3(0.0, -b * 0.10, l * 1.0), b * 0.10, b * 0.12, b * 0.05, j.head, horn, 0}};
    add_loft(out.mesh, loft);
    loft.sections = {{gape - Vec3(0.0, b * 0.05, 0.0), b * 0.85, b * 0.05, b * 0.66, j.beak, horn, 2},
                     {gape - Vec3(0.0, b * 0.05, -l * 0.45), b * 0.54, b * 0.05, b * 0.42, j.beak, horn, 2},
                     {gape - Vec3(0.0, b * 0.05, -l * 0.88), b * 0.09, b * 0.04, b * 0.08, j.beak, horn, 0}};
    add_loft(out.mesh, loft);
}

void add_eye(Builder& out) {
    const double r = out.shape().head_radius * 0.20;
    Ellipsoid eye;
    eye.centre = out.head_of(out.joints().eye) - kAxisX * (r * 0.35);
    eye.radii = {r, r, r};
    eye.turn = yaw(66.0) * pitch(-8.0);
    eye.colour = out.shape().iris;
    eye.tip_colour = out.shape().eye;
    eye.joint = out.joints().eye;
    add_ellipsoid(out.mesh, eye);
}

// A flat group of feathers from `root` along `way`: `half` its half width on the way, thickest at the root.
struct Feathers {
    Vec3 root{}, way{}, side{};
    double root_half = 0.0, middle_half = 0.0, tip_half = 0.0;
    double thickness = 0.0;
    int owner = 0;  // joint at the root
    int joint = 0;
    Paint root_paint, paint, tip_paint;
};

void add_feathers(Builder& out, const Feathers& f) {
    const double t = f.thickness;
    Loft loft;
    loft.side = glm::normalize(f.side - f.way * (glm::dot(f.side, f.way) / glm::dot(f.way, f.way)));
    loft.segments = 10;
    loft.start_cap = 0.0;
    loft.end_cap = glm::length(f.way) * 0.04;
    loft.sections = {{f.root, f.root_half, t, t, f.owner, f.root_paint, 2},
                     {f.root + f.way * 0.30, f.middle_half, t * 0.85, t * 0.7, f.joint, f.paint, 2},
                     {f.root + f.way * 0.65, f.middle_half * 0.6 + f.tip_half * 0.4, t * 0.6, t * 0.5,
                      f.joint, f.paint, 2},
                     {f.root + f.way * 0.90, f.tip_half, t * 0.4, t * 0.3, f.joint, f.tip_paint, 1},
                     {f.root + f.way, f.tip_half * 0.55, t * 0.2, t * 0.2, f.joint, f.tip_paint, 0}};
    const Mark from = mark(out.mesh);
    add_loft(out.mesh, loft);
    attract(out.mesh, from, f.owner, f.root, glm::length(f.way) * 0.6, 0.5);
}

void add_wing(Builder& out) {
    const BirdShape& s = out.shape();
    const BirdJoints& j = out.joints();
    const Vec3 shoulder = out.head_of(j.upper_arm);
    const Vec3 elbow = out.head_of(j.forearm);
    const Vec3 wrist = out.head_of(j.hand);
    const double l = s.wing_length;
    const double c = s.wing_chord;
    const double t = c * 0.085;
    const Vec3 hand = shoulder + Vec3(0.66, 0.03, 0.01) * l;
    const Paint cover{s.wing, s.wing, s.belly};
    Loft arm;
    arm.side = -kAxisZ;
    arm.segments = 10;
    arm.start_cap = 0.0;
    arm.end_cap = t * 0.5;
    arm.sections = {{shoulder - kAxisX * (l * 0.05), c * 0.22, t * 1.7, t * 1.7, j.upper_arm, cover, 2},
                    {mixed(shoulder, elbow, 0.55), c * 0.20, t * 1.5, t * 1.4, j.upper_arm, cover, 2},
                    {mixed(elbow, wrist, 0.25), c * 0.19, t * 1.3, t * 1.2, j.forearm, cover, 2},
                    {mixed(elbow, wrist, 0.80), c * 0.15, t * 1.1, t, j.forearm, cover, 2},
                    {mixed(wrist, hand, 0.40), c * 0.10, t * 0.9, t * 0.8, j.hand, cover, 1},
                    {hand, c * 0.04, t * 0.4, t * 0.4, j.hand, cover, 0}};
    add_loft(out.mesh, arm);
    const Paint bar{s.wing_bar, s.wing_bar, s.belly};
    const Paint quill{s.feather, s.feather, s.side};
    const Paint edge{s.wing, s.wing, s.side};
    const Vec3 inner = out.head_of(j.tertials);
    // Tertials on the arm, secondaries on the forearm, primaries in two fans on the hand.
    add_feathers(out, {inner - Vec3(0.0, t * 0.3, c * 0.05), -kAxisZ * (c * 0.92), kAxisX, l * 0.15, l * 0.15,
                       l * 0.12, t, j.upper_arm, j.tertials, cover, edge, quill});
    add_feathers(out,
                 {out.head_of(j.secondaries) + Vec3(0.0, -t * 0.1, c * 0.02), Vec3(0.04 * l, 0.0, -c * 1.05),
                  kAxisX, l * 0.15, l * 0.17, l * 0.14, t, j.forearm, j.secondaries, cover, bar, quill});
    add_feathers(
        out, {wrist + Vec3(l * 0.02, -t * 0.4, -c * 0.06), Vec3(0.30 * l, 0.0, -c * 1.0), Vec3(1.0, 0.0, 0.4),
              c * 0.22, c * 0.34, c * 0.22, t * 0.9, j.hand, j.primaries, edge, quill, quill});
    add_feathers(out, {wrist + Vec3(l * 0.03, -t * 0.2, 0.0), Vec3(0.50 * l, -0.01 * l, -c * 0.50),
                       Vec3(0.5, 0.0, 1.0), c * 0.16, c * 0.24, c * 0.10, t * 0.9, j.hand, j.primaries, edge,
                       quill, plain(s.feather)});
}

void add_tail(Builder& out) {
    const BirdShape& s = out.shape();
    const BirdJoints& j = out.joints();
    const Vec3 root = out.head_of(j.tail[0]);
    const Vec3 way = (out.head_of(j.tail[1]) - root) / 0.4;
    const double t = s.tail_radius * 0.16;
    const Paint paint{s.tail, s.tail, s.side};
    add_feathers(out, {root + way * 0.05, way, -kAxisX, s.tail_radius * 0.62, s.tail_radius * 0.60,
                       s.tail_radius * 0.62, t, j.tail[0], j.tail[1], paint, paint, plain(s.tail)});
}

void add_tail_side(Builder& out) {
    const BirdShape& s = out.shape();
    const BirdJoints& j = out.joints();
    const Vec3 root = out.head_of(j.fan);
    const Vec3 way = (out.head_of(j.tail[1]) - out.head_of(j.tail[0])) / 0.4;
    const Vec3 out_way = way * 0.62 + kAxisX * (s.tail_radius * 0.35);
    const Paint paint{s.feather, s.feather, s.side};
    add_feathers(out, {root - kAxisY * (s.tail_radius * 0.06), out_way, -kAxisX, s.tail_radius * 0.40,
                       s.tail_radius * 0.44, s.tail_radius * 0.42, s.tail_radius * 0.13, j.tail[1], j.fan,
                       paint, paint, plain(s.feather)});
}

void add_toe(Builder& out, int joint, const Vec3& way) {
    const BirdShape& s = out.shape();
    const Vec3 root = out.head_of(out.joints().leg.foot);
    const double r = s.leg_radius;
    const Vec3 tip(root.x + way.x, r * 0.35, root.z + way.z);
    Loft loft;
    loft.side = glm::normalize(glm::cross(kAxisY, way));
    loft.segments = 6;
    loft.start_cap = 0.0;
    loft.end_cap = r * 0.3;
    loft.sections = {{root - way * 0.06, r * 0.9, r * 0.9, r * 0.9, joint, plain(s.leg), 2},
                     {Vec3(root.x + way.x * 0.6, r * 0.9, root.z + way.z * 0.6), r * 0.75, r * 0.8, r * 0.85,
                      joint, plain(s.leg), 1},
                     {tip, r * 0.25, r * 0.3, r * 0.3, joint, plain(s.beak), 0}};
    add_loft(out.mesh, loft);
}

void add_leg(Builder& out) {
    const BirdShape& s = out.shape();
    const BirdJoints& j = out.joints();
    const Vec3 hip = out.head_of(j.leg.upper);
    const Vec3 knee = out.head_of(j.leg.lower);
    const Vec3 hock = out.head_of(j.leg.cannon);
    const Vec3 foot = out.head_of(j.leg.foot);
    const double r = s.leg_radius;
    const double d = s.body_depth;
    const Paint plume = plain(s.belly);
    Loft loft;
    loft.segments = 10;
    loft.start_cap = d * 0.06;
    loft.end_cap = 0.0;
    loft.sections = {{hip, d * 0.24, d * 0.34, d * 0.34, j.leg.upper, {s.side, s.side, s.side}, 2},
                     {mixed(hip, knee, 0.75), d * 0.20, d * 0.26, d * 0.28, j.leg.upper, plume, 2},
                     {mixed(knee, hock, 0.45), r * 2.0, r * 2.2, r * 2.4, j.leg.lower, plume, 2},
                     {mixed(knee, hock, 0.88), r * 1.15, r * 1.2, r * 1.2, j.leg.lower, plain(s.leg), 1},
                     {mixed(hock, foot, 0.20), r, r, r, j.leg.cannon, plain(s.leg), 2},
                     {foot, r * 0.95, r * 0.95, r * 0.95, j.leg.cannon, plain(s.leg), 0}};
    add_loft(out.mesh, loft);
    const double l = s.toe_length;
    add_toe(out, j.leg.foot, {0.0, 0.0, l});
    add_toe(out, j.leg.foot, {l * 0.42, 0.0, l * 0.80});
    add_toe(out, j.leg.foot, {-l * 0.42, 0.0, l * 0.80});
    add_toe(out, j.hind_toe, {0.0, 0.0, -l * 0.75});
}

}  // namespace

Mesh bird_mesh(const Bird& animal) {
    Builder out{animal, {}};
    add_trunk(out);
    add_head(out);
    add_tail(out);
    const Mark sides = mark(out.mesh);
    add_eye(out);
    add_wing(out);
    add_tail_side(out);
    add_leg(out);
    add_mirror_image(out.mesh, animal.rig, sides);
    finish(out.mesh);
    return std::move(out.mesh);
}

}  // namespace posepack::menagerie
