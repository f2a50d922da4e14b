// SPDX-License-Identifier: MIT
// The skin of a quadruped: a trunk with its neck, a head with its jaw, four legs, and what stands out of
// them. Every part is a closed surface of rings x segments + 2 vertices. For the goat, whose tail has three
// joints: trunk 25 x 24, head 16 x 18, jaw 6 x 10, beard 4 x 8, tail 5 x 10, and twice ear 6 x 10, horn 9 x
// 10, eye 3 x 8, front leg 19 x 14 and back leg 20 x 14: with two poles for each of the 15 parts, exactly
// 2,500.
#include <glm/geometric.hpp>

#include "menagerie/quadruped.hpp"

namespace posepack::menagerie {
namespace {

constexpr int kTrunkSegments = 24;
constexpr int kHeadSegments = 18;
constexpr int kLegSegments = 14;
constexpr int kSmallSegments = 10;

struct Builder {
    const Quadruped& animal;
    Mesh mesh;

    const QuadrupedShape& shape() const { return animal.shape; }
    const QuadrupedJoints& joints() const { return animal.joints; }
    const Vec3& head_of(int joint) const { return animal.rig.joints[static_cast<std::size_t>(joint)].head; }
};

Vec3 between(const Vec3& a, const Vec3& b, double share) {
    return a + (b - a) * share;
}

void add_trunk(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const QuadrupedJoints& j = out.joints();
    const Vec3 hip = out.head_of(j.body);
    const Vec3 loin = out.head_of(j.spine[0]);
    const Vec3 waist = out.head_of(j.spine[1]);
    const Vec3 chest = out.head_of(j.spine[2]);
    const Vec3 neck = out.head_of(j.neck[0]);
    const Vec3 poll = out.head_of(j.head);
    const Vec3 withers(0.0, chest.y, s.body_length * 0.44);
    const double ridge = s.chest_depth * 0.30;  // height of the back above the spine
    const double r = s.rump_radius;
    const Paint coat{s.back, s.coat, s.belly};
    const Paint front{s.back, s.coat, s.coat};
    const Paint neck_paint{s.back, s.neck, s.neck};
    const auto throat = [&](double share) {
        return s.neck_base_depth + (s.neck_radius * 1.2 - s.neck_base_depth) * share;
    };
    const auto side = [&](double share) {
        return s.chest_radius * 0.72 + (s.neck_radius - s.chest_radius * 0.72) * share;
    };
    Loft loft;
    loft.segments = kTrunkSegments;
    loft.start_cap = r * 0.12;
    loft.end_cap = 0.0;
    loft.sections = {
        {hip - Vec3(0.0, r * 0.45, r * 1.12), r * 0.42, r * 0.42, r * 0.50, j.body, coat, 1},
        {hip - Vec3(0.0, r * 0.20, r * 0.80), r * 0.80, r * 0.55, r * 0.95, j.body, coat, 2},
        {hip - Vec3(0.0, 0.0, r * 0.05), r, ridge, r * 1.25, j.body, coat, 3},
        {loin, s.belly_radius * 0.93, ridge * 0.95, s.belly_depth * 0.95, j.spine[0], coat, 3},
        {waist, s.belly_radius, ridge * 0.95, s.belly_depth, j.spine[1], coat, 3},
        {chest, (s.belly_radius + s.chest_radius) * 0.5, ridge * 1.05, s.chest_depth * 1.05, j.spine[2], coat,
         3},
        {withers, s.chest_radius, ridge * 1.1, s.chest_depth, j.spine[2], front, 3},
        {between(neck, poll, 0.10), side(0.25), throat(0.15) * 0.9, throat(0.0) * 1.15, j.neck[0], front, 2},
        {between(neck, poll, 0.40), side(0.62), throat(0.45), throat(0.45), j.neck[1], neck_paint, 2},
        {between(neck, poll, 0.72), side(0.88), throat(0.80), throat(0.80), j.neck[2], neck_paint, 2},
        {between(neck, poll, 1.04), side(1.05), throat(1.05), throat(1.05), j.head, neck_paint, 0}};
    const Mark from = mark(out.mesh);
    add_loft(out.mesh, loft);
    for (int right = 0; right < 2; ++right) {
        attract(out.mesh, from, j.front_blade + right,
                between(out.head_of(j.front_blade + right), out.head_of(j.front.upper + right), 0.5),
                s.chest_depth * 0.95, 0.65);
        attract(out.mesh, from, j.back_blade + right, out.head_of(j.back.upper + right), s.rump_radius * 1.3,
                0.55);
    }
}

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
    const Paint paint{s.ear_inside, s.ear, s.ear};
    Loft loft;
    loft.side = glm::normalize(glm::cross(opening - along * glm::dot(opening, along), along));
    loft.segments = kSmallSegments;
    loft.start_cap = 0.0;
    loft.end_cap = s.ear_length * 0.05;
    loft.sections = {{root - along * (s.ear_length * 0.10), w * 0.40, w * 0.22, w * 0.40, out.joints().head,
                      plain(s.ear), 1},
                     {root + way * 0.18, w * 0.72, -w * 0.02, w * 0.42, ear[0], paint, 2},
                     {root + way * 0.55, w, -w * 0.06, w * 0.36, ear[1], paint, 2},
                     {root + way * 0.94, w * 0.25, w * 0.02, w * 0.12, ear[1], plain(s.ear), 0}};
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

// The part of a leg that front and back have in common: from above the hock or wrist to the ground.
void add_shank(Builder& out, const Leg& leg, int toe, double r, std::vector<Section>& sections) {
    const QuadrupedShape& s = out.shape();
    const Vec3 hock = out.head_of(leg.cannon);
    const Vec3 ankle = out.head_of(leg.foot);
    const Vec3 toe_head = out.head_of(toe);
    const bool paw = s.foot == Foot::paw;
    const double spread = paw ? 1.55 : 1.30;
    const Paint sock = plain(s.sock);
    // The last two rings stand above each other, so that the sole is level.
    const Vec3 sole(toe_head.x, 0.0, toe_head.z + toe_head.y * (paw ? 0.30 : 0.45));
    sections.push_back(
        {between(hock, ankle, 0.12), r * 1.15, r * 1.15, r * 1.25, leg.cannon, plain(s.leg), 2});
    sections.push_back({between(hock, ankle, 0.60), r * 0.88, r * 0.90, r * 0.95, leg.cannon, sock, 1});
    sections.push_back({between(hock, ankle, 0.92), r * 1.05, r * 1.05, r * 1.15, leg.cannon, sock, 1});
    sections.push_back({between(ankle, toe_head, 0.10), r * 1.22, r * 1.20, r * 1.30, leg.foot, sock, 1});
    sections.push_back({between(ankle, toe_head, 0.70), r * 1.10, r * 1.15, r * 1.15, leg.foot, sock, 1});
    sections.push_back(
        {between(sole + kAxisY * toe_head.y, toe_head, 0.25) + kAxisY * (toe_head.y * 0.10), r * spread, r * spread * 1.1, r * spread, toe, sock, 1});
    sections.push_back({sole + kAxisY * (toe_head.y * 0.88), r * spread * 1.08, r * spread * 1.2, r * spread * 1.05,
                        toe, plain(s.hoof), 1});
    sections.push_back({sole, r * spread * 1.22, r * spread * 1.5, r * spread * 1.2, toe, plain(s.hoof), 0});
}

void add_front_leg(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const QuadrupedJoints& j = out.joints();
    const Vec3 blade = out.head_of(j.front_blade);
    const Vec3 upper = out.head_of(j.front.upper);
    const Vec3 elbow = out.head_of(j.front.lower);
    const Vec3 wrist = out.head_of(j.front.cannon);
    const double r = s.leg_radius;
    const double c = s.chest_depth;
    Loft loft;
    loft.segments = kLegSegments;
    loft.start_cap = c * 0.05;
    loft.end_cap = 0.0;
    loft.sections = {
        {blade - Vec3(s.chest_radius * 0.02, 0.0, 0.0), c * 0.17, c * 0.32, c * 0.34, j.front_blade,
         plain(s.coat), 2},
        {between(blade, upper, 0.70), c * 0.23, c * 0.36, c * 0.44, j.front_blade, plain(s.coat), 2},
        {between(upper, elbow, 0.55), c * 0.21, c * 0.27, c * 0.33, j.front.upper, plain(s.coat), 3},
        {between(elbow, wrist, 0.18), r * 1.55, r * 1.75, r * 2.10, j.front.lower, plain(s.coat), 1},
        {between(elbow, wrist, 0.60), r * 1.18, r * 1.25, r * 1.35, j.front.lower, plain(s.leg), 1},
        {between(elbow, wrist, 0.93), r * 1.22, r * 1.32, r * 1.15, j.front.lower, plain(s.leg), 1}};
    add_shank(out, j.front, j.front_toe, r, loft.sections);
    add_loft(out.mesh, loft);
}

void add_back_leg(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const QuadrupedJoints& j = out.joints();
    const Vec3 blade = out.head_of(j.back_blade);
    const Vec3 upper = out.head_of(j.back.upper);
    const Vec3 knee = out.head_of(j.back.lower);
    const Vec3 hock = out.head_of(j.back.cannon);
    const double r = s.leg_radius;
    const double t = s.thigh_radius;
    Loft loft;
    loft.segments = kLegSegments;
    loft.start_cap = t * 0.10;
    loft.end_cap = 0.0;
    loft.sections = {
        {blade, t * 0.40, t * 0.85, t * 0.85, j.back_blade, plain(s.coat), 2},
        {between(blade, upper, 0.95), t * 0.62, t * 1.05, t * 1.10, j.back_blade, plain(s.coat), 2},
        {between(upper, knee, 0.55), t * 0.62, t * 0.85, t * 1.05, j.back.upper, plain(s.coat), 2},
        {between(knee, hock, 0.12), t * 0.48, t * 0.55, t * 0.72, j.back.lower, plain(s.coat), 3},
        {between(knee, hock, 0.55), r * 1.25, r * 1.35, r * 1.60, j.back.lower, plain(s.leg), 1},
        {between(knee, hock, 0.93), r * 1.10, r * 1.20, r * 1.60, j.back.lower, plain(s.leg), 1}};
    add_shank(out, j.back, j.back_toe, r * 1.05, loft.sections);
    add_loft(out.mesh, loft);
}

void add_tail(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const std::vector<int>& tail = out.joints().tail;
    const Vec3 root = out.head_of(tail.front());
    const Vec3 way = pitch(s.tail_rise_degrees) * -kAxisZ * s.tail_length;
    const double r = s.tail_radius;
    Loft loft;
    loft.segments = kSmallSegments;
    loft.start_cap = 0.0;
    loft.end_cap = r * 0.4;
    loft.sections = {{root - glm::normalize(way) * (r * 0.9),
                      r * 0.9,
                      r * 0.9,
                      r * 0.9,
                      out.joints().body,
                      {s.coat, s.coat, s.coat},
                      1}};
    const std::size_t count = tail.size();
    for (std::size_t index = 0; index < count; ++index) {
        const double along = (static_cast<double>(index) + 0.45) / static_cast<double>(count);
        const double swell = 1.0 + s.tail_bush * along * (1.0 - along) * 4.0;
        const Paint paint{s.tail, s.tail, s.belly};
        loft.sections.push_back({root + way * along, r * swell, r * swell, r * swell, tail[index], paint, 1});
    }
    loft.sections.push_back({root + way, r * 0.3, r * 0.3, r * 0.3, tail.back(), plain(s.tail), 0});
    add_loft(out.mesh, loft);
}

}  // namespace

Mesh quadruped_mesh(const Quadruped& animal) {
    Builder out{animal, {}};
    add_trunk(out);
    add_head(out);
    add_jaw(out);
    add_tail(out);
    const Mark sides = mark(out.mesh);
    add_ear(out);
    add_horn(out);
    add_eye(out);
    add_front_leg(out);
    add_back_leg(out);
    add_mirror_image(out.mesh, animal.rig, sides);
    finish(out.mesh);
    return std::move(out.mesh);
}

}  // namespace posepack::menagerie
