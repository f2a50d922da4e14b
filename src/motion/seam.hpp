// SPDX-License-Identifier: MIT
// How a clip ends: does its last pose meet the first?
#pragma once

#include "animal/animal.hpp"
#include "motion/clip_sampler.hpp"
#include "motion/skin_set.hpp"

namespace posepack::motion {

struct SeamMeasure {
    double gap = 0.0;   // largest distance of a vertex between the first and the last pose, in model units
    double step = 0.0;  // largest distance a vertex moves in one step, mean of the first and the last step
};

// Measures the seam of a clip of `duration_s` with steps of `step_s` seconds.
SeamMeasure measure_seam(ClipSampler& sampler, const SkinSet& points, std::size_t bone_count,
                         double duration_s, double step_s);

}  // namespace posepack::motion
