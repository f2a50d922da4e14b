// SPDX-License-Identifier: MIT
// The front against its definition, point by point.
#include "output/pareto.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace posepack::output {
namespace {

bool dominates(const CostPoint& a, const CostPoint& b) {
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

std::vector<std::size_t> by_definition(const std::vector<CostPoint>& points) {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::none_of(points.begin(), points.end(),
                         [&](const CostPoint& other) { return dominates(other, points[i]); }))
            front.push_back(i);
    return front;
}

TEST(Pareto, IsWhatTheDefinitionSays) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int round = 0; round < 2000; ++round) {
        // Few different values, so that ties are common.
        std::uniform_int_distribution<int> value(0, round % 7 + 1), count(0, 25);
        std::vector<CostPoint> points(static_cast<std::size_t>(count(random)));
        for (CostPoint& point : points)
            point = {static_cast<double>(value(random)), static_cast<double>(value(random))};
        std::vector<std::size_t> found = pareto_front(points);
        for (std::size_t i = 1; i < found.size(); ++i)
            EXPECT_LE(points[found[i - 1]].cost, points[found[i]].cost);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, by_definition(points));
    }
}

TEST(Pareto, KeepsEqualPointsTogetherAndInOrder) {
    const std::vector<CostPoint> points{{2, 1}, {1, 2}, {1, 2}, {2, 1}, {1, 3}, {3, 1}};
    EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 2, 0, 3}));
    EXPECT_TRUE(pareto_front({}).empty());
}

}  // namespace
}  // namespace posepack::output
