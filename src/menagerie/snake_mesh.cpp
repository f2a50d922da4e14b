// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "menagerie/skin_builder.hpp"
#include "menagerie/snake.hpp"

namespace posepack::menagerie {
namespace {

using Builder = SkinBuilder<Snake>;

// Thickness along the body: 0 at the neck, 1 at the tip of the tail.
double radius_at(const SnakeShape& s, double along) {
    const double swell = smooth_step(along * 4.0);
    const double taper = 1.0 - smooth_step((along - 0.55) / 0.45);
    return (s.neck_radius + (s.body_radius - s.neck_radius) * swell) * (0.16 + 0.84 * taper);
}

Section body_section(const SnakeShape& s, const Vec3& place, double along, int joint) {
    const double r = radius_at(s, along);
    const Paint paint{s.back, s.side, s.belly};
    // At rest the chain is level; the thin ends hang a little below its middle, towards the ground.
    const Vec3 centre(place.x, s.body_radius - (s.body_radius - r) * 0.25, place.z);
    return {centre, r, r, r, joint, paint, 2};
}

// The dark zigzag down the back: blotches to the left and right in turn.
void add_zigzag(Builder& out, const Mark& from) {
    const SnakeShape& s = out.shape();
    constexpr int kBlotches = 40;
    for (int index = 0; index < kBlotches; ++index) {
        const double along = 0.03 + 0.93 * index / kBlotches;
        const double r = radius_at(s, along);
        const double side = index % 2 == 0 ? 1.0 : -1.0;
        const Vec3 spot(side * r * 0.36, r * 1.86, s.length * (0.46 + 0.46 / s.front_joints - along));
        tint(out.mesh, from, s.zigzag, spot, r * 1.15, 1.0);
    }
}

void add_body(Builder& out) {
    const SnakeShape& s = out.shape();
    const SnakeJoints& j = out.joints();
    Loft loft;
    loft.segments = 14;
    loft.start_cap = 0.006;
    loft.end_cap = 0.0;
    const double back = s.length * 0.54 / s.back_joints;
    const double front = s.length * 0.46 / s.front_joints;
    // Two sections a joint, so that the middle of each moves with it alone.
    const auto add = [&](int joint, double ahead_m) {
        const Vec3 place = out.head_of(joint) + kAxisZ * ahead_m;
        const double along = (0.46 * s.length + front - place.z) / (s.length + front);
        loft.sections.push_back(body_section(s, place, along, joint));
    };
    for (std::size_t index = j.back.size(); index-- > 0;) {
        if (index + 1 == j.back.size()) add(j.back[index], -back * 0.98);
        add(j.back[index], -back * 0.75);
        add(j.back[index], -back * 0.25);
    }
    std::vector<int> ahead = {j.middle};
    ahead.insert(ahead.end(), j.front.begin(), j.front.end());
    for (const int joint : ahead) {
        add(joint, front * 0.25);
        add(joint, front * 0.75);
    }
    Section neck = body_section(s, out.head_of(j.head) + kAxisZ * (s.head_length * 0.15), 0.0, j.head);
    neck.centre.y = out.head_of(j.head).y;
    loft.sections.push_back(neck);
    const Mark from = mark(out.mesh);
    add_loft(out.mesh, loft);
    add_zigzag(out, from);
}

void add_head(Builder& out) {
    const SnakeShape& s = out.shape();
    const SnakeJoints& j = out.joints();
    const Vec3 neck = out.head_of(j.head);
    const double l = s.head_length;
    const double w = s.head_radius;
    const double d = s.head_depth;
    const Paint top{s.zigzag, s.head, s.belly};
    const Paint snout{s.head, s.head, s.belly};
    const auto at = [&](double along, double above) { return neck + Vec3(0.0, above * d, along * l); };
    Loft loft;
    loft.segments = 14;
    loft.start_cap = 0.0;
    loft.end_cap = w * 0.08;
    loft.sections = {{at(-0.10, 0.0), s.neck_radius * 0.95, d * 0.80, d * 0.30, j.head, top, 2},
                     {at(0.16, 0.05), w * 0.92, d * 0.98, d * 0.25, j.head, top, 2},
                     {at(0.36, 0.05), w, d, d * 0.22, j.head, top, 2},
                     {at(0.62, 0.03), w * 0.76, d * 0.86, d * 0.20, j.head, snout, 2},
                     {at(0.88, -0.02), w * 0.52, d * 0.62, d * 0.18, j.head, snout, 1},
                     {at(0.99, -0.06), w * 0.36, d * 0.40, d * 0.14, j.head, snout, 0}};
    add_loft(out.mesh, loft);
    loft.segments = 12;
    loft.sections = {{at(0.06, -0.40), w * 0.60, d * 0.16, d * 0.34, j.head, plain(s.belly), 2},
                     {at(0.30, -0.36), w * 0.92, d * 0.14, d * 0.34, j.jaw, plain(s.belly), 2},
                     {at(0.62, -0.34), w * 0.68, d * 0.12, d * 0.28, j.jaw, plain(s.belly), 2},
                     {at(0.94, -0.30), w * 0.34, d * 0.10, d * 0.18, j.jaw, plain(s.belly), 0}};
    add_loft(out.mesh, loft);
}

void add_tongue(Builder& out) {
    const SnakeShape& s = out.shape();
    const SnakeJoints& j = out.joints();
    const Vec3 root = out.head_of(j.tongue[0]);
    const double l = s.tongue_length;
    const double r = l * 0.045;
    Loft loft;
    loft.segments = 6;
    loft.start_cap = 0.0;
    loft.end_cap = 0.0;
    loft.sections = {
        {root, r * 1.2, r * 0.6, r * 0.6, j.tongue[0], plain(s.tongue), 2},
        {root + kAxisZ * (l * 0.40), r * 1.2, r * 0.6, r * 0.6, j.tongue[0], plain(s.tongue), 2},
        {root + kAxisZ * (l * 0.68), r * 1.2, r * 0.6, r * 0.6, j.tongue[1], plain(s.tongue), 0}};
    add_loft(out.mesh, loft);
}

void add_sides(Builder& out) {
    const SnakeShape& s = out.shape();
    const SnakeJoints& j = out.joints();
    Ellipsoid eye;
    const double r = s.head_depth * 0.24;
    eye.centre = out.head_of(j.eye) - kAxisX * (r * 0.2);
    eye.radii = {r, r, r};
    eye.turn = yaw(68.0) * pitch(-12.0);
    eye.colour = s.iris;
    eye.tip_colour = s.eye;
    eye.joint = j.eye;
    add_ellipsoid(out.mesh, eye);
    const Vec3 fang = out.head_of(j.fang);
    Loft loft;
    loft.side = kAxisX;
    loft.segments = 6;
    loft.start_cap = 0.0;
    loft.end_cap = 0.0005;
    const double t = s.head_depth * 0.09;
    loft.sections = {
        {fang, t, t, t, j.fang, plain(s.fang), 1},
        {fang + Vec3(0.0, -0.45, -0.06) * s.head_depth, t * 0.7, t * 0.7, t * 0.7, j.fang, plain(s.fang), 1},
        {fang + Vec3(0.0, -0.85, -0.22) * s.head_depth, t * 0.15, t * 0.15, t * 0.15, j.fang, plain(s.fang),
         0}};
    add_loft(out.mesh, loft);
    const double l = s.tongue_length;
    const Vec3 fork = out.head_of(j.tongue[0]) + kAxisZ * (l * 0.64);
    const double f = l * 0.028;
    loft.segments = 6;
    loft.sections = {{fork, f, f, f, j.tongue[1], plain(s.tongue), 1},
                     {fork + Vec3(l * 0.07, l * 0.02, l * 0.20), f, f, f, j.tongue[1], plain(s.tongue), 1},
                     {fork + Vec3(l * 0.17, l * 0.06, l * 0.36), f * 0.3, f * 0.3, f * 0.3, j.tongue[1],
                      plain(s.tongue), 0}};
    add_loft(out.mesh, loft);
}

}  // namespace

Mesh snake_mesh(const Snake& animal) {
    Builder out{animal, {}};
    add_body(out);
    add_head(out);
    add_tongue(out);
    const Mark sides = mark(out.mesh);
    add_sides(out);
    add_mirror_image(out.mesh, animal.rig, sides);
    finish(out.mesh);
    return std::move(out.mesh);
}

}  // namespace posepack::menagerie
