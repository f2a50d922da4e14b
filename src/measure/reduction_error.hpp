// SPDX-License-Identifier: MIT
// What it costs to leave influences out: vertices with all of theirs against vertices with those that were
// kept.
//
// Both are skinned by the exact matrices of the rows, so that nothing of the palette's own error is in it.
#pragma once

#include <cstdint>
#include <vector>

#include "animal/animal.hpp"
#include "base/result.hpp"
#include "palette/palette.hpp"

namespace posepack::measure {

// (Rows x reduced vertices) of one animal: some seconds of one core.
inline constexpr std::uint64_t kMaxReductionSamples = 200'000'000;

struct ReductionError {
    std::uint32_t vertex_count = 0;     // vertices that lost influences; all else is zero when there are none
    std::uint32_t influences_most = 0;  // the largest number of influences of one of them, before
    double max = 0.0, rms = 0.0;        // distances as fractions of R; rms over (rows x these vertices)
    std::uint32_t clip = 0;             // the worst place: index into Palette::clips,
    double time_s = 0.0;                //   clip time of the row,
    std::uint32_t mesh = 0, vertex = 0;  //   mesh, and vertex within it
};

// Compares at every row of every clip. Errors: E-LIM-WORK when that would take more than
// kMaxReductionSamples; E-LIM-FLOAT-RANGE when a distance fits no float.
base::Result<ReductionError> measure_reduction(const animal::Animal& animal, const palette::Palette& palette);

}  // namespace posepack::measure
