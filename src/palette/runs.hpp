// SPDX-License-Identifier: MIT
// Runs: the row scheme in which every bone of every clip has rows of its own
// (docs/format/posepack-1.md, section 10).
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "palette/bounds.hpp"
#include "palette/encode.hpp"
#include "palette/layout.hpp"

namespace posepack::palette {

// The rows of one clip under runs, as they are stored.
struct ClipRuns {
    std::uint8_t encoding = 0;           // POSEPACK_ENCODING_AFFINE or _DUALQUAT
    std::vector<std::uint32_t> entries;  // one a bone, as in RUNS
    std::vector<std::uint8_t> texels;    // of all bone-rows, one behind the other
    std::uint32_t longest = 0;           // intervals of the longest run
    std::vector<std::uint32_t> slots;    // as in SLOT; none: rows are even

    bool is_empty() const { return entries.empty(); }
};

// Puts the runs of one clip together. Bones with rows of their own come first in any order, then those that
// share.
class RunEncoder {
 public:
    // `aids` as for uniform rows; they must outlive the encoder. `enough` as of round_dualquat.
    RunEncoder(std::uint8_t encoding, std::uint8_t texel_format, const RoundingAids& aids,
               std::size_t bone_count, double enough = HUGE_VAL);

    // Rows of a bone, the end of the run included, as matrices or as similarities whose rotations keep the
    // lengths they are given with.
    //   closes  the last row is stored as the first; `turned`: with all signs turned
    // Returns false, and nothing is added, when a value does not fit the texel format.
    bool add_affine(std::size_t bone, std::span<const motion::Affine> rows, bool closes);
    bool add_dualquat(std::size_t bone, std::span<const Similarity> rows, bool closes, bool turned);
    // `bone` reads the rows of `other`, which has some.
    void share(std::size_t bone, std::size_t other);

    // Grows `box` by all poses of the clip and all between them. Every bone has rows.
    void grow_bounds(const BoneBoxes& boxes, Box& box) const;

    ClipRuns finish();

 private:
    bool store(std::size_t bone, std::span<const float> numbers, std::size_t row_count);
    void write_matrix(std::size_t bone, std::uint32_t interval, float factor, float* matrix) const;

    std::uint8_t encoding_, texel_format_;
    const RoundingAids& aids_;
    double enough_;
    struct Run {
        std::uint32_t first_row = 0, interval_count = 0;
    };
    std::vector<Run> runs_;       // of every bone
    std::vector<float> numbers_;  // of every bone-row, as a reader sees them
};

// The geometry of a texture that holds `texel_count` texels of runs and one bone-row of `last_texels` behind
// them. `bone_count` and `row_count` as in the header. Errors: E-LIM-CONTAINER.
base::Result<Layout> runs_layout(std::uint8_t encoding, std::uint8_t texel_format, std::uint32_t bone_count,
                                 std::uint32_t row_count, std::uint64_t texel_count,
                                 std::uint32_t last_texels);

}  // namespace posepack::palette
