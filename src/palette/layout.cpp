// SPDX-License-Identifier: MIT
#include "palette/layout.hpp"

#include <fmt/format.h>

#include "format/texels.h"
#include "posepack/format.h"

namespace posepack::palette {

using base::Issue;
using base::IssueCode;

namespace {

std::uint8_t encoding_of(recipe::Encoding encoding) {
    switch (encoding) {
        case recipe::Encoding::mat4:
            return POSEPACK_ENCODING_MAT4;
        case recipe::Encoding::affine:
            return POSEPACK_ENCODING_AFFINE;
        default:
            return POSEPACK_ENCODING_DUALQUAT;
    }
}

}  // namespace

base::Result<Layout> choose_layout(const recipe::OutputOptions& options, std::uint32_t bone_count,
                                   std::uint32_t row_count) {
    const bool half = options.texel_format == recipe::TexelFormat::rgba16f;
    const bool planar = options.texel_order == recipe::TexelOrder::planar;
    const std::uint32_t cap = options.caps == recipe::Caps::webgl2 ? 4096 : 16384;
    Layout layout;
    layout.encoding = encoding_of(options.encoding);
    layout.texel_format = half ? POSEPACK_TEXEL_RGBA16F : POSEPACK_TEXEL_RGBA32F;
    layout.texel_order = planar ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
    layout.texels_per_bone = static_cast<std::uint8_t>(posepack_encoding_texels(layout.encoding));
    layout.texel_bytes = half ? 8 : 16;
    layout.bone_count = bone_count;
    layout.row_count = row_count;
    const std::uint32_t row_texels = bone_count * layout.texels_per_bone;
    layout.rows_per_line = (row_count + cap - 1) / cap;
    if (row_texels > cap / layout.rows_per_line)
        return Issue{IssueCode::lim_texture, "",
                     fmt::format("expected at most {} x {} texels, found {} rows of {} texels", cap, cap,
                                 row_count, row_texels)};
    layout.texture_width = row_texels * layout.rows_per_line;
    layout.texture_height = (row_count + layout.rows_per_line - 1) / layout.rows_per_line;
    layout.row_pitch_bytes = layout.texture_width * layout.texel_bytes;
    if (options.row_pitch == recipe::RowPitch::align256)
        layout.row_pitch_bytes = (layout.row_pitch_bytes + 255u) / 256u * 256u;
    // Tables take some of the file too; a thousand bones and four thousand clips need less than 2 MiB.
    constexpr std::uint64_t kTableBytes = 2u << 20;
    if (layout.pixel_bytes() > POSEPACK_MAX_FILE_BYTES - kTableBytes)
        return Issue{IssueCode::lim_container, "",
                     fmt::format("expected at most {} bytes of texels, found {}",
                                 POSEPACK_MAX_FILE_BYTES - kTableBytes, layout.pixel_bytes())};
    return layout;
}

}  // namespace posepack::palette
