/* SPDX-License-Identifier: MIT */
/* What the loader's own files share. */
#ifndef POSEPACK_LOADER_INTERNAL_H
#define POSEPACK_LOADER_INTERNAL_H

#include "format/dualquat.h"
#include "format/texels.h"
#include "posepack/loader.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes inside the container. Sizes fit 32 bits because a file has at most 2^28 bytes. */
typedef struct posepack_span {
    const uint8_t* data;
    uint32_t size;
} posepack_span;

/* The stored bytes of `view->sections[section]`, whose place posepack_open has checked. */
posepack_span posepack_section_span(const posepack_view* view, uint32_t section);

/* Number of strings STRS really has room for: at most the count it states. */
uint32_t posepack_string_count(posepack_span strs);

/* String `index`; empty where the index or the stored offsets lead outside the section. */
posepack_string posepack_string_at(posepack_span strs, uint32_t index);

/* Number of u16 in the joint map: the stated count, or less if BONE is shorter. */
uint32_t posepack_joint_map_count(const posepack_view* view, posepack_span bones);

/* Byte order of `a` and `b`: negative, zero or positive; a prefix comes first. */
int posepack_compare_strings(posepack_string a, posepack_string b);

/* The record of clip `index`, which must be below clip_count. */
const uint8_t* posepack_clip_record(const posepack_view* view, uint32_t index);

/* The stored run of a bone in a clip; under runs only. */
uint32_t posepack_stored_run(const posepack_view* view, uint32_t clip, uint32_t bone);

/* The stored slots of a clip, as many as SLOT has room for; none where the clip has none. */
typedef struct posepack_slot_range {
    const uint8_t* slots;
    uint32_t count;
} posepack_slot_range;
posepack_slot_range posepack_stored_slots(const posepack_view* view, uint32_t clip);
posepack_slot posepack_unpack_slot(const uint8_t* stored);

/* The rows at a phase, 0 to 1, in at least one slot. */
posepack_place posepack_place_in_slots(posepack_slot_range range, float phase);

/* SLOT, once runs are known to be valid; also that it is there where a clip needs it, and only there. */
int posepack_slots_are_valid(const posepack_view* view);

/* RUNS, once every other table is known to be valid. */
int posepack_runs_are_valid(const posepack_view* view);

/* Texture geometry and texels under runs. */
posepack_result posepack_check_run_pixels(const posepack_view* view);

/* The pixel section. */
const uint8_t* posepack_pixels(const posepack_view* view);

/*
 * Rules about texels that all row schemes share. No infinity and no NaN in `size` bytes, a multiple of 8; a
 * real part that can be normalised; `closing` the texels `first`, or these with all eight signs turned,
 * texels `k_step_bytes` apart.
 */
int posepack_texels_are_finite(const uint8_t* texels, uint32_t size, int is_half);
int posepack_real_part_is_usable(const uint8_t* texel, int is_half);
int posepack_bone_closes(const uint8_t* first, const uint8_t* closing, uint32_t texel_count,
                         uint32_t k_step_bytes, uint32_t texel_bytes, int may_turn);
int posepack_is_equal(const uint8_t* a, const uint8_t* b, uint32_t size);

/* How the texels of a bone-row are read. */
typedef struct posepack_bone_form {
    uint32_t encoding, texels_per_bone, texel_bytes;
    uint32_t k_step_bytes; /* from a texel of a bone to its next */
    float dualquat_length;
} posepack_bone_form;

/* One bone-row, and the blend of two, as 3x4 matrices. */
void posepack_decode_texels(const posepack_bone_form* form, const uint8_t* texel, float* matrix);
void posepack_blend_texels(const posepack_bone_form* form, const uint8_t* texel0, const uint8_t* texel1,
                           float factor, float* matrix);

/* Where one bone is found at a phase: `texel0` alone where the factor is 0. NULL where changed bytes lead. */
typedef struct posepack_bone_source {
    posepack_bone_form form;
    const uint8_t *texel0, *texel1;
    float factor;
} posepack_bone_source;
posepack_bone_source posepack_find_source(const posepack_view* view, uint32_t clip, uint32_t bone,
                                          float phase);

/* The bone as a 3x4 matrix, zero where texel0 is NULL; as numbers, of a dualquat whose texel0 is not. */
void posepack_decode_source(const posepack_bone_source* source, float* matrix);
posepack_scaled_dualquat posepack_read_source(const posepack_bone_source* source);

/* The layout that the header's copy describes; uniform rows only. */
posepack_texel_layout posepack_view_layout(const posepack_view* view);

/* Every rule about header fields and tables; sections are placed and their checksums right. */
posepack_result posepack_check_tables(const posepack_view* view);

/* Texture geometry, and every rule about texels unless the section is compressed. */
posepack_result posepack_check_pixels(const posepack_view* view);

/* 1 if `size` bytes are zero. */
int posepack_all_zero(const uint8_t* bytes, uint64_t size);

#ifdef __cplusplus
}
#endif

#endif
