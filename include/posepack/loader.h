/* SPDX-License-Identifier: MIT */
/*
 * The posepack loader: reads a `.posepack` animation palette from memory.
 *
 * A palette holds, for every baked row (a frame of a clip) and every bone, the skinning matrix
 * `joint global x inverse bind`: one affine matrix that carries a bind-pose vertex to its posed
 * place. Conventions: right-handed, +Y up, seconds, column vectors; a matrix handed out by this
 * API is 3x4, row-major, 12 floats: position' = M[r*4+0..2] . position + M[r*4+3].
 *
 * Use:
 *
 *     posepack_view view;
 *     uint32_t index;
 *     float matrix[12];
 *     if (posepack_open(&view, bytes, size) != POSEPACK_OK) return 0;
 *     if (posepack_find_clip(&view, "walk", &index) != POSEPACK_OK) return 0;
 *     posepack_sample_bone(&view, index, 0.25f, 0, matrix);  (bone 0, a quarter through the clip)
 *
 * Memory: no allocation, no I/O, no globals, no recursion. The view copies header and section
 * table; everything else points into the caller's bytes, which must outlive the view. Bytes may
 * have any alignment. `posepack_open` makes every check of the format before it answers OK, and
 * each accessor checks its index again, so that bytes which change later give wrong values at
 * worst, never a read outside the buffer.
 *
 * Threads: a view is const after open; any number of threads may read it.
 *
 * Stability: draft. Result values are pinned; structs may still grow until the format is frozen.
 */
#ifndef POSEPACK_LOADER_H
#define POSEPACK_LOADER_H

#include <stddef.h>
#include <stdint.h>

#include "posepack/format.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Results. Families: 1 caller, 10s framing, 20s sections, 30s meaning, 40s look-ups. */
typedef int32_t posepack_result;
#define POSEPACK_OK 0
#define POSEPACK_ERROR_ARG 1               /* a null pointer */
#define POSEPACK_ERROR_TOO_SMALL 10        /* fewer bytes than a header */
#define POSEPACK_ERROR_MAGIC 11            /* not a container, or changed by a text-mode transfer */
#define POSEPACK_ERROR_VERSION 12          /* another major version, or another draft */
#define POSEPACK_ERROR_SIZE 13             /* the buffer is longer or shorter than the file was */
#define POSEPACK_ERROR_LIMIT 14            /* a count outside the limits of the format */
#define POSEPACK_ERROR_HEADER_CRC 15       /* the header was changed */
#define POSEPACK_ERROR_TABLE_CRC 16        /* the section table was changed */
#define POSEPACK_ERROR_SECTION 20          /* a section lies where it may not */
#define POSEPACK_ERROR_SECTION_DUP 21      /* a section is listed twice */
#define POSEPACK_ERROR_SECTION_MISSING 22  /* a required section is missing */
#define POSEPACK_ERROR_SECTION_CRC 23      /* a section was changed */
#define POSEPACK_ERROR_PADDING 24          /* a fill byte is not zero */
#define POSEPACK_ERROR_UNKNOWN_REQUIRED 25 /* a required section or feature this reader lacks */
#define POSEPACK_ERROR_SEMANTIC 30         /* a value that breaks a rule of the format */
#define POSEPACK_ERROR_UNSUPPORTED 31      /* a known encoding, format or order not read yet */
#define POSEPACK_ERROR_NEEDS_DECODE 32     /* a compressed section: decode the file first */
#define POSEPACK_ERROR_NOT_FOUND 40        /* no such name, state or joint */
#define POSEPACK_ERROR_INDEX 41            /* an index out of range */

/* One entry of the section table, as stored. */
typedef struct posepack_section {
    uint32_t type;
    uint32_t flags;
    uint64_t offset;
    uint64_t stored_bytes;
    uint64_t raw_bytes;
    uint32_t align_log2;
    uint32_t crc;
    uint32_t raw_crc;
} posepack_section;

