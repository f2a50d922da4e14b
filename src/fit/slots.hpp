// SPDX-License-Identifier: MIT
// Slots: rows of all moving bones at the same uneven times, close where the motion is fast
// (docs/format/posepack-1.md, section 10).
#pragma once

#include <vector>

#include "fit/profile.hpp"
#include "fit/tracks.hpp"

namespace posepack::fit {

// Slots of a clip whose keys are the even grid of its tracks, one slot a key interval: greedily from the
// first key on, each interval between rows as long as straight lines between the tracks' samples leave the
// vertices within `limit`, and an interval of keys cut into up to sixteen where one is too long (two samples
// at least for each).
//   limit  fraction of R
//   reach  R in units of palette space
//   jump_times_s  clip times at which a channel jumps: a row ends in front of those that are keys
// Nothing where the tracks are one pose, held, or have more rows than runs can.
SlotPlan plan_slots(const Tracks& tracks, const std::vector<BonePoints>& points, double limit, double reach,
                    double period_s, const std::vector<double>& jump_times_s);

// Gives the tracks these slots: polylines through them have rows at the slots' times.
void bend(Tracks& tracks, SlotPlan plan);

}  // namespace posepack::fit
