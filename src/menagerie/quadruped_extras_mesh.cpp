// SPDX-License-Identifier: MIT
// What only some quadrupeds carry: horns that move with the head, antlers, manes, a trunk and tusks.
#include <glm/geometric.hpp>

#include "menagerie/quadruped_parts.hpp"

namespace posepack::menagerie {
namespace {

using Builder = SkinBuilder<Quadruped>;

struct Stage {
    Vec3 place{};
    double radius = 0.0;
};

// A rod along places, all of it one joint's: `hue` at the root, `tip` at the last two stages.
void add_rod(Builder& out, const std::vector<Stage>& stages, int joint, Colour hue, Colour tip) {
    Loft loft;
    const Vec3 way = stages.back().place - stages.front().place;
    loft.side = glm::normalize(glm::cross(way, glm::abs(way.z) < glm::abs(way.x) ? kAxisZ : kAxisX));
    loft.segments = 8;
    loft.start_cap = 0.0;
    loft.end_cap = stages.back().radius;
    for (std::size_t index = 0; index < stages.size(); ++index) {
        const auto& [place, r] = stages[index];
        loft.sections.push_back(
            {place, r, r, r, joint, plain(index + 2 < stages.size() ? hue : tip), index % 2 == 0 ? 2 : 1});
    }
    add_loft(out.mesh, loft);
}

// The frame of the skull at the root of the left horn.
struct Root {
    Vec3 place, forward, up;

