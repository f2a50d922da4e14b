// SPDX-License-Identifier: MIT
// Encoding of rows: skinning matrices to texels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "format/dualquat.h"
#include "motion/affine.hpp"
#include "palette/dualquat_fit.hpp"
#include "palette/layout.hpp"
#include "palette/moments.hpp"
#include "palette/rounding.hpp"

namespace posepack::palette {

// What rounding may know of the animal. Without moments every number of a matrix is rounded to the nearest
// half.
struct RoundingAids {
    std::vector<BoneMoment> moments;  // of every bone, or none; `dualquat` needs them
    Halves halves = Halves::all;
    float dualquat_length = 0.0f;  // L; above zero for `dualquat`
};

// The texels of a palette, line by line, and the bones that did not fit their format.
class RowEncoder {
 public:
    explicit RowEncoder(const Layout& layout, RoundingAids aids = {});

    // The row that comes next starts a clip. Needed by `dualquat` alone.
    void begin_clip();

    // Writes row `row`. `stored` receives what a reader will decode: a 3x4 row-major matrix for every bone.
    // Under `dualquat` the rows of a clip come in their order.
    // Returns the first bone with a value that the texel format cannot hold, or bone_count when all fit;
    // then nothing is written.
    std::uint32_t encode(std::uint32_t row, std::span<const motion::Affine> bones, std::span<float> stored);

    // Ends a loop: row `closing_row` becomes the first row of the clip once more, with signs that continue
    // the last one's. kNone: it is stored nowhere, but between() knows it.
    void close_clip(std::uint32_t closing_row);

    // What a reader decodes between the two rows written last, under `dualquat`.
    void between(float factor, std::span<float> matrices) const;

    // Fills what is left of the last line with its last row, and hands the texels over.
    std::vector<std::uint8_t> finish();

 private:
    void round_matrices(std::span<const motion::Affine> bones, std::span<float> stored);
    void round_dualquats(std::span<const motion::Affine> bones, std::span<float> stored);
    void write_row(std::uint32_t row, std::span<const float> floats);

    Layout layout_;
    RoundingAids aids_;
    std::vector<std::uint8_t> pixels_;
    std::vector<std::uint16_t> halves_;  // of the row being written
    Hemispheres hemispheres_;
    std::vector<posepack_dualquat> before_, last_, clip_first_;  // rows as stored
    bool starts_clip_ = false;
};

}  // namespace posepack::palette
