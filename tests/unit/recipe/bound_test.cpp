// SPDX-License-Identifier: MIT
#include "recipe/bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace posepack::recipe {
namespace {

TEST(ErrorLimits, AreFractionsMillimetresOrPixels) {
    EXPECT_EQ(parse_error_limit("0.02"), (ErrorLimit{0.02, false}));
    EXPECT_EQ(parse_error_limit("1"), (ErrorLimit{1.0, false}));
    EXPECT_EQ(parse_error_limit("5mm"), (ErrorLimit{0.005, true}));
    // A pixel of 1,080 lines over 2 tan(30 degrees) x 20 m.
    const auto pixel = parse_error_limit("1px@20m,1080,60");
    ASSERT_TRUE(pixel);
    EXPECT_TRUE(pixel->in_metres);
    EXPECT_NEAR(pixel->value, 40.0 / std::sqrt(3.0) / 1080.0, 1e-12);
    EXPECT_EQ((ErrorLimit{0.005, true}).fraction(0.5), 0.01);
    EXPECT_EQ((ErrorLimit{0.02, false}).fraction(0.5), 0.02);
}

TEST(ErrorLimits, RefuseWhatIsNone) {
    for (const char* text :
         {"", "0", "-1", "1.5", "nan", "inf", "mm", "0.02 ", " 0.02", "5 mm", "5cm", "1px", "1px@20m",
          "1px@20m,1080", "1px@20m,1080,180", "1px@20m,1080,60x", "1px@0m,1080,60", "hero"})
        EXPECT_FALSE(parse_error_limit(text)) << text;
    EXPECT_FALSE(parse_error_bound("heroic"));
}

TEST(ErrorBounds, ArePresetsOrGiveAQuarterToP999) {
    EXPECT_EQ(parse_error_bound("default"), (ErrorBound{{0.02}, ErrorLimit{0.005}, {}}));
    EXPECT_EQ(parse_error_bound("hero"), (ErrorBound{{5e-3}, ErrorLimit{1e-3}, {}}));
    EXPECT_EQ(parse_error_bound("far"), (ErrorBound{{5e-2}, ErrorLimit{2e-2}, {}}));
    EXPECT_EQ(parse_error_bound("8mm"), (ErrorBound{{0.008, true}, ErrorLimit{0.002, true}, {}}));
    EXPECT_EQ(bound_json(*parse_error_bound("0.5")),
              R"({"max":{"unit":"R","value":0.5},"p999":{"unit":"R","value":0.125},"rms":null})");
}

}  // namespace
}  // namespace posepack::recipe
