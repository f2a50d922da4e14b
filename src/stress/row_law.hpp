// SPDX-License-Identifier: MIT
// How a reader finds its rows: the time law of docs/format/posepack-1.md, section 11, in 32-bit float.
#pragma once

#include <cstdint>
#include <vector>

#include "posepack/loader.h"
#include "stress/reader.hpp"

namespace posepack::stress {

// A clip as a reader knows it.
struct ReaderClip {
    posepack_clip facts{};
    std::vector<std::uint32_t> cuts;  // rising
};

// Clip `index` of an opened container, which must have it.
ReaderClip read_clip(const posepack_view& view, std::uint32_t index);

// The pose is row0 (1 - factor) + row1 factor; rows counted from the container's first.
struct RowPair {
    std::uint32_t row0 = 0, row1 = 0;
    float factor = 0.0f;
};

// The rows that show clip time `time_s`, 0 up to the period. The clip is looked at `reader.running_s` into
// the run of the program, or at most one period earlier, so that this time of it shows.
RowPair rows_at(const ReaderClip& clip, double time_s, const Reader& reader);

// Clip time of a row, seconds.
double row_time_s(const ReaderClip& clip, std::uint32_t row);

}  // namespace posepack::stress
