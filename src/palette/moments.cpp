// SPDX-License-Identifier: MIT
#include "palette/moments.hpp"

#include <algorithm>
#include <cmath>

namespace posepack::palette {
namespace {

// f(bone, weight, point) for every influence of every vertex, points in palette space.
template <class F>
void for_each_influence(const motion::SkinSet& points, const Spaces& spaces, F f) {
    for (std::size_t n = 1; n + 1 < points.first.size(); ++n)
        for (std::uint32_t i = points.first[n]; i < points.first[n + 1]; ++i) {
            const glm::dvec3 point(points.vectors[i][0], points.vectors[i][1], points.vectors[i][2]);
            for (std::size_t k = 0; k < n; ++k) {
                const std::size_t bone = points.bones[i][k];
                f(bone, static_cast<double>(points.weights[i][k]), spaces.bone_entry(bone) * point);
            }
        }
}

}  // namespace

double BoneMoment::cost(const std::array<double, 4>& d) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
        sum += d[i] * (square[i][0] * d[0] + square[i][1] * d[1] + square[i][2] * d[2] + square[i][3] * d[3]);
    return sum;
}

std::vector<BoneMoment> bone_moments(const motion::SkinSet& points, const Spaces& spaces,
                                     std::size_t bone_count, double reach) {
    std::vector<BoneMoment> moments(bone_count);
    for_each_influence(points, spaces, [&](std::size_t bone, double weight, const glm::dvec3& p) {
        const std::array<double, 4> v{p.x, p.y, p.z, 1.0};
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t c = 0; c < 4; ++c) moments[bone].square[r][c] += weight * weight * v[r] * v[c];
    });
    for (BoneMoment& moment : moments) {
        const double total = moment.square[3][3];
        if (total > 0.0) {
            for (auto& row : moment.square)
                for (double& element : row) element /= total;
        } else {
            // The mean square along an axis of a ball of radius a is a^2 / 5.
            for (std::size_t i = 0; i < 3; ++i) moment.square[i][i] = 0.05 * reach * reach;
            moment.square[3][3] = 1.0;
        }
    }
    for_each_influence(points, spaces, [&](std::size_t bone, double, const glm::dvec3& p) {
        const glm::dvec3 away = p - moments[bone].centroid();
        moments[bone].radius = std::max(moments[bone].radius, std::sqrt(glm::dot(away, away)));
    });
    return moments;
}

}  // namespace posepack::palette
