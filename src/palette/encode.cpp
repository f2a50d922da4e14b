// SPDX-License-Identifier: MIT
#include "palette/encode.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

// The texels of one bone from its numbers `m`, a 3x4 matrix or the two parts of a dual quaternion. Texel k of
// a mat4 holds column k of the 4x4, whose last row is 0 0 0 1; texel k of the others the numbers from 4 k on.
template <class Number>
void write_bone(std::uint8_t* at, std::size_t texel_step, const Number* m, std::uint8_t encoding,
                Number one) {
    constexpr std::size_t kSize = sizeof(Number);
    if (encoding != POSEPACK_ENCODING_MAT4) {
        for (std::size_t k = 0; k < posepack_encoding_texels(encoding); ++k, at += texel_step)
            for (std::size_t c = 0; c < 4; ++c) write_number(at + c * kSize, m[k * 4 + c]);
        return;
    }
    for (std::size_t k = 0; k < 4; ++k, at += texel_step) {
        for (std::size_t c = 0; c < 3; ++c) write_number(at + c * kSize, m[c * 4 + k]);
        write_number(at + 3 * kSize, k == 3 ? one : Number{0});
    }
}

static_assert(sizeof(posepack_dualquat) == 8 * sizeof(float), "read as eight numbers in a row");

std::span<const float> numbers_of(const std::vector<posepack_dualquat>& row) {
    return {row.front().real, row.size() * 8};
}

std::uint32_t numbers_per_bone(const Layout& layout) {
    return layout.encoding == POSEPACK_ENCODING_DUALQUAT ? 8 : 12;
}

}  // namespace

RowEncoder::RowEncoder(const Layout& layout, RoundingAids aids)
    : layout_(layout),
      aids_(std::move(aids)),
      pixels_(static_cast<std::size_t>(layout.pixel_bytes())),
      halves_(std::size_t{layout.bone_count} * numbers_per_bone(layout)),
      hemispheres_(layout.bone_count) {}

void RowEncoder::begin_clip() {
    hemispheres_.begin_clip();
    starts_clip_ = true;
}

// The twelve numbers of each matrix, as they will be stored.
void RowEncoder::round_matrices(std::span<const motion::Affine> bones, std::span<float> stored) {
    const bool half = layout_.texel_format == POSEPACK_TEXEL_RGBA16F;
    if (half && layout_.encoding == POSEPACK_ENCODING_AFFINE && !aids_.moments.empty()) {
        for (std::size_t b = 0; b < bones.size(); ++b)
            round_affine(bones[b], aids_.moments[b], aids_.halves, std::span<float, 12>(&stored[b * 12], 12));
        round_to_halves(stored.first(halves_.size()), halves_);
        return;
    }
    for (std::uint32_t b = 0; b < layout_.bone_count; ++b)
        for (std::uint32_t r = 0; r < 3; ++r) {
            const int i = static_cast<int>(r);
            float* out = &stored[b * 12 + r * 4];
            for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(bones[b].linear[c][i]);
            out[3] = static_cast<float>(bones[b].translation[i]);
        }
    if (half) round_to_halves(stored.first(halves_.size()), halves_);
}

// The eight numbers of each dual quaternion, as they will be stored: in last_.
void RowEncoder::round_dualquats(std::span<const motion::Affine> bones, std::span<float> stored) {
    const bool half = layout_.texel_format == POSEPACK_TEXEL_RGBA16F;
    const double length = static_cast<double>(aids_.dualquat_length);
    std::swap(before_, last_);
    last_.resize(bones.size());
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const Similarity target = hemispheres_.next(b, bones[b]);
        std::array<float, 8> numbers{};
        if (half) {
            round_dualquat(bones[b], target, aids_.moments[b], length, aids_.halves, numbers);
            round_to_halves(numbers, std::span(halves_).subspan(b * 8, 8));
        } else {
            std::array<double, 8> exact{};
            dualquat_numbers(target, length, exact);
            for (std::size_t c = 0; c < 8; ++c) numbers[c] = static_cast<float>(exact[c]);
        }
        std::copy_n(&numbers[0], 4, last_[b].real);
        std::copy_n(&numbers[4], 4, last_[b].dual);
        posepack_dualquat_decode(&last_[b], aids_.dualquat_length, &stored[b * 12]);
    }
    if (starts_clip_) clip_first_ = last_;
    starts_clip_ = false;
}

// The numbers of all bones, bone by bone, to their texels; halves come from halves_.
void RowEncoder::write_row(std::uint32_t row, std::span<const float> floats) {
    const bool half = layout_.texel_format == POSEPACK_TEXEL_RGBA16F;
    const posepack_texel_layout texels{layout_.bone_count,  layout_.texels_per_bone, layout_.texel_order,
                                       layout_.texel_bytes, layout_.rows_per_line,   layout_.row_pitch_bytes};
    std::uint8_t* at = pixels_.data() + posepack_texel_offset(&texels, row, 0, 0);
    const bool planar = layout_.texel_order == POSEPACK_ORDER_PLANAR;
    const std::size_t bone_step = std::size_t{layout_.texel_bytes} * (planar ? 1 : layout_.texels_per_bone);
    const std::size_t texel_step = std::size_t{layout_.texel_bytes} * (planar ? layout_.bone_count : 1);
    const std::size_t numbers = numbers_per_bone(layout_);
    for (std::uint32_t b = 0; b < layout_.bone_count; ++b, at += bone_step)
        if (half)
            write_bone(at, texel_step, &halves_[b * numbers], layout_.encoding,
                       std::uint16_t{POSEPACK_HALF_ONE});
        else
            write_bone(at, texel_step, &floats[b * numbers], layout_.encoding, 1.0f);
}

std::uint32_t RowEncoder::encode(std::uint32_t row, std::span<const motion::Affine> bones,
                                 std::span<float> stored) {
    const bool dualquat = layout_.encoding == POSEPACK_ENCODING_DUALQUAT;
    if (dualquat)
        round_dualquats(bones, stored);
    else
        round_matrices(bones, stored);
    const std::span<const float> numbers = dualquat ? numbers_of(last_) : stored;
    for (std::uint32_t e = 0; e < halves_.size(); ++e)
        if (!std::isfinite(numbers[e])) return e / numbers_per_bone(layout_);
    write_row(row, numbers);
    return layout_.bone_count;
}

void RowEncoder::close_clip(std::uint32_t closing_row) {
    std::swap(before_, last_);
    last_ = clip_first_;
    for (std::size_t b = 0; b < last_.size(); ++b) {
        const bool turned = hemispheres_.is_turned(b);
        for (std::size_t c = 0; c < 4; ++c) {
            if (turned) last_[b].real[c] = -last_[b].real[c];
            if (turned) last_[b].dual[c] = -last_[b].dual[c];
            if (layout_.texel_format != POSEPACK_TEXEL_RGBA16F) continue;
            halves_[b * 8 + c] = posepack_half_from_float(last_[b].real[c]);
            halves_[b * 8 + 4 + c] = posepack_half_from_float(last_[b].dual[c]);
        }
    }
    if (closing_row != animal::kNone) write_row(closing_row, numbers_of(last_));
}

void RowEncoder::between(float factor, std::span<float> matrices) const {
    for (std::size_t b = 0; b < last_.size(); ++b)
        posepack_dualquat_blend(&before_[b], &last_[b], factor, aids_.dualquat_length, &matrices[b * 12]);
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
