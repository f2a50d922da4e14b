// SPDX-License-Identifier: MIT
// The uniform grid that a clip's keys lie on, found from the keys alone.
#pragma once

#include <optional>
#include <span>

namespace posepack::motion {

// The coarsest step of at most 1/23.976 s on which at least 98 % of `times_s` lie within a thousandth of the
// step; nothing when there is none of at least 1/240 s. Sparse keys (at 2 s and 4 s, say) lie on many
// grids: that limit keeps enough rows between them.
//   times_s  sorted, seconds after the first key of the clip
std::optional<double> key_step_s(std::span<const double> times_s);

}  // namespace posepack::motion
