// SPDX-License-Identifier: MIT
#include "palette/encode.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "format/bytes.h"
#include "format/half.h"
#include "format/texels.h"
#include "posepack/format.h"

namespace posepack::palette {
namespace {

// Texel k of an affine form holds row k of the 3x4; texel k of a mat4 holds column k of the 4x4.
std::array<float, 4> texel_of(const float* m, std::uint8_t encoding, unsigned k) {
    if (encoding == POSEPACK_ENCODING_AFFINE) return {m[k * 4], m[k * 4 + 1], m[k * 4 + 2], m[k * 4 + 3]};
    return {m[k], m[4 + k], m[8 + k], k == 3 ? 1.0f : 0.0f};
}

}  // namespace

RowEncoder::RowEncoder(const Layout& layout)
    : layout_(layout), pixels_(static_cast<std::size_t>(layout.pixel_bytes())) {}

std::uint32_t RowEncoder::encode(std::uint32_t row, std::span<const motion::Affine> bones,
                                 std::span<float> stored) {
    const bool half = layout_.texel_format == POSEPACK_TEXEL_RGBA16F;
    for (std::uint32_t b = 0; b < layout_.bone_count; ++b)
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 4; ++c) {
                const double exact = c < 3 ? bones[b].linear[c][r] : bones[b].translation[r];
                auto value = static_cast<float>(exact);
                if (half) value = posepack_float_from_half(posepack_half_from_float(value));
                if (!std::isfinite(value)) return b;
                stored[b * 12 + static_cast<std::uint32_t>(r * 4 + c)] = value;
            }
    const posepack_texel_layout texels{layout_.bone_count,  layout_.texels_per_bone, layout_.texel_order,
                                       layout_.texel_bytes, layout_.rows_per_line,   layout_.row_pitch_bytes};
    std::uint8_t* first = pixels_.data() + posepack_texel_offset(&texels, row, 0, 0);
    const std::size_t planar = layout_.texel_order == POSEPACK_ORDER_PLANAR;
    const std::size_t bone_step = layout_.texel_bytes * (planar ? 1u : layout_.texels_per_bone);
    const std::size_t texel_step = layout_.texel_bytes * (planar ? layout_.bone_count : 1u);
    for (std::uint32_t b = 0; b < layout_.bone_count; ++b)
        for (std::uint32_t k = 0; k < layout_.texels_per_bone; ++k) {
            std::uint8_t* at = first + b * bone_step + k * texel_step;
            const auto texel = texel_of(&stored[b * 12], layout_.encoding, k);
            for (std::size_t c = 0; c < 4; ++c)
                if (half)
                    posepack_write_u16(at + c * 2, posepack_half_from_float(texel[c]));
                else
                    posepack_write_f32(at + c * 4, texel[c]);
        }
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
