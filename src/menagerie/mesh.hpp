// SPDX-License-Identifier: MIT
// Skinned meshes under construction: vertices with shares of joints, and what is done to whole parts of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "menagerie/rig.hpp"

namespace posepack::menagerie {

using Colour = std::uint32_t;  // 0xRRGGBB, sRGB

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

// What a part cost, to mirror or blend it afterwards: everything from these counts on.
struct Mark {
    std::size_t vertex_count = 0;
    std::size_t index_count = 0;
};

Mark mark(const Mesh& mesh);

// Linear light, 0..1.
Vec3 linear_colour(Colour colour);

// Between two colours or places.
Vec3 mixed(const Vec3& a, const Vec3& b, double share);

Influences one_influence(int joint);

// Raises a joint's weight; the sum is the caller's concern. At most four joints take part.
void add_share(Influences& influences, int joint, double share);

// Counter-clockwise seen from outside.
void add_triangle(Mesh& mesh, std::size_t a, std::size_t b, std::size_t c);

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

// The triangles that follow `joint` most, in that joint's axes at rest: what a model without a skin hangs
// under its node. Vertices on a border belong to both sides.
Mesh rigid_part(const Mesh& mesh, const Rig& rig, int joint);

}  // namespace posepack::menagerie
