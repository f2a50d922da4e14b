/* SPDX-License-Identifier: MIT */
/*
 * Framing: header, section table, and the place and checksum of every section. The order of the
 * checks is part of the format: each failure has one result, whatever else is wrong behind it.
 */
#include "format/bytes.h"
#include "format/crc32c.h"
#include "loader/internal.h"

/* The sections that must be there, then RUNS and SLOT, and where the view keeps their indices. */
#define REQUIRED_SECTION_COUNT 6u
#define KNOWN_SECTION_COUNT 8u
static const uint32_t kKnownTypes[KNOWN_SECTION_COUNT] = {
    POSEPACK_SECTION_CLIP, POSEPACK_SECTION_STAT, POSEPACK_SECTION_BONE, POSEPACK_SECTION_SPAC,
    POSEPACK_SECTION_STRS, POSEPACK_SECTION_PIXL, POSEPACK_SECTION_RUNS, POSEPACK_SECTION_SLOT};

static uint32_t* known_section(posepack_view* view, uint32_t known) {
    uint32_t* fields[KNOWN_SECTION_COUNT];
    fields[0] = &view->clip_section;
    fields[1] = &view->stat_section;
    fields[2] = &view->bone_section;
    fields[3] = &view->spac_section;
    fields[4] = &view->strs_section;
    fields[5] = &view->pixl_section;
    fields[6] = &view->runs_section;
    fields[7] = &view->slot_section;
    return fields[known];
}

int posepack_all_zero(const uint8_t* bytes, uint64_t size) {
    uint64_t i;
    for (i = 0; i < size; ++i) {
        if (bytes[i] != 0) return 0;
    }
    return 1;
}

static void clear_view(posepack_view* view) {
    uint8_t* bytes = (uint8_t*)view;
    size_t i;
    for (i = 0; i < sizeof *view; ++i) bytes[i] = 0;
}

/* Magic, version and checksum: what must hold before any other field means anything. */
static posepack_result check_prefix(const uint8_t* bytes, size_t size) {
    static const uint8_t kMagic[8] = POSEPACK_MAGIC_BYTES;
    uint32_t i;
    if (size < POSEPACK_HEADER_BYTES) return POSEPACK_ERROR_TOO_SMALL;
    for (i = 0; i < 8; ++i) {
        if (bytes[POSEPACK_HDR_MAGIC + i] != kMagic[i]) return POSEPACK_ERROR_MAGIC;
    }
    if (posepack_read_u16(bytes + POSEPACK_HDR_MAJOR) != POSEPACK_FORMAT_MAJOR) {
        return POSEPACK_ERROR_VERSION;
    }
    /* Drafts promise each other nothing, so a draft reader takes its own draft alone. */
    if (posepack_read_u16(bytes + POSEPACK_HDR_MINOR) != POSEPACK_FORMAT_MINOR) {
        return POSEPACK_ERROR_VERSION;
    }
    if (posepack_read_u32(bytes + POSEPACK_HDR_HEADER_BYTES) != POSEPACK_HEADER_BYTES) {
        return POSEPACK_ERROR_VERSION;
    }
    if (posepack_read_u32(bytes + POSEPACK_HDR_HEADER_CRC) !=
        posepack_crc32c(0, bytes, POSEPACK_HDR_HEADER_CRC)) {
        return POSEPACK_ERROR_HEADER_CRC;
    }
    return POSEPACK_OK;
}

static void copy_header(posepack_header* header, const uint8_t* bytes) {
    uint32_t i;
    header->major = posepack_read_u16(bytes + POSEPACK_HDR_MAJOR);
    header->minor = posepack_read_u16(bytes + POSEPACK_HDR_MINOR);
    header->file_bytes = posepack_read_u64(bytes + POSEPACK_HDR_FILE_BYTES);
    header->section_count = posepack_read_u32(bytes + POSEPACK_HDR_SECTION_COUNT);
    header->required_features = posepack_read_u32(bytes + POSEPACK_HDR_REQUIRED_FEATURES);
    header->optional_features = posepack_read_u32(bytes + POSEPACK_HDR_OPTIONAL_FEATURES);
    header->bone_count = posepack_read_u32(bytes + POSEPACK_HDR_BONE_COUNT);
    header->row_count = posepack_read_u32(bytes + POSEPACK_HDR_ROW_COUNT);
    header->clip_count = posepack_read_u32(bytes + POSEPACK_HDR_CLIP_COUNT);
    header->encoding = bytes[POSEPACK_HDR_ENCODING];
    header->texel_format = bytes[POSEPACK_HDR_TEXEL_FORMAT];
    header->texels_per_bone = bytes[POSEPACK_HDR_TEXELS_PER_BONE];
    header->texel_order = bytes[POSEPACK_HDR_TEXEL_ORDER];
    header->row_scheme = bytes[POSEPACK_HDR_ROW_SCHEME];
    header->space_flags = bytes[POSEPACK_HDR_SPACE_FLAGS];
    header->texture_width_texels = posepack_read_u32(bytes + POSEPACK_HDR_TEXTURE_WIDTH);
    header->texture_height_texels = posepack_read_u32(bytes + POSEPACK_HDR_TEXTURE_HEIGHT);
    header->row_pitch_bytes = posepack_read_u32(bytes + POSEPACK_HDR_ROW_PITCH);
    header->rows_per_line = posepack_read_u32(bytes + POSEPACK_HDR_ROWS_PER_LINE);
    header->radius_m = posepack_read_f32(bytes + POSEPACK_HDR_RADIUS_M);
    header->dualquat_length = posepack_read_f32(bytes + POSEPACK_HDR_DUALQUAT_LENGTH);
    header->bake_abi = posepack_read_u32(bytes + POSEPACK_HDR_BAKE_ABI);
    for (i = 0; i < 32; ++i) header->recipe_sha256[i] = bytes[POSEPACK_HDR_RECIPE_SHA256 + i];
}

