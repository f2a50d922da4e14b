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

// One value at each of the times.
using Lanes = std::array<float, kLanes>;

// Element e of bone b at time t lies at [(b * elements + e) * kLanes + t].
struct LaneMatrices {
    std::vector<float> values;
};

// The largest value seen at each time, and where.
struct LaneWorst {
    Lanes value{};
    std::array<std::uint32_t, kLanes> entry{};
};

// sum += (m[0] x + m[1] y + m[2] z) of a weighted vector, lane by lane. `m` points at three elements of a
// row.
inline void add_row(const float* m, float wx, float wy, float wz, Lanes& sum) {
    for (std::size_t l = 0; l < kLanes; ++l)
        sum[l] += m[l] * wx + m[kLanes + l] * wy + m[2 * kLanes + l] * wz;
}

// sum += w m, lane by lane.
inline void add_scaled(const float* m, float w, Lanes& sum) {
    for (std::size_t l = 0; l < kLanes; ++l) sum[l] += m[l] * w;
}

// Squared distances |D p|^2 of entry `i` of `set`, which has `influences` influences: what measure_points
// adds up. Here, so that every measurement of a point rounds alike.
inline Lanes squared_distances(const motion::SkinSet& set, std::uint32_t i, std::size_t influences,
                               const LaneMatrices& difference) {
    Lanes x{}, y{}, z{}, square{};
    for (std::size_t k = 0; k < influences; ++k) {
        const float* m = &difference.values[std::size_t{set.bones[i][k]} * 12 * kLanes];
        const float w = set.weights[i][k];
        const float wx = w * set.vectors[i][0];
        const float wy = w * set.vectors[i][1];
        const float wz = w * set.vectors[i][2];
        add_row(m, wx, wy, wz, x);
        add_scaled(m + 3 * kLanes, w, x);
        add_row(m + 4 * kLanes, wx, wy, wz, y);
        add_scaled(m + 7 * kLanes, w, y);
        add_row(m + 8 * kLanes, wx, wy, wz, z);
        add_scaled(m + 11 * kLanes, w, z);
    }
    for (std::size_t l = 0; l < kLanes; ++l) square[l] = x[l] * x[l] + y[l] * y[l] + z[l] * z[l];
    return square;
}

// Squared distances |D p|^2 for every point of `set` under the difference `difference` (12 elements a bone,
// 3x4 row-major), at the first `lane_count` times. Adds them to `histogram` and to `sum`.
LaneWorst measure_points(const motion::SkinSet& set, const LaneMatrices& difference, std::size_t lane_count,
                         Histogram& histogram, double& sum);

// The largest of the same, and nothing else.
LaneWorst largest_points(const motion::SkinSet& set, const LaneMatrices& difference);

// Squared tangents of half the angle between E n and (E + D) n for every normal of `set`; E is `exact` (9
// elements a bone, row-major 3x3), D is `difference` as above. They rise with the angle from 0 to 180
// degrees; opposite normals, and those that vanish, count as kStraightAngle.
inline constexpr float kStraightAngle = 1e30f;
LaneWorst measure_normals(const motion::SkinSet& set, const LaneMatrices& difference,
                          const LaneMatrices& exact, std::size_t lane_count, Histogram& histogram);

}  // namespace posepack::measure
