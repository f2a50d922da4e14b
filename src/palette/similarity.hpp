// SPDX-License-Identifier: MIT
// Affine maps as similarities: a rotation, a signed uniform scale and a translation. No function of the C
// library but sqrt takes part, so that results are the same on every host.
#pragma once

#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "motion/affine.hpp"

namespace posepack::palette {

// p' = scale * rotation * p + translation.
struct Similarity {
    glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0};  // unit quaternion x y z w
    double scale = 1.0;                       // negative for a mirrored map
    glm::dvec3 translation{0.0};
};

// Root of the mean square of the singular values, with the sign of the determinant.
double signed_scale(const glm::dmat3& linear);

// The similarity nearest to `map`: the orthogonal part of its polar decomposition, and signed_scale().
//   fallback  the rotation where there is none to see, because the map shrinks everything to a point or folds
//   it
Similarity nearest_similarity(const motion::Affine& map, const glm::dvec4& fallback);

// The 3x3 rotation of a quaternion of any length but zero.
glm::dmat3 rotation_matrix(const glm::dvec4& quaternion);

// The largest and the smallest singular value of a 3x3 matrix.
struct Stretch {
    double largest = 0.0, smallest = 0.0;
    double ratio() const { return smallest > 0.0 ? largest / smallest : HUGE_VAL; }
};
Stretch stretch_of(const glm::dmat3& linear);

}  // namespace posepack::palette
