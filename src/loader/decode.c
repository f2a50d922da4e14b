/* SPDX-License-Identifier: MIT */
/* Pixels: the rules of the pixel section, and bone-rows as matrices. */
#include "format/bytes.h"
#include "format/dualquat.h"
#include "format/half.h"
#include "loader/internal.h"

posepack_texel_layout posepack_view_layout(const posepack_view* view) {
    posepack_texel_layout layout;
    layout.bone_count = view->header.bone_count;
    layout.texels_per_bone = view->header.texels_per_bone;
    layout.texel_order = view->header.texel_order;
    layout.texel_bytes = posepack_texel_bytes(view->header.texel_format);
    layout.rows_per_line = view->header.rows_per_line;
    layout.row_pitch_bytes = view->header.row_pitch_bytes;
    return layout;
}

const uint8_t* posepack_pixels(const posepack_view* view) {
    return posepack_section_span(view, view->pixl_section).data;
}

static int geometry_is_valid(const posepack_view* view, uint32_t row_bytes) {
    const posepack_header* h = &view->header;
    const uint64_t raw_bytes = view->sections[view->pixl_section].raw_bytes;
    const uint64_t row_texels = (uint64_t)h->bone_count * h->texels_per_bone;
    const uint64_t tight_bytes = (uint64_t)h->rows_per_line * row_bytes;
    const uint64_t padded_bytes = (tight_bytes + 255u) & ~(uint64_t)255u;
    if (h->rows_per_line < 1 || h->rows_per_line > h->row_count) return 0;
    return h->texture_width_texels == h->rows_per_line * row_texels &&
           h->texture_height_texels == (h->row_count + h->rows_per_line - 1) / h->rows_per_line &&
           (h->row_pitch_bytes == tight_bytes || h->row_pitch_bytes == padded_bytes) &&
           raw_bytes == (uint64_t)h->row_pitch_bytes * h->texture_height_texels &&
           raw_bytes <= POSEPACK_MAX_FILE_BYTES;
}

/*
 * No infinity and no NaN, four halves or two floats at a time: adding one to an exponent field
 * carries into the sign's place only where the field is all ones.
 */
int posepack_texels_are_finite(const uint8_t* texels, uint32_t size, int is_half) {
    const uint64_t exponents = is_half ? 0x7C007C007C007C00u : 0x7F8000007F800000u;
    const uint64_t ones = is_half ? 0x0400040004000400u : 0x0080000000800000u;
    uint64_t carries = 0;
    uint32_t at;
    for (at = 0; at < size; at += 8) carries |= (posepack_read_u64(texels + at) & exponents) + ones;
    return (carries & (is_half ? 0x8000800080008000u : 0x8000000080000000u)) == 0;
}

/* A mat4 is affine: the fourth component of its columns is exactly 0, 0, 0, 1. */
static int bottom_row_is_affine(const uint8_t* row, const posepack_texel_layout* layout, int is_half) {
    const uint32_t bone_step = layout->texel_order == POSEPACK_ORDER_PLANAR ? 1 : 4;
    const uint32_t k_step = layout->texel_order == POSEPACK_ORDER_PLANAR ? layout->bone_count : 1;
    const uint32_t one = is_half ? POSEPACK_HALF_ONE : 0x3F800000u;
    uint32_t bone, k;
    for (bone = 0; bone < layout->bone_count; ++bone) {
        for (k = 0; k < 4; ++k) {
            const uint8_t* texel = row + (bone * bone_step + k * k_step) * layout->texel_bytes;
            const uint32_t w = is_half ? posepack_read_u16(texel + 6) : posepack_read_u32(texel + 12);
            if (w != (k == 3 ? one : 0)) return 0;
        }
    }
    return 1;
}

/* Some component of at least 1/4 and none above 2, by their bits without the sign. Writers stay near 1. */
int posepack_real_part_is_usable(const uint8_t* texel, int is_half) {
    const uint32_t quarter = is_half ? 0x3400u : 0x3E800000u;
    const uint32_t two = is_half ? 0x4000u : 0x40000000u;
    uint32_t largest = 0;
    uint32_t c;
    for (c = 0; c < 4; ++c) {
        const uint32_t magnitude = is_half ? posepack_read_u16(texel + 2 * c) & 0x7FFFu
                                           : posepack_read_u32(texel + 4 * c) & 0x7FFFFFFFu;
        if (magnitude > largest) largest = magnitude;
    }
    return largest >= quarter && largest <= two;
}

