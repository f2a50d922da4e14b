/* SPDX-License-Identifier: MIT */
/* What the loader's own files share. */
#ifndef POSEPACK_LOADER_INTERNAL_H
#define POSEPACK_LOADER_INTERNAL_H

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

/* The layout that the header's copy describes. */
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
