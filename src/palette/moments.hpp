// SPDX-License-Identifier: MIT
// What the vertices of a bone make of an error of its matrix.
//
// A matrix that is wrong by E (3x4) moves a vertex p with weight w by w E [p; 1]; the squares of that, summed
// over the vertices, are tr(E S E') with S = sum of w^2 [p; 1][p; 1]'. Rounding is chosen to make that small.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "motion/skin_set.hpp"
#include "palette/spaces.hpp"

namespace posepack::palette {

// S is kept divided by its last element, as the centroid of the points and their spread about it.
struct BoneMoment {
    glm::dvec3 centroid{0.0};        // weighted by w^2
    std::array<double, 6> spread{};  // mean squares about the centroid, by w^2: xx, yy, zz, xy, xz, yz
    double radius = 0.0;             // largest distance of a vertex from the centroid; 0 without vertices

    // What a row d of E costs as seen about the centroid, when the translation keeps the centroid in place.
    double spread_cost(double x, double y, double z) const {
        return x * (spread[0] * x + 2.0 * (spread[3] * y + spread[4] * z)) +
               y * (spread[1] * y + 2.0 * spread[5] * z) + spread[2] * z * z;
    }
    // d' S d: what a row of E costs.
    double cost(const std::array<double, 4>& d) const {
        const double at_centroid = d[0] * centroid.x + d[1] * centroid.y + d[2] * centroid.z + d[3];
        return spread_cost(d[0], d[1], d[2]) + at_centroid * at_centroid;
    }
};

// Moments of every bone over the different vertices of an animal, in palette space. A bone without vertices
// counts as a ball of half the animal's size about the origin, so that what hangs from it is treated fairly.
//   reach  R in units of palette space
std::vector<BoneMoment> bone_moments(const motion::SkinSet& points, const Spaces& spaces,
                                     std::size_t bone_count, double reach);

}  // namespace posepack::palette
