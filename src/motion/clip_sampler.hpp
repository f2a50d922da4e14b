// SPDX-License-Identifier: MIT
// ClipSampler: the skinning matrices of one clip at any time, in double precision (glTF 2.0 appendix C).
#pragma once

#include <span>
#include <vector>

#include "animal/animal.hpp"
#include "motion/affine.hpp"

namespace posepack::motion {

// The skinning matrices of the node rest pose: joint global x inverse bind of every bone.
std::vector<Affine> rest_pose(const animal::Animal& animal);

// Samples one clip. Nodes that do not move in it are composed once; nodes above no bone never.
// Keeps cursors, so that rising times cost O(1) a channel. Not for use by two threads at once.
class ClipSampler {
 public:
    // `animal` and `clip` must outlive the sampler.
    ClipSampler(const animal::Animal& animal, const animal::Clip& clip);

    // Skinning matrices at `time_s` seconds after the clip's first key; before the first and after the last
    // key of a channel its end values hold. `bones` has one place for every bone of the animal.
    void sample(double time_s, std::span<Affine> bones);

    // Global transform of a node, which some bone hangs from, at the time of the last sample (at the first
    // key before any).
    const Affine& node_global(std::uint32_t node) const { return globals_[node]; }

    // True when some channel above a bone changes over time.
    bool moves() const { return !moving_channels_.empty(); }

    // True when every channel that changes is STEP: poses are held, never blended.
    bool all_steps() const;

    // True when a channel that changes is a cubic spline: it may bend as it likes between two keys.
    bool has_splines() const;

    // Times at which the source jumps, seconds after the first key of the clip; sorted: STEP keys of another
    // value than the one before, and keys within 1e-6 s of one of another value.
    std::vector<double> jump_times_s() const;

    // Key times of the channels that change, seconds after the first key of the clip; sorted, and one
    // of those that lie within 1e-6 s.
    std::vector<double> key_times_s() const;

 private:
    struct Cursor {
        const animal::Channel* channel;
        std::uint32_t key = 0;
    };
    void apply(Cursor& cursor, double absolute_s);

    const animal::Animal& animal_;
    const animal::Clip& clip_;
    std::vector<animal::Transform> locals_;  // of every node
    std::vector<Affine> globals_;            // of every node that a bone hangs from
    std::vector<Cursor> moving_channels_;
    std::vector<std::uint32_t> moving_nodes_;  // parents first: nodes whose global changes
    std::vector<std::uint32_t> moving_bones_;
    std::vector<Affine> inverse_binds_;
    std::vector<Affine> still_bones_;  // every bone at the start; right for bones that never move
};

}  // namespace posepack::motion
