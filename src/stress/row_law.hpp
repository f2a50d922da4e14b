// SPDX-License-Identifier: MIT
// How a reader comes to its rows: the time law of docs/format/posepack-1.md, section 11. From the clock to
// the phase it is the program's, in 32-bit float; from the phase to the rows it is the loader's.
#pragma once

#include <cstdint>
#include <vector>

#include "posepack/loader.h"
#include "stress/reader.hpp"

namespace posepack::stress {

// The phase at which a reader shows clip time `time_s`, 0 up to the period. The clip is looked at
// `reader.running_s` into the run of the program, or at most one period earlier, so that this time of it
// shows.
float phase_at(const posepack_clip& clip, double time_s, const Reader& reader);

// Clip times of the rows of every bone of clip `index`, which the view must have, seconds: of uniform rows in
// their order, and behind those of a loop its end.
std::vector<double> row_times_s(const posepack_view& view, std::uint32_t index);

}  // namespace posepack::stress
