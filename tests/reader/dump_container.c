/* SPDX-License-Identifier: MIT */
/*
 * Prints everything that the C loader finds in a container, in the form of posepack_reader: floats as
 * the digits of their bits, one bone-row a line; `refused RESULT` for a file that does not open.
 *
 *     dump_container FILE.posepack
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "posepack/loader.h"

static void print_index(uint32_t index) {
    if (index == POSEPACK_NONE) {
        printf(" none");
    } else {
        printf(" %" PRIu32, index);
    }
}

static void print_floats(const float* values, uint32_t count) {
    uint32_t i;
    for (i = 0; i < count; ++i) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        printf(" %08" PRIx32, bits);
    }
}

static void print_named_float(const char* name, float value) {
    printf(" %s", name);
    print_floats(&value, 1);
}

static void print_string(posepack_string text) {
    uint32_t i;
    printf(" \"");
    for (i = 0; i < text.size_bytes; ++i) {
        const unsigned byte = (unsigned char)text.data[i];
        if (byte >= 0x20 && byte <= 0x7E && byte != '"' && byte != '\\') {
            putchar((int)byte);
        } else {
            printf("\\x%02x", byte);
        }
    }
    printf("\"");
}

static void print_header(const posepack_header* h) {
    uint32_t i;
    printf("header major %u\nheader minor %u\n", h->major, h->minor);
    printf("header file_bytes %" PRIu64 "\nheader section_count %" PRIu32 "\n", h->file_bytes,
           h->section_count);
    printf("header required_features %" PRIu32 "\n", h->required_features);
    printf("header optional_features %" PRIu32 "\n", h->optional_features);
    printf("header bone_count %" PRIu32 "\nheader row_count %" PRIu32 "\n", h->bone_count, h->row_count);
    printf("header clip_count %" PRIu32 "\nheader encoding %u\n", h->clip_count, h->encoding);
    printf("header texel_format %u\nheader texels_per_bone %u\n", h->texel_format, h->texels_per_bone);
    printf("header texel_order %u\nheader row_scheme %u\n", h->texel_order, h->row_scheme);
    printf("header space_flags %u\nheader texture_width %" PRIu32 "\n", h->space_flags,
           h->texture_width_texels);
    printf("header texture_height %" PRIu32 "\n", h->texture_height_texels);
    printf("header row_pitch %" PRIu32 "\n", h->row_pitch_bytes);
    printf("header rows_per_line %" PRIu32 "\n", h->rows_per_line);
    printf("header");
    print_named_float("radius_m", h->radius_m);
    printf("\nheader");
    print_named_float("dualquat_length", h->dualquat_length);
    printf("\nheader bake_abi %" PRIu32 "\nheader recipe_sha256 ", h->bake_abi);
    for (i = 0; i < 32; ++i) printf("%02x", h->recipe_sha256[i]);
    printf("\n");
}

static void print_sections(const posepack_view* view) {
    uint32_t i;
    for (i = 0; i < view->header.section_count; ++i) {
        const posepack_section* s = &view->sections[i];
        printf("section %c%c%c%c", (int)(s->type & 255u), (int)((s->type >> 8) & 255u),
               (int)((s->type >> 16) & 255u), (int)(s->type >> 24));
        printf(" flags %" PRIu32 " offset %" PRIu64 " stored %" PRIu64 " raw %" PRIu64, s->flags, s->offset,
               s->stored_bytes, s->raw_bytes);
        printf(" align_log2 %" PRIu32 " crc %08" PRIx32 " raw_crc %08" PRIx32 "\n", s->align_log2, s->crc,
               s->raw_crc);
    }
}

static void print_clip_errors(const posepack_clip_error* error) {
    printf("  error");
    print_floats(&error->max, 1);
    print_floats(&error->p999, 1);
    print_floats(&error->rms, 1);
    print_floats(&error->time_s, 1);
    print_index(error->mesh);
    print_index(error->vertex);
    print_index(error->bone);
    printf("\n  normal");
    print_floats(&error->normal_max_deg, 1);
    print_floats(&error->normal_p999_deg, 1);
    print_floats(&error->normal_rms_deg, 1);
    print_floats(&error->normal_time_s, 1);
    print_index(error->normal_mesh);
    print_index(error->normal_vertex);
    print_index(error->normal_bone);
    printf("\n");
}

static void print_clip(const posepack_view* view, uint32_t index) {
    posepack_clip clip;
    posepack_slot slot;
    uint32_t i, row;
    if (posepack_get_clip(view, index, &clip) != POSEPACK_OK) exit(3);
    printf("clip %" PRIu32, index);
    print_string(clip.name);
    print_string(clip.source_name);
    printf("\n  encoding %u texels_per_bone %u row_scheme %u", clip.encoding, clip.texels_per_bone,
           clip.row_scheme);
    printf(" wrap %u seam %u closing_row %u interpolation %u measured %u", clip.wrap, clip.seam,
           clip.closing_row, clip.interpolation, clip.measured);
    printf(" first_row %" PRIu32 " row_count %" PRIu32, clip.first_row, clip.row_count);
    printf(" first_texel %" PRIu32 " cut_count %" PRIu32 "\n ", clip.first_texel, clip.cut_count);
    print_named_float("rate_hz", clip.rate_hz);
    print_named_float("period_s", clip.period_s);
    print_named_float("start_s", clip.start_s);
    print_named_float("speed_mps", clip.speed_mps);
    print_named_float("stride_phase", clip.stride_phase);
    print_named_float("sphere_radius", clip.sphere_radius);
    print_named_float("seam_gap", clip.seam_gap);
    printf("\n  box");
    print_floats(clip.box_min, 3);
    print_floats(clip.box_max, 3);
    printf(" sphere");
    print_floats(clip.sphere_center, 3);
    printf("\n");
    print_clip_errors(&clip.error);
    printf("  cuts");
    for (i = 0; posepack_get_cut(view, index, i, &row) == POSEPACK_OK; ++i) printf(" %" PRIu32, row);
    printf("\n  slots");
    for (i = 0; posepack_get_slot(view, index, i, &slot) == POSEPACK_OK; ++i)
        printf(" %" PRIu32 ":%" PRIu32 "/%" PRIu32, slot.row, slot.offset, slot.span);
    printf("\n");
    if (i != clip.slot_count) exit(3);
}

static void print_states(const posepack_view* view) {
    posepack_state state;
    uint32_t count, default_state, i;
    if (posepack_count_states(view, &count, &default_state) != POSEPACK_OK) exit(3);
    printf("states %" PRIu32 " default", count);
    print_index(default_state);
    printf("\n");
    for (i = 0; posepack_get_state(view, i, &state) == POSEPACK_OK; ++i) {
        printf("state %" PRIu32, i);
        print_string(state.name);
        printf(" clip %" PRIu32 "\n", state.clip);
    }
}

static void print_bones(const posepack_view* view) {
    posepack_bone bone;
    uint32_t i;
    for (i = 0; posepack_get_bone(view, i, &bone) == POSEPACK_OK; ++i) {
        printf("bone %" PRIu32, i);
        print_string(bone.name);
        printf(" parent");
        print_index(bone.parent);
        printf(" flags %" PRIu32 " node %" PRIu32 "\n", bone.flags, bone.node);
    }
}

static void print_space(const posepack_view* view) {
    posepack_space space;
    posepack_mesh mesh;
    uint32_t i, joint, bone = POSEPACK_NONE;
    if (posepack_get_space(view, &space) != POSEPACK_OK) exit(3);
    printf("space model_from_palette");
    print_floats(space.model_from_palette, 12);
    printf("\nspace forward_axis %" PRIu32, space.forward_axis);
    print_named_float("metres_per_unit", space.metres_per_unit);
    printf("\n");
    for (i = 0; posepack_get_mesh(view, i, &mesh) == POSEPACK_OK; ++i) {
        printf("mesh %" PRIu32, i);
        print_string(mesh.name);
        printf(" node %" PRIu32 " mesh %" PRIu32 " skin %" PRIu32 " vertices %" PRIu32, mesh.node, mesh.mesh,
               mesh.skin, mesh.vertex_count);
        printf("\n  palette_from_mesh");
        print_floats(mesh.palette_from_mesh, 12);
        printf("\n  joints");
        for (joint = 0; joint < mesh.joint_count; ++joint) {
            if (posepack_map_joint(view, i, joint, &bone) == POSEPACK_OK)
                printf(" %" PRIu32, bone);
            else
                printf(bone == POSEPACK_NONE ? " none" : " ?");
        }
        printf("\n");
    }
}

static void print_rows(const posepack_view* view) {
    float matrix[12];
    uint32_t row, bone;
    for (row = 0; row < view->header.row_count; ++row) {
        for (bone = 0; posepack_decode_bone(view, row, bone, matrix) == POSEPACK_OK; ++bone) {
            printf("row %" PRIu32 " bone %" PRIu32, row, bone);
            print_floats(matrix, 12);
            printf("\n");
        }
    }
}

/* Bits of the phases at which poses are printed: those of posepack_reader/dump.py. */
static const uint32_t kPhases[] = {0x7FC00000u, 0x3A83126Fu, 0x3DCCCCCDu, 0x3EAAAAABu, 0x3F000000u,
                                   0x3F3851ECu, 0x3F7FFFFFu, 0x3F800000u, 0x40000000u};

