// SPDX-License-Identifier: MIT
// The skin of a quadruped: a trunk with its neck, a head with its jaw, four legs, and what stands out of
// them. Every part is a closed surface of rings x segments + 2 vertices. For the goat, whose tail has three
// joints: trunk 25 x 24, head 16 x 18, jaw 6 x 10, beard 4 x 8, tail 5 x 10, and twice ear 6 x 10, horn 9 x
// 10, eye 3 x 8, front leg 19 x 14 and back leg 20 x 14: with two poles for each of the 15 parts, exactly
// 2,500.
#include <algorithm>
#include <glm/geometric.hpp>

#include "menagerie/quadruped_parts.hpp"

namespace posepack::menagerie {
namespace {

constexpr int kTrunkSegments = 24;
constexpr int kLegSegments = 14;
constexpr int kSmallSegments = 10;

using Builder = SkinBuilder<Quadruped>;

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
    // A thick neck that is carried low does not stand above the back like a hood.
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
        {mixed(neck, poll, 0.10), side(0.25), std::min(throat(0.15) * 0.9, ridge * 1.7), throat(0.0) * 1.15,
         j.neck[0], front, 2},
        {mixed(neck, poll, 0.40), side(0.62), std::min(throat(0.45), ridge * 1.9), throat(0.45), j.neck[1],
         neck_paint, 2},
        {mixed(neck, poll, 0.72), side(0.88), throat(0.80), throat(0.80), j.neck[2], neck_paint, 2},
        {mixed(neck, poll, 1.04), side(1.05), throat(1.05), throat(1.05), j.head, neck_paint, 0}};
    const Mark from = mark(out.mesh);
    add_loft(out.mesh, loft);
    for (int right = 0; right < 2; ++right) {
        attract(out.mesh, from, j.front_blade + right,
                mixed(out.head_of(j.front_blade + right), out.head_of(j.front.upper + right), 0.5),
                s.chest_depth * 0.95, 0.65);
        attract(out.mesh, from, j.back_blade + right, out.head_of(j.back.upper + right), s.rump_radius * 1.3,
                0.55);
    }
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
    sections.push_back({mixed(hock, ankle, 0.12), r * 1.15, r * 1.15, r * 1.25, leg.cannon, plain(s.leg), 2});
    sections.push_back({mixed(hock, ankle, 0.60), r * 0.88, r * 0.90, r * 0.95, leg.cannon, sock, 1});
    sections.push_back({mixed(hock, ankle, 0.92), r * 1.05, r * 1.05, r * 1.15, leg.cannon, sock, 1});
    sections.push_back({mixed(ankle, toe_head, 0.10), r * 1.22, r * 1.20, r * 1.30, leg.foot, sock, 1});
    sections.push_back({mixed(ankle, toe_head, 0.70), r * 1.10, r * 1.15, r * 1.15, leg.foot, sock, 1});
    sections.push_back({mixed(sole + kAxisY * toe_head.y, toe_head, 0.25) + kAxisY * (toe_head.y * 0.10),
                        r * spread, r * spread * 1.1, r * spread, toe, sock, 1});
    sections.push_back({sole + kAxisY * (toe_head.y * 0.88), r * spread * 1.08, r * spread * 1.2,
                        r * spread * 1.05, toe, plain(s.hoof), 1});
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
        {mixed(blade, upper, 0.70), c * 0.23, c * 0.36, c * 0.44, j.front_blade, plain(s.coat), 2},
        {mixed(upper, elbow, 0.55), c * 0.21, c * 0.27, c * 0.33, j.front.upper, plain(s.coat), 3},
        {mixed(elbow, wrist, 0.18), r * 1.55, r * 1.75, r * 2.10, j.front.lower, plain(s.coat), 1},
        {mixed(elbow, wrist, 0.60), r * 1.18, r * 1.25, r * 1.35, j.front.lower, plain(s.leg), 1},
        {mixed(elbow, wrist, 0.93), r * 1.22, r * 1.32, r * 1.15, j.front.lower, plain(s.leg), 1}};
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
        {mixed(blade, upper, 0.95), t * 0.62, t * 1.05, t * 1.10, j.back_blade, plain(s.coat), 2},
        {mixed(upper, knee, 0.55), t * 0.62, t * 0.85, t * 1.05, j.back.upper, plain(s.coat), 2},
        {mixed(knee, hock, 0.12), t * 0.48, t * 0.55, t * 0.72, j.back.lower, plain(s.coat), 3},
        {mixed(knee, hock, 0.55), r * 1.25, r * 1.35, r * 1.60, j.back.lower, plain(s.leg), 1},
        {mixed(knee, hock, 0.93), r * 1.10, r * 1.20, r * 1.60, j.back.lower, plain(s.leg), 1}};
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
        const double swell = (1.0 + s.tail_bush * along * (1.0 - along) * 4.0) * (1.0 - s.tail_taper * along);
        // A path that leads backwards has its upper line below; only a tail that is carried high shows its
        // underside from above.
        const bool is_high = s.tail_rise_degrees > 40.0;
        const Paint paint{s.tail, s.tail, is_high ? s.belly : s.tail};
        loft.sections.push_back({root + way * along, r * swell, r * swell, r * swell, tail[index], paint, 1});
    }
    loft.sections.push_back({root + way, r * 0.3, r * 0.3, r * 0.3, tail.back(), plain(s.tail), 0});
    add_loft(out.mesh, loft);
}

}  // namespace

Mesh quadruped_mesh(const Quadruped& animal) {
    Builder out{animal, {}};
    add_trunk(out);
    add_quadruped_head(out);
    add_tail(out);
    add_quadruped_extras(out);
    const Mark sides = mark(out.mesh);
    add_quadruped_head_sides(out);
    add_quadruped_side_extras(out);
    add_front_leg(out);
    add_back_leg(out);
    add_mirror_image(out.mesh, animal.rig, sides);
    finish(out.mesh);
    return std::move(out.mesh);
}

}  // namespace posepack::menagerie
