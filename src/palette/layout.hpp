// SPDX-License-Identifier: MIT
// Layout: how the rows of a palette lie in a texture.
#pragma once

#include <cstdint>

#include "base/result.hpp"
#include "recipe/catalog.hpp"

namespace posepack::palette {

struct Layout {
    std::uint8_t encoding = 0;      // POSEPACK_ENCODING_*
    std::uint8_t texel_format = 0;  // POSEPACK_TEXEL_*
    std::uint8_t texel_order = 0;   // POSEPACK_ORDER_*
    std::uint8_t texels_per_bone = 0;
    std::uint32_t texel_bytes = 0;
    std::uint32_t bone_count = 0;
    std::uint32_t row_count = 0;
    std::uint32_t rows_per_line = 1;
    std::uint32_t texture_width = 0;   // texels
    std::uint32_t texture_height = 0;  // lines
    std::uint32_t row_pitch_bytes = 0;
    std::uint64_t run_texels = 0;  // texels of all runs; 0: rows are uniform

    std::uint64_t pixel_bytes() const { return std::uint64_t{row_pitch_bytes} * texture_height; }
    // Bytes of the texels that hold rows: no padding, no unused places of the last line.
    std::uint64_t texel_payload_bytes() const {
        if (run_texels > 0) return run_texels * texel_bytes;
        return std::uint64_t{texel_bytes} * texels_per_bone * bone_count * row_count;
    }
};

// One row a line; several side by side only where the height cap forces it.
//   bone_count  1..1024, row_count  1..65536
// Errors: E-LIM-TEXTURE, E-LIM-CONTAINER.
base::Result<Layout> choose_layout(const recipe::OutputOptions& options, std::uint32_t bone_count,
                                   std::uint32_t row_count);

}  // namespace posepack::palette
