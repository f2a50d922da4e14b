// SPDX-License-Identifier: MIT
#include "output/pareto.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace posepack::output {

std::vector<std::size_t> pareto_front(std::span<const CostPoint> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(points[a].cost, points[a].error, a) < std::tie(points[b].cost, points[b].error, b);
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        const bool is_first = front.empty();
        const CostPoint& last = points[is_first ? i : front.back()];
        const bool is_equal = points[i].cost == last.cost && points[i].error == last.error;
        if (is_first || is_equal || points[i].error < last.error) front.push_back(i);
    }
    return front;
}

}  // namespace posepack::output
