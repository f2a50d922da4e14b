/* SPDX-License-Identifier: MIT */
/* A clip at a phase, whatever the row scheme. */
#include "format/bytes.h"
#include "loader/internal.h"

static int is_open(const posepack_view* view) {
    return view != NULL && view->bytes != NULL;
}

static posepack_run uniform_run(const posepack_view* view, const uint8_t* record, uint32_t bone) {
    const posepack_header* h = &view->header;
    const int is_loop = record[POSEPACK_CLIP_WRAP] == POSEPACK_WRAP_LOOP;
    const int is_planar = h->texel_order == POSEPACK_ORDER_PLANAR;
    const uint32_t first_row = posepack_read_u32(record + POSEPACK_CLIP_FIRST_ROW);
    const uint32_t row_count = posepack_read_u32(record + POSEPACK_CLIP_ROW_COUNT);
    posepack_run run;
    run.texel_step = h->bone_count * h->texels_per_bone;
    run.texel = first_row * run.texel_step + (is_planar ? bone : bone * h->texels_per_bone);
    run.k_step = is_planar ? h->bone_count : 1;
    run.interval_count = is_loop && row_count > 1 ? row_count : row_count - 1;
    run.wraps = is_loop && row_count > 1 && record[POSEPACK_CLIP_CLOSING_ROW] == 0;
    return run;
}

static posepack_run stored_run(const posepack_view* view, const uint8_t* record, uint32_t clip,
                               uint32_t bone) {
    const uint32_t stored = posepack_stored_run(view, clip, bone);
    posepack_run run;
    run.texel_step = record[POSEPACK_CLIP_TEXELS_PER_BONE];
    run.texel = posepack_read_u32(record + POSEPACK_CLIP_FIRST_TEXEL) +
                (stored & POSEPACK_RUN_OFFSET_MASK) * run.texel_step;
    run.k_step = 1;
    run.interval_count = stored >> POSEPACK_RUN_OFFSET_BITS;
    run.wraps = 0;
    return run;
}

static posepack_run run_of(const posepack_view* view, const uint8_t* record, uint32_t clip, uint32_t bone) {
    return view->header.row_scheme == POSEPACK_ROWS_RUNS ? stored_run(view, record, clip, bone)
                                                         : uniform_run(view, record, bone);
}

/* Where texel `texel` of the linear order is; NULL where bytes that changed since lead outside. */
static const uint8_t* texel_at(const posepack_view* view, uint64_t texel, const posepack_bone_form* form) {
    const posepack_header* h = &view->header;
    const uint64_t line = texel / h->texture_width_texels;
    const uint64_t offset = line * h->row_pitch_bytes + texel % h->texture_width_texels * form->texel_bytes;
    const uint64_t size = view->sections[view->pixl_section].stored_bytes;
    const uint64_t reach = (uint64_t)(form->texels_per_bone - 1) * form->k_step_bytes + form->texel_bytes;
    return offset <= size && reach <= size - offset ? posepack_pixels(view) + offset : NULL;
}

/* Cuts rise within a clip. */
static int is_cut(const posepack_view* view, const uint8_t* record, uint32_t clip, uint32_t row) {
    uint32_t first = 0, last = posepack_read_u32(record + POSEPACK_CLIP_CUT_COUNT);
    while (first < last) {
        const uint32_t middle = first + (last - first) / 2;
        uint32_t cut = 0;
        if (posepack_get_cut(view, clip, middle, &cut) != POSEPACK_OK || cut > row) {
            last = middle;
        } else if (cut == row) {
            return 1;
        } else {
            first = middle + 1;
        }
    }
    return 0;
}

/* Rows at even times. */
static posepack_place place_in_run(const posepack_run* run, float phase) {
    const uint32_t intervals = run->interval_count;
    const float position = phase * (float)intervals;
    posepack_place place;
    place.row0 = position >= (float)intervals ? (intervals > 0 ? intervals - 1 : 0) : (uint32_t)position;
    place.factor = position - (float)place.row0;
    place.row1 = run->wraps && place.row0 + 1 == intervals ? 0 : place.row0 + 1;
    return place;
}

static posepack_place place_of(const posepack_view* view, const uint8_t* record, uint32_t clip,
                               const posepack_run* run, float phase) {
    const posepack_slot_range slots = posepack_stored_slots(view, clip);
    posepack_place place = slots.count > 0 && run->interval_count > 0 ? posepack_place_in_slots(slots, phase)
                                                                      : place_in_run(run, phase);
    if (record[POSEPACK_CLIP_INTERPOLATION] == POSEPACK_INTERPOLATION_STEP ||
        is_cut(view, record, clip, place.row0)) {
        /* A row is held until the next begins. */
        if (place.factor >= 1.0f) place.row0 = place.row1;
        place.factor = 0.0f;
    }
    return place;
}

