// SPDX-License-Identifier: MIT
// Skinned meshes from lofts (rings along a path) and ellipsoids. A body is authored as a few sections, each
// with a joint that owns it; the rings between two sections share their joints' weights smoothly.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "menagerie/rig.hpp"

namespace posepack::menagerie {

using Colour = std::uint32_t;  // 0xRRGGBB, sRGB

// The colours of a ring: along its upper, middle and lower line.
struct Paint {
    Colour back = 0x808080;
    Colour side = 0x808080;
    Colour belly = 0x808080;
};

// One hue all round.
Paint plain(Colour colour);

// Up to four joints and their shares, which sum to one.
struct Influences {
    std::array<int, 4> joints{};
    std::array<double, 4> weights{};
};

struct Vertex {
    Vec3 position{};
    Vec3 normal{};
    Vec3 colour{};  // linear, 0..1
    Influences influences;
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> indices;  // triangles, counter-clockwise seen from outside
};

// A cross-section of a loft. With the path along t and the loft's side vector s, "up" is t x s.
struct Section {
    Vec3 centre{};
    double half_width = 0.0;  // along the side vector, metres
    double up = 0.0;          // from the centre upwards and downwards
    double down = 0.0;
    int joint = 0;
    Paint paint;
    int rings = 2;  // rings from here up to, not including, the next section
};

struct Loft {
    std::vector<Section> sections;  // at least two
    Vec3 side = kAxisX;
    int segments = 12;                // vertices of a ring
    std::optional<double> start_cap;  // how far the closing point stands out, metres; nothing: left open
    std::optional<double> end_cap;
};

struct Ellipsoid {
    Vec3 centre{};
    Vec3 radii{};  // along X, Y, Z before the turn
    Quat turn = kNoTurn;
    int segments = 8;
    int rings = 3;          // between the two poles, which lie on the ellipsoid's Z axis
    Colour colour = 0;      // from the equator on
    Colour tip_colour = 0;  // towards +Z (an iris)
    int joint = 0;
};

// What a part cost, to mirror or blend it afterwards: everything from these counts on.
struct Mark {
    std::size_t vertex_count = 0;
    std::size_t index_count = 0;
};

Mark mark(const Mesh& mesh);

// Appends segments x rings vertices, and one for each closed end.
void add_loft(Mesh& mesh, const Loft& loft);

// Appends segments x rings + 2 vertices.
void add_ellipsoid(Mesh& mesh, const Ellipsoid& ellipsoid);

// Appends the mirror image of everything since `from`, on the mirrored joints.
void add_mirror_image(Mesh& mesh, const Rig& rig, const Mark& from);

// Hands a share of the weights of the vertices since `from` to `joint`: `share` at `centre`, falling smoothly
// to nothing at `radius` metres. The smallest of five influences gives way.
void attract(Mesh& mesh, const Mark& from, int joint, const Vec3& centre, double radius, double share);

// Blends the colours of the vertices since `from` to `colour` in the same way.
void tint(Mesh& mesh, const Mark& from, Colour colour, const Vec3& centre, double radius, double share);

// Fills in the normals, smooth over shared vertices, and rounds the weights to multiples of 1/65536 that sum
// to exactly one. Call once, last.
void finish(Mesh& mesh);

}  // namespace posepack::menagerie