/* Size, limits and features, from the header's copy. */
static posepack_result check_header(const posepack_header* header, size_t size) {
    if (header->file_bytes != size) return POSEPACK_ERROR_SIZE;
    if (size > POSEPACK_MAX_FILE_BYTES) return POSEPACK_ERROR_LIMIT;
    if (header->section_count < 1 || header->section_count > POSEPACK_MAX_SECTIONS) {
        return POSEPACK_ERROR_LIMIT;
    }
    if (header->bone_count < 1 || header->bone_count > POSEPACK_MAX_BONES) return POSEPACK_ERROR_LIMIT;
    if (header->row_count < 1 || header->row_count > POSEPACK_MAX_ROWS) return POSEPACK_ERROR_LIMIT;
    if (header->clip_count < 1 || header->clip_count > POSEPACK_MAX_CLIPS) return POSEPACK_ERROR_LIMIT;
    if (header->required_features != 0) return POSEPACK_ERROR_UNKNOWN_REQUIRED;
    return POSEPACK_OK;
}

/* Finds and copies the table. */
static posepack_result copy_table(posepack_view* view, const uint8_t* bytes, uint32_t size) {
    const uint32_t table_offset = posepack_read_u32(bytes + POSEPACK_HDR_TABLE_OFFSET);
    const uint32_t table_bytes = view->header.section_count * POSEPACK_ENTRY_BYTES;
    uint32_t i;
    if (table_offset != POSEPACK_HEADER_BYTES) return POSEPACK_ERROR_SECTION;
    if (table_bytes > size - table_offset) return POSEPACK_ERROR_SECTION;
    if (posepack_read_u32(bytes + POSEPACK_HDR_TABLE_CRC) !=
        posepack_crc32c(0, bytes + table_offset, table_bytes)) {
        return POSEPACK_ERROR_TABLE_CRC;
    }
    for (i = 0; i < view->header.section_count; ++i) {
        const uint8_t* entry = bytes + table_offset + i * POSEPACK_ENTRY_BYTES;
        posepack_section* section = &view->sections[i];
        section->type = posepack_read_u32(entry + POSEPACK_ENT_TYPE);
        section->flags = posepack_read_u32(entry + POSEPACK_ENT_FLAGS);
        section->offset = posepack_read_u64(entry + POSEPACK_ENT_OFFSET);
        section->stored_bytes = posepack_read_u64(entry + POSEPACK_ENT_STORED_BYTES);
        section->raw_bytes = posepack_read_u64(entry + POSEPACK_ENT_RAW_BYTES);
        section->align_log2 = posepack_read_u32(entry + POSEPACK_ENT_ALIGN_LOG2);
        section->crc = posepack_read_u32(entry + POSEPACK_ENT_CRC);
        section->raw_crc = posepack_read_u32(entry + POSEPACK_ENT_RAW_CRC);
        if (posepack_read_u32(entry + POSEPACK_ENT_RESERVED) != 0) return POSEPACK_ERROR_SECTION;
    }
    return POSEPACK_OK;
}

static int is_four_letters(uint32_t type) {
    uint32_t i;
    for (i = 0; i < 4; ++i) {
        const uint32_t lower = ((type >> (8 * i)) & 0xFFu) | 0x20u;
        if (lower < 'a' || lower > 'z') return 0;
    }
    return 1;
}

