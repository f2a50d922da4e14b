// SPDX-License-Identifier: MIT
// The rows of a bone: a polyline through its numbers, fitted by least squares.
#pragma once

#include <cstdint>
#include <vector>

#include "fit/tracks.hpp"

namespace posepack::fit {

// Rows 0 to interval_count, evenly over the period; of a loop the last is the first, its sign turned where
// the track is.
struct Polyline {
    std::uint32_t interval_count = 0;
    std::vector<double> rows;  // [row][number]
};

// The polyline of `interval_count` intervals whose numbers differ least from a track's, in the mean square
// over its samples; of a clip whose poses are held, the mean of each interval. 0 intervals: one pose.
//   interval_count  at most half the intervals of the track, for a fit that means something
//   weights  of the known samples; empty: 1
Polyline fit_polyline(const Tracks& tracks, std::size_t bone, std::uint32_t interval_count,
                      std::span<const float> weights = {});

// The polyline through the track's own numbers at the times of its rows.
Polyline sample_polyline(const Tracks& tracks, std::size_t bone, std::uint32_t interval_count);

// The numbers at a phase in [0, 1].
void blend_numbers(const Polyline& line, std::size_t width, bool step, double phase, double* numbers);

}  // namespace posepack::fit