/* The header, as stored. Encodings, formats and orders are the POSEPACK_* values of format.h. */
typedef struct posepack_header {
    uint16_t major;
    uint16_t minor;
    uint64_t file_bytes;
    uint32_t section_count;
    uint32_t required_features;
    uint32_t optional_features;
    uint32_t bone_count;
    uint32_t row_count;
    uint32_t clip_count;
    uint8_t encoding;
    uint8_t texel_format;
    uint8_t texels_per_bone;
    uint8_t texel_order;
    uint8_t row_scheme;
    uint8_t space_flags;
    uint32_t texture_width_texels;
    uint32_t texture_height_texels;
    uint32_t row_pitch_bytes;
    uint32_t rows_per_line;
    float radius_m;        /* R: rest-pose bounding radius, in metres */
    float dualquat_length; /* L of dualquat, palette units; zero under other encodings */
    uint32_t bake_abi;
    uint8_t recipe_sha256[32];
} posepack_header;

/* A container opened by posepack_open. Read `header`; the rest belongs to the loader. */
typedef struct posepack_view {
    posepack_header header;
    const uint8_t* bytes;
    posepack_section sections[POSEPACK_MAX_SECTIONS];
    uint32_t clip_section, stat_section, bone_section, spac_section, strs_section, pixl_section;
    uint32_t runs_section; /* POSEPACK_NONE under uniform rows */
    uint32_t slot_section; /* POSEPACK_NONE where no clip has slots */
} posepack_view;

/* UTF-8 inside the container's bytes; not terminated by a zero. */
typedef struct posepack_string {
    const char* data;
    uint32_t size_bytes;
} posepack_string;

/*
 * Measured error of one clip: every vertex, at rows, source keys and the midpoints between. Amounts are
 * zero and indices POSEPACK_NONE where nothing was measured.
 */
typedef struct posepack_clip_error {
    float max, p999, rms; /* fraction of R */
    float time_s;         /* clip time of the maximum */
    uint32_t mesh, vertex, bone;
    float normal_max_deg, normal_p999_deg, normal_rms_deg;
    float normal_time_s;
    uint32_t normal_mesh, normal_vertex, normal_bone;
} posepack_clip_error;

typedef struct posepack_clip {
    posepack_string name;
    posepack_string source_name; /* the glTF animation name, verbatim */
    uint8_t encoding, texels_per_bone, row_scheme;
    uint8_t wrap, seam;
    uint8_t closing_row; /* 1: row 0 is stored once more at first_row + row_count, for the last blend */
    uint8_t interpolation;
    uint8_t measured; /* 1: `error` holds measurements */
    uint32_t first_row;
    uint32_t row_count; /* under runs: of the clip's longest run, its end included */
    uint32_t first_texel;
    uint32_t cut_count;
    uint32_t slot_count; /* 0 unless row_scheme is POSEPACK_ROWS_SLOTS */
    float rate_hz;       /* rows a second; 0 for a clip of one row */
    float period_s;      /* loop: exact period; once and ping-pong: duration; 0 for one row */
    float start_s;       /* glTF time of row 0 */
    float speed_mps;     /* ground speed at rate 1, 0 = not stated */
    float stride_phase;
    float box_min[3], box_max[3]; /* bounds of every pose and blend, palette space */
    float sphere_center[3], sphere_radius;
    float seam_gap; /* largest distance of first to last source pose, fraction of R */
    posepack_clip_error error;
} posepack_clip;

typedef struct posepack_state {
    posepack_string name;
    uint32_t clip;
} posepack_state;

typedef struct posepack_bone {
    posepack_string name;
    uint32_t parent; /* bone index or POSEPACK_NONE */
    uint32_t flags;  /* POSEPACK_BONE_FLAG_* */
    uint32_t node;   /* glTF node index */
} posepack_bone;

/*
 * A mesh of the model. Its vertices enter the palette by palette_from_mesh, in every space: in model space
 * too it may be another matrix than the identity (a skin that shares the bones of another; format, section
 * 7).
 */
typedef struct posepack_mesh {
    posepack_string name;
    uint32_t node, mesh, skin; /* glTF indices */
    uint32_t joint_count;
    uint32_t vertex_count;
    float palette_from_mesh[12];
} posepack_mesh;

typedef struct posepack_space {
    float model_from_palette[12];
    uint32_t forward_axis; /* POSEPACK_FORWARD_* */
    float metres_per_unit;
    uint32_t mesh_count;
} posepack_space;