/* What an entry says of itself: codec, sizes and alignment. `known` is KNOWN_SECTION_COUNT if unknown. */
static posepack_result check_entry(const posepack_section* section, uint32_t known) {
    const int is_pixl = section->type == POSEPACK_SECTION_PIXL;
    if (section->flags > POSEPACK_CODEC_ZSTD) return POSEPACK_ERROR_SECTION;
    if (section->flags != POSEPACK_CODEC_NONE && known < KNOWN_SECTION_COUNT && !is_pixl) {
        return POSEPACK_ERROR_SECTION;
    }
    if (section->flags == POSEPACK_CODEC_NONE &&
        (section->raw_bytes != section->stored_bytes || section->raw_crc != section->crc)) {
        return POSEPACK_ERROR_SECTION;
    }
    if (section->align_log2 < POSEPACK_TABLE_ALIGN_LOG2 || section->align_log2 > POSEPACK_PIXL_ALIGN_LOG2) {
        return POSEPACK_ERROR_SECTION;
    }
    if (known < KNOWN_SECTION_COUNT &&
        section->align_log2 != (is_pixl ? POSEPACK_PIXL_ALIGN_LOG2 : POSEPACK_TABLE_ALIGN_LOG2)) {
        return POSEPACK_ERROR_SECTION;
    }
    return POSEPACK_OK;
}

/* Types, duplicates, unknown and missing sections; fills the view's section indices. */
static posepack_result identify_sections(posepack_view* view) {
    uint32_t found = 0;
    uint32_t i, j;
    for (i = 0; i < view->header.section_count; ++i) {
        const posepack_section* section = &view->sections[i];
        uint32_t known = 0;
        posepack_result result;
        if (!is_four_letters(section->type)) return POSEPACK_ERROR_SECTION;
        for (j = 0; j < i; ++j) {
            if (view->sections[j].type == section->type) return POSEPACK_ERROR_SECTION_DUP;
        }
        while (known < KNOWN_SECTION_COUNT && kKnownTypes[known] != section->type) ++known;
        if (known < KNOWN_SECTION_COUNT) {
            *known_section(view, known) = i;
            if (known < REQUIRED_SECTION_COUNT) ++found;
        } else if ((section->type & 0x20u) == 0) { /* an upper-case first letter: required */
            return POSEPACK_ERROR_UNKNOWN_REQUIRED;
        }
        result = check_entry(section, known);
        if (result != POSEPACK_OK) return result;
    }
    if (view->header.row_scheme == POSEPACK_ROWS_RUNS && view->runs_section == POSEPACK_NONE) {
        return POSEPACK_ERROR_SECTION_MISSING;
    }
    return found == REQUIRED_SECTION_COUNT ? POSEPACK_OK : POSEPACK_ERROR_SECTION_MISSING;
}

/* The law of no holes: each section begins where the last one ended, rounded up to its alignment. */
static posepack_result check_places(const posepack_view* view, uint64_t size) {
    const uint32_t count = view->header.section_count;
    uint64_t end = POSEPACK_HEADER_BYTES + count * POSEPACK_ENTRY_BYTES;
    uint32_t i;
    for (i = 0; i < count; ++i) {
        const posepack_section* section = &view->sections[i];
        const uint64_t align = (uint64_t)1 << section->align_log2;
        const uint64_t start = (end + align - 1) & ~(align - 1);
        if (section->offset != start || start > size) return POSEPACK_ERROR_SECTION;
        if (section->stored_bytes < 1 || section->stored_bytes > size - start) return POSEPACK_ERROR_SECTION;
        if (!posepack_all_zero(view->bytes + end, start - end)) return POSEPACK_ERROR_PADDING;
        end = start + section->stored_bytes;
    }
    return end == size ? POSEPACK_OK : POSEPACK_ERROR_SECTION;
}

static posepack_result check_section_crcs(const posepack_view* view) {
    uint32_t i;
    for (i = 0; i < view->header.section_count; ++i) {
        const posepack_span span = posepack_section_span(view, i);
        if (posepack_crc32c(0, span.data, span.size) != view->sections[i].crc) {
            return POSEPACK_ERROR_SECTION_CRC;
        }
    }
    return POSEPACK_OK;
}

static posepack_result open_checked(posepack_view* view, const uint8_t* bytes, size_t size) {
    posepack_result result = check_prefix(bytes, size);
    if (result != POSEPACK_OK) return result;
    copy_header(&view->header, bytes);
    view->bytes = bytes;
    view->runs_section = POSEPACK_NONE;
    view->slot_section = POSEPACK_NONE;
    result = check_header(&view->header, size);
    if (result == POSEPACK_OK) result = copy_table(view, bytes, (uint32_t)size);
    if (result == POSEPACK_OK) result = identify_sections(view);
    if (result == POSEPACK_OK) result = check_places(view, size);
    if (result == POSEPACK_OK) result = check_section_crcs(view);
    if (result == POSEPACK_OK) result = posepack_check_tables(view);
    if (result == POSEPACK_OK) result = posepack_check_pixels(view);
    return result;
}

posepack_result posepack_open(posepack_view* view, const void* bytes, size_t size) {
    posepack_result result;
    if (view == NULL) return POSEPACK_ERROR_ARG;
    clear_view(view);
    if (bytes == NULL) return POSEPACK_ERROR_ARG;
    result = open_checked(view, (const uint8_t*)bytes, size);
    if (result != POSEPACK_OK) clear_view(view);
    return result;
}
