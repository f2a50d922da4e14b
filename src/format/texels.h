/* SPDX-License-Identifier: MIT */
/*
 * Where a texel of the palette lies: as a linear index in a storage buffer, and as a byte offset in
 * the texture.
 *
 * One row of the palette is a block of bone_count * texels_per_bone consecutive texels; within it
 *   bone-major  bone * texels_per_bone + k
 *   planar      k * bone_count + bone
 * and a texture line holds rows_per_line such blocks side by side. With a tight pitch the two
 * addresses are the same place.
 */
#ifndef POSEPACK_FORMAT_TEXELS_H
#define POSEPACK_FORMAT_TEXELS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The shape of a palette's pixel section; all counts at least 1. */
typedef struct posepack_texel_layout {
    uint32_t bone_count;
    uint32_t texels_per_bone;
    uint32_t texel_order; /* POSEPACK_ORDER_BONE_MAJOR or POSEPACK_ORDER_PLANAR */
    uint32_t texel_bytes;
    uint32_t rows_per_line;
    uint32_t row_pitch_bytes; /* from one texture line to the next */
} posepack_texel_layout;

/* Bytes of one texel of a POSEPACK_TEXEL_* format: 8 or 16; 0 for a format nobody knows. */
uint32_t posepack_texel_bytes(uint32_t texel_format);

/* Texels a bone takes in an encoding: mat4 4, affine 3, dualquat and local 2, packed 1; else 0. */
uint32_t posepack_encoding_texels(uint32_t encoding);

/* Linear index of texel `k` of bone `bone` in row `row`. Cannot overflow within the format's limits. */
uint64_t posepack_texel_index(const posepack_texel_layout* layout, uint32_t row, uint32_t bone, uint32_t k);

/* Byte offset of the same texel from the start of the pixel section. */
uint64_t posepack_texel_offset(const posepack_texel_layout* layout, uint32_t row, uint32_t bone, uint32_t k);

#ifdef __cplusplus
}
#endif

#endif
