// SPDX-License-Identifier: MIT
// Heat maps of error over clip time and bone, as inline SVG.
#pragma once

#include <span>
#include <string>

#include "output/report_model.hpp"

namespace posepack::output {

// The lower edges of the classes of error, fractions of R, rising: class k of heat_class() is below edge k
// and not below edge k - 1. The same for all animals, so that maps can be compared.
std::span<const float> heat_edges();
std::size_t heat_class(float error);

// At most so many bones are drawn: those that err most. At most so many clips stand side by side.
inline constexpr std::size_t kHeatBones = 64;
inline constexpr std::size_t kHeatClips = 24;

// An <svg> element: a line a bone, clips side by side along the time, a colour an error class (style classes
// h0, h1...); more than kHeatClips clips in several bands. Hovering over a bone in a clip shows its largest
// error there and when.
//   radius_m  metres of R
std::string heat_svg(const HeatMap& heat, const std::string& animal, double radius_m);

}  // namespace posepack::output
