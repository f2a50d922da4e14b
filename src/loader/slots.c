/* SPDX-License-Identifier: MIT */
/* Slots: rows at uneven times, which all moving bones of a clip share. */
#include "format/bytes.h"
#include "loader/internal.h"

/* Slots of all clips that SLOT has room for behind its head; 0 where there is no SLOT. */
static uint32_t slot_room(const posepack_view* view) {
    const uint32_t head_bytes = POSEPACK_SLOT_HEAD_BYTES * view->header.clip_count;
    uint32_t size = 0;
    if (view->slot_section != POSEPACK_NONE) size = posepack_section_span(view, view->slot_section).size;
    return size >= head_bytes ? (size - head_bytes) / POSEPACK_SLOT_BYTES : 0;
}

posepack_slot_range posepack_stored_slots(const posepack_view* view, uint32_t clip) {
    const uint32_t room = slot_room(view);
    posepack_slot_range range = {NULL, 0};
    if (room > 0) {
        const uint8_t* head = posepack_section_span(view, view->slot_section).data;
        const uint32_t first = posepack_read_u32(head + POSEPACK_SLOT_HEAD_BYTES * clip);
        const uint32_t count = posepack_read_u32(head + POSEPACK_SLOT_HEAD_BYTES * clip + 4);
        if (first <= room && count <= room - first) {
            range.slots =
                head + POSEPACK_SLOT_HEAD_BYTES * view->header.clip_count + POSEPACK_SLOT_BYTES * first;
            range.count = count;
        }
    }
    return range;
}

posepack_slot posepack_unpack_slot(const uint8_t* stored) {
    posepack_slot slot;
    slot.row = posepack_read_u16(stored);
    slot.offset = stored[2];
    slot.span = stored[3];
    return slot;
}

posepack_place posepack_place_in_slots(posepack_slot_range range, float phase) {
    const float position = phase * (float)range.count;
    const uint32_t index = position >= (float)range.count ? range.count - 1 : (uint32_t)position;
    const float along = position - (float)index;
    const posepack_slot slot = posepack_unpack_slot(range.slots + POSEPACK_SLOT_BYTES * index);
    posepack_place place;
    place.row0 = slot.row;
    if (slot.span > 0) {
        place.factor = ((float)slot.offset + along) / (float)slot.span;
    } else {
        const float rows = along * (float)slot.offset;
        const uint32_t whole =
            rows >= (float)slot.offset ? (slot.offset > 0 ? slot.offset - 1u : 0) : (uint32_t)rows;
        place.row0 += whole;
        place.factor = rows - (float)whole;
    }
    place.row1 = place.row0 + 1;
    return place;
}

/* The slots of one clip lead to rows of its runs, and all its moving bones have the same number. */
static int clip_slots_are_valid(const posepack_view* view, uint32_t clip, posepack_slot_range range) {
    const uint32_t row_count = posepack_read_u32(posepack_clip_record(view, clip) + POSEPACK_CLIP_ROW_COUNT);
    uint32_t i;
    for (i = 0; i < range.count; ++i) {
        const posepack_slot slot = posepack_unpack_slot(range.slots + POSEPACK_SLOT_BYTES * i);
        const uint32_t intervals = slot.span > 0 ? 1u : slot.offset;
        if (slot.span > 0 && slot.offset >= slot.span) return 0;
        if (slot.row + intervals >= row_count) return 0;
    }
    for (i = 0; i < view->header.bone_count; ++i) {
        const uint32_t intervals = posepack_stored_run(view, clip, i) >> POSEPACK_RUN_OFFSET_BITS;
        if (intervals != 0 && intervals + 1 != row_count) return 0;
    }
    return 1;
}

int posepack_slots_are_valid(const posepack_view* view) {
    const int is_there = view->slot_section != POSEPACK_NONE;
    const uint32_t clip_count = view->header.clip_count;
    uint32_t clip, next_slot = 0;
    int any = 0;
    for (clip = 0; clip < clip_count; ++clip) {
        any |= posepack_clip_record(view, clip)[POSEPACK_CLIP_ROW_SCHEME] == POSEPACK_ROWS_SLOTS;
    }
    if (any != is_there) return 0;
    if (!is_there) return 1;
    if (posepack_section_span(view, view->slot_section).size < POSEPACK_SLOT_HEAD_BYTES * clip_count)
        return 0;
    for (clip = 0; clip < clip_count; ++clip) {
        const uint8_t* record = posepack_clip_record(view, clip);
        const int has_slots = record[POSEPACK_CLIP_ROW_SCHEME] == POSEPACK_ROWS_SLOTS;
        const uint8_t* head = posepack_section_span(view, view->slot_section).data;
        const uint32_t count = posepack_read_u32(head + POSEPACK_SLOT_HEAD_BYTES * clip + 4);
        if (posepack_read_u32(head + POSEPACK_SLOT_HEAD_BYTES * clip) != next_slot) return 0;
        if (count > slot_room(view) - next_slot || (count > 0) != has_slots) return 0;
        if (has_slots && !clip_slots_are_valid(view, clip, posepack_stored_slots(view, clip))) return 0;
        next_slot += count;
    }
    return posepack_section_span(view, view->slot_section).size ==
           POSEPACK_SLOT_HEAD_BYTES * clip_count + POSEPACK_SLOT_BYTES * next_slot;
}
