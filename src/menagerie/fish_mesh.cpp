// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "menagerie/fish.hpp"
#include "menagerie/skin_builder.hpp"

namespace posepack::menagerie {
namespace {

using Builder = SkinBuilder<Fish>;

// Places along the body: `along` 0 at the snout, 1 at the root of the tail fin.
Vec3 station(const Builder& out, double along, double above = 0.0) {
    return {0.0, out.shape().swim_height + above, out.shape().length * (0.45 - along)};
}

// Spots on the back and flanks: three rows, staggered.
void add_spots(Builder& out, const Mark& from) {
    const FishShape& s = out.shape();
    for (int row = 0; row < 3; ++row) {
        for (int index = 0; index < 13; ++index) {
            const double along = 0.26 + 0.054 * index + 0.027 * (row % 2);
            const double fade = 1.0 - 0.75 * (along - 0.3);
            const double above = s.body_depth * fade * (0.82 - 0.30 * row);
            for (const double side : {1.0, -1.0}) {
                const Vec3 spot =
                    station(out, along, above) + kAxisX * (side * s.body_radius * fade * (0.42 + 0.26 * row));
                tint(out.mesh, from, s.spot, spot, s.body_depth * 0.20, 0.95);
            }
        }
    }
}

void add_body(Builder& out) {
    const FishShape& s = out.shape();
    const FishJoints& j = out.joints();
    const double w = s.body_radius;
    const double d = s.body_depth;
    const auto spine = [&j](double share) {
        return j.spine[static_cast<std::size_t>(share * (static_cast<double>(j.spine.size()) - 0.01))];
    };
    const Paint coat{s.back, s.band, s.belly};
    const Paint head{s.back, s.side, s.belly};
    Loft loft;
    loft.segments = 24;
    loft.start_cap = 0.002;
    loft.end_cap = w * 0.10;
    loft.sections = {
        {station(out, 1.02), w * 0.10, s.tail_depth * 1.05, s.tail_depth * 1.05, j.tail_fin, coat, 2},
        {station(out, 0.95), w * 0.22, s.tail_depth, s.tail_depth, spine(1.0), coat, 3},
        {station(out, 0.86), w * 0.40, d * 0.38, d * 0.38, spine(0.8), coat, 3},
        {station(out, 0.76), w * 0.62, d * 0.56, d * 0.60, spine(0.62), coat, 3},
        {station(out, 0.66), w * 0.80, d * 0.74, d * 0.80, spine(0.45), coat, 3},
        {station(out, 0.55), w * 0.94, d * 0.90, d * 0.95, spine(0.25), coat, 4},
        {station(out, 0.44), w, d * 0.97, d, spine(0.0), coat, 4},
        {station(out, 0.32), w * 0.98, d * 0.90, d * 0.94, j.body, coat, 4},
        {station(out, 0.22), w * 0.90, d * 0.76, d * 0.80, j.body, head, 3},
        {station(out, 0.14, d * 0.02), w * 0.78, d * 0.62, d * 0.62, j.head, head, 3},
        {station(out, 0.06, d * 0.04), w * 0.56, d * 0.42, d * 0.32, j.head, head, 3},
        {station(out, 0.01, d * 0.02), w * 0.30, d * 0.20, d * 0.14, j.head, head, 0}};
    const Mark from = mark(out.mesh);
    add_loft(out.mesh, loft);
    for (int side = 0; side < 2; ++side) {
        attract(out.mesh, from, j.gill + side, out.head_of(j.gill + side) - kAxisZ * (s.length * 0.02),
                s.length * 0.055, 0.8);
    }
    add_spots(out, from);
}

void add_jaw(Builder& out) {
    const FishShape& s = out.shape();
    const FishJoints& j = out.joints();
    const double w = s.body_radius;
    const double d = s.body_depth;
    Loft loft;
    loft.segments = 10;
    loft.start_cap = 0.0;
    loft.end_cap = w * 0.06;
    loft.sections = {{station(out, 0.14, -d * 0.26), w * 0.58, d * 0.22, d * 0.26, j.head, plain(s.belly), 2},
                     {station(out, 0.075, -d * 0.20), w * 0.46, d * 0.12, d * 0.17, j.jaw, plain(s.belly), 2},
                     {station(out, 0.005, -d * 0.13), w * 0.22, d * 0.06, d * 0.08, j.jaw, plain(s.side), 0}};
    add_loft(out.mesh, loft);
}

// A fin: a flat body from its root line to its edge.
struct Fin {
    Vec3 root{}, way{}, side{};
    double root_half = 0.0, middle_half = 0.0,
           tip_half = 0.0;  // half lengths of its root line, middle and edge
    int owner = 0, joint = 0, tip_joint = 0;
};

void add_fin(Builder& out, const Fin& fin) {
    const FishShape& s = out.shape();
    const double t = s.body_radius * 0.055;
    Loft loft;
    loft.side =
        glm::normalize(fin.side - fin.way * (glm::dot(fin.side, fin.way) / glm::dot(fin.way, fin.way)));
    loft.segments = 12;
    loft.start_cap = 0.0;
    loft.end_cap = t;
    loft.sections = {
        {fin.root - fin.way * 0.06, fin.root_half, t * 2.0, t * 2.0, fin.owner, plain(s.fin), 2},
        {fin.root + fin.way * 0.35, fin.middle_half, t * 1.4, t * 1.4, fin.joint, plain(s.fin), 2},
        {fin.root + fin.way * 0.75, (fin.middle_half + fin.tip_half) * 0.5, t, t, fin.tip_joint, plain(s.fin),
         1},
        {fin.root + fin.way, fin.tip_half, t * 0.4, t * 0.4, fin.tip_joint, plain(s.fin_tip), 0}};
    add_loft(out.mesh, loft);
}

void add_middle_fins(Builder& out) {
    const FishShape& s = out.shape();
    const FishJoints& j = out.joints();
    const double h = s.dorsal_height;
    const double l = s.dorsal_length;
    add_fin(out, {out.head_of(j.dorsal[0]) - kAxisZ * (l * 0.30),
                  {0.0, h, -l * 0.36},
                  kAxisZ,
                  l * 0.50,
                  l * 0.38,
                  l * 0.20,
                  j.spine[0],
                  j.dorsal[0],
                  j.dorsal[1]});
    add_fin(out, {out.head_of(j.adipose),
                  {0.0, h * 0.45, -h * 0.42},
                  kAxisZ,
                  h * 0.22,
                  h * 0.18,
                  h * 0.12,
                  j.spine[j.spine.size() - 2],
                  j.adipose,
                  j.adipose});
    add_fin(out, {out.head_of(j.anal),
                  {0.0, -h * 0.72, -h * 0.40},
                  kAxisZ,
                  l * 0.30,
                  l * 0.24,
                  l * 0.13,
                  j.spine[j.spine.size() - 3],
                  j.anal,
                  j.anal});
    const double f = s.tail_fin_length;
    add_fin(out, {station(out, 0.99),
                  {0.0, 0.0, -f * 0.62},
                  kAxisY,
                  s.tail_depth * 0.9,
                  s.tail_depth * 1.5,
                  s.tail_depth * 1.3,
                  j.spine.back(),
                  j.tail_fin,
                  j.tail_fin});
    for (const double side : {1.0, -1.0}) {
        const int lobe = side > 0.0 ? j.tail_upper : j.tail_lower;
        add_fin(out, {station(out, 0.99, side * s.tail_depth * 0.35),
                      {0.0, side * s.tail_fin_spread * 0.92, -f},
                      {0.0, 1.0, 0.35 * side},
                      s.tail_depth * 0.75,
                      s.tail_depth * 1.35,
                      s.tail_depth * 0.95,
                      j.spine.back(),
                      j.tail_fin,
                      lobe});
    }
}

void add_side_fins(Builder& out) {
    const FishShape& s = out.shape();
    const FishJoints& j = out.joints();
    const double p = s.pectoral_length;
    add_fin(out, {out.head_of(j.pectoral[0]),
                  Vec3(0.62, -0.30, -0.72) * p,
                  {0.0, -0.75, -0.55},
                  p * 0.14,
                  p * 0.27,
                  p * 0.20,
                  j.body,
                  j.pectoral[0],
                  j.pectoral[1]});
    const double v = s.pelvic_length;
    add_fin(out, {out.head_of(j.pelvic),
                  Vec3(0.35, -0.55, -0.75) * v,
                  {0.2, 0.5, -0.8},
                  v * 0.16,
                  v * 0.26,
                  v * 0.18,
                  j.spine[1],
                  j.pelvic,
                  j.pelvic});
    Ellipsoid eye;
    const double r = s.body_depth * 0.15;
    eye.centre = out.head_of(j.eye) - kAxisX * (r * 0.42);
    eye.radii = {r, r, r * 0.8};
    eye.turn = yaw(80.0) * pitch(-8.0);
    eye.segments = 10;
    eye.colour = s.iris;
    eye.tip_colour = s.eye;
    eye.joint = j.eye;
    add_ellipsoid(out.mesh, eye);
}

}  // namespace

Mesh fish_mesh(const Fish& animal) {
    Builder out{animal, {}};
    add_body(out);
    add_jaw(out);
    add_middle_fins(out);
    const Mark sides = mark(out.mesh);
    add_side_fins(out);
    add_mirror_image(out.mesh, animal.rig, sides);
    finish(out.mesh);
    return std::move(out.mesh);
}

}  // namespace posepack::menagerie
