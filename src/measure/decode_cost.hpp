// SPDX-License-Identifier: MIT
// What reading a palette costs on the CPU.
#pragma once

#include <cstdint>
#include <span>

#include "motion/skin_set.hpp"

namespace posepack::measure {

// Nanoseconds a vertex to decode two rows through the loader, blend them and skin every point of `points`
// in float, on this thread; the fastest of several rounds over rows of the whole container. 0 when the bytes
// are no container or there are no points.
double decode_cost_ns(std::span<const std::uint8_t> container, const motion::SkinSet& points);

}  // namespace posepack::measure
