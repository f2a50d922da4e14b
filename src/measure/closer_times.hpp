// SPDX-License-Identifier: MIT
// Where a clip deserves a closer look: times between those that were measured at which an error may be larger
// than all that was seen.
#pragma once

#include <span>
#include <vector>

namespace posepack::measure {

// The largest squared distance of a vertex at one time.
struct Moment {
    double time_s;
    float square;
};

// The quarters of every span between two of `moments` (rising) of which one end has at least `share` of the
// largest distance and the other `other_share`, rising. Spans of some microseconds, beside a jump, have none.
std::vector<double> closer_times_s(std::span<const Moment> moments, double share, double other_share);

}  // namespace posepack::measure
