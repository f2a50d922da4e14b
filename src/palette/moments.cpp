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

std::vector<BoneMoment> bone_moments(const motion::SkinSet& points, const Spaces& spaces,
                                     std::size_t bone_count, double reach) {
    std::vector<BoneMoment> moments(bone_count);
    std::vector<double> totals(bone_count);
    for_each_influence(points, spaces, [&](std::size_t bone, double weight, const glm::dvec3& p) {
        moments[bone].centroid += weight * weight * p;
        totals[bone] += weight * weight;
    });
    for (std::size_t b = 0; b < bone_count; ++b)
        if (totals[b] > 0.0) moments[b].centroid /= totals[b];
    for_each_influence(points, spaces, [&](std::size_t bone, double weight, const glm::dvec3& p) {
        BoneMoment& moment = moments[bone];
        const glm::dvec3 away = p - moment.centroid;
        const std::array<double, 6> products{away.x * away.x, away.y * away.y, away.z * away.z,
                                             away.x * away.y, away.x * away.z, away.y * away.z};
        for (std::size_t i = 0; i < 6; ++i) moment.spread[i] += weight * weight * products[i];
        moment.radius = std::max(moment.radius, std::sqrt(glm::dot(away, away)));
    });
    for (std::size_t b = 0; b < bone_count; ++b) {
        // The mean square along an axis of a ball of radius a is a^2 / 5.
        const double ball = 0.05 * reach * reach;
        if (totals[b] > 0.0)
            for (double& element : moments[b].spread) element /= totals[b];
        else
            moments[b].spread = {ball, ball, ball, 0.0, 0.0, 0.0};
    }
    return moments;
}

}  // namespace posepack::palette
