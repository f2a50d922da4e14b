// SPDX-License-Identifier: MIT
#include "measure/skin_difference.hpp"

#include <cmath>

namespace posepack::measure {
namespace {

inline void keep_largest(const Lanes& value, std::uint32_t entry, LaneWorst& worst) {
    for (std::size_t l = 0; l < kLanes; ++l) {
        const bool larger = value[l] > worst.value[l];
        worst.value[l] = larger ? value[l] : worst.value[l];
        worst.entry[l] = larger ? entry : worst.entry[l];
    }
}

}  // namespace

LaneWorst measure_points(const motion::SkinSet& set, const LaneMatrices& difference, std::size_t lane_count,
                         Histogram& histogram, double& sum) {
    LaneWorst worst;
    std::array<double, kLanes> sums{};
    for (std::size_t influences = 1; influences + 1 < set.first.size(); ++influences)
        for (std::uint32_t i = set.first[influences]; i < set.first[influences + 1]; ++i) {
            const Lanes square = squared_distances(set, i, influences, difference);
            for (std::size_t l = 0; l < kLanes; ++l) sums[l] += static_cast<double>(square[l]);
            keep_largest(square, i, worst);
            for (std::size_t l = 0; l < lane_count; ++l) histogram.add(square[l]);
        }
    for (std::size_t l = 0; l < lane_count; ++l) sum += sums[l];
    return worst;
}

LaneWorst largest_points(const motion::SkinSet& set, const LaneMatrices& difference) {
    LaneWorst worst;
    for (std::size_t influences = 1; influences + 1 < set.first.size(); ++influences)
        for (std::uint32_t i = set.first[influences]; i < set.first[influences + 1]; ++i)
            keep_largest(squared_distances(set, i, influences, difference), i, worst);
    return worst;
}

LaneWorst measure_normals(const motion::SkinSet& set, const LaneMatrices& difference,
                          const LaneMatrices& exact, std::size_t lane_count, Histogram& histogram) {
    LaneWorst worst;
    for (std::size_t influences = 1; influences + 1 < set.first.size(); ++influences)
        for (std::uint32_t i = set.first[influences]; i < set.first[influences + 1]; ++i) {
            Lanes dx{}, dy{}, dz{}, ex{}, ey{}, ez{}, square{};
            for (std::size_t k = 0; k < influences; ++k) {
                const float* d = &difference.values[std::size_t{set.bones[i][k]} * 12 * kLanes];
                const float* e = &exact.values[std::size_t{set.bones[i][k]} * 9 * kLanes];
                const float wx = set.weights[i][k] * set.vectors[i][0];
                const float wy = set.weights[i][k] * set.vectors[i][1];
                const float wz = set.weights[i][k] * set.vectors[i][2];
                add_row(d, wx, wy, wz, dx);
                add_row(d + 4 * kLanes, wx, wy, wz, dy);
                add_row(d + 8 * kLanes, wx, wy, wz, dz);
                add_row(e, wx, wy, wz, ex);
                add_row(e + 3 * kLanes, wx, wy, wz, ey);
                add_row(e + 6 * kLanes, wx, wy, wz, ez);
            }
            for (std::size_t l = 0; l < kLanes; ++l) {
                // With a = E n and b = (E + D) n: a x b = a x D n, without cancellation for small D.
                const float cx = ey[l] * dz[l] - ez[l] * dy[l];
                const float cy = ez[l] * dx[l] - ex[l] * dz[l];
                const float cz = ex[l] * dy[l] - ey[l] * dx[l];
                const float cross = cx * cx + cy * cy + cz * cz;
                const float bx = ex[l] + dx[l], by = ey[l] + dy[l], bz = ez[l] + dz[l];
                const float dot = ex[l] * bx + ey[l] * by + ez[l] * bz;
                const float lengths = std::sqrt(ex[l] * ex[l] + ey[l] * ey[l] + ez[l] * ez[l]) *
                                      std::sqrt(bx * bx + by * by + bz * bz);
                // tan(angle / 2) = |a x b| / (|a||b| + a.b) = (|a||b| - a.b) / |a x b|: the one that adds.
                const float sum = lengths + std::abs(dot);
                const float half = dot >= 0.0f ? cross / (sum * sum) : sum * sum / cross;
                // Written so that NaN (0 / 0: a normal that vanishes) and infinity end as a straight angle.
                square[l] = half < kStraightAngle ? half : kStraightAngle;
            }
            keep_largest(square, i, worst);
            for (std::size_t l = 0; l < lane_count; ++l) histogram.add(square[l]);
        }
    return worst;
}

}  // namespace posepack::measure
