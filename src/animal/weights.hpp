// SPDX-License-Identifier: MIT
// Skin weights: from what files hold to a few falling weights that sum to one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "animal/animal.hpp"

namespace posepack::animal {

// Distances that may be measured to find neighbours, for all primitives of a file: below a second.
inline constexpr std::uint64_t kMaxNeighbourTests = 200'000'000;

// What was repaired, counted in vertices.
struct WeightRepairs {
    std::uint32_t bad = 0;              // NaN, infinite or negative weights, zeroed
    std::uint32_t none_left = 0;        // no weight left: took those of the nearest good vertex
    std::uint32_t sum_not_one = 0;      // renormalised
    std::uint32_t truncated = 0;        // more influences than are kept
    std::size_t influences_most = 0;    // the largest number of them
    bool hopeless = false;              // too many lost weights to look for neighbours; nothing was repaired
    double truncated_weight_max = 0.0;  // the largest sum of weights dropped from one vertex
};

// Reduces the weights of `count` vertices with `influences` (joint, weight) pairs each.
//   bones, weights  count x influences, vertex by vertex
//   keep            influences that a vertex may keep, 1 to kMaxInfluences
//   positions       of the same vertices, to find the nearest good one
//   tests_left      distances that may still be measured; falls by those this call needs
//   out, reduced    grow by `count` vertices of bones and weights, and by all influences of those that lose
//   some
WeightRepairs reduce_weights(std::span<const std::uint16_t> bones, std::span<const float> weights,
                             std::size_t influences, std::size_t keep,
                             std::span<const std::array<float, 3>> positions, std::uint64_t& tests_left,
                             Vertices& out, ReducedVertices& reduced);

}  // namespace posepack::animal