/* 0 where the encoding that the clip states now is none that posepack_open lets through. */
static int form_of(const posepack_view* view, const uint8_t* record, const posepack_run* run,
                   posepack_bone_form* form) {
    form->encoding = record[POSEPACK_CLIP_ENCODING];
    form->texels_per_bone = posepack_encoding_texels(form->encoding);
    form->texel_bytes = posepack_texel_bytes(view->header.texel_format);
    form->k_step_bytes = run->k_step * form->texel_bytes;
    form->dualquat_length = view->header.dualquat_length;
    return form->encoding >= POSEPACK_ENCODING_MAT4 && form->encoding <= POSEPACK_ENCODING_DUALQUAT;
}

/* Into 0 to 1; NaN compares with nothing and becomes 0. */
static float clamped(float phase) {
    if (!(phase > 0.0f)) return 0.0f;
    return phase < 1.0f ? phase : 1.0f;
}

static posepack_bone_source source_of(const posepack_view* view, uint32_t clip, const posepack_run* run,
                                      float phase) {
    const uint8_t* record = posepack_clip_record(view, clip);
    const posepack_place place = place_of(view, record, clip, run, clamped(phase));
    posepack_bone_source source;
    source.texel0 = source.texel1 = NULL;
    source.factor = place.factor;
    if (form_of(view, record, run, &source.form)) {
        source.texel0 = texel_at(view, run->texel + (uint64_t)place.row0 * run->texel_step, &source.form);
        source.texel1 = texel_at(view, run->texel + (uint64_t)place.row1 * run->texel_step, &source.form);
    }
    if (source.texel1 == NULL && source.factor > 0.0f) source.texel0 = NULL;
    return source;
}

posepack_bone_source posepack_find_source(const posepack_view* view, uint32_t clip, uint32_t bone,
                                          float phase) {
    const posepack_run run = run_of(view, posepack_clip_record(view, clip), clip, bone);
    return source_of(view, clip, &run, phase);
}

posepack_result posepack_get_run(const posepack_view* view, uint32_t clip_index, uint32_t bone,
                                 posepack_run* run) {
    if (!is_open(view) || run == NULL) return POSEPACK_ERROR_ARG;
    if (clip_index >= view->header.clip_count || bone >= view->header.bone_count) {
        return POSEPACK_ERROR_INDEX;
    }
    *run = run_of(view, posepack_clip_record(view, clip_index), clip_index, bone);
    return POSEPACK_OK;
}

posepack_result posepack_get_slot(const posepack_view* view, uint32_t clip_index, uint32_t index,
                                  posepack_slot* slot) {
    posepack_slot_range slots;
    if (!is_open(view) || slot == NULL) return POSEPACK_ERROR_ARG;
    if (clip_index >= view->header.clip_count) return POSEPACK_ERROR_INDEX;
    slots = posepack_stored_slots(view, clip_index);
    if (index >= slots.count) return POSEPACK_ERROR_INDEX;
    *slot = posepack_unpack_slot(slots.slots + POSEPACK_SLOT_BYTES * index);
    return POSEPACK_OK;
}

posepack_result posepack_find_place(const posepack_view* view, uint32_t clip_index, float phase,
                                    uint32_t bone, posepack_place* place) {
    posepack_run run;
    const posepack_result result =
        place == NULL ? POSEPACK_ERROR_ARG : posepack_get_run(view, clip_index, bone, &run);
    if (result != POSEPACK_OK) return result;
    *place = place_of(view, posepack_clip_record(view, clip_index), clip_index, &run, clamped(phase));
    return POSEPACK_OK;
}

posepack_result posepack_sample_bone(const posepack_view* view, uint32_t clip_index, float phase,
                                     uint32_t bone, float matrix[12]) {
    posepack_run run;
    posepack_bone_source source;
    const posepack_result result =
        matrix == NULL ? POSEPACK_ERROR_ARG : posepack_get_run(view, clip_index, bone, &run);
    if (result != POSEPACK_OK) return result;
    source = source_of(view, clip_index, &run, phase);
    posepack_decode_source(&source, matrix);
    return POSEPACK_OK;
}

posepack_result posepack_sample_pose(const posepack_view* view, uint32_t clip_index, float phase,
                                     float* matrices) {
    uint32_t bone;
    if (!is_open(view) || matrices == NULL) return POSEPACK_ERROR_ARG;
    if (clip_index >= view->header.clip_count) return POSEPACK_ERROR_INDEX;
    for (bone = 0; bone < view->header.bone_count; ++bone) {
        const posepack_bone_source source = posepack_find_source(view, clip_index, bone, phase);
        posepack_decode_source(&source, matrices + 12 * (size_t)bone);
    }
    return POSEPACK_OK;
}