/* The texels, ready for upload: `height` lines of `row_pitch_bytes` at `data`. */
typedef struct posepack_texels {
    const void* data; /* 4096-aligned when the file itself is page-aligned in memory */
    size_t size_bytes;
    uint32_t width_texels, height_texels, row_pitch_bytes;
    uint8_t format; /* POSEPACK_TEXEL_* */
} posepack_texels;

/*
 * Opens a container after checking all of it: framing, checksums, sections, every table and every
 * texel.
 *   view   filled on success; zeroed otherwise.
 *   bytes  the file, any alignment; must stay readable while the view is used.
 *   size   its length in bytes; the file's own idea of its length must agree.
 * Gives any framing, section or meaning result above. Cost: one pass over the file.
 */
posepack_result posepack_open(posepack_view* view, const void* bytes, size_t size);

/* The pinned name of a result, such as "HEADER_CRC"; "UNKNOWN" for any other number. */
const char* posepack_result_name(posepack_result result);

/* Clip `index` < header.clip_count. OK, ARG or INDEX. O(1). */
posepack_result posepack_get_clip(const posepack_view* view, uint32_t index, posepack_clip* clip);

/*
 * Cut `index` < clip.cut_count of clip `clip_index`: a row, counted from the clip's first, that does not
 * blend into the next. OK, ARG or INDEX.
 */
posepack_result posepack_get_cut(const posepack_view* view, uint32_t clip_index, uint32_t index,
                                 uint32_t* row);

/* Index of the first clip called `name` (zero-terminated UTF-8, exact). OK, ARG or NOT_FOUND. O(clips). */
posepack_result posepack_find_clip(const posepack_view* view, const char* name, uint32_t* index);

/* Number of states, and the default one (POSEPACK_NONE where the catalog names none). */
posepack_result posepack_count_states(const posepack_view* view, uint32_t* count, uint32_t* default_state);

/* State `index` < count. OK, ARG or INDEX. */
posepack_result posepack_get_state(const posepack_view* view, uint32_t index, posepack_state* state);

/* The clip that state `name` plays. OK, ARG or NOT_FOUND. O(states). */
posepack_result posepack_find_state(const posepack_view* view, const char* name, uint32_t* clip_index);

/* Bone `index` < header.bone_count. OK, ARG or INDEX. */
posepack_result posepack_get_bone(const posepack_view* view, uint32_t index, posepack_bone* bone);

/* Index of the first bone called `name`. OK, ARG or NOT_FOUND. O(bones). */
posepack_result posepack_find_bone(const posepack_view* view, const char* name, uint32_t* index);

/* Spaces and units of the palette. */
posepack_result posepack_get_space(const posepack_view* view, posepack_space* space);

/* Skinned mesh `index` < space.mesh_count. OK, ARG or INDEX. */
posepack_result posepack_get_mesh(const posepack_view* view, uint32_t index, posepack_mesh* mesh);

/*
 * The bone that joint `joint` (a value of JOINTS_0) of mesh `mesh_index` reads. OK, ARG or INDEX; NOT_FOUND,
 * and POSEPACK_NONE in *bone, for a joint that was left out of the palette because no vertex has a weight on
 * it: where a vertex names it with weight 0, any bone will do.
 */
posepack_result posepack_map_joint(const posepack_view* view, uint32_t mesh_index, uint32_t joint,
                                   uint32_t* bone);

/* The texels, in place. */
posepack_result posepack_get_texels(const posepack_view* view, posepack_texels* texels);

/* The stored bytes of section `type` (POSEPACK_FOURCC), known or not. OK, ARG or NOT_FOUND. */
posepack_result posepack_get_section(const posepack_view* view, uint32_t type, const void** data,
                                     size_t* size_bytes);

/* Where the rows of one bone of one clip are: row r (0 to interval_count) begins at texel `texel` + r x
 * `texel_step`, counted along the lines of the texture (or in a storage buffer under a tight pitch), and the
 * bone's texels of a row are `k_step` apart. */
typedef struct posepack_run {
    uint32_t texel;
    uint32_t texel_step, k_step;
    uint32_t interval_count;
    uint32_t wraps; /* 1: the last interval ends at row 0 (uniform rows of a loop without closing row) */
} posepack_run;

