// SPDX-License-Identifier: MIT
// Texture memory and texel reads of palettes and of vertex animation textures at the same rows.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace posepack::vat {

// The forms compared, in the order of Vram::forms.
inline constexpr std::size_t kFormCount = 8;

struct Form {
    std::string_view name;
    bool is_palette;                  // else a vertex animation texture
    std::uint32_t bytes_per_element;  // bytes of one bone (palette) or vertex (VAT) in one row
    std::uint32_t texels_per_element;
};

// mat4, affine and dualquat palettes, then VAT: position alone as 12-byte texels (the published figure), and
// position with normal, a texel each, as RGBA32F and RGBA16F.
inline constexpr std::array<Form, kFormCount> kForms{{
    {"mat4 RGBA32F", true, 64, 4},
    {"mat4 RGBA16F", true, 32, 4},
    {"affine RGBA32F", true, 48, 3},
    {"affine RGBA16F", true, 24, 3},
    {"dualquat RGBA16F", true, 16, 2},
    {"VAT RGB32F position", false, 12, 1},
    {"VAT RGBA32F position + normal", false, 32, 2},
    {"VAT RGBA16F position + normal", false, 16, 2},
}};

// Bytes of the texels of `form`: rows x elements x bytes, nothing for padding.
std::uint64_t texture_bytes(const Form& form, std::uint64_t row_count, std::uint64_t bone_count,
                            std::uint64_t vertex_count);

// Texels that a vertex shader reads for one vertex that blends two rows: a palette reads the texels of each
// of `influences` bones, a VAT its own.
std::uint32_t texel_reads(const Form& form, std::uint32_t influences);

}  // namespace posepack::vat
