// SPDX-License-Identifier: MIT
// Logarithmic axes: their range, their ticks, and how the ticks are written.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace posepack::output {

// What the numbers of an axis are.
enum class AxisUnit {
    bytes,        // "200 kB": thousands
    nanoseconds,  // "5.4"
    count,        // "16"; few different values are ticks themselves
    fraction,     // "0.02", below 1e-3 "2e-4"
};

struct LogAxis {
    AxisUnit unit = AxisUnit::count;
    double low = 0.1, high = 1.0;  // the ends; 0 < low < high
    std::vector<double> ticks;     // written out, rising
    std::vector<double> minor_ticks;

    // 0 at the lower end, 1 at the upper; numbers beyond, and zero, lie at the ends.
    double place(double value) const;
};

// An axis around `values`, with some air at both ends. Numbers that are not positive do not count; none
// positive: a decade below 1.
//   least_ratio  high / low is at least that, so that noise does not look like a difference
LogAxis log_axis(AxisUnit unit, std::span<const double> values, double least_ratio);

// A tick as it is written, without the unit's name where the axis title has it.
std::string tick_text(AxisUnit unit, double value);

// 380928 as "380.9 kB": three or four digits, thousands, for ticks, prose and hover texts.
std::string decimal_bytes(double bytes);

// A length in three digits and the unit that suits it: "2.69 m", "31.7 mm", "4.2 um" (with the Greek letter).
std::string length_text(double metres);

// A fraction of R in three digits: "5.42e-2", "0".
std::string short_error(double value);

}  // namespace posepack::output
