/* SPDX-License-Identifier: MIT */
/* Runs: every bone of every clip has rows of its own. The rules of RUNS and of the texels behind it. */
#include "format/bytes.h"
#include "format/half.h"
#include "loader/internal.h"

uint32_t posepack_stored_run(const posepack_view* view, uint32_t clip, uint32_t bone) {
    const posepack_span runs = posepack_section_span(view, view->runs_section);
    return posepack_read_u32(runs.data + POSEPACK_RUN_BYTES * (clip * view->header.bone_count + bone));
}

/*
 * The bone-rows of a clip, or 0 when its runs break a rule: a new run begins where those before it end, any
 * other lies within them, and the longest gives the clip's row_count.
 */
static uint32_t clip_bone_rows(const posepack_view* view, uint32_t clip) {
    const uint8_t* record = posepack_clip_record(view, clip);
    uint32_t bone_rows = 0, longest = 0;
    uint32_t bone;
    for (bone = 0; bone < view->header.bone_count; ++bone) {
        const uint32_t run = posepack_stored_run(view, clip, bone);
        const uint32_t offset = run & POSEPACK_RUN_OFFSET_MASK;
        const uint32_t intervals = run >> POSEPACK_RUN_OFFSET_BITS;
        const uint32_t end = offset + intervals + 1;
        if (end > bone_rows) {
            if (offset != bone_rows) return 0;
            bone_rows = end;
        }
        if (intervals > longest) longest = intervals;
    }
    return posepack_read_u32(record + POSEPACK_CLIP_ROW_COUNT) == longest + 1 ? bone_rows : 0;
}

/* Texels that hold bone-rows: where the last clip ends. Tables are valid. */
static uint64_t used_texels(const posepack_view* view) {
    const uint32_t last = view->header.clip_count - 1;
    const uint8_t* record = posepack_clip_record(view, last);
    return posepack_read_u32(record + POSEPACK_CLIP_FIRST_TEXEL) +
           (uint64_t)clip_bone_rows(view, last) * record[POSEPACK_CLIP_TEXELS_PER_BONE];
}

int posepack_runs_are_valid(const posepack_view* view) {
    const posepack_header* h = &view->header;
    const posepack_span runs = posepack_section_span(view, view->runs_section);
    uint64_t next_texel = 0;
    uint32_t clip;
    if (runs.size != (uint64_t)POSEPACK_RUN_BYTES * h->clip_count * h->bone_count) return 0;
    if (h->texel_order != POSEPACK_ORDER_BONE_MAJOR) return 0;
    for (clip = 0; clip < h->clip_count; ++clip) {
        const uint8_t* record = posepack_clip_record(view, clip);
        const uint32_t bone_rows = clip_bone_rows(view, clip);
        if (bone_rows == 0) return 0;
        if (posepack_read_u32(record + POSEPACK_CLIP_FIRST_TEXEL) != next_texel) return 0;
        /* At most 2^28: a clip has no more bone-rows than bone_count times its row_count. */
        next_texel += (uint64_t)bone_rows * record[POSEPACK_CLIP_TEXELS_PER_BONE];
    }
    return 1;
}

/* Lines for `texels` at a width. */
static uint64_t lines_of(uint64_t texels, uint32_t width) {
    return (texels + width - 1) / width;
}

/* One bone-row behind the last is texels too: whoever reads a row too far finds a pose. */
static int geometry_is_valid(const posepack_view* view, uint64_t texels) {
    const posepack_header* h = &view->header;
    const uint64_t raw_bytes = view->sections[view->pixl_section].raw_bytes;
    const uint32_t last_texels = posepack_clip_record(view, h->clip_count - 1)[POSEPACK_CLIP_TEXELS_PER_BONE];
    uint32_t width = POSEPACK_RUNS_MIN_WIDTH;
    while (lines_of(texels + last_texels, width) > POSEPACK_RUNS_MAX_HEIGHT) width *= 2;
    return h->rows_per_line == 1 && h->texture_width_texels == width &&
           h->texture_height_texels == lines_of(texels + last_texels, width) &&
           h->row_pitch_bytes == width * posepack_texel_bytes(h->texel_format) &&
           raw_bytes == (uint64_t)h->row_pitch_bytes * h->texture_height_texels &&
           raw_bytes <= POSEPACK_MAX_FILE_BYTES;
}

