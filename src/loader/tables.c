/* SPDX-License-Identifier: MIT */
/*
 * Accessors. The bytes may have changed since posepack_open: every count is bounded by the size of
 * its section, which the view holds a copy of, and every index that is read is tested before use.
 */
#include "format/bytes.h"
#include "loader/internal.h"

static int is_open(const posepack_view* view) {
    return view != NULL && view->bytes != NULL;
}

posepack_span posepack_section_span(const posepack_view* view, uint32_t section) {
    posepack_span span;
    span.data = view->bytes + view->sections[section].offset;
    span.size = (uint32_t)view->sections[section].stored_bytes;
    return span;
}

/* STRS: count, count + 1 offsets, bytes. */
uint32_t posepack_string_count(posepack_span strs) {
    const uint32_t count = posepack_read_u32(strs.data);
    const uint32_t room = (strs.size - 8) / 4;
    return count < room ? count : room;
}

posepack_string posepack_string_at(posepack_span strs, uint32_t index) {
    const uint32_t count = posepack_string_count(strs);
    posepack_string text = {"", 0};
    if (index < count) {
        const uint32_t bytes_offset = 8 + 4 * count;
        const uint32_t begin = posepack_read_u32(strs.data + 4 + 4 * index);
        const uint32_t end = posepack_read_u32(strs.data + 8 + 4 * index);
        if (begin <= end && end <= strs.size - bytes_offset) {
            text.data = (const char*)(strs.data + bytes_offset + begin);
            text.size_bytes = end - begin;
        }
    }
    return text;
}

int posepack_compare_strings(posepack_string a, posepack_string b) {
    uint32_t i;
    for (i = 0; i < a.size_bytes && i < b.size_bytes; ++i) {
        const int difference = (int)(uint8_t)a.data[i] - (int)(uint8_t)b.data[i];
        if (difference != 0) return difference;
    }
    return (int)a.size_bytes - (int)b.size_bytes;
}

uint32_t posepack_joint_map_count(const posepack_view* view, posepack_span bones) {
    const uint32_t fixed_bytes =
        POSEPACK_BONE_HEAD_BYTES + view->header.bone_count * POSEPACK_BONE_RECORD_BYTES;
    const uint32_t room = (bones.size - fixed_bytes) / 2;
    const uint32_t count = posepack_read_u32(bones.data + POSEPACK_BONE_HEAD_JOINT_MAP_COUNT);
    return count < room ? count : room;
}

static posepack_string string_of(const posepack_view* view, const uint8_t* field) {
    return posepack_string_at(posepack_section_span(view, view->strs_section), posepack_read_u32(field));
}

/* `text` equals the zero-terminated `name`. */
static int is_name(posepack_string text, const char* name) {
    uint32_t i;
    for (i = 0; i < text.size_bytes; ++i) {
        if (name[i] == 0 || name[i] != text.data[i]) return 0;
    }
    return name[text.size_bytes] == 0;
}

static void read_floats(const uint8_t* bytes, float* values, uint32_t count) {
    uint32_t i;
    for (i = 0; i < count; ++i) values[i] = posepack_read_f32(bytes + 4 * i);
}

const uint8_t* posepack_clip_record(const posepack_view* view, uint32_t index) {
    return posepack_section_span(view, view->clip_section).data + POSEPACK_CLIP_HEAD_BYTES +
           index * POSEPACK_CLIP_RECORD_BYTES;
}

static void read_clip_error(const uint8_t* r, posepack_clip_error* error) {
    error->max = posepack_read_f32(r + POSEPACK_CLIP_ERROR_MAX);
    error->p999 = posepack_read_f32(r + POSEPACK_CLIP_ERROR_P999);
    error->rms = posepack_read_f32(r + POSEPACK_CLIP_ERROR_RMS);
    error->time_s = posepack_read_f32(r + POSEPACK_CLIP_ERROR_TIME_S);
    error->mesh = posepack_read_u32(r + POSEPACK_CLIP_ERROR_MESH);
    error->vertex = posepack_read_u32(r + POSEPACK_CLIP_ERROR_VERTEX);
    error->bone = posepack_read_u32(r + POSEPACK_CLIP_ERROR_BONE);
    error->normal_max_deg = posepack_read_f32(r + POSEPACK_CLIP_NORMAL_MAX_DEG);
    error->normal_p999_deg = posepack_read_f32(r + POSEPACK_CLIP_NORMAL_P999_DEG);
    error->normal_rms_deg = posepack_read_f32(r + POSEPACK_CLIP_NORMAL_RMS_DEG);
    error->normal_time_s = posepack_read_f32(r + POSEPACK_CLIP_NORMAL_TIME_S);
    error->normal_mesh = posepack_read_u32(r + POSEPACK_CLIP_NORMAL_MESH);
    error->normal_vertex = posepack_read_u32(r + POSEPACK_CLIP_NORMAL_VERTEX);
    error->normal_bone = posepack_read_u32(r + POSEPACK_CLIP_NORMAL_BONE);
}

