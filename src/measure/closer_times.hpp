// SPDX-License-Identifier: MIT
// Where a clip deserves a closer look: times between those that were measured at which an error may be larger
// than all that was seen.
#pragma once

#include <span>
#include <vector>

namespace posepack::measure {

// How much of the largest error so far one end of a span must show, at the first look and at the second. The
// first is the share up to which a bend that hides between two times is left alone (measure_error.cpp); the
// second goes to the top of what the first has found.
inline constexpr double kCloserShares[] = {0.5, 0.9};

// The largest squared distance of a vertex at one time.
struct Moment {
    double time_s;
    float square;
};

// The quarters of every span between two of `moments` (rising) of which an end has at least `share` of the
// largest distance, rising. Spans of some microseconds, beside a jump, have none.
std::vector<double> closer_times_s(std::span<const Moment> moments, double share);

}  // namespace posepack::measure
