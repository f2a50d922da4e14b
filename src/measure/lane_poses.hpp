// SPDX-License-Identifier: MIT
// What every measurement looks at: the source pose of a clip, and how far the bones that a reader of the
// container draws are from it, at several times at once; by bindings, not by bones.
#pragma once

#include <vector>

#include "animal/animal.hpp"
#include "measure/bindings.hpp"
#include "measure/skin_difference.hpp"
#include "motion/clip_sampler.hpp"
#include "palette/palette.hpp"
#include "posepack/loader.h"

namespace posepack::measure {

// Points in units of R, as differences are.
motion::SkinSet in_radii(motion::SkinSet points, double inverse_radius);

// Buffers for the bindings of one animal at kLanes times. What it was made of must outlive it.
class LanePoses {
 public:
    //   inverse_radius  1 / R: differences have lengths in units of R, for tiny ones would vanish in squares
    LanePoses(const animal::Animal& animal, const palette::Palette& palette, const posepack_view& view,
              double inverse_radius);

    // Puts `time_s` of `clip` (seconds from its first key) into lane `lane`: the curves in double precision,
    // and the rows as the loader decodes and blends them. `sampler` is of the same clip.
    void fill(motion::ClipSampler& sampler, const palette::PaletteClip& clip, double time_s,
              std::size_t lane);

    // Sets that are measured name these in the place of bones.
    const Bindings& bindings() const { return bindings_; }
    // Drawn less exact, in model space with lengths in units of R: 12 elements a binding, 3x4 row-major.
    const LaneMatrices& difference() const { return difference_; }
    // The linear parts of the exact matrices: 9 elements a binding, row-major.
    const LaneMatrices& exact() const { return exact_; }

 private:
    // What the loader makes of a time, in blended_. `clip` is one of the palette's.
    void read_pose(const palette::PaletteClip& clip, double time_s);

    const palette::Palette& palette_;
    const Bindings bindings_;
    const posepack_view& view_;
    double inverse_radius_;
    std::vector<motion::Affine> bones_;
    std::vector<float> blended_;
    LaneMatrices difference_, exact_;
};

// The binding that moves entry `entry` of `set` furthest from its place at lane `lane`, weights taken into
// account: the one that an error is blamed on. Points are moved, directions turned.
std::uint32_t blamed_bone(const motion::SkinSet& set, std::uint32_t entry, const LaneMatrices& difference,
                          std::size_t lane, bool is_point);

}  // namespace posepack::measure
