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

struct BoneMoment {
    // S divided by its last element, symmetric: the last row is the centroid (weighted by w^2) and 1.
    std::array<std::array<double, 4>, 4> square{};
    double radius = 0.0;  // largest distance of a vertex from the centroid; 0 without vertices

    glm::dvec3 centroid() const { return {square[3][0], square[3][1], square[3][2]}; }
    // d' S d: what a row of E costs.
    double cost(const std::array<double, 4>& d) const;
};

// Moments of every bone over the different vertices of an animal, in palette space. A bone without vertices
// counts as a ball of half the animal's size about the origin, so that what hangs from it is treated fairly.
//   reach  R in units of palette space
std::vector<BoneMoment> bone_moments(const motion::SkinSet& points, const Spaces& spaces,
                                     std::size_t bone_count, double reach);

}  // namespace posepack::palette