static int real_parts_are_usable(const uint8_t* row, const posepack_texel_layout* layout, int is_half) {
    const uint32_t bone_step = layout->texel_order == POSEPACK_ORDER_PLANAR ? 1 : 2;
    uint32_t bone;
    for (bone = 0; bone < layout->bone_count; ++bone) {
        if (!posepack_real_part_is_usable(row + bone * bone_step * layout->texel_bytes, is_half)) return 0;
    }
    return 1;
}

static int row_is_valid(const posepack_view* view, const uint8_t* row, const posepack_texel_layout* layout,
                        int is_half) {
    switch (view->header.encoding) {
        case POSEPACK_ENCODING_MAT4:
            return bottom_row_is_affine(row, layout, is_half);
        case POSEPACK_ENCODING_DUALQUAT:
            return real_parts_are_usable(row, layout, is_half);
        default:
            return 1;
    }
}

int posepack_is_equal(const uint8_t* a, const uint8_t* b, uint32_t size) {
    uint32_t i;
    for (i = 0; i < size; ++i) {
        if (a[i] != b[i]) return 0;
    }
    return 1;
}

/* One texture line: its rows, the places behind the last row, and the fill up to the pitch. */
static posepack_result check_line(const posepack_view* view, const posepack_texel_layout* layout,
                                  uint32_t line, uint32_t row_bytes) {
    const int is_half = view->header.texel_format == POSEPACK_TEXEL_RGBA16F;
    const uint32_t used_bytes = layout->rows_per_line * row_bytes;
    const uint8_t* start = posepack_pixels(view) + (uint64_t)line * layout->row_pitch_bytes;
    const uint8_t* last = NULL;
    uint32_t column;
    if (!posepack_texels_are_finite(start, used_bytes, is_half)) return POSEPACK_ERROR_SEMANTIC;
    for (column = 0; column < layout->rows_per_line; ++column) {
        const uint8_t* row = start + column * row_bytes;
        if (line * layout->rows_per_line + column >= view->header.row_count) {
            /* Blending may read one row too far: what it finds there must be a pose. */
            if (!posepack_is_equal(row, last, row_bytes)) return POSEPACK_ERROR_SEMANTIC;
        } else if (!row_is_valid(view, row, layout, is_half)) {
            return POSEPACK_ERROR_SEMANTIC;
        } else {
            last = row;
        }
    }
    if (!posepack_all_zero(start + used_bytes, layout->row_pitch_bytes - used_bytes)) {
        return POSEPACK_ERROR_PADDING;
    }
    return POSEPACK_OK;
}

int posepack_bone_closes(const uint8_t* first, const uint8_t* closing, uint32_t texel_count,
                         uint32_t k_step_bytes, uint32_t texel_bytes, int may_turn) {
    const uint32_t number_bytes = texel_bytes / 4;
    uint32_t turned = 0, differing = 0;
    uint32_t k, i;
    for (k = 0; k < texel_count; ++k) {
        const uint8_t* a = first + k * k_step_bytes;
        const uint8_t* b = closing + k * k_step_bytes;
        for (i = 0; i < texel_bytes; ++i) {
            const uint32_t sign = i % number_bytes == number_bytes - 1 ? 0x80u : 0u;
            differing |= (uint32_t)(a[i] ^ b[i]);
            turned |= (uint32_t)(a[i] ^ b[i]) ^ sign;
        }
    }
    return differing == 0 || (may_turn && turned == 0);
}

static int closing_rows_are_valid(const posepack_view* view, const posepack_texel_layout* layout) {
    const uint32_t k_step = layout->texel_order == POSEPACK_ORDER_PLANAR ? layout->bone_count : 1;
    const uint8_t* clips = posepack_section_span(view, view->clip_section).data + POSEPACK_CLIP_HEAD_BYTES;
    uint32_t i, bone;
    for (i = 0; i < view->header.clip_count; ++i) {
        const uint8_t* r = clips + i * POSEPACK_CLIP_RECORD_BYTES;
        const uint32_t first_row = posepack_read_u32(r + POSEPACK_CLIP_FIRST_ROW);
        const uint32_t row_count = posepack_read_u32(r + POSEPACK_CLIP_ROW_COUNT);
        if (r[POSEPACK_CLIP_CLOSING_ROW] == 0) continue;
        for (bone = 0; bone < layout->bone_count; ++bone) {
            const uint8_t* first = posepack_pixels(view) + posepack_texel_offset(layout, first_row, bone, 0);
            const uint8_t* last =
                posepack_pixels(view) + posepack_texel_offset(layout, first_row + row_count, bone, 0);
            if (!posepack_bone_closes(first, last, 2, k_step * layout->texel_bytes, layout->texel_bytes, 1)) {
                return 0;
            }
        }
    }
    return 1;
}

