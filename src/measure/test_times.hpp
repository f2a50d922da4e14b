// SPDX-License-Identifier: MIT
// When a clip is measured: docs/error_metric.md, "When".
#pragma once

#include <span>
#include <vector>

#include "animal/animal.hpp"
#include "motion/clip_sampler.hpp"
#include "palette/moments.hpp"
#include "palette/palette.hpp"

namespace posepack::measure {

// How many parts the span between two rows or keys is looked at in: its middle alone, or its quarters.
enum class Parts { halves = 2, quarters = 4 };

// When one clip was looked at.
struct Look {
    Parts parts = Parts::halves;
    // Beside test_times_s(): where the largest error was sought, rising (closer_times.hpp).
    std::vector<double> closer_s;
};

// Rows (under runs those of every bone), keys and the times between them, seconds from the first key of the
// clip, rising; and the moments just before and behind a jump of the source.
std::vector<double> test_times_s(const palette::PaletteClip& clip, std::span<const double> key_times_s,
                                 std::span<const double> jump_times_s = {}, Parts parts = Parts::halves);

// How far a blend of the dual quaternions of `from` and `to` (matrices of one bone in palette space) is off a
// quarter of the way along, in units of palette space: a rough bound, right within a factor of two for a
// turn. Half way such a blend is right, and a measurement there tells nothing.
double bend_between(const motion::Affine& from, const motion::Affine& to, const palette::BoneMoment& moment);

// The largest bend_between over all bones of a clip and all spans between its rows and keys, as a fraction of
// R.
//   moments  of every bone
double largest_bend(const animal::Animal& animal, const palette::Palette& palette,
                    const palette::PaletteClip& clip, motion::ClipSampler& sampler,
                    std::span<const palette::BoneMoment> moments);

}  // namespace posepack::measure
