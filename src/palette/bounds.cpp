// SPDX-License-Identifier: MIT
#include "palette/bounds.hpp"

#include <algorithm>
#include <cmath>

#include "palette/spaces.hpp"

namespace posepack::palette {

bool Box::fits_floats() const {
    if (is_empty()) return true;
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c) square += (high[c] - low[c]) * (high[c] - low[c]);
    constexpr double kLargest = 3.4e38;
    return std::sqrt(square)<kLargest&& * std::min_element(low.begin(), low.end())> - kLargest &&
           *std::max_element(high.begin(), high.end()) < kLargest;
}

BoneBoxes::BoneBoxes(const animal::Animal& animal) : BoneBoxes(animal, model_space(animal)) {}

BoneBoxes::BoneBoxes(const animal::Animal& animal, const Spaces& spaces) {
    struct Range {
        std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    };
    std::vector<Range> ranges(animal.bones.size());
    const animal::Vertices& vertices = animal.vertices;
    const auto grow = [&](std::uint32_t v, const glm::dvec3& entered) {
        for (std::size_t i = 0; i < animal::kMaxInfluences; ++i) {
            if (vertices.weights[v][i] <= 0.0f) continue;
            Range& range = ranges[vertices.bones[v][i]];
            for (std::size_t c = 0; c < 3; ++c) {
                range.low[c] = std::min(range.low[c], entered[static_cast<int>(c)]);
                range.high[c] = std::max(range.high[c], entered[static_cast<int>(c)]);
            }
        }
    };
    for (std::uint32_t m = 0; m < animal.meshes.size(); ++m) {
        const animal::Mesh& mesh = animal.meshes[m];
        const motion::Affine entry = spaces.mesh_entry(m);
        for (std::uint32_t v = mesh.first_vertex; v < mesh.first_vertex + mesh.vertex_count; ++v) {
            const auto& p = vertices.positions[v];
            grow(v, entry * glm::dvec3(p[0], p[1], p[2]));
        }
    }
    for (std::uint32_t b = 0; b < ranges.size(); ++b) {
        if (ranges[b].low[0] > ranges[b].high[0]) continue;
        BoneBox box{b, {}, {}};
        for (std::size_t c = 0; c < 3; ++c) {
            box.center[c] = 0.5 * (ranges[b].low[c] + ranges[b].high[c]);
            box.half_size[c] = 0.5 * (ranges[b].high[c] - ranges[b].low[c]);
        }
        boxes_.push_back(box);
    }
}

void BoneBoxes::grow(const BoneBox& bone, std::span<const float> matrices, double margin, Box& box) const {
    for (std::size_t r = 0; r < 3; ++r) {
        const float* m = &matrices[bone.bone * std::size_t{12} + r * 4];
        double center = static_cast<double>(m[3]);
        double reach = margin;
        for (std::size_t c = 0; c < 3; ++c) {
            center += static_cast<double>(m[c]) * bone.center[c];
            reach += std::abs(static_cast<double>(m[c])) * bone.half_size[c];
        }
        box.low[r] = std::min(box.low[r], center - reach);
        box.high[r] = std::max(box.high[r], center + reach);
    }
}

void BoneBoxes::add(std::span<const float> matrices, Box& box) const {
    for (const BoneBox& bone : boxes_) grow(bone, matrices, 0.0, box);
}

void BoneBoxes::add(std::span<const motion::Affine> bones, Box& box) const {
    std::vector<float> matrices(bones.size() * 12);
    for (std::size_t b = 0; b < bones.size(); ++b)
        for (int r = 0; r < 3; ++r) {
            float* row = &matrices[b * 12 + static_cast<std::size_t>(4 * r)];
            for (int c = 0; c < 3; ++c) row[c] = static_cast<float>(bones[b].linear[c][r]);
            row[3] = static_cast<float>(bones[b].translation[r]);
        }
    add(matrices, box);
}

// The largest distance of a point of the box, half way, from the middle of its chord; affine in the point, so
// that a corner has it.
double BoneBoxes::bulge(const BoneBox& bone, std::span<const std::vector<float>, 5> quarters) const {
    double square = 0.0;
    for (std::size_t r = 0; r < 3; ++r) {
        const std::size_t at = bone.bone * std::size_t{12} + r * 4;
        const auto off = [&](std::size_t i) {
            return static_cast<double>(quarters[2][at + i]) -
                   0.5 *
                       (static_cast<double>(quarters[0][at + i]) + static_cast<double>(quarters[4][at + i]));
        };
        double center = off(3);
        double reach = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            center += off(c) * bone.center[c];
            reach += std::abs(off(c)) * bone.half_size[c];
        }
        square += (std::abs(center) + reach) * (std::abs(center) + reach);
    }
    return std::sqrt(square);
}

// Between two quarters an arc leaves its chord by at most a ninth of what the whole leaves its own (at half a
// turn, the most that aligned rows are apart; a sixteenth for small ones). A quarter is room for scale and
// screw.
void BoneBoxes::add_arcs(std::span<const std::vector<float>, 5> quarters, Box& box) const {
    for (const BoneBox& bone : boxes_) {
        const double margin = 0.25 * bulge(bone, quarters);
        for (const std::vector<float>& matrices : quarters) grow(bone, matrices, margin, box);
    }
}

}  // namespace posepack::palette
