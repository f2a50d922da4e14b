// SPDX-License-Identifier: MIT
// The Pareto front of points that cost something and err: those that nothing else beats.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace posepack::output {

struct CostPoint {
    double cost = 0.0, error = 0.0;  // less is better; never NaN
};

// Indices of the points that no other point dominates, by rising cost, then index. A point dominates another
// when it is no worse in both numbers and better in one: equal points are on the front together.
// Cost: O(n log n).
std::vector<std::size_t> pareto_front(std::span<const CostPoint> points);

}  // namespace posepack::output
