// SPDX-License-Identifier: MIT
#include "palette/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace posepack::palette {

bool Box::fits_floats() const {
    if (is_empty()) return true;
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c) square += (high[c] - low[c]) * (high[c] - low[c]);
    constexpr double kLargest = 3.4e38;
    return std::sqrt(square)<kLargest&& * std::min_element(low.begin(), low.end())> - kLargest &&
           *std::max_element(high.begin(), high.end()) < kLargest;
}

BoneBoxes::BoneBoxes(const animal::Animal& animal) {
    struct Range {
        std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    };
    std::vector<Range> ranges(animal.bones.size());
    const animal::Vertices& vertices = animal.vertices;
    for (std::size_t v = 0; v < vertices.positions.size(); ++v)
        for (std::size_t i = 0; i < animal::kMaxInfluences; ++i) {
            if (vertices.weights[v][i] <= 0.0f) continue;
            Range& range = ranges[vertices.bones[v][i]];
            for (std::size_t c = 0; c < 3; ++c) {
                range.low[c] = std::min(range.low[c], static_cast<double>(vertices.positions[v][c]));
                range.high[c] = std::max(range.high[c], static_cast<double>(vertices.positions[v][c]));
            }
        }
    for (std::uint32_t b = 0; b < ranges.size(); ++b) {
        if (!animal.bones[b].weighted) continue;
        BoneBox box{b, {}, {}};
        for (std::size_t c = 0; c < 3; ++c) {
            box.center[c] = 0.5 * (ranges[b].low[c] + ranges[b].high[c]);
            box.half_size[c] = 0.5 * (ranges[b].high[c] - ranges[b].low[c]);
        }
        boxes_.push_back(box);
    }
}

void BoneBoxes::add(std::span<const float> matrices, Box& box) const {
    for (const BoneBox& bone : boxes_)
        for (std::size_t r = 0; r < 3; ++r) {
            const float* m = &matrices[bone.bone * 12 + r * 4];
            double center = m[3];
            double reach = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                center += static_cast<double>(m[c]) * bone.center[c];
                reach += std::abs(static_cast<double>(m[c])) * bone.half_size[c];
            }
            box.low[r] = std::min(box.low[r], center - reach);
            box.high[r] = std::max(box.high[r], center + reach);
        }
}

}  // namespace posepack::palette
