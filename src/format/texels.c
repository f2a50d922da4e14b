/* SPDX-License-Identifier: MIT */
#include "format/texels.h"

#include "posepack/format.h"

uint32_t posepack_texel_bytes(uint32_t texel_format) {
    switch (texel_format) {
        case POSEPACK_TEXEL_RGBA16F:
        case POSEPACK_TEXEL_RG32UI:
            return 8;
        case POSEPACK_TEXEL_RGBA32F:
        case POSEPACK_TEXEL_RGBA32UI:
            return 16;
        default:
            return 0;
    }
}

uint32_t posepack_encoding_texels(uint32_t encoding) {
    switch (encoding) {
        case POSEPACK_ENCODING_MAT4:
            return 4;
        case POSEPACK_ENCODING_AFFINE:
            return 3;
        case POSEPACK_ENCODING_DUALQUAT:
        case POSEPACK_ENCODING_LOCAL:
            return 2;
        case POSEPACK_ENCODING_PACKED:
            return 1;
        default:
            return 0;
    }
}

/* The texel's place within the block of its row. */
static uint32_t index_in_row(const posepack_texel_layout* layout, uint32_t bone, uint32_t k) {
    if (layout->texel_order == POSEPACK_ORDER_PLANAR) return k * layout->bone_count + bone;
    return bone * layout->texels_per_bone + k;
}

uint64_t posepack_texel_index(const posepack_texel_layout* layout, uint32_t row, uint32_t bone, uint32_t k) {
    const uint64_t row_texels = (uint64_t)layout->bone_count * layout->texels_per_bone;
    return row * row_texels + index_in_row(layout, bone, k);
}

uint64_t posepack_texel_offset(const posepack_texel_layout* layout, uint32_t row, uint32_t bone, uint32_t k) {
    const uint64_t row_texels = (uint64_t)layout->bone_count * layout->texels_per_bone;
    const uint64_t line = row / layout->rows_per_line;
    const uint64_t column = (row % layout->rows_per_line) * row_texels + index_in_row(layout, bone, k);
    return line * layout->row_pitch_bytes + column * layout->texel_bytes;
}
