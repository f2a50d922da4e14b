// SPDX-License-Identifier: MIT
#include "vat/vram.hpp"

namespace posepack::vat {

std::uint64_t texture_bytes(const Form& form, std::uint64_t row_count, std::uint64_t bone_count,
                            std::uint64_t vertex_count) {
    return row_count * (form.is_palette ? bone_count : vertex_count) * form.bytes_per_element;
}

std::uint32_t texel_reads(const Form& form, std::uint32_t influences) {
    constexpr std::uint32_t kBlendedRows = 2;
    return kBlendedRows * form.texels_per_element * (form.is_palette ? influences : 1);
}

}  // namespace posepack::vat
