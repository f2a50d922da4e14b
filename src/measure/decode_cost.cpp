// SPDX-License-Identifier: MIT
#include "measure/decode_cost.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include "posepack/loader.h"

namespace posepack::measure {
namespace {

using Point = std::array<float, 3>;

void skin_floats(const motion::SkinSet& set, std::span<const float> matrices, std::vector<Point>& out) {
    for (std::size_t n = 1; n + 1 < set.first.size(); ++n)
        for (std::uint32_t i = set.first[n]; i < set.first[n + 1]; ++i) {
            const Point& p = set.vectors[i];
            Point sum{};
            for (std::size_t k = 0; k < n; ++k) {
                const float* m = &matrices[std::size_t{set.bones[i][k]} * 12];
                const float w = set.weights[i][k];
                for (std::size_t r = 0; r < 3; ++r)
                    sum[r] +=
                        w * (m[r * 4] * p[0] + m[r * 4 + 1] * p[1] + m[r * 4 + 2] * p[2] + m[r * 4 + 3]);
            }
            out[i] = sum;
        }
}

}  // namespace

double decode_cost_ns(std::span<const std::uint8_t> container, const motion::SkinSet& points) {
    posepack_view view;
    if (posepack_open(&view, container.data(), container.size()) != POSEPACK_OK || points.size() == 0)
        return 0.0;
    constexpr int kRounds = 5;
    constexpr std::uint32_t kPoses = 32;
    std::vector<float> matrices(std::size_t{view.header.bone_count} * 12);
    std::vector<Point> posed(points.size());
    double best_s = 1e9;
    for (int round = 0; round < kRounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        for (std::uint32_t pose = 0; pose < kPoses; ++pose) {
            // Far apart, so that every pose decodes two rows of its own.
            const float phase = static_cast<float>(pose) * 0.618034f;
            posepack_sample_pose(&view, pose % view.header.clip_count, phase - std::floor(phase),
                                 matrices.data());
            skin_floats(points, matrices, posed);
        }
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        best_s = std::min(best_s, elapsed.count());
    }
    return best_s * 1e9 / kPoses / static_cast<double>(points.size());
}

}  // namespace posepack::measure
