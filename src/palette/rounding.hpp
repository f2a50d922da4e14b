// SPDX-License-Identifier: MIT
// Rounding to halves that a bone's vertices notice least: docs/encodings/affine.md and dualquat.md.
#pragma once

#include <cmath>
#include <span>

#include "motion/affine.hpp"
#include "palette/moments.hpp"
#include "palette/similarity.hpp"

namespace posepack::palette {

// Which halves may be written. Where an animal is normalised, subnormal halves (below 2^-14) are left out:
// some GPUs read them as zero, and there they are worth nothing.
enum class Halves { all, normal };

// The twelve halves of a 3x4 matrix as floats, row by row: in each row the three entries are rounded up or
// down and the translation follows, whichever of the eight ways costs least. Values that no half holds stay
// beyond 65504.
void round_affine(const motion::Affine& matrix, const BoneMoment& moment, Halves allowed,
                  std::span<float, 12> rounded);

// The eight halves of a dual quaternion with scale (src/format/dualquat.h), as floats. The real part is
// rounded first, at several lengths from 1 down to 1 - `span`; the translation is then that which keeps the
// centroid of the vertices in place under the rounded rotation; of the results the one that costs least is
// kept. Values that no half holds stay beyond 65504.
//   exact   the matrix that is meant
//   target  its nearest similarity, in the hemisphere wanted
//   length  L
//   enough  mean square of the distances, squared units of palette space, above which more lengths are tried,
//           each with the dual part rounded up and down in all ways
inline constexpr double kRealSpan = 0.004;
void round_dualquat(const motion::Affine& exact, const Similarity& target, const BoneMoment& moment,
                    double length, Halves allowed, std::span<float, 8> rounded, double enough = HUGE_VAL,
                    double span = kRealSpan);

// The eight numbers before rounding, real part of length 1.
void dualquat_numbers(const Similarity& target, double length, std::span<double, 8> numbers);

}  // namespace posepack::palette