static void print_runs(const posepack_view* view, uint32_t clip) {
    posepack_run run;
    uint32_t bone;
    for (bone = 0; posepack_get_run(view, clip, bone, &run) == POSEPACK_OK; ++bone) {
        printf("run %" PRIu32 " bone %" PRIu32 " texel %" PRIu32 " texel_step %" PRIu32, clip, bone,
               run.texel, run.texel_step);
        printf(" k_step %" PRIu32 " intervals %" PRIu32 " wraps %" PRIu32 "\n", run.k_step,
               run.interval_count, run.wraps);
    }
}

static void print_poses(const posepack_view* view, uint32_t clip) {
    float* matrices = (float*)malloc(view->header.bone_count * 12 * sizeof(float));
    uint32_t i, bone;
    if (matrices == NULL) exit(2);
    for (i = 0; i < sizeof kPhases / sizeof kPhases[0]; ++i) {
        float phase;
        memcpy(&phase, &kPhases[i], sizeof phase);
        if (posepack_sample_pose(view, clip, phase, matrices) != POSEPACK_OK) exit(3);
        for (bone = 0; bone < view->header.bone_count; ++bone) {
            printf("sample %" PRIu32 " phase %08" PRIx32 " bone %" PRIu32, clip, kPhases[i], bone);
            print_floats(matrices + 12 * bone, 12);
            printf("\n");
        }
    }
    free(matrices);
}

