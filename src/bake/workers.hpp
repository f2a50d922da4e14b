// SPDX-License-Identifier: MIT
// A handful of threads over a list of independent jobs.
#pragma once

#include <cstddef>
#include <functional>

namespace posepack::bake {

// Calls `job` with each index below `count`, in rising order of start, on `thread_count` threads (0: one a
// core). A job that answers false stops the start of later ones; all that started are finished, so that the
// first failing index is the same for every number of threads. So does an interrupt (base/interrupt.hpp), for
// which the caller looks. An exception of a job is thrown again here.
void run_jobs(std::size_t count, unsigned thread_count, const std::function<bool(std::size_t)>& job);

}  // namespace posepack::bake