/* Behind the last bone-row it is repeated, up to the end of the texture. */
static int fill_is_valid(const posepack_view* view, uint32_t texels, uint32_t texel_bytes) {
    const uint32_t row_bytes =
        posepack_clip_record(view, view->header.clip_count - 1)[POSEPACK_CLIP_TEXELS_PER_BONE] * texel_bytes;
    const uint8_t* end = posepack_pixels(view) + (uint64_t)texels * texel_bytes;
    const uint32_t size = (uint32_t)view->sections[view->pixl_section].stored_bytes - texels * texel_bytes;
    return posepack_is_equal(end, end - row_bytes, size);
}

static int run_is_valid(const posepack_view* view, uint32_t clip, uint32_t bone, uint32_t texel_bytes) {
    const uint8_t* record = posepack_clip_record(view, clip);
    const int is_half = texel_bytes == 8;
    const int is_dualquat = record[POSEPACK_CLIP_ENCODING] == POSEPACK_ENCODING_DUALQUAT;
    const uint32_t run = posepack_stored_run(view, clip, bone);
    const uint32_t intervals = run >> POSEPACK_RUN_OFFSET_BITS;
    const uint32_t texels = record[POSEPACK_CLIP_TEXELS_PER_BONE];
    const uint32_t row_bytes = texels * texel_bytes;
    const uint8_t* first = posepack_pixels(view) +
                           (uint64_t)posepack_read_u32(record + POSEPACK_CLIP_FIRST_TEXEL) * texel_bytes +
                           (uint64_t)(run & POSEPACK_RUN_OFFSET_MASK) * row_bytes;
    uint32_t row, k;
    for (row = 0; row <= intervals; ++row) {
        const uint8_t* texel = first + (uint64_t)row * row_bytes;
        if (is_dualquat && !posepack_real_part_is_usable(texel, is_half)) return 0;
        if (record[POSEPACK_CLIP_ENCODING] != POSEPACK_ENCODING_MAT4) continue;
        for (k = 0; k < 4; ++k, texel += texel_bytes) {
            const uint32_t one = is_half ? POSEPACK_HALF_ONE : 0x3F800000u;
            const uint32_t w = is_half ? posepack_read_u16(texel + 6) : posepack_read_u32(texel + 12);
            if (w != (k == 3 ? one : 0)) return 0;
        }
    }
    return record[POSEPACK_CLIP_WRAP] != POSEPACK_WRAP_LOOP ||
           posepack_bone_closes(first, first + (uint64_t)intervals * row_bytes, texels, texel_bytes,
                                texel_bytes, is_dualquat);
}

posepack_result posepack_check_run_pixels(const posepack_view* view) {
    const uint32_t texel_bytes = posepack_texel_bytes(view->header.texel_format);
    const uint64_t texels = used_texels(view);
    uint32_t clip, bone;
    if (!geometry_is_valid(view, texels)) return POSEPACK_ERROR_SEMANTIC;
    if (view->sections[view->pixl_section].flags != POSEPACK_CODEC_NONE) return POSEPACK_ERROR_NEEDS_DECODE;
    if (!posepack_texels_are_finite(posepack_pixels(view),
                                    (uint32_t)view->sections[view->pixl_section].stored_bytes,
                                    texel_bytes == 8)) {
        return POSEPACK_ERROR_SEMANTIC;
    }
    for (clip = 0; clip < view->header.clip_count; ++clip) {
        for (bone = 0; bone < view->header.bone_count; ++bone) {
            if (!run_is_valid(view, clip, bone, texel_bytes)) return POSEPACK_ERROR_SEMANTIC;
        }
    }
    return fill_is_valid(view, (uint32_t)texels, texel_bytes) ? POSEPACK_OK : POSEPACK_ERROR_SEMANTIC;
}
