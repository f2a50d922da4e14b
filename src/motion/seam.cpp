// SPDX-License-Identifier: MIT
#include "motion/seam.hpp"

#include <algorithm>
#include <cmath>

namespace posepack::motion {
namespace {

double largest_distance(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b) {
    double square = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) square = std::max(square, glm::dot(a[i] - b[i], a[i] - b[i]));
    return std::sqrt(square);
}

}  // namespace

SeamMeasure measure_seam(ClipSampler& sampler, const SkinSet& points, std::size_t bone_count,
                         double duration_s, double step_s) {
    std::vector<Affine> bones(bone_count);
    const auto pose = [&](double time_s) {
        std::vector<glm::dvec3> posed(points.size());
        sampler.sample(time_s, bones);
        skin(points, bones, posed);
        return posed;
    };
    const auto first = pose(0.0);
    const auto after_first = pose(std::min(step_s, duration_s));
    const auto before_last = pose(std::max(0.0, duration_s - step_s));
    const auto last = pose(duration_s);
    return {largest_distance(first, last),
            0.5 * (largest_distance(first, after_first) + largest_distance(before_last, last))};
}

}  // namespace posepack::motion
