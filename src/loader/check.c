/* SPDX-License-Identifier: MIT */
/* The meaning of header fields and tables: every index, range, enumeration and reserved byte. */
#include "format/bytes.h"
#include "loader/internal.h"

/* Counts that one table gives and another needs. */
typedef struct table_counts {
    uint32_t strings, joints, meshes;
} table_counts;

static int all_finite(const uint8_t* bytes, uint32_t count) {
    uint32_t i;
    for (i = 0; i < count; ++i) {
        if ((posepack_read_u32(bytes + 4 * i) & 0x7F800000u) == 0x7F800000u) return 0;
    }
    return 1;
}

/* `count` finite floats, none below zero, nor minus zero. */
static int all_non_negative(const uint8_t* bytes, uint32_t count) {
    uint32_t i;
    for (i = 0; i < count; ++i) {
        if (posepack_read_u32(bytes + 4 * i) >= 0x7F800000u) return 0;
    }
    return 1;
}

/* `count` finite floats above zero. */
static int all_positive(const uint8_t* bytes, uint32_t count) {
    uint32_t i;
    for (i = 0; i < count; ++i) {
        if (posepack_read_u32(bytes + 4 * i) == 0) return 0;
    }
    return all_non_negative(bytes, count);
}

static int is_index(uint32_t index, uint32_t count) {
    return index < count || index == POSEPACK_NONE;
}

/* Values of enumerations that no version knows, and fields this draft pins. */
static int header_is_valid(const posepack_view* view) {
    const posepack_header* h = &view->header;
    const uint8_t* bytes = view->bytes;
    return h->encoding >= POSEPACK_ENCODING_MAT4 &&
           (h->encoding <= POSEPACK_ENCODING_PACKED || h->encoding == POSEPACK_MIXED) &&
           h->texel_format >= POSEPACK_TEXEL_RGBA16F && h->texel_format <= POSEPACK_TEXEL_RG32UI &&
           h->texel_order <= POSEPACK_ORDER_TRANSPOSED &&
           (h->row_scheme <= POSEPACK_ROWS_RUNS || h->row_scheme == POSEPACK_MIXED) &&
           h->space_flags <= POSEPACK_SPACE_NORMALISED &&
           posepack_all_zero(bytes + POSEPACK_HDR_RESERVED, 2) &&
           all_positive(bytes + POSEPACK_HDR_RADIUS_M, 1);
}

/* The encodings, formats, orders and row schemes that this reader has code for. */
static int header_is_supported(const posepack_header* h) {
    if (h->texel_format > POSEPACK_TEXEL_RGBA32F || h->texel_order > POSEPACK_ORDER_PLANAR) return 0;
    if (h->row_scheme == POSEPACK_ROWS_RUNS) {
        return h->encoding <= POSEPACK_ENCODING_DUALQUAT || h->encoding == POSEPACK_MIXED;
    }
    return h->row_scheme == POSEPACK_ROWS_UNIFORM && h->encoding <= POSEPACK_ENCODING_DUALQUAT;
}

/* What an encoding asks of the header. */
static int encoding_is_consistent(const posepack_view* view) {
    const uint8_t* length = view->bytes + POSEPACK_HDR_DUALQUAT_LENGTH;
    const int is_mixed = view->header.encoding == POSEPACK_MIXED;
    const uint32_t texels = is_mixed ? POSEPACK_MIXED : posepack_encoding_texels(view->header.encoding);
    if (view->header.texels_per_bone != texels) return 0;
    /* RUNS is known, and nothing is stored in vain. */
    if ((view->header.row_scheme == POSEPACK_ROWS_RUNS) != (view->runs_section != POSEPACK_NONE)) return 0;
    if (view->runs_section == POSEPACK_NONE && view->slot_section != POSEPACK_NONE) return 0;
    return is_mixed || view->header.encoding == POSEPACK_ENCODING_DUALQUAT ? all_positive(length, 1)
                                                                           : posepack_all_zero(length, 4);
}

/*
 * Bytes of the UTF-8 sequence at `s` (RFC 3629: shortest form, no surrogates, at most U+10FFFF), or 0
 * if it is none, or a control character (U+0000-001F, U+007F-009F).
 */
