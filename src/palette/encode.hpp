// SPDX-License-Identifier: MIT
// Encoding of rows: skinning matrices to texels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "motion/affine.hpp"
#include "palette/layout.hpp"

namespace posepack::palette {

// The texels of a palette, line by line, and the bones that did not fit their format.
class RowEncoder {
 public:
    explicit RowEncoder(const Layout& layout);

    // Writes row `row`. `stored` receives what a reader will decode: a 3x4 row-major matrix for every bone.
    // Returns the first bone with a value that the texel format cannot hold, or bone_count when all fit;
    // then nothing is written.
    std::uint32_t encode(std::uint32_t row, std::span<const motion::Affine> bones, std::span<float> stored);

    // Fills what is left of the last line with its last row, and hands the texels over.
    std::vector<std::uint8_t> finish();

 private:
    Layout layout_;
    std::vector<std::uint8_t> pixels_;
    std::vector<std::uint16_t> halves_;  // of the row being written
};

}  // namespace posepack::palette
