// SPDX-License-Identifier: MIT
// Signs along rows and across the seam, and bones that are no similarity.
#include "palette/dualquat_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/affine.hpp"

namespace posepack::palette {
namespace {

motion::Affine turned(double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360.0;
    return {rotation_matrix({0, 0, std::sin(half), std::cos(half)}), {}};
}

TEST(Hemispheres, FollowAWholeTurnAndKnowItsEnd) {
    Hemispheres hemispheres(2);
    hemispheres.begin_clip();
    glm::dvec4 previous{0, 0, 0, 1};
    for (int step = 0; step < 24; ++step) {
        const Similarity s = hemispheres.next(0, turned(15.0 * step));
        hemispheres.next(1, turned(10.0 * std::sin(step)));
        EXPECT_GT(glm::dot(s.rotation, previous), 0.99) << step;
        previous = s.rotation;
    }
    EXPECT_TRUE(hemispheres.is_turned(0)) << "345 degrees: the next 15 lead to minus the first";
    EXPECT_FALSE(hemispheres.is_turned(1));
}

TEST(Hemispheres, StartEveryClipWhereTheFirstBegan) {
    Hemispheres hemispheres(1);
    hemispheres.begin_clip();
    const Similarity first = hemispheres.next(0, turned(100));
    for (int degrees = 100; degrees <= 500; degrees += 50) hemispheres.next(0, turned(degrees));
    hemispheres.begin_clip();
    const Similarity again = hemispheres.next(0, turned(100));
    EXPECT_GT(glm::dot(first.rotation, again.rotation), 0.999);
    EXPECT_FALSE(hemispheres.is_turned(0));
}

TEST(Hemispheres, KeepTheRotationOfABoneThatShrinksToNothing) {
    Hemispheres hemispheres(1);
    hemispheres.begin_clip();
    const Similarity before = hemispheres.next(0, turned(70));
    motion::Affine gone = turned(200);
    gone.linear *= 0.0;
    const Similarity at_zero = hemispheres.next(0, gone);
    EXPECT_EQ(at_zero.rotation, before.rotation);
    EXPECT_EQ(at_zero.scale, 0.0);
}

}  // namespace
}  // namespace posepack::palette