static uint32_t utf8_sequence(const uint8_t* s, uint32_t room) {
    static const uint32_t kSmallest[5] = {0, 0, 0xA0, 0x800, 0x10000};
    const uint32_t lead = s[0];
    uint32_t length, code, i;
    if (lead < 0x80) return lead >= 0x20 && lead != 0x7F;
    length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || length > room) return 0;
    code = lead & (0xFFu >> (length + 1));
    for (i = 1; i < length; ++i) {
        if ((s[i] & 0xC0u) != 0x80u) return 0;
        code = (code << 6) | (s[i] & 0x3Fu);
    }
    if (code < kSmallest[length] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return 0;
    return length;
}

static int is_clean_text(posepack_string text) {
    const uint8_t* s = (const uint8_t*)text.data;
    uint32_t at = 0;
    while (at < text.size_bytes) {
        const uint32_t length = utf8_sequence(s + at, text.size_bytes - at);
        if (length == 0) return 0;
        at += length;
    }
    return 1;
}

static int strings_are_valid(posepack_span strs, table_counts* counts) {
    posepack_string previous = {"", 0};
    uint32_t begin = 0;
    uint32_t i;
    if (strs.size < 8 || posepack_read_u32(strs.data + 4) != 0) return 0;
    counts->strings = posepack_string_count(strs);
    if (counts->strings != posepack_read_u32(strs.data)) return 0;
    for (i = 0; i < counts->strings; ++i) {
        const uint32_t end = posepack_read_u32(strs.data + 8 + 4 * i);
        const posepack_string text = posepack_string_at(strs, i);
        /* An offset that falls makes a difference near 2^32. One past the end stays unequal to the end below.
         */
        if (end - begin > POSEPACK_MAX_STRING_BYTES) return 0;
        if (i > 0 && posepack_compare_strings(previous, text) >= 0) return 0;
        if (!is_clean_text(text)) return 0;
        previous = text;
        begin = end;
    }
    return begin == strs.size - 8 - 4 * counts->strings;
}

static const uint8_t* bone_record(posepack_span bones, uint32_t bone) {
    return bones.data + POSEPACK_BONE_HEAD_BYTES + bone * POSEPACK_BONE_RECORD_BYTES;
}

static uint32_t bone_parent(posepack_span bones, uint32_t bone) {
    return posepack_read_u32(bone_record(bones, bone) + POSEPACK_BONE_PARENT);
}

/* Every parent is in range already: a walk longer than the bones there are runs in a circle. */
static int parents_end(posepack_span bones, uint32_t bone_count) {
    uint32_t i;
    for (i = 0; i < bone_count; ++i) {
        uint32_t bone = i;
        uint32_t steps = 0;
        while (bone != POSEPACK_NONE && steps++ <= bone_count) bone = bone_parent(bones, bone);
        if (bone != POSEPACK_NONE) return 0;
    }
    return 1;
}

static int bones_are_valid(const posepack_view* view, table_counts* counts) {
    const posepack_span bones = posepack_section_span(view, view->bone_section);
    const uint32_t bone_count = view->header.bone_count;
    const uint32_t joints_offset = POSEPACK_BONE_HEAD_BYTES + bone_count * POSEPACK_BONE_RECORD_BYTES;
    uint32_t i;
    if (bones.size < joints_offset) return 0;
    if (posepack_read_u32(bones.data + POSEPACK_BONE_HEAD_COUNT) != bone_count) return 0;
    if (posepack_read_u32(bones.data + POSEPACK_BONE_HEAD_RECORD_BYTES) != POSEPACK_BONE_RECORD_BYTES)
        return 0;
    counts->joints = posepack_joint_map_count(view, bones);
    if (counts->joints != posepack_read_u32(bones.data + POSEPACK_BONE_HEAD_JOINT_MAP_COUNT)) return 0;
    if (!posepack_all_zero(bones.data + POSEPACK_BONE_HEAD_RESERVED, 4)) return 0;
    if (bones.size != joints_offset + ((2 * counts->joints + 3u) & ~3u)) return 0;
    for (i = 0; i < counts->joints; ++i) {
        const uint32_t bone = posepack_read_u16(bones.data + joints_offset + 2 * i);
        if (bone >= bone_count && bone != POSEPACK_NO_BONE) return 0;
    }
    for (i = 0; i < bone_count; ++i) {
        const uint8_t* record = bone_record(bones, i);
        if (posepack_read_u32(record + POSEPACK_BONE_NAME) >= counts->strings) return 0;
        if (!is_index(bone_parent(bones, i), bone_count)) return 0;
        if (posepack_read_u32(record + POSEPACK_BONE_FLAGS) > POSEPACK_BONE_FLAG_WEIGHTED) return 0;
    }
    return parents_end(bones, bone_count);
}

