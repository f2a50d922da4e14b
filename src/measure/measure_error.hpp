// SPDX-License-Identifier: MIT
// The true error of a container: what a reader of its bytes draws, against the source curves.
//
// For every clip, at its rows, at its source keys and between (test_times.hpp), the rows are decoded
// by the shipped loader, blended in float as a shader does, and compared with the glTF curves in double
// precision, at every different vertex and normal. docs/error_metric.md says what this sees and what it
// cannot.
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

// (Times x points and normals) of one animal: about a minute of one core. Real characters of eighty clips
// have 1 % of it; a small file of many keys could ask for days.
inline constexpr std::uint64_t kMaxSamples = 10'000'000'000;

struct ErrorStats {
    std::vector<palette::ClipError> clips;  // in the order of the palette's clips
    palette::ClipError pooled;              // over all clips: the worst place is in clip `worst_clip`
    std::uint32_t worst_clip = 0;
    std::vector<Look> looks;          // one a clip
    std::uint64_t point_samples = 0;  // (times x points) that p99.9 and rms are made of
    std::uint64_t normal_samples = 0;
};

// Measures `container` (bytes of write_container) against `animal`.
//   palette  tells the plan of each clip; its pixels are not looked at
//   points, normals  of the animal
// Errors: E-LIM-WORK when that would take more than kMaxSamples; E-INTERNAL when the loader refuses the
// bytes, which are our own, E-LIM-FLOAT-RANGE when an error fits no float.
base::Result<ErrorStats> measure_error(const animal::Animal& animal, const palette::Palette& palette,
                                       std::span<const std::uint8_t> container, const motion::SkinSet& points,
                                       const motion::SkinSet& normals);

}  // namespace posepack::measure