static void print_container(const void* bytes, size_t size) {
    posepack_view view;
    const posepack_result result = posepack_open(&view, bytes, size);
    uint32_t i;
    if (result != POSEPACK_OK) {
        printf("refused %s\n", posepack_result_name(result));
        return;
    }
    print_header(&view.header);
    print_sections(&view);
    for (i = 0; i < view.header.clip_count; ++i) print_clip(&view, i);
    print_states(&view);
    print_bones(&view);
    print_space(&view);
    print_rows(&view);
    for (i = 0; i < view.header.clip_count; ++i) {
        print_runs(&view, i);
        print_poses(&view, i);
    }
}

int main(int argument_count, char** arguments) {
    FILE* file = argument_count == 2 ? fopen(arguments[1], "rb") : NULL;
    unsigned char* bytes = NULL;
    size_t size = 0, capacity = 0, got = 0;
    if (file == NULL) {
        fprintf(stderr, "usage: dump_container FILE.posepack\n");
        return 1;
    }
    do {
        size += got;
        if (capacity - size < 65536) {
            unsigned char* grown = (unsigned char*)realloc(bytes, capacity = 2 * capacity + 65536);
            if (grown == NULL) return 2;
            bytes = grown;
        }
        got = fread(bytes + size, 1, capacity - size, file);
    } while (got > 0);
    fclose(file);
    print_container(bytes, size);
    free(bytes);
    return 0;
}
