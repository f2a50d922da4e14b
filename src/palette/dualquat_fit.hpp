// SPDX-License-Identifier: MIT
// Whether a clip can be dual quaternions, and whether it needs a closing row.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "motion/row_plan.hpp"
#include "palette/moments.hpp"
#include "palette/similarity.hpp"
#include "palette/spaces.hpp"

namespace posepack::palette {

// What a bone that is no similarity may be off by, fraction of R: the share of rounding in the default bound.
inline constexpr double kStretchTolerance = 5e-4;

// L of an animal, in units of palette space. Longer holds the scale more finely, but what carries the scale,
// (s - 1) L/2, then drowns the translation beside it: here it stays below 2 R. docs/encodings/dualquat.md has
// the measurement.
//   largest_change  of all fits, at least 0
inline double scale_length(double reach, double largest_change) {
    return 4.0 * reach / std::max(1.0, largest_change);
}

// Turns rotations of successive rows into one hemisphere: q and -q turn alike, but blend through zero.
class Hemispheres {
 public:
    explicit Hemispheres(std::size_t bone_count) : previous_(bone_count, glm::dvec4(0.0, 0.0, 0.0, 1.0)) {}

    // The next row starts a clip: its rotations are turned towards those of the very first row, so that clips
    // blend with each other.
    void begin_clip();
    // The similarity of a bone in the next row, its rotation turned towards the one before. Where a bone has
    // shrunk to nothing it keeps the rotation before.
    Similarity next(std::size_t bone, const motion::Affine& matrix);
    // True when the bone's last rotation lies in another hemisphere than its first in this clip: an odd
    // number of whole turns.
    bool is_turned(std::size_t bone) const { return glm::dot(previous_[bone], clip_first_[bone]) < 0.0; }

 private:
    std::vector<glm::dvec4> previous_, reference_, clip_first_;
    std::vector<bool> is_fresh_ = std::vector<bool>(previous_.size(), true);
};

// A bone that stretches or shears more than its vertices may show.
struct Unfit {
    std::uint32_t row = 0, bone = 0;
    double ratio = 1.0;  // largest to smallest stretch
};

struct DualquatFit {
    std::optional<Unfit> unfit;   // the first found
    bool closing_row = false;     // of a loop: some bone arrives at its first row in the other hemisphere
    double largest_change = 0.0;  // of a scale s: |s - 1|
};

// Walks all rows of a clip.
//   reach  R in units of palette space
DualquatFit fit_dualquat(motion::ClipSampler& sampler, const motion::RowPlan& plan, const Spaces& spaces,
                         std::span<const BoneMoment> moments, double reach);

}  // namespace posepack::palette