posepack_result posepack_get_clip(const posepack_view* view, uint32_t index, posepack_clip* clip) {
    const uint8_t* r;
    if (!is_open(view) || clip == NULL) return POSEPACK_ERROR_ARG;
    if (index >= view->header.clip_count) return POSEPACK_ERROR_INDEX;
    r = posepack_clip_record(view, index);
    clip->name = string_of(view, r + POSEPACK_CLIP_NAME);
    clip->source_name = string_of(view, r + POSEPACK_CLIP_SOURCE_NAME);
    clip->encoding = r[POSEPACK_CLIP_ENCODING];
    clip->texels_per_bone = r[POSEPACK_CLIP_TEXELS_PER_BONE];
    clip->row_scheme = r[POSEPACK_CLIP_ROW_SCHEME];
    clip->wrap = r[POSEPACK_CLIP_WRAP];
    clip->seam = r[POSEPACK_CLIP_SEAM];
    clip->closing_row = r[POSEPACK_CLIP_CLOSING_ROW];
    clip->interpolation = r[POSEPACK_CLIP_INTERPOLATION];
    clip->measured = r[POSEPACK_CLIP_FLAGS] & POSEPACK_CLIP_FLAG_MEASURED;
    clip->first_row = posepack_read_u32(r + POSEPACK_CLIP_FIRST_ROW);
    clip->row_count = posepack_read_u32(r + POSEPACK_CLIP_ROW_COUNT);
    clip->first_texel = posepack_read_u32(r + POSEPACK_CLIP_FIRST_TEXEL);
    clip->slot_count = posepack_stored_slots(view, index).count;
    clip->cut_count = posepack_read_u32(r + POSEPACK_CLIP_CUT_COUNT);
    clip->rate_hz = posepack_read_f32(r + POSEPACK_CLIP_RATE_HZ);
    clip->period_s = posepack_read_f32(r + POSEPACK_CLIP_PERIOD_S);
    clip->start_s = posepack_read_f32(r + POSEPACK_CLIP_START_S);
    clip->speed_mps = posepack_read_f32(r + POSEPACK_CLIP_SPEED_MPS);
    clip->stride_phase = posepack_read_f32(r + POSEPACK_CLIP_STRIDE_PHASE);
    read_floats(r + POSEPACK_CLIP_BOX_MIN, clip->box_min, 3);
    read_floats(r + POSEPACK_CLIP_BOX_MAX, clip->box_max, 3);
    read_floats(r + POSEPACK_CLIP_SPHERE_CENTER, clip->sphere_center, 3);
    clip->sphere_radius = posepack_read_f32(r + POSEPACK_CLIP_SPHERE_RADIUS);
    clip->seam_gap = posepack_read_f32(r + POSEPACK_CLIP_SEAM_GAP);
    read_clip_error(r, &clip->error);
    return POSEPACK_OK;
}

posepack_result posepack_get_cut(const posepack_view* view, uint32_t clip_index, uint32_t index,
                                 uint32_t* row) {
    posepack_span clips;
    uint32_t fixed_bytes, first_cut, room;
    const uint8_t* r;
    if (!is_open(view) || row == NULL) return POSEPACK_ERROR_ARG;
    if (clip_index >= view->header.clip_count) return POSEPACK_ERROR_INDEX;
    clips = posepack_section_span(view, view->clip_section);
    fixed_bytes = POSEPACK_CLIP_HEAD_BYTES + view->header.clip_count * POSEPACK_CLIP_RECORD_BYTES;
    room = (clips.size - fixed_bytes) / 4;
    r = posepack_clip_record(view, clip_index);
    first_cut = posepack_read_u32(r + POSEPACK_CLIP_FIRST_CUT);
    if (index >= posepack_read_u32(r + POSEPACK_CLIP_CUT_COUNT)) return POSEPACK_ERROR_INDEX;
    if (first_cut >= room || index >= room - first_cut) return POSEPACK_ERROR_INDEX;
    *row = posepack_read_u32(clips.data + fixed_bytes + 4 * (first_cut + index));
    return POSEPACK_OK;
}

posepack_result posepack_find_clip(const posepack_view* view, const char* name, uint32_t* index) {
    uint32_t i;
    if (!is_open(view) || name == NULL || index == NULL) return POSEPACK_ERROR_ARG;
    for (i = 0; i < view->header.clip_count; ++i) {
        if (is_name(string_of(view, posepack_clip_record(view, i) + POSEPACK_CLIP_NAME), name)) {
            *index = i;
            return POSEPACK_OK;
        }
    }
    return POSEPACK_ERROR_NOT_FOUND;
}

