// SPDX-License-Identifier: MIT
// Sine, cosine and arc tangent from our own polynomials: the C library's differ from host to host, and
// these values reach the bytes of a palette. Only + - * / and sqrt are used; build with contraction off.
#pragma once

namespace posepack::base {

inline constexpr double kPi = 3.14159265358979323846;

// sin(x), absolute error below 4e-16 for |x| <= 64 pi; x in radians.
double sine(double x);

// cos(x), same range and error.
double cosine(double x);

// atan(x) for 0 <= x <= 1, absolute error below 3e-16; result in radians, in [0, pi/4].
double arc_tangent_unit(double x);

// atan(x) for any x >= 0, infinity too; absolute error below 6e-16, in radians.
double arc_tangent(double x);

}  // namespace posepack::base