/* An odd joint map ends in two fill bytes. */
static int joint_fill_is_zero(const posepack_view* view, uint32_t joint_count) {
    const posepack_span bones = posepack_section_span(view, view->bone_section);
    return joint_count % 2 == 0 || posepack_all_zero(bones.data + bones.size - 2, 2);
}

static int is_identity(const uint8_t* matrix) {
    uint32_t i;
    for (i = 0; i < 12; ++i) {
        if (posepack_read_f32(matrix + 4 * i) != (i % 5 == 0 ? 1.0f : 0.0f)) return 0;
    }
    return 1;
}

static int mesh_is_valid(const uint8_t* record, const table_counts* counts) {
    const uint32_t first_joint = posepack_read_u32(record + POSEPACK_MESH_FIRST_JOINT);
    const uint32_t joint_count = posepack_read_u32(record + POSEPACK_MESH_JOINT_COUNT);
    return posepack_read_u32(record + POSEPACK_MESH_NAME) < counts->strings &&
           first_joint <= counts->joints && joint_count <= counts->joints - first_joint &&
           posepack_all_zero(record + POSEPACK_MESH_RESERVED, 4) &&
           all_finite(record + POSEPACK_MESH_PALETTE_FROM_MESH, 12);
}

static int space_is_valid(const posepack_view* view, table_counts* counts) {
    const posepack_span spac = posepack_section_span(view, view->spac_section);
    const int is_normalised = view->header.space_flags & POSEPACK_SPACE_NORMALISED;
    const uint8_t* matrix = spac.data + POSEPACK_SPAC_MODEL_FROM_PALETTE;
    uint64_t size = POSEPACK_SPAC_HEAD_BYTES;
    uint32_t i;
    if (spac.size < size) return 0;
    counts->meshes = posepack_read_u32(spac.data + POSEPACK_SPAC_MESH_COUNT);
    size += (uint64_t)counts->meshes * POSEPACK_MESH_RECORD_BYTES;
    if (spac.size != size) return 0;
    if (posepack_read_u32(spac.data + POSEPACK_SPAC_RECORD_SIZE) != POSEPACK_MESH_RECORD_BYTES) return 0;
    if (!all_finite(matrix, 12) || (!is_normalised && !is_identity(matrix))) return 0;
    if (posepack_read_u32(spac.data + POSEPACK_SPAC_FORWARD_AXIS) > POSEPACK_FORWARD_MINUS_X) return 0;
    if (!all_positive(spac.data + POSEPACK_SPAC_METRES_PER_UNIT, 1)) return 0;
    for (i = 0; i < counts->meshes; ++i) {
        const uint8_t* record = spac.data + POSEPACK_SPAC_HEAD_BYTES + i * POSEPACK_MESH_RECORD_BYTES;
        if (!mesh_is_valid(record, counts)) return 0;
    }
    return 1;
}

/* Dual quaternions of a loop alone may need one: q and -q are the same rotation, but blend differently. */
static int closing_row_is_valid(const uint8_t* r) {
    const int may_close = r[POSEPACK_CLIP_ROW_SCHEME] == POSEPACK_ROWS_UNIFORM &&
                          r[POSEPACK_CLIP_ENCODING] == POSEPACK_ENCODING_DUALQUAT &&
                          r[POSEPACK_CLIP_WRAP] == POSEPACK_WRAP_LOOP;
    return r[POSEPACK_CLIP_CLOSING_ROW] <= may_close;
}