static uint32_t state_count(posepack_span stat) {
    return (stat.size - POSEPACK_STAT_HEAD_BYTES) / POSEPACK_STAT_RECORD_BYTES;
}

posepack_result posepack_count_states(const posepack_view* view, uint32_t* count, uint32_t* default_state) {
    posepack_span stat;
    uint32_t stored;
    if (!is_open(view) || count == NULL || default_state == NULL) return POSEPACK_ERROR_ARG;
    stat = posepack_section_span(view, view->stat_section);
    stored = posepack_read_u32(stat.data + 4);
    *count = state_count(stat);
    *default_state = stored < *count ? stored : POSEPACK_NONE;
    return POSEPACK_OK;
}

posepack_result posepack_get_state(const posepack_view* view, uint32_t index, posepack_state* state) {
    posepack_span stat;
    const uint8_t* record;
    if (!is_open(view) || state == NULL) return POSEPACK_ERROR_ARG;
    stat = posepack_section_span(view, view->stat_section);
    if (index >= state_count(stat)) return POSEPACK_ERROR_INDEX;
    record = stat.data + POSEPACK_STAT_HEAD_BYTES + index * POSEPACK_STAT_RECORD_BYTES;
    state->name = string_of(view, record);
    state->clip = posepack_read_u32(record + 4);
    return POSEPACK_OK;
}

posepack_result posepack_find_state(const posepack_view* view, const char* name, uint32_t* clip_index) {
    posepack_state state;
    uint32_t i;
    if (!is_open(view) || name == NULL || clip_index == NULL) return POSEPACK_ERROR_ARG;
    for (i = 0; posepack_get_state(view, i, &state) == POSEPACK_OK; ++i) {
        if (is_name(state.name, name)) {
            *clip_index = state.clip;
            return POSEPACK_OK;
        }
    }
    return POSEPACK_ERROR_NOT_FOUND;
}

posepack_result posepack_get_bone(const posepack_view* view, uint32_t index, posepack_bone* bone) {
    const uint8_t* record;
    if (!is_open(view) || bone == NULL) return POSEPACK_ERROR_ARG;
    if (index >= view->header.bone_count) return POSEPACK_ERROR_INDEX;
    record = posepack_section_span(view, view->bone_section).data + POSEPACK_BONE_HEAD_BYTES +
             index * POSEPACK_BONE_RECORD_BYTES;
    bone->name = string_of(view, record + POSEPACK_BONE_NAME);
    bone->parent = posepack_read_u32(record + POSEPACK_BONE_PARENT);
    bone->flags = posepack_read_u32(record + POSEPACK_BONE_FLAGS);
    bone->node = posepack_read_u32(record + POSEPACK_BONE_NODE);
    return POSEPACK_OK;
}

posepack_result posepack_find_bone(const posepack_view* view, const char* name, uint32_t* index) {
    posepack_bone bone;
    uint32_t i;
    if (!is_open(view) || name == NULL || index == NULL) return POSEPACK_ERROR_ARG;
    for (i = 0; posepack_get_bone(view, i, &bone) == POSEPACK_OK; ++i) {
        if (is_name(bone.name, name)) {
            *index = i;
            return POSEPACK_OK;
        }
    }
    return POSEPACK_ERROR_NOT_FOUND;
}

static uint32_t mesh_count(posepack_span spac) {
    return (spac.size - POSEPACK_SPAC_HEAD_BYTES) / POSEPACK_MESH_RECORD_BYTES;
}

posepack_result posepack_get_space(const posepack_view* view, posepack_space* space) {
    posepack_span spac;
    if (!is_open(view) || space == NULL) return POSEPACK_ERROR_ARG;
    spac = posepack_section_span(view, view->spac_section);
    read_floats(spac.data + POSEPACK_SPAC_MODEL_FROM_PALETTE, space->model_from_palette, 12);
    space->forward_axis = posepack_read_u32(spac.data + POSEPACK_SPAC_FORWARD_AXIS);
    space->metres_per_unit = posepack_read_f32(spac.data + POSEPACK_SPAC_METRES_PER_UNIT);
    space->mesh_count = mesh_count(spac);
    return POSEPACK_OK;
}