/* The run of bone `bone` in clip `clip_index`, under every row scheme. OK, ARG or INDEX. O(1). */
posepack_result posepack_get_run(const posepack_view* view, uint32_t clip_index, uint32_t bone,
                                 posepack_run* run);

/*
 * A share of a clip's period: one of clip.slot_count, all of equal length. It goes from `offset` / `span` to
 * (`offset` + 1) / `span` of the way from row `row` to the next, or, where `span` is 0, from `row` on through
 * `offset` whole intervals (none: the row is held).
 */
typedef struct posepack_slot {
    uint32_t row, offset, span;
} posepack_slot;

/* Slot `index` < clip.slot_count of clip `clip_index`. OK, ARG or INDEX. O(1). */
posepack_result posepack_get_slot(const posepack_view* view, uint32_t clip_index, uint32_t index,
                                  posepack_slot* slot);

/* Two rows of a bone's run, counted from its first, and the share of the second, 0 to 1. */
typedef struct posepack_place {
    uint32_t row0, row1;
    float factor;
} posepack_place;

/*
 * The rows that show bone `bone` of a clip at a phase (as below), under every row scheme. Where the factor is
 * 0 the pose is row0 alone, and row1 may be one behind the last. OK, ARG or INDEX. O(1) but for a search
 * among the clip's cuts.
 */
posepack_result posepack_find_place(const posepack_view* view, uint32_t clip_index, float phase,
                                    uint32_t bone, posepack_place* place);

/*
 * Decodes one bone of a clip at a phase, as a shader does, under every row scheme: between two rows of its
 * run, or one row alone where the clip is made of steps or the row is a cut.
 *   phase  0 to 1 over the clip's period_s: what wrap makes of the time (docs/format/posepack-1.md, section
 *          11). Smaller values and NaN count as 0, larger ones as 1.
 * OK, ARG or INDEX. O(1) but for a search among the clip's cuts.
 */
posepack_result posepack_sample_bone(const posepack_view* view, uint32_t clip_index, float phase,
                                     uint32_t bone, float matrix[12]);

/* The same for all bones: header.bone_count matrices of 12 floats, bone by bone. */
posepack_result posepack_sample_pose(const posepack_view* view, uint32_t clip_index, float phase,
                                     float* matrices);

/*
 * Decodes one bone of one row to a 3x4 row-major matrix, from palette space to palette space.
 *   row   0 <= row < header.row_count (clip.first_row + a row of the clip)
 *   bone  0 <= bone < header.bone_count
 * OK, ARG or INDEX, and UNSUPPORTED where the palette has runs, which share no rows: sample it. Under mat4
 * and affine, values are exactly the stored ones, widened to float; under dualquat they are computed in
 * float, in the order that the format's section 10 gives.
 */
posepack_result posepack_decode_bone(const posepack_view* view, uint32_t row, uint32_t bone,
                                     float matrix[12]);

/* Decodes all bones of one row: header.bone_count matrices of 12 floats, bone by bone. */
posepack_result posepack_decode_row(const posepack_view* view, uint32_t row, float* matrices);

/*
 * Decodes one bone between two rows, as a shader does: matrices of mat4 and affine are mixed entry by entry,
 * dual quaternions are mixed and normalised, their scales apart.
 *   row0, row1  0 <= row < header.row_count. They should be neighbours of one clip: behind the last row of a
 *               loop comes its closing row (first_row + row_count) where clip.closing_row is 1, else its row
 *               0
 *   factor      share of row1, 0 to 1; 0 gives exactly posepack_decode_bone of row0
 * OK, ARG, INDEX or UNSUPPORTED, as above.
 */
posepack_result posepack_blend_bone(const posepack_view* view, uint32_t row0, uint32_t row1, float factor,
                                    uint32_t bone, float matrix[12]);

/* The same for all bones: header.bone_count matrices of 12 floats, bone by bone. */
posepack_result posepack_blend_row(const posepack_view* view, uint32_t row0, uint32_t row1, float factor,
                                   float* matrices);

#ifdef __cplusplus
}
#endif

#endif