/* The encoding and its texels: the header's, or of runs one that the clip has for itself. */
static int clip_encoding_is_valid(const posepack_view* view, const uint8_t* r) {
    const uint32_t encoding = r[POSEPACK_CLIP_ENCODING];
    if (view->header.encoding != POSEPACK_MIXED && encoding != view->header.encoding) return 0;
    return encoding >= POSEPACK_ENCODING_MAT4 && encoding <= POSEPACK_ENCODING_DUALQUAT &&
           r[POSEPACK_CLIP_TEXELS_PER_BONE] == posepack_encoding_texels(encoding);
}

/* The header's, or in a file with runs slots for some clips. */
static int clip_row_scheme_is_valid(const posepack_view* view, const uint8_t* r) {
    const uint32_t row_scheme = r[POSEPACK_CLIP_ROW_SCHEME];
    return row_scheme == view->header.row_scheme ||
           (row_scheme == POSEPACK_ROWS_SLOTS && view->header.row_scheme == POSEPACK_ROWS_RUNS);
}

/* Names, encoding, enumerations, and what this draft leaves empty. */
static int clip_kind_is_valid(const posepack_view* view, const uint8_t* r, uint32_t string_count) {
    return posepack_read_u32(r + POSEPACK_CLIP_NAME) < string_count &&
           posepack_read_u32(r + POSEPACK_CLIP_SOURCE_NAME) < string_count &&
           clip_encoding_is_valid(view, r) && clip_row_scheme_is_valid(view, r) &&
           r[POSEPACK_CLIP_WRAP] <= POSEPACK_WRAP_PING_PONG && r[POSEPACK_CLIP_SEAM] <= POSEPACK_SEAM_OPEN &&
           closing_row_is_valid(r) && r[POSEPACK_CLIP_INTERPOLATION] <= POSEPACK_INTERPOLATION_STEP &&
           r[POSEPACK_CLIP_FLAGS] <= POSEPACK_CLIP_FLAG_MEASURED &&
           posepack_all_zero(r + POSEPACK_CLIP_TRANSLATION_MIN, 24) &&
           posepack_read_u32(r + POSEPACK_CLIP_FIRST_ROOT_MOTION) == POSEPACK_NONE &&
           posepack_all_zero(r + POSEPACK_CLIP_ROOT_MOTION_COUNT, 4) &&
           posepack_all_zero(r + POSEPACK_CLIP_RESERVED, 4);
}

static int box_is_ordered(const uint8_t* box_min, const uint8_t* box_max) {
    uint32_t i;
    for (i = 0; i < 12; i += 4) {
        if (posepack_read_f32(box_min + i) > posepack_read_f32(box_max + i)) return 0;
    }
    return 1;
}

/* Time and bounds. start_s, speed_mps, stride_phase, box and sphere follow each other: 13 floats. */
static int clip_floats_are_valid(const uint8_t* r) {
    const int one_row = posepack_read_u32(r + POSEPACK_CLIP_ROW_COUNT) == 1;
    if (one_row && !posepack_all_zero(r + POSEPACK_CLIP_RATE_HZ, 4)) return 0;
    if (!one_row && !all_positive(r + POSEPACK_CLIP_RATE_HZ, 2)) return 0; /* rate and period */
    return all_non_negative(r + POSEPACK_CLIP_PERIOD_S, 1) && all_finite(r + POSEPACK_CLIP_START_S, 13) &&
           all_non_negative(r + POSEPACK_CLIP_SPEED_MPS, 1) &&
           box_is_ordered(r + POSEPACK_CLIP_BOX_MIN, r + POSEPACK_CLIP_BOX_MAX) &&
           all_non_negative(r + POSEPACK_CLIP_SPHERE_RADIUS, 1) &&
           all_non_negative(r + POSEPACK_CLIP_SEAM_GAP, 1);
}