posepack_result posepack_get_mesh(const posepack_view* view, uint32_t index, posepack_mesh* mesh) {
    posepack_span spac;
    const uint8_t* record;
    if (!is_open(view) || mesh == NULL) return POSEPACK_ERROR_ARG;
    spac = posepack_section_span(view, view->spac_section);
    if (index >= mesh_count(spac)) return POSEPACK_ERROR_INDEX;
    record = spac.data + POSEPACK_SPAC_HEAD_BYTES + index * POSEPACK_MESH_RECORD_BYTES;
    mesh->name = string_of(view, record + POSEPACK_MESH_NAME);
    mesh->node = posepack_read_u32(record + POSEPACK_MESH_NODE);
    mesh->mesh = posepack_read_u32(record + POSEPACK_MESH_MESH);
    mesh->skin = posepack_read_u32(record + POSEPACK_MESH_SKIN);
    mesh->joint_count = posepack_read_u32(record + POSEPACK_MESH_JOINT_COUNT);
    mesh->vertex_count = posepack_read_u32(record + POSEPACK_MESH_VERTEX_COUNT);
    read_floats(record + POSEPACK_MESH_PALETTE_FROM_MESH, mesh->palette_from_mesh, 12);
    return POSEPACK_OK;
}

posepack_result posepack_map_joint(const posepack_view* view, uint32_t mesh_index, uint32_t joint,
                                   uint32_t* bone) {
    posepack_span spac, bones;
    uint32_t first_joint, room, found;
    const uint8_t* record;
    if (!is_open(view) || bone == NULL) return POSEPACK_ERROR_ARG;
    spac = posepack_section_span(view, view->spac_section);
    bones = posepack_section_span(view, view->bone_section);
    if (mesh_index >= mesh_count(spac)) return POSEPACK_ERROR_INDEX;
    record = spac.data + POSEPACK_SPAC_HEAD_BYTES + mesh_index * POSEPACK_MESH_RECORD_BYTES;
    if (joint >= posepack_read_u32(record + POSEPACK_MESH_JOINT_COUNT)) return POSEPACK_ERROR_INDEX;
    first_joint = posepack_read_u32(record + POSEPACK_MESH_FIRST_JOINT);
    room = posepack_joint_map_count(view, bones);
    if (first_joint >= room || joint >= room - first_joint) return POSEPACK_ERROR_INDEX;
    found =
        posepack_read_u16(bones.data + POSEPACK_BONE_HEAD_BYTES +
                          view->header.bone_count * POSEPACK_BONE_RECORD_BYTES + 2 * (first_joint + joint));
    if (found == POSEPACK_NO_BONE) {
        *bone = POSEPACK_NONE;
        return POSEPACK_ERROR_NOT_FOUND;
    }
    if (found >= view->header.bone_count) return POSEPACK_ERROR_INDEX;
    *bone = found;
    return POSEPACK_OK;
}

posepack_result posepack_get_section(const posepack_view* view, uint32_t type, const void** data,
                                     size_t* size_bytes) {
    uint32_t i;
    if (!is_open(view) || data == NULL || size_bytes == NULL) return POSEPACK_ERROR_ARG;
    for (i = 0; i < view->header.section_count; ++i) {
        if (view->sections[i].type == type) {
            const posepack_span span = posepack_section_span(view, i);
            *data = span.data;
            *size_bytes = span.size;
            return POSEPACK_OK;
        }
    }
    return POSEPACK_ERROR_NOT_FOUND;
}

const char* posepack_result_name(posepack_result result) {
    switch (result) {
        case POSEPACK_OK:
            return "OK";
        case POSEPACK_ERROR_ARG:
            return "ARG";
        case POSEPACK_ERROR_TOO_SMALL:
            return "TOO_SMALL";
        case POSEPACK_ERROR_MAGIC:
            return "MAGIC";
        case POSEPACK_ERROR_VERSION:
            return "VERSION";
        case POSEPACK_ERROR_SIZE:
            return "SIZE";
        case POSEPACK_ERROR_LIMIT:
            return "LIMIT";
        case POSEPACK_ERROR_HEADER_CRC:
            return "HEADER_CRC";
        case POSEPACK_ERROR_TABLE_CRC:
            return "TABLE_CRC";
        case POSEPACK_ERROR_SECTION:
            return "SECTION";
        case POSEPACK_ERROR_SECTION_DUP:
            return "SECTION_DUP";
        case POSEPACK_ERROR_SECTION_MISSING:
            return "SECTION_MISSING";
        case POSEPACK_ERROR_SECTION_CRC:
            return "SECTION_CRC";
        case POSEPACK_ERROR_PADDING:
            return "PADDING";
        case POSEPACK_ERROR_UNKNOWN_REQUIRED:
            return "UNKNOWN_REQUIRED";
        case POSEPACK_ERROR_SEMANTIC:
            return "SEMANTIC";
        case POSEPACK_ERROR_UNSUPPORTED:
            return "UNSUPPORTED";
        case POSEPACK_ERROR_NEEDS_DECODE:
            return "NEEDS_DECODE";
        case POSEPACK_ERROR_NOT_FOUND:
            return "NOT_FOUND";
        case POSEPACK_ERROR_INDEX:
            return "INDEX";
        default:
            return "UNKNOWN";
    }
}