static posepack_result check_row_pixels(const posepack_view* view) {
    const posepack_texel_layout layout = posepack_view_layout(view);
    const uint32_t row_bytes = layout.bone_count * layout.texels_per_bone * layout.texel_bytes;
    uint32_t line;
    if (!geometry_is_valid(view, row_bytes)) return POSEPACK_ERROR_SEMANTIC;
    if (view->sections[view->pixl_section].flags != POSEPACK_CODEC_NONE) return POSEPACK_ERROR_NEEDS_DECODE;
    for (line = 0; line < view->header.texture_height_texels; ++line) {
        const posepack_result result = check_line(view, &layout, line, row_bytes);
        if (result != POSEPACK_OK) return result;
    }
    return closing_rows_are_valid(view, &layout) ? POSEPACK_OK : POSEPACK_ERROR_SEMANTIC;
}

posepack_result posepack_check_pixels(const posepack_view* view) {
    return view->header.row_scheme == POSEPACK_ROWS_RUNS ? posepack_check_run_pixels(view)
                                                         : check_row_pixels(view);
}

posepack_result posepack_get_texels(const posepack_view* view, posepack_texels* texels) {
    if (view == NULL || view->bytes == NULL || texels == NULL) return POSEPACK_ERROR_ARG;
    texels->data = posepack_pixels(view);
    texels->size_bytes = (size_t)view->sections[view->pixl_section].stored_bytes;
    texels->width_texels = view->header.texture_width_texels;
    texels->height_texels = view->header.texture_height_texels;
    texels->row_pitch_bytes = view->header.row_pitch_bytes;
    texels->format = view->header.texel_format;
    return POSEPACK_OK;
}

/* The four components of one RGBA16F or RGBA32F texel. */
static void read_texel(const uint8_t* texel, uint32_t texel_bytes, float out[4]) {
    uint32_t c;
    for (c = 0; c < 4; ++c) {
        out[c] = texel_bytes == 8 ? posepack_float_from_half(posepack_read_u16(texel + 2 * c))
                                  : posepack_read_f32(texel + 4 * c);
    }
}

static posepack_dualquat read_dualquat(const posepack_bone_form* form, const uint8_t* texel) {
    posepack_dualquat row;
    read_texel(texel, form->texel_bytes, row.real);
    read_texel(texel + form->k_step_bytes, form->texel_bytes, row.dual);
    return row;
}

/* Columns of a mat4, rows of an affine, to a 3x4 matrix. */
static void read_matrix(const posepack_bone_form* form, const uint8_t* texel, float* matrix) {
    float column[4];
    uint32_t k;
    for (k = 0; k < form->texels_per_bone; ++k) {
        if (form->encoding == POSEPACK_ENCODING_AFFINE) {
            read_texel(texel + k * form->k_step_bytes, form->texel_bytes, matrix + 4 * k);
        } else {
            read_texel(texel + k * form->k_step_bytes, form->texel_bytes, column);
            matrix[k] = column[0];
            matrix[4 + k] = column[1];
            matrix[8 + k] = column[2];
        }
    }
}

void posepack_decode_texels(const posepack_bone_form* form, const uint8_t* texel, float* matrix) {
    if (form->encoding == POSEPACK_ENCODING_DUALQUAT) {
        const posepack_dualquat row = read_dualquat(form, texel);
        posepack_dualquat_decode(&row, form->dualquat_length, matrix);
    } else {
        read_matrix(form, texel, matrix);
    }
}

void posepack_blend_texels(const posepack_bone_form* form, const uint8_t* texel0, const uint8_t* texel1,
                           float factor, float* matrix) {
    if (form->encoding == POSEPACK_ENCODING_DUALQUAT) {
        const posepack_dualquat a = read_dualquat(form, texel0);
        const posepack_dualquat b = read_dualquat(form, texel1);
        posepack_dualquat_blend(&a, &b, factor, form->dualquat_length, matrix);
    } else {
        float other[12];
        uint32_t i;
        read_matrix(form, texel0, matrix);
        read_matrix(form, texel1, other);
        for (i = 0; i < 12; ++i) matrix[i] = matrix[i] * (1.0f - factor) + other[i] * factor;
    }
}