/* Of positions or of normals: max, p99.9, rms, time; then mesh, vertex and bone of the worst place. */
static int clip_error_is_valid(const posepack_view* view, const uint8_t* error, int measured,
                               uint32_t mesh_count) {
    const uint8_t* meshes = posepack_section_span(view, view->spac_section).data + POSEPACK_SPAC_HEAD_BYTES;
    const uint32_t mesh = posepack_read_u32(error + 16);
    const uint32_t vertex = posepack_read_u32(error + 20);
    const uint32_t bone = posepack_read_u32(error + 24);
    uint32_t vertex_count = 0;
    if (!measured) return posepack_all_zero(error, 16) && (mesh & vertex & bone) == POSEPACK_NONE;
    if (!is_index(mesh, mesh_count)) return 0;
    if (mesh != POSEPACK_NONE) {
        const uint8_t* record = meshes + mesh * POSEPACK_MESH_RECORD_BYTES;
        vertex_count = posepack_read_u32(record + POSEPACK_MESH_VERTEX_COUNT);
    }
    return all_non_negative(error, 3) && all_finite(error + 12, 1) && is_index(vertex, vertex_count) &&
           is_index(bone, view->header.bone_count);
}

/* Rows follow each other without a gap, clip after clip. */
static int clip_rows_are_valid(const posepack_view* view, const uint8_t* r, uint32_t* next_row) {
    const uint32_t row_count = posepack_read_u32(r + POSEPACK_CLIP_ROW_COUNT);
    const uint32_t row_texels = view->header.bone_count * view->header.texels_per_bone;
    const uint32_t closing_row = r[POSEPACK_CLIP_CLOSING_ROW];
    if (posepack_read_u32(r + POSEPACK_CLIP_FIRST_ROW) != *next_row) return 0;
    if (row_count < 1 || row_count > view->header.row_count - *next_row) return 0;
    if (view->header.row_scheme == POSEPACK_ROWS_UNIFORM &&
        posepack_read_u32(r + POSEPACK_CLIP_FIRST_TEXEL) != *next_row * row_texels) {
        return 0;
    }
    if (closing_row > view->header.row_count - *next_row - row_count) return 0;
    *next_row += row_count + closing_row;
    return 1;
}

/* Cuts follow each other without a gap, clip after clip, and rise within a clip. */
static int clip_cuts_are_valid(const uint8_t* r, const uint8_t* cuts, uint32_t cut_count,
                               uint32_t* next_cut) {
    const uint32_t row_count = posepack_read_u32(r + POSEPACK_CLIP_ROW_COUNT);
    const uint32_t count = posepack_read_u32(r + POSEPACK_CLIP_CUT_COUNT);
    uint32_t i;
    if (posepack_read_u32(r + POSEPACK_CLIP_FIRST_CUT) != *next_cut) return 0;
    if (count > cut_count - *next_cut) return 0;
    if (count > 0 && r[POSEPACK_CLIP_ROW_SCHEME] != POSEPACK_ROWS_UNIFORM) return 0;
    cuts += 4 * *next_cut;
    for (i = 0; i < count; ++i) {
        if (posepack_read_u32(cuts + 4 * i) >= row_count) return 0;
        if (i > 0 && posepack_read_u32(cuts + 4 * i) <= posepack_read_u32(cuts + 4 * i - 4)) return 0;
    }
    *next_cut += count;
    return 1;
}

static int clip_head_is_valid(const posepack_view* view, posepack_span clips) {
    const uint32_t clip_count = view->header.clip_count;
    const uint64_t cuts_offset = POSEPACK_CLIP_HEAD_BYTES + clip_count * POSEPACK_CLIP_RECORD_BYTES;
    if (clips.size < cuts_offset) return 0;
    return posepack_read_u32(clips.data + POSEPACK_CLIP_HEAD_COUNT) == clip_count &&
           posepack_read_u32(clips.data + POSEPACK_CLIP_HEAD_RECORD_BYTES) == POSEPACK_CLIP_RECORD_BYTES &&
           clips.size ==
               cuts_offset + 4 * (uint64_t)posepack_read_u32(clips.data + POSEPACK_CLIP_HEAD_CUT_COUNT) &&
           posepack_all_zero(clips.data + POSEPACK_CLIP_HEAD_RESERVED, 4);
}

