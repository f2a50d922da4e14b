// SPDX-License-Identifier: MIT
// The inner loops of the measurement: how far a difference of matrices moves every vertex, and how far it
// turns every normal, at several times at once.
//
// Skinning is linear in the matrices, so the error of a vertex is the skinned difference of the matrices,
// taken once in double precision and then skinned in float: its relative error is that of a float.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "measure/histogram.hpp"
#include "motion/skin_set.hpp"

namespace posepack::measure {

inline constexpr std::size_t kLanes = 8;  // times measured together

// Element e of bone b at time t lies at [(b * elements + e) * kLanes + t].
struct LaneMatrices {
    std::vector<float> values;
};

// The largest value seen at each time, and where.
struct LaneWorst {
    std::array<float, kLanes> value{};
    std::array<std::uint32_t, kLanes> entry{};
};

// Squared distances |D p|^2 for every point of `set` under the difference `difference` (12 elements a bone,
// 3x4 row-major), at the first `lane_count` times. Adds them to `histogram` and to `sum`.
LaneWorst measure_points(const motion::SkinSet& set, const LaneMatrices& difference, std::size_t lane_count,
                         Histogram& histogram, double& sum);

// Squared tangents of half the angle between E n and (E + D) n for every normal of `set`; E is `exact` (9
// elements a bone, row-major 3x3), D is `difference` as above. They rise with the angle from 0 to 180
// degrees; opposite normals, and those that vanish, count as kStraightAngle.
inline constexpr float kStraightAngle = 1e30f;
LaneWorst measure_normals(const motion::SkinSet& set, const LaneMatrices& difference,
                          const LaneMatrices& exact, std::size_t lane_count, Histogram& histogram);

}  // namespace posepack::measure
