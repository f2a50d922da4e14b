// SPDX-License-Identifier: MIT
// Rows of a container as the shipped loader decodes them, the last two kept.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "posepack/loader.h"

namespace posepack::measure {

class DecodedRows {
 public:
    // `view` must be open and outlive this.
    explicit DecodedRows(const posepack_view& view);

    // Matrices of row `row` of the container (3x4 row-major, one a bone); valid until two other rows are
    // read.
    std::span<const float> row(std::uint32_t row);

    // The blend that a shader makes of two rows, in float: row0 * (1 - factor) + row1 * factor.
    void blend(std::uint32_t row0, std::uint32_t row1, float factor, std::span<float> out);

 private:
    struct Slot {
        std::uint32_t row = POSEPACK_NONE;
        std::vector<float> matrices;
    };
    const posepack_view& view_;
    Slot slots_[2];
    int oldest_ = 0;
};

}  // namespace posepack::measure
