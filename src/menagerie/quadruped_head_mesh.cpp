// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "menagerie/quadruped_parts.hpp"

namespace posepack::menagerie {
namespace {

using Builder = SkinBuilder<Quadruped>;

constexpr int kHeadSegments = 18;
constexpr int kSmallSegments = 10;

struct HeadFrame {
    Vec3 origin, forward, up;
    double length;

    Vec3 at(double along, double above) const { return origin + forward * (along * length) + up * above; }
};

HeadFrame head_frame(const Builder& out) {
    const double drop = out.shape().head_drop_degrees;
    return {out.head_of(out.joints().head), pitch(drop) * kAxisZ, pitch(drop) * kAxisY,
            out.shape().head_length};
}

void add_head(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const int head = out.joints().head;
    const HeadFrame f = head_frame(out);
    const double w = s.head_radius;
    const double d = s.head_depth;
    const double m = s.muzzle_radius;
    const double md = s.muzzle_depth;
    const Paint top{s.back, s.neck, s.neck};
    const Paint face{s.face, s.face, s.face};
    const Paint muzzle{s.face, s.muzzle, s.muzzle};
    Loft loft;
    loft.segments = kHeadSegments;
    loft.start_cap = d * 0.10;
    loft.end_cap = m * 0.18;
    loft.sections = {
        {f.at(-0.20, -d * 0.10), w * 0.50, d * 0.50, d * 0.50, head, top, 1},
        {f.at(-0.08, 0.0), w * 0.80, d * 0.80, d * 0.75, head, top, 2},
        {f.at(0.14, 0.0), w * 0.98, d * 0.98, d * 0.92, head, face, 3},
        {f.at(0.36, 0.0), w * 0.95, d * 0.88, d * 0.85, head, face, 3},
        {f.at(0.58, -d * 0.08), (w * 0.35 + m * 0.65), d * 0.30 + md * 0.62, md * 1.10, head, face, 3},
        {f.at(0.80, -d * 0.18), m, md * 0.95, md * 0.72, head, muzzle, 2},
        {f.at(0.93, -d * 0.20), m * 1.02, md * 0.88, md * 0.62, head, {s.nose, s.muzzle, s.muzzle}, 1},
        {f.at(0.985, -d * 0.21), m * 0.78, md * 0.62, md * 0.45, head, plain(s.nose), 0}};
    add_loft(out.mesh, loft);
}

void add_jaw(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const QuadrupedJoints& j = out.joints();
    const HeadFrame f = head_frame(out);
    const double d = s.head_depth;
    const double m = s.muzzle_radius;
    const double md = s.muzzle_depth;
    Loft loft;
    loft.segments = kSmallSegments;
    loft.start_cap = 0.0;
    loft.end_cap = m * 0.15;
    loft.sections = {{f.at(0.20, -d * 0.62), m * 0.95, md * 0.45, md * 0.55, j.jaw, plain(s.face), 2},
                     {f.at(0.50, -d * 0.62), m * 0.90, md * 0.40, md * 0.55, j.jaw, plain(s.face), 2},
                     {f.at(0.78, -d * 0.56), m * 0.80, md * 0.35, md * 0.50, j.jaw, plain(s.muzzle), 1},
                     {f.at(0.93, -d * 0.53), m * 0.62, md * 0.28, md * 0.38, j.jaw, plain(s.muzzle), 0}};
    add_loft(out.mesh, loft);
    if (j.beard < 0) return;
    const Vec3 root = out.head_of(j.beard);
    const double l = s.beard_length;
    loft.segments = 8;
    loft.start_cap = 0.0;
    loft.end_cap = l * 0.10;
    loft.sections = {
        {root + Vec3(0.0, 0.012, 0.0), m * 0.50, m * 0.55, m * 0.60, j.jaw, plain(s.muzzle), 1},
        {root - Vec3(0.0, l * 0.30, l * 0.02), m * 0.52, m * 0.50, m * 0.62, j.beard, plain(s.muzzle), 2},
        {root - Vec3(0.0, l * 0.90, l * 0.16), m * 0.12, m * 0.12, m * 0.16, j.beard, plain(s.belly), 0}};
    add_loft(out.mesh, loft);
}

void add_ear(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const std::vector<int>& ear = out.joints().ear;
    const Vec3 root = out.head_of(ear[0]);
    const Vec3 way = (out.head_of(ear[1]) - root) * 2.0;
    const Vec3 along = glm::normalize(way);
    const Vec3 opening(0.15, -0.35, 0.9);  // where the inside of the ear looks
    const double w = s.ear_width;
    const double t = w * s.ear_thickness;
    const Paint paint{s.ear_inside, s.ear, s.ear};
    Loft loft;
    loft.side = glm::normalize(glm::cross(opening - along * glm::dot(opening, along), along));
    loft.segments = kSmallSegments;
    loft.start_cap = 0.0;
    loft.end_cap = s.ear_length * 0.05;
    loft.sections = {{root - along * (s.ear_length * 0.10), w * 0.40, t * 0.22, t * 0.40, out.joints().head,
                      plain(s.ear), 1},
                     {root + way * 0.18, w * 0.72, -t * 0.02, t * 0.42, ear[0], paint, 2},
                     {root + way * 0.55, w, -t * 0.06, t * 0.36, ear[1], paint, 2},
                     {root + way * 0.94, w * 0.25, t * 0.02, t * 0.12, ear[1], plain(s.ear), 0}};
    add_loft(out.mesh, loft);
}

void add_horn(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const std::vector<int>& horn = out.joints().horn;
    if (horn.empty()) return;
    const Vec3 root = out.head_of(horn[0]);
    const double l = s.horn_length;
    const double r = l * 0.098;
    Loft loft;
    loft.segments = kSmallSegments;
    loft.start_cap = 0.0;
    loft.end_cap = r * 0.3;
    // The growth rings of a horn: every second section stands out a little.
    loft.sections = {
        {root - Vec3(0.0, l * 0.12, -l * 0.02), r * 0.85, r * 1.25, r * 1.25, out.joints().head,
         plain(s.horn), 1},
        {root + Vec3(0.02, 0.16, -0.02) * l, r * 0.88, r * 1.30, r * 1.30, horn[0], plain(s.horn), 1},
        {root + Vec3(0.05, 0.30, -0.07) * l, r * 0.72, r * 1.05, r * 1.05, horn[0], plain(s.horn), 1},
        {root + Vec3(0.08, 0.44, -0.14) * l, r * 0.80, r * 1.12, r * 1.12, horn[0], plain(s.horn), 1},
        {root + Vec3(0.11, 0.56, -0.24) * l, r * 0.62, r * 0.86, r * 0.86, horn[1], plain(s.horn), 1},
        {root + Vec3(0.15, 0.66, -0.36) * l, r * 0.64, r * 0.84, r * 0.84, horn[1], plain(s.horn), 1},
        {root + Vec3(0.20, 0.72, -0.51) * l, r * 0.46, r * 0.58, r * 0.58, horn[1], plain(s.horn_tip), 1},
        {root + Vec3(0.26, 0.73, -0.66) * l, r * 0.34, r * 0.40, r * 0.40, horn[1], plain(s.horn_tip), 1},
        {root + Vec3(0.34, 0.69, -0.82) * l, r * 0.10, r * 0.12, r * 0.12, horn[1], plain(s.horn_tip), 0}};
    add_loft(out.mesh, loft);
}

void add_eye(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const double r = s.head_radius * 0.27;
    Ellipsoid eye;
    eye.centre = out.head_of(out.joints().eye) - kAxisX * (r * 0.75);
    eye.radii = {r, r, r};
    eye.turn = yaw(72.0) * pitch(-6.0);
    eye.segments = 8;
    eye.rings = 3;
    eye.colour = s.iris;
    eye.tip_colour = s.eye;
    eye.joint = out.joints().eye;
    add_ellipsoid(out.mesh, eye);
}

}  // namespace

void add_quadruped_head(SkinBuilder<Quadruped>& out) {
    add_head(out);
    add_jaw(out);
}

void add_quadruped_head_sides(SkinBuilder<Quadruped>& out) {
    add_ear(out);
    add_horn(out);
    add_eye(out);
}

}  // namespace posepack::menagerie
