// SPDX-License-Identifier: MIT
#include "measure/decoded_rows.hpp"

#include <algorithm>
#include <cassert>

namespace posepack::measure {

DecodedRows::DecodedRows(const posepack_view& view) : view_(view) {
    for (Slot& slot : slots_) slot.matrices.resize(std::size_t{view.header.bone_count} * 12);
}

std::span<const float> DecodedRows::row(std::uint32_t row) {
    for (int i = 0; i < 2; ++i)
        if (slots_[i].row == row) {
            oldest_ = 1 - i;
            return slots_[i].matrices;
        }
    Slot& slot = slots_[oldest_];
    [[maybe_unused]] const posepack_result result = posepack_decode_row(&view_, row, slot.matrices.data());
    assert(result == POSEPACK_OK);
    slot.row = row;
    oldest_ = 1 - oldest_;
    return slot.matrices;
}

void DecodedRows::blend(std::uint32_t row0, std::uint32_t row1, float factor, std::span<float> out) {
    const std::span<const float> a = row(row0);
    if (factor == 0.0f || row0 == row1) {
        std::copy(a.begin(), a.end(), out.begin());
        return;
    }
    const std::span<const float> b = row(row1);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] * (1.0f - factor) + b[i] * factor;
}

}  // namespace posepack::measure
