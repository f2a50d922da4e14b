// SPDX-License-Identifier: MIT
// A second evaluation of glTF animations, slow and plain, in long double with the C library's functions:
// what the sampler and the measurement are compared with. Shares no code with either.
#pragma once

#include <array>
#include <vector>

#include "animal/animal.hpp"

namespace posepack::support {

using Real = long double;
using Matrix34 = std::array<Real, 12>;  // 3x4, row-major
using Point = std::array<Real, 3>;

Matrix34 multiply(const Matrix34& a, const Matrix34& b);
Point transform(const Matrix34& m, const Point& p);

// T * R * S.
Matrix34 matrix_of(const Point& translation, const std::array<Real, 4>& rotation, const Point& scale);

// Skinning matrices of every bone at `time_s` seconds after the first key of the clip (glTF 2.0 appendix C).
std::vector<Matrix34> naive_bones(const animal::Animal& animal, const animal::Clip& clip, Real time_s);

// Vertex or normal `vertex` of the animal under these bones; a normal is not made unit length.
Point naive_point(const animal::Animal& animal, std::size_t vertex, const std::vector<Matrix34>& bones);
Point naive_normal(const animal::Animal& animal, std::size_t vertex, const std::vector<Matrix34>& bones);

// A spherical interpolation by the textbook: sin((1 - u) a) / sin(a), along the shorter arc.
std::array<Real, 4> naive_slerp(std::array<Real, 4> from, std::array<Real, 4> to, Real u);

}  // namespace posepack::support