    Vec3 at(double side, double above, double ahead) const {
        return place + kAxisX * side + up * above + forward * ahead;
    }
};

Root horn_root(const Builder& out) {
    const QuadrupedShape& s = out.shape();
    const Vec3 forward = pitch(s.head_drop_degrees) * kAxisZ;
    const Vec3 up = pitch(s.head_drop_degrees) * kAxisY;
    return {out.head_of(out.joints().head) + forward * (s.head_length * 0.10) + up * (s.head_depth * 0.70) +
                kAxisX * (s.head_radius * 0.50),
            forward, up};
}

void add_antler(Builder& out, const Root& f) {
    const QuadrupedShape& s = out.shape();
    const int head = out.joints().head;
    const double l = s.horn_length;
    const double r = l * 0.035;
    const auto at = [&](double side, double above, double ahead) {
        return f.place + Vec3(side, above, ahead) * l;
    };
    add_rod(out,
            {{at(-0.02, -0.06, 0.0), r * 1.4},
             {at(0.18, 0.24, -0.20), r * 1.1},
             {at(0.40, 0.55, -0.24), r},
             {at(0.48, 0.82, -0.12), r * 0.8},
             {at(0.44, 1.00, 0.04), r * 0.35}},
            head, s.horn, s.horn_tip);
    const auto tine = [&](const Vec3& from, const Vec3& middle, const Vec3& to) {
        add_rod(out, {{from, r}, {middle, r * 0.8}, {to, r * 0.3}}, head, s.horn, s.horn_tip);
    };
    tine(at(0.05, 0.06, -0.05), at(0.12, 0.14, 0.18), at(0.14, 0.32, 0.34));
    tine(at(0.26, 0.36, -0.23), at(0.36, 0.44, 0.0), at(0.36, 0.62, 0.14));
    tine(at(0.42, 0.62, -0.22), at(0.62, 0.76, -0.30), at(0.72, 0.95, -0.24));
}

void add_head_horn(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const Root f = horn_root(out);
    const int head = out.joints().head;
    const double l = s.horn_length;
    switch (s.horns) {
        case Horns::bull:
            add_rod(out,
                    {{f.at(-0.10 * l, -0.05 * l, 0.0), l * 0.13},
                     {f.at(0.25 * l, 0.06 * l, 0.02 * l), l * 0.12},
                     {f.at(0.58 * l, 0.12 * l, 0.14 * l), l * 0.095},
                     {f.at(0.76 * l, 0.34 * l, 0.28 * l), l * 0.06},
                     {f.at(0.74 * l, 0.62 * l, 0.36 * l), l * 0.02}},
                    head, s.horn, s.horn_tip);
            break;
        case Horns::curled:
            add_rod(out,
                    {{f.at(-0.10 * l, -0.02 * l, 0.0), l * 0.20},
                     {f.at(0.16 * l, 0.18 * l, -0.24 * l), l * 0.20},
                     {f.at(0.36 * l, -0.02 * l, -0.52 * l), l * 0.17},
                     {f.at(0.46 * l, -0.42 * l, -0.44 * l), l * 0.14},
                     {f.at(0.46 * l, -0.58 * l, -0.08 * l), l * 0.10},
                     {f.at(0.56 * l, -0.40 * l, 0.18 * l), l * 0.03}},
                    head, s.horn, s.horn_tip);
            break;
        case Horns::antlers:
            add_antler(out, f);
            break;
        case Horns::knobs:
            add_rod(out,
                    {{f.at(-0.1 * l, -0.2 * l, 0.0), l * 0.16},
                     {f.at(0.02 * l, 0.5 * l, -0.10 * l), l * 0.13},
                     {f.at(0.05 * l, 0.9 * l, -0.18 * l), l * 0.20},
                     {f.at(0.05 * l, 1.05 * l, -0.2 * l), l * 0.16}},
                    head, s.horn, s.horn_tip);
            break;
        default:
            break;
    }
}

void add_tusk(Builder& out) {
    const QuadrupedShape& s = out.shape();
    if (s.tusk_length <= 0.0) return;
    const Vec3 forward = pitch(s.head_drop_degrees) * kAxisZ;
    const double l = s.tusk_length;
    const Vec3 root = out.head_of(out.joints().head) + forward * (s.head_length * 0.72) +
                      Vec3(s.muzzle_radius * 0.85, -s.muzzle_depth * 1.1, 0.0);
    add_rod(out,
            {{root, l * 0.075},
             {root + Vec3(0.05, -0.30, 0.25) * l, l * 0.07},
             {root + Vec3(0.10, -0.45, 0.62) * l, l * 0.055},
             {root + Vec3(0.06, -0.36, 0.98) * l, l * 0.015}},
            out.joints().head, 0xF1E8D2, 0xF7F1E2);
}

void add_trunk_of_head(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const std::vector<int>& trunk = out.joints().trunk;
    if (trunk.empty()) return;
    const Vec3 root = out.head_of(trunk[0]);
    const Vec3 step = out.head_of(trunk[1]) - root;
    const Paint paint{s.face, s.face, s.muzzle};
    Loft loft;
    loft.segments = 12;
    loft.start_cap = 0.0;
    loft.end_cap = 0.0;
    const double r = s.muzzle_radius;
    loft.sections.push_back(
        {root - step * 0.35 - kAxisZ * (r * 0.5), r * 1.05, r, r, out.joints().head, paint, 2});
    for (std::size_t index = 0; index < trunk.size(); ++index) {
        const double thin = r * (0.95 - 0.15 * static_cast<double>(index));
        loft.sections.push_back(
            {out.head_of(trunk[index]) + step * 0.5, thin, thin, thin, trunk[index], paint, 2});
    }
    loft.sections.push_back(
        {out.head_of(trunk.back()) + step, r * 0.38, r * 0.40, r * 0.40, trunk.back(), plain(s.muzzle), 0});
    add_loft(out.mesh, loft);
}

// Hair that stands along the neck from poll to withers, thin across.
void add_crest(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const QuadrupedJoints& j = out.joints();
    const Vec3 along = pitch(-s.neck_rise_degrees) * kAxisZ;
    const Vec3 up = pitch(-s.neck_rise_degrees) * kAxisY;
    const Paint hair = plain(s.mane_colour);
    const double l = s.mane_length;
    Loft loft;
    loft.segments = 10;
    loft.start_cap = 0.0;
    loft.end_cap = l * 0.2;
    const auto stage = [&](double share, double depth, double height, int joint) {
        const Vec3 place = mixed(out.head_of(j.neck[0]), out.head_of(j.head), share) + up * depth;
        loft.sections.push_back({place, l * 0.24, height, height * 0.8, joint, hair, 2});
    };
    const double base = s.neck_base_depth;
    const double top = s.neck_radius;
    stage(-0.25, base * 0.45, l * 0.35, j.spine[2]);
    stage(0.10, base * 0.85, l * 0.75, j.neck[0]);
    stage(0.45, (base + top) * 0.50, l * 0.85, j.neck[1]);
    stage(0.80, top * 1.05, l * 0.80, j.neck[2]);
    stage(1.08, top * 1.10, l * 0.60, j.head);
    loft.sections.push_back(
        {out.head_of(j.head) + along * (s.head_length * 0.22) + up * (s.head_depth * 1.05), l * 0.18,
         l * 0.20, l * 0.25, j.head, hair, 0});
    add_loft(out.mesh, loft);
}

// A ruff round the neck and under the throat, as lions have.
void add_ruff(Builder& out) {
    const QuadrupedShape& s = out.shape();
    const QuadrupedJoints& j = out.joints();
    const Paint hair{s.mane_colour, s.mane_colour, s.mane_colour};
    const double l = s.mane_length;
    Loft loft;
    loft.segments = 18;
    loft.start_cap = 0.0;
    loft.end_cap = 0.0;
    const auto stage = [&](double share, double part, int joint, int rings) {
        const double r = s.neck_radius + l * part;
        const Vec3 place = mixed(out.head_of(j.neck[0]), out.head_of(j.head), share);
        loft.sections.push_back(
            {place - kAxisY * (l * 0.15 * part), r * 0.92, r, r * 1.2, joint, hair, rings});
    };
    stage(-0.35, 0.15, j.spine[2], 2);
    stage(0.05, 0.85, j.neck[0], 2);
    stage(0.45, 1.10, j.neck[1], 2);
    stage(0.85, 1.15, j.neck[2], 2);
    stage(1.06, 0.80, j.head, 1);
    stage(1.14, 0.20, j.head, 0);
    add_loft(out.mesh, loft);
}

}  // namespace

void add_quadruped_extras(SkinBuilder<Quadruped>& out) {
    add_trunk_of_head(out);
    if (out.shape().mane == Mane::crest) add_crest(out);
    if (out.shape().mane == Mane::ruff) add_ruff(out);
}

void add_quadruped_side_extras(SkinBuilder<Quadruped>& out) {
    add_head_horn(out);
    add_tusk(out);
}

}  // namespace posepack::menagerie
