// SPDX-License-Identifier: MIT
// Axes hold their values, have ticks that can be read, and survive zeros.
#include "output/log_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace posepack::output {
namespace {

TEST(LogAxis, HoldsItsValuesAndHasTicks) {
    for (const AxisUnit unit : {AxisUnit::bytes, AxisUnit::nanoseconds, AxisUnit::count, AxisUnit::fraction})
        for (const double low : {3.7e-9, 2e-5, 0.011, 5.0, 130.0, 4.1e5})
            for (const double ratio : {1.0, 1.2, 2.5, 9.0, 40.0, 3e4, 1e9}) {
                const std::vector<double> values{low, low * ratio};
                const LogAxis axis = log_axis(unit, values, 1.5);
                SCOPED_TRACE(std::to_string(low) + " x " + std::to_string(ratio));
                EXPECT_LT(0.0, axis.low);
                EXPECT_GE(axis.high / axis.low, 1.5);
                EXPECT_GT(axis.place(low), 0.0);
                EXPECT_LT(axis.place(low * ratio), 1.0);
                EXPECT_TRUE(std::is_sorted(axis.ticks.begin(), axis.ticks.end()));
                EXPECT_GE(axis.ticks.size(), unit == AxisUnit::count && ratio == 1.0 ? 1u : 2u);
                EXPECT_LE(axis.ticks.size(), 13u);
                for (const auto* ticks : {&axis.ticks, &axis.minor_ticks})
                    for (const double tick : *ticks) {
                        EXPECT_GE(tick, axis.low);
                        EXPECT_LE(tick, axis.high);
                    }
            }
}

TEST(LogAxis, TicksAreWrittenAsTheyAre) {
    const std::vector<double> errors{0.012, 0.19};
    const LogAxis axis = log_axis(AxisUnit::fraction, errors, 1.5);
    EXPECT_EQ(axis.ticks, (std::vector<double>{0.02, 0.05, 0.1, 0.2}));
    const std::vector<double> fetches{32, 16, 24, 16};
    EXPECT_EQ(log_axis(AxisUnit::count, fetches, 2.0).ticks, (std::vector<double>{16, 24, 32}));
}

TEST(LogAxis, NumbersThatHaveNoLogarithmLieOnTheEdge) {
    const std::vector<double> values{0.0, 1.0, 10.0, std::numeric_limits<double>::infinity()};
    const LogAxis axis = log_axis(AxisUnit::fraction, values, 1.5);
    EXPECT_EQ(axis.place(0.0), 0.0);
    EXPECT_EQ(axis.place(-1.0), 0.0);
    EXPECT_EQ(axis.place(std::numeric_limits<double>::infinity()), 1.0);
    EXPECT_LT(axis.high, 100.0);
    const std::vector<double> none{0.0, 0.0};
    EXPECT_GE(log_axis(AxisUnit::fraction, none, 1.5).ticks.size(), 2u);
    EXPECT_GE(log_axis(AxisUnit::count, {}, 1.5).high, 1.0);
}

TEST(LogAxis, TextOfTicksAndNumbers) {
    EXPECT_EQ(tick_text(AxisUnit::bytes, 200e3), "200 kB");
    EXPECT_EQ(tick_text(AxisUnit::bytes, 1e6), "1 MB");
    EXPECT_EQ(tick_text(AxisUnit::bytes, 50), "50 B");
    EXPECT_EQ(tick_text(AxisUnit::bytes, 2e9), "2 GB");
    EXPECT_EQ(tick_text(AxisUnit::fraction, 0.05), "0.05");
    EXPECT_EQ(tick_text(AxisUnit::fraction, 1e-3), "0.001");
    EXPECT_EQ(tick_text(AxisUnit::fraction, 2e-4), "2e-4");
    EXPECT_EQ(tick_text(AxisUnit::fraction, 1.5e-7), "1.5e-7");
    EXPECT_EQ(tick_text(AxisUnit::nanoseconds, 5.5), "5.5");
    EXPECT_EQ(tick_text(AxisUnit::count, 500), "500");
    EXPECT_EQ(decimal_bytes(380'928), "380.9 kB");
    EXPECT_EQ(decimal_bytes(999'949), "999.9 kB");
    EXPECT_EQ(decimal_bytes(999'950), "1 MB");
    EXPECT_EQ(length_text(2.69), "2.69 m");
    EXPECT_EQ(length_text(12'345.0), "12345 m");
    EXPECT_EQ(length_text(0.9996), "1 m");
    EXPECT_EQ(length_text(0.0317), "31.7 mm");
    EXPECT_EQ(length_text(4.2e-6), "4.2 \u00b5m");
    EXPECT_EQ(length_text(0.0), "0 mm");
    EXPECT_EQ(short_error(0.0542), "5.42e-2");
    EXPECT_EQ(short_error(0.2), "2.00e-1");
    EXPECT_EQ(short_error(1.0), "1.00e0");
    EXPECT_EQ(short_error(0.0), "0");
}

}  // namespace
}  // namespace posepack::output
