// SPDX-License-Identifier: MIT
// Which spans are looked at again, and where.
#include <gtest/gtest.h>

#include "measure/closer_times.hpp"

namespace posepack::measure {
namespace {

TEST(CloserTimes, AreQuartersBesideTheLargest) {
    const std::vector<Moment> moments{{0, 0}, {1, 1}, {2, 4}, {4, 0}, {5, 0}};
    EXPECT_EQ(closer_times_s(moments, 0.9, 0.0), (std::vector<double>{1.25, 1.5, 1.75, 2.5, 3, 3.5}));
}

TEST(CloserTimes, CompareDistancesNotTheirSquares) {
    const std::vector<Moment> moments{{0, 1}, {1, 0}, {2, 0}, {3, 4}};
    EXPECT_EQ(closer_times_s(moments, 0.5, 0.0).size(), 6u) << "half of the largest distance is enough";
    EXPECT_EQ(closer_times_s(moments, 0.51, 0.0).size(), 3u);
}

TEST(CloserTimes, AskForBothEndsWhereErrorsAreArcs) {
    const std::vector<Moment> moments{{0, 0}, {1, 1}, {2, 4}, {4, 0}, {5, 4}, {6, 4}};
    EXPECT_EQ(closer_times_s(moments, 0.8, 0.4), (std::vector<double>{1.25, 1.5, 1.75, 5.25, 5.5, 5.75}));
}

TEST(CloserTimes, LeaveSidesOfAJumpAlone) {
    const std::vector<Moment> moments{{0, 0}, {1 - 1.5e-6, 4}, {1, 4}, {1 + 1.5e-6, 4}, {2, 0}};
    EXPECT_EQ(closer_times_s(moments, 0.5, 0.0).size(), 6u);
}

TEST(CloserTimes, AreNoneWhereNothingIsOff) {
    EXPECT_TRUE(closer_times_s(std::vector<Moment>{{0, 0}, {1, 0}}, 0.5, 0.0).empty());
    EXPECT_TRUE(closer_times_s(std::vector<Moment>{{0, 3}}, 0.5, 0.0).empty()) << "one time has no span";
    EXPECT_TRUE(closer_times_s({}, 0.5, 0.0).empty());
}

}  // namespace
}  // namespace posepack::measure
