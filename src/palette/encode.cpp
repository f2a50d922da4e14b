// SPDX-License-Identifier: MIT
#include "palette/encode.hpp"

#include <algorithm>
#include <cmath>

#include "format/bytes.h"
#include "format/half.h"
#include "format/texels.h"
#include "palette/half_rows.hpp"
#include "posepack/format.h"

namespace posepack::palette {
namespace {

void write_number(std::uint8_t* at, std::uint16_t half) {
    posepack_write_u16(at, half);
}
void write_number(std::uint8_t* at, float value) {
    posepack_write_f32(at, value);
}

// The texels of one bone from its 3x4 matrix `m`. Texel k of an affine form holds row k; texel k of a mat4
// holds column k of the 4x4, whose last row is 0 0 0 1.
template <class Number>
void write_bone(std::uint8_t* at, std::size_t texel_step, const Number* m, std::uint8_t encoding,
                Number one) {
    constexpr std::size_t kSize = sizeof(Number);
    if (encoding == POSEPACK_ENCODING_AFFINE) {
        for (std::size_t k = 0; k < 3; ++k, at += texel_step)
            for (std::size_t c = 0; c < 4; ++c) write_number(at + c * kSize, m[k * 4 + c]);
        return;
    }
    for (std::size_t k = 0; k < 4; ++k, at += texel_step) {
        for (std::size_t c = 0; c < 3; ++c) write_number(at + c * kSize, m[c * 4 + k]);
        write_number(at + 3 * kSize, k == 3 ? one : Number{0});
    }
}

}  // namespace

RowEncoder::RowEncoder(const Layout& layout)
    : layout_(layout),
      pixels_(static_cast<std::size_t>(layout.pixel_bytes())),
      halves_(std::size_t{layout.bone_count} * 12) {}

std::uint32_t RowEncoder::encode(std::uint32_t row, std::span<const motion::Affine> bones,
                                 std::span<float> stored) {
    const bool half = layout_.texel_format == POSEPACK_TEXEL_RGBA16F;
    for (std::uint32_t b = 0; b < layout_.bone_count; ++b)
        for (std::uint32_t r = 0; r < 3; ++r) {
            const int i = static_cast<int>(r);
            float* out = &stored[b * 12 + r * 4];
            for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(bones[b].linear[c][i]);
            out[3] = static_cast<float>(bones[b].translation[i]);
        }
    if (half) round_to_halves(stored.first(halves_.size()), halves_);
    for (std::uint32_t e = 0; e < halves_.size(); ++e)
        if (!std::isfinite(stored[e])) return e / 12;
    const posepack_texel_layout texels{layout_.bone_count,  layout_.texels_per_bone, layout_.texel_order,
                                       layout_.texel_bytes, layout_.rows_per_line,   layout_.row_pitch_bytes};
    std::uint8_t* at = pixels_.data() + posepack_texel_offset(&texels, row, 0, 0);
    const bool planar = layout_.texel_order == POSEPACK_ORDER_PLANAR;
    const std::size_t bone_step = std::size_t{layout_.texel_bytes} * (planar ? 1 : layout_.texels_per_bone);
    const std::size_t texel_step = std::size_t{layout_.texel_bytes} * (planar ? layout_.bone_count : 1);
    for (std::uint32_t b = 0; b < layout_.bone_count; ++b, at += bone_step)
        if (half)
            write_bone(at, texel_step, &halves_[b * 12], layout_.encoding, std::uint16_t{POSEPACK_HALF_ONE});
        else
            write_bone(at, texel_step, &stored[b * 12], layout_.encoding, 1.0f);
    return layout_.bone_count;
}

std::vector<std::uint8_t> RowEncoder::finish() {
    const std::size_t row_bytes =
        std::size_t{layout_.bone_count} * layout_.texels_per_bone * layout_.texel_bytes;
    const std::size_t last_line = std::size_t{layout_.row_pitch_bytes} * (layout_.texture_height - 1);
    const std::uint32_t used = layout_.row_count - layout_.rows_per_line * (layout_.texture_height - 1);
    for (std::uint32_t i = used; i < layout_.rows_per_line; ++i)
        std::copy_n(pixels_.begin() + static_cast<long>(last_line + (used - 1) * row_bytes), row_bytes,
                    pixels_.begin() + static_cast<long>(last_line + i * row_bytes));
    return std::move(pixels_);
}

}  // namespace posepack::palette