void posepack_decode_source(const posepack_bone_source* source, float* matrix) {
    uint32_t i;
    if (source->texel0 == NULL) {
        for (i = 0; i < 12; ++i) matrix[i] = 0.0f;
    } else if (source->factor > 0.0f) {
        posepack_blend_texels(&source->form, source->texel0, source->texel1, source->factor, matrix);
    } else {
        posepack_decode_texels(&source->form, source->texel0, matrix);
    }
}

posepack_scaled_dualquat posepack_read_source(const posepack_bone_source* source) {
    const float length = source->form.dualquat_length;
    const posepack_dualquat row0 = read_dualquat(&source->form, source->texel0);
    const posepack_scaled_dualquat first = posepack_dualquat_take_scale(&row0, length);
    if (source->factor > 0.0f) {
        const posepack_dualquat row1 = read_dualquat(&source->form, source->texel1);
        const posepack_scaled_dualquat second = posepack_dualquat_take_scale(&row1, length);
        return posepack_dualquat_mix(&first, &second, source->factor);
    }
    return first;
}

static posepack_bone_form form_of(const posepack_view* view) {
    posepack_bone_form form;
    form.encoding = view->header.encoding;
    form.texels_per_bone = view->header.texels_per_bone;
    form.texel_bytes = posepack_texel_bytes(view->header.texel_format);
    form.k_step_bytes =
        form.texel_bytes * (view->header.texel_order == POSEPACK_ORDER_PLANAR ? view->header.bone_count : 1);
    form.dualquat_length = view->header.dualquat_length;
    return form;
}

static const uint8_t* bone_texel(const posepack_view* view, const posepack_texel_layout* layout, uint32_t row,
                                 uint32_t bone) {
    return posepack_pixels(view) + posepack_texel_offset(layout, row, bone, 0);
}

/* Bones `first` to `last` - 1, between two rows that are in range. */
static void blend_bones(const posepack_view* view, uint32_t row0, uint32_t row1, float factor, uint32_t first,
                        uint32_t last, float* matrices) {
    const posepack_texel_layout layout = posepack_view_layout(view);
    const posepack_bone_form form = form_of(view);
    uint32_t bone;
    for (bone = first; bone < last; ++bone, matrices += 12) {
        const uint8_t* texel = bone_texel(view, &layout, row0, bone);
        if (factor == 0.0f) {
            posepack_decode_texels(&form, texel, matrices);
        } else {
            posepack_blend_texels(&form, texel, bone_texel(view, &layout, row1, bone), factor, matrices);
        }
    }
}

posepack_result posepack_blend_bone(const posepack_view* view, uint32_t row0, uint32_t row1, float factor,
                                    uint32_t bone, float matrix[12]) {
    if (view == NULL || view->bytes == NULL || matrix == NULL) return POSEPACK_ERROR_ARG;
    if (view->header.row_scheme != POSEPACK_ROWS_UNIFORM) return POSEPACK_ERROR_UNSUPPORTED;
    if (row0 >= view->header.row_count || row1 >= view->header.row_count || bone >= view->header.bone_count) {
        return POSEPACK_ERROR_INDEX;
    }
    blend_bones(view, row0, row1, factor, bone, bone + 1, matrix);
    return POSEPACK_OK;
}

posepack_result posepack_blend_row(const posepack_view* view, uint32_t row0, uint32_t row1, float factor,
                                   float* matrices) {
    if (view == NULL || view->bytes == NULL || matrices == NULL) return POSEPACK_ERROR_ARG;
    if (view->header.row_scheme != POSEPACK_ROWS_UNIFORM) return POSEPACK_ERROR_UNSUPPORTED;
    if (row0 >= view->header.row_count || row1 >= view->header.row_count) return POSEPACK_ERROR_INDEX;
    blend_bones(view, row0, row1, factor, 0, view->header.bone_count, matrices);
    return POSEPACK_OK;
}

posepack_result posepack_decode_bone(const posepack_view* view, uint32_t row, uint32_t bone,
                                     float matrix[12]) {
    return posepack_blend_bone(view, row, row, 0.0f, bone, matrix);
}

posepack_result posepack_decode_row(const posepack_view* view, uint32_t row, float* matrices) {
    return posepack_blend_row(view, row, row, 0.0f, matrices);
}
