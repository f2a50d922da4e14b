// SPDX-License-Identifier: MIT
// Where and when a container errs: the largest error over (time bin, bone), read back through the loader like
// all errors. Measured only where somebody asks for it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "animal/animal.hpp"
#include "base/result.hpp"
#include "measure/test_times.hpp"
#include "motion/skin_set.hpp"
#include "palette/palette.hpp"

namespace posepack::measure {

struct ClipHeat {
    // Bin b lasts from edges_s[b] to edges_s[b + 1], seconds from the clip's first key. Every bin holds a
    // time that was measured: bins are as wide as asked, or as the measured times are apart.
    std::vector<double> edges_s;
    // [bin * bone_count + bone]: the largest error within the bin, a fraction of R, of the vertices that are
    // wrong because of that bone more than of another (the bone that ErrorStats names for its worst vertex).
    std::vector<float> errors;
};

struct ErrorHeat {
    std::uint32_t bone_count = 0;
    std::vector<ClipHeat> clips;  // in the order of the palette's clips
};

// Measures at the times of measure_error(): the largest number of a clip is its ClipError::max, bit for bit.
//   points       of the animal
//   looks        of every clip, as measure_error() tells
//   bin_width_s  wished width of a bin, above 0
// Errors: E-LIM-WORK beyond kMaxSamples of measure_error.hpp, E-INTERNAL when the loader refuses the bytes.
// Cost: as measuring the points in measure_error().
base::Result<ErrorHeat> measure_heat(const animal::Animal& animal, const palette::Palette& palette,
                                     std::span<const std::uint8_t> container, const motion::SkinSet& points,
                                     std::span<const Look> looks, double bin_width_s);

}  // namespace posepack::measure
