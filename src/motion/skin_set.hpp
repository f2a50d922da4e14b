// SPDX-License-Identifier: MIT
// SkinSet: the different vertices of an animal, each once, in the order that skinning likes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "animal/animal.hpp"
#include "motion/affine.hpp"

namespace posepack::motion {

// Vectors with their influences, grouped by how many influences they have: entries
// [first[n], first[n + 1]) have exactly n.
struct SkinSet {
    std::vector<std::array<float, 3>> vectors;  // points, or directions
    std::vector<animal::InfluenceBones> bones;
    std::vector<animal::InfluenceWeights> weights;
    std::vector<std::uint32_t> vertices;  // the first vertex of the animal that each entry stands for
    std::array<std::uint32_t, animal::kMaxInfluences + 2> first{};

    std::size_t size() const { return vectors.size(); }
};

// Different (position, bones, weights), positions as the bones bind them: where a skin is folded, behind its
// X. Vertices of different folds are different.
SkinSet unique_points(const animal::Animal& animal);

// Different (normal, bones, weights), without zero normals; behind the linear part of X where a skin is
// folded.
SkinSet unique_normals(const animal::Animal& animal);

// Points of `set` under linear blend skinning: the sum of weight x bone x point.
//   bones  one map for every bone of the animal
//   out    set.size() points
void skin(const SkinSet& set, std::span<const Affine> bones, std::span<glm::dvec3> out);

struct Sphere {
    glm::dvec3 center{0.0};
    double radius = 0.0;
};

// The smallest sphere around `points` whose center is that of their axis-aligned box.
Sphere sphere_around(std::span<const glm::dvec3> points);

}  // namespace posepack::motion