static int clips_are_valid(const posepack_view* view, const table_counts* counts) {
    const posepack_span clips = posepack_section_span(view, view->clip_section);
    const uint8_t* records = clips.data + POSEPACK_CLIP_HEAD_BYTES;
    const uint8_t* cuts = records + view->header.clip_count * POSEPACK_CLIP_RECORD_BYTES;
    uint32_t next_row = 0, next_cut = 0, all_measured = 1, differ = 0;
    uint32_t cut_count, i;
    if (!clip_head_is_valid(view, clips)) return 0;
    cut_count = posepack_read_u32(clips.data + POSEPACK_CLIP_HEAD_CUT_COUNT);
    for (i = 0; i < view->header.clip_count; ++i) {
        const uint8_t* r = records + i * POSEPACK_CLIP_RECORD_BYTES;
        const int measured = r[POSEPACK_CLIP_FLAGS] & POSEPACK_CLIP_FLAG_MEASURED;
        if (!clip_kind_is_valid(view, r, counts->strings)) return 0;
        if (!clip_rows_are_valid(view, r, &next_row)) return 0;
        if (!clip_cuts_are_valid(r, cuts, cut_count, &next_cut)) return 0;
        if (!clip_floats_are_valid(r)) return 0;
        if (!clip_error_is_valid(view, r + POSEPACK_CLIP_ERROR_MAX, measured, counts->meshes)) return 0;
        if (!clip_error_is_valid(view, r + POSEPACK_CLIP_NORMAL_MAX_DEG, measured, counts->meshes)) return 0;
        all_measured &= (uint32_t)measured;
        differ |= r[POSEPACK_CLIP_ENCODING] != records[POSEPACK_CLIP_ENCODING];
    }
    return differ == (view->header.encoding == POSEPACK_MIXED) && next_row == view->header.row_count &&
           next_cut == cut_count &&
           (view->header.optional_features & POSEPACK_OPTIONAL_ERROR_MEASURED) == all_measured;
}

static int states_are_valid(const posepack_view* view, uint32_t string_count) {
    const posepack_span stat = posepack_section_span(view, view->stat_section);
    uint32_t i, state_count;
    if (stat.size < POSEPACK_STAT_HEAD_BYTES) return 0;
    state_count = posepack_read_u32(stat.data);
    if (stat.size != POSEPACK_STAT_HEAD_BYTES + (uint64_t)state_count * POSEPACK_STAT_RECORD_BYTES) return 0;
    if (!is_index(posepack_read_u32(stat.data + 4), state_count)) return 0;
    for (i = 0; i < state_count; ++i) {
        const uint8_t* record = stat.data + POSEPACK_STAT_HEAD_BYTES + i * POSEPACK_STAT_RECORD_BYTES;
        const uint32_t name = posepack_read_u32(record);
        if (name >= string_count) return 0;
        /* Strings are sorted, so names in order are indices in order. */
        if (i > 0 && name <= posepack_read_u32(record - POSEPACK_STAT_RECORD_BYTES)) return 0;
        if (posepack_read_u32(record + 4) >= view->header.clip_count) return 0;
    }
    return 1;
}

posepack_result posepack_check_tables(const posepack_view* view) {
    table_counts counts = {0, 0, 0};
    if (!header_is_valid(view)) return POSEPACK_ERROR_SEMANTIC;
    if (!header_is_supported(&view->header)) return POSEPACK_ERROR_UNSUPPORTED;
    if (!encoding_is_consistent(view)) return POSEPACK_ERROR_SEMANTIC;
    if (!strings_are_valid(posepack_section_span(view, view->strs_section), &counts)) {
        return POSEPACK_ERROR_SEMANTIC;
    }
    if (!bones_are_valid(view, &counts)) return POSEPACK_ERROR_SEMANTIC;
    if (!joint_fill_is_zero(view, counts.joints)) return POSEPACK_ERROR_PADDING;
    if (!space_is_valid(view, &counts)) return POSEPACK_ERROR_SEMANTIC;
    if (!clips_are_valid(view, &counts)) return POSEPACK_ERROR_SEMANTIC;
    if (!states_are_valid(view, counts.strings)) return POSEPACK_ERROR_SEMANTIC;
    if (view->runs_section == POSEPACK_NONE) return POSEPACK_OK;
    if (!posepack_runs_are_valid(view) || !posepack_slots_are_valid(view)) return POSEPACK_ERROR_SEMANTIC;
    return POSEPACK_OK;
}
