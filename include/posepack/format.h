/* SPDX-License-Identifier: MIT */
/*
 * The byte layout of a `.posepack` container, shared by the compiler and the loader.
 *
 * A container is a 128-byte header, a section table of 48-byte entries and the sections, with no
 * holes between them. Every integer and float is little-endian; every offset is counted in bytes
 * from the start of the file unless its name says otherwise. Offsets below name the place of a
 * field inside its record; `docs/format/posepack-1.md` says what each field means.
 *
 * Texel addressing (linear index of texel k of bone b in row r):
 *   bone-major  (r * bone_count + b) * texels_per_bone + k
 *   planar      (r * texels_per_bone + k) * bone_count + b
 * A texture line holds `rows_per_line` rows side by side: line = r / rows_per_line.
 *
 * C99 and C++; constants only. Version 1 is a draft: its minor number counts drafts.
 */
#ifndef POSEPACK_FORMAT_H
#define POSEPACK_FORMAT_H

#define POSEPACK_FORMAT_MAJOR 1u
#define POSEPACK_FORMAT_MINOR 4u /* draft 4 */

/* Raised whenever equal inputs may give other bytes than before. */
#define POSEPACK_BAKE_ABI 4u

/* Limits of version 1. */
#define POSEPACK_MAX_FILE_BYTES 268435456u /* 2^28 */
#define POSEPACK_MAX_SECTIONS 32u
#define POSEPACK_MAX_BONES 1024u
#define POSEPACK_MAX_ROWS 65536u
#define POSEPACK_MAX_CLIPS 4096u
#define POSEPACK_MAX_STRING_BYTES 255u

#define POSEPACK_NONE 0xFFFFFFFFu /* "no such index" in every u32 index field */
#define POSEPACK_NO_BONE 0xFFFFu  /* joint map: a joint that moves no vertex and has no bone */
#define POSEPACK_MIXED 255u       /* header encoding and row scheme where clips differ */

/* The first 16 bytes (magic, major, minor, header_bytes) never change. */
#define POSEPACK_MAGIC_BYTES \
    { 0x8B, 'P', 'P', 'K', 0x0D, 0x0A, 0x1A, 0x0A }

/* Header. */
#define POSEPACK_HEADER_BYTES 128u
#define POSEPACK_HDR_MAGIC 0              /* u8[8]  */
#define POSEPACK_HDR_MAJOR 8              /* u16    */
#define POSEPACK_HDR_MINOR 10             /* u16    */
#define POSEPACK_HDR_HEADER_BYTES 12      /* u32    */
#define POSEPACK_HDR_FILE_BYTES 16        /* u64    */
#define POSEPACK_HDR_SECTION_COUNT 24     /* u32    */
#define POSEPACK_HDR_TABLE_OFFSET 28      /* u32    */
#define POSEPACK_HDR_REQUIRED_FEATURES 32 /* u32    */
#define POSEPACK_HDR_OPTIONAL_FEATURES 36 /* u32    */
#define POSEPACK_HDR_BONE_COUNT 40        /* u32    */
#define POSEPACK_HDR_ROW_COUNT 44         /* u32    */
#define POSEPACK_HDR_CLIP_COUNT 48        /* u32    */
#define POSEPACK_HDR_ENCODING 52          /* u8     */
#define POSEPACK_HDR_TEXEL_FORMAT 53      /* u8     */
#define POSEPACK_HDR_TEXELS_PER_BONE 54   /* u8     */
#define POSEPACK_HDR_TEXEL_ORDER 55       /* u8     */
#define POSEPACK_HDR_ROW_SCHEME 56        /* u8     */
#define POSEPACK_HDR_SPACE_FLAGS 57       /* u8     */
#define POSEPACK_HDR_RESERVED 58          /* u8[2], zero */
#define POSEPACK_HDR_TEXTURE_WIDTH 60     /* u32    */
#define POSEPACK_HDR_TEXTURE_HEIGHT 64    /* u32    */
#define POSEPACK_HDR_ROW_PITCH 68         /* u32    */
#define POSEPACK_HDR_ROWS_PER_LINE 72     /* u32    */
#define POSEPACK_HDR_RADIUS_M 76          /* f32    */
#define POSEPACK_HDR_DUALQUAT_LENGTH 80   /* f32: L of dualquat, else zero */
#define POSEPACK_HDR_BAKE_ABI 84          /* u32    */
#define POSEPACK_HDR_RECIPE_SHA256 88     /* u8[32] */
#define POSEPACK_HDR_TABLE_CRC 120        /* u32    */
#define POSEPACK_HDR_HEADER_CRC 124       /* u32: CRC-32C of bytes 0..123 */

/* Optional feature bits. */
#define POSEPACK_OPTIONAL_ERROR_MEASURED 1u /* every clip carries its measured error */

/* Space flags. */
#define POSEPACK_SPACE_NORMALISED 1u /* palette space is not model space: use SPAC */

/* Encodings. This draft writes and reads mat4, affine and dualquat; the others are named, and refused. */
#define POSEPACK_ENCODING_MAT4 1u     /* 4 texels: the columns of a 4x4 matrix   */
#define POSEPACK_ENCODING_AFFINE 2u   /* 3 texels: the rows of a 3x4 matrix      */
#define POSEPACK_ENCODING_DUALQUAT 3u /* 2 texels: real and dual part, with scale */
#define POSEPACK_ENCODING_LOCAL 4u    /* 2 texels, parent-relative               */
#define POSEPACK_ENCODING_PACKED 5u   /* 1 texel RG32UI                          */

/* Texel formats. */
#define POSEPACK_TEXEL_RGBA16F 1u
#define POSEPACK_TEXEL_RGBA32F 2u
#define POSEPACK_TEXEL_RGBA32UI 3u
#define POSEPACK_TEXEL_RG32UI 4u

/* Texel orders. */
#define POSEPACK_ORDER_BONE_MAJOR 0u
#define POSEPACK_ORDER_PLANAR 1u
#define POSEPACK_ORDER_TRANSPOSED 2u /* named, and refused by this draft */

/* Row schemes of a file: uniform rows or runs. Of the clips of a file with runs, some may have slots. */
#define POSEPACK_ROWS_UNIFORM 0u
#define POSEPACK_ROWS_SLOTS 1u
#define POSEPACK_ROWS_RUNS 2u

/* Section table entry. Type: four ASCII letters, the first letter in the lowest byte. */
#define POSEPACK_ENTRY_BYTES 48u
#define POSEPACK_ENT_TYPE 0          /* u32 */
#define POSEPACK_ENT_FLAGS 4         /* u32: low 4 bits codec, the rest zero */
#define POSEPACK_ENT_OFFSET 8        /* u64 */
#define POSEPACK_ENT_STORED_BYTES 16 /* u64 */
#define POSEPACK_ENT_RAW_BYTES 24    /* u64 */
#define POSEPACK_ENT_ALIGN_LOG2 32   /* u32 */
#define POSEPACK_ENT_CRC 36          /* u32: CRC-32C of the stored bytes  */
#define POSEPACK_ENT_RAW_CRC 40      /* u32: CRC-32C of the decoded bytes */
#define POSEPACK_ENT_RESERVED 44     /* u32, zero */

#define POSEPACK_FOURCC(a, b, c, d) \
    ((unsigned)(a) | ((unsigned)(b) << 8) | ((unsigned)(c) << 16) | ((unsigned)(d) << 24))
#define POSEPACK_SECTION_CLIP POSEPACK_FOURCC('C', 'L', 'I', 'P')
#define POSEPACK_SECTION_STAT POSEPACK_FOURCC('S', 'T', 'A', 'T')
#define POSEPACK_SECTION_BONE POSEPACK_FOURCC('B', 'O', 'N', 'E')
#define POSEPACK_SECTION_SPAC POSEPACK_FOURCC('S', 'P', 'A', 'C')
#define POSEPACK_SECTION_STRS POSEPACK_FOURCC('S', 'T', 'R', 'S')
#define POSEPACK_SECTION_PIXL POSEPACK_FOURCC('P', 'I', 'X', 'L')
#define POSEPACK_SECTION_RUNS POSEPACK_FOURCC('R', 'U', 'N', 'S')
#define POSEPACK_SECTION_SLOT POSEPACK_FOURCC('S', 'L', 'O', 'T')
#define POSEPACK_SECTION_PROV POSEPACK_FOURCC('p', 'r', 'o', 'v')

#define POSEPACK_TABLE_ALIGN_LOG2 3u /* every section but PIXL */
#define POSEPACK_PIXL_ALIGN_LOG2 12u

#define POSEPACK_CODEC_NONE 0u
#define POSEPACK_CODEC_MESHOPT 1u
#define POSEPACK_CODEC_ZSTD 2u

/* CLIP: this head, then clip_count records, then cut_count rows of clips (u32, rising within a clip). */
#define POSEPACK_CLIP_HEAD_BYTES 16u
#define POSEPACK_CLIP_HEAD_COUNT 0        /* u32, equals the header's clip_count */
#define POSEPACK_CLIP_HEAD_RECORD_BYTES 4 /* u32, 192 */
#define POSEPACK_CLIP_HEAD_CUT_COUNT 8    /* u32 */
#define POSEPACK_CLIP_HEAD_RESERVED 12    /* u32, zero */
#define POSEPACK_CLIP_RECORD_BYTES 192u
#define POSEPACK_CLIP_NAME 0                /* u32 string */
#define POSEPACK_CLIP_SOURCE_NAME 4         /* u32 string: the glTF name, verbatim */
#define POSEPACK_CLIP_ENCODING 8            /* u8 */
#define POSEPACK_CLIP_TEXELS_PER_BONE 9     /* u8 */
#define POSEPACK_CLIP_ROW_SCHEME 10         /* u8 */
#define POSEPACK_CLIP_WRAP 11               /* u8 */
#define POSEPACK_CLIP_SEAM 12               /* u8 */
#define POSEPACK_CLIP_CLOSING_ROW 13        /* u8: 1: row 0 once more behind the last row, not counted */
#define POSEPACK_CLIP_INTERPOLATION 14      /* u8 */
#define POSEPACK_CLIP_FLAGS 15              /* u8 */
#define POSEPACK_CLIP_FIRST_ROW 16          /* u32 */
#define POSEPACK_CLIP_ROW_COUNT 20          /* u32 */
#define POSEPACK_CLIP_FIRST_TEXEL 24        /* u32: texels before the clip in its pixel section */
#define POSEPACK_CLIP_FIRST_CUT 28          /* u32 index into the cut rows */
#define POSEPACK_CLIP_CUT_COUNT 32          /* u32 */
#define POSEPACK_CLIP_RATE_HZ 36            /* f32: rows a second; 0 when row_count is 1 */
#define POSEPACK_CLIP_PERIOD_S 40           /* f32: loop: exact period; once: duration */
#define POSEPACK_CLIP_START_S 44            /* f32: glTF time of row 0 */
#define POSEPACK_CLIP_SPEED_MPS 48          /* f32: ground speed at rate 1, 0 = not stated */
#define POSEPACK_CLIP_STRIDE_PHASE 52       /* f32 */
#define POSEPACK_CLIP_BOX_MIN 56            /* f32[3]: bounds of every pose, palette space */
#define POSEPACK_CLIP_BOX_MAX 68            /* f32[3] */
#define POSEPACK_CLIP_SPHERE_CENTER 80      /* f32[3] */
#define POSEPACK_CLIP_SPHERE_RADIUS 92      /* f32 */
#define POSEPACK_CLIP_TRANSLATION_MIN 96    /* f32[3]: box of `packed` translations, else zero */
#define POSEPACK_CLIP_TRANSLATION_MAX 108   /* f32[3] */
#define POSEPACK_CLIP_ERROR_MAX 120         /* f32: fraction of R */
#define POSEPACK_CLIP_ERROR_P999 124        /* f32 */
#define POSEPACK_CLIP_ERROR_RMS 128         /* f32 */
#define POSEPACK_CLIP_ERROR_TIME_S 132      /* f32: clip time of the maximum */
#define POSEPACK_CLIP_ERROR_MESH 136        /* u32: SPAC mesh of the maximum */
#define POSEPACK_CLIP_ERROR_VERTEX 140      /* u32: vertex within that mesh */
#define POSEPACK_CLIP_ERROR_BONE 144        /* u32 */
#define POSEPACK_CLIP_NORMAL_MAX_DEG 148    /* f32 */
#define POSEPACK_CLIP_NORMAL_P999_DEG 152   /* f32 */
#define POSEPACK_CLIP_NORMAL_RMS_DEG 156    /* f32 */
#define POSEPACK_CLIP_NORMAL_TIME_S 160     /* f32 */
#define POSEPACK_CLIP_NORMAL_MESH 164       /* u32 */
#define POSEPACK_CLIP_NORMAL_VERTEX 168     /* u32 */
#define POSEPACK_CLIP_NORMAL_BONE 172       /* u32 */
#define POSEPACK_CLIP_FIRST_ROOT_MOTION 176 /* u32, POSEPACK_NONE in this draft */
#define POSEPACK_CLIP_ROOT_MOTION_COUNT 180 /* u32, zero in this draft */
#define POSEPACK_CLIP_SEAM_GAP 184          /* f32: first pose to last pose, fraction of R */
#define POSEPACK_CLIP_RESERVED 188          /* u32, zero */

#define POSEPACK_CLIP_FLAG_MEASURED 1u /* the error fields hold measurements (else zero / NONE) */

#define POSEPACK_WRAP_LOOP 0u
#define POSEPACK_WRAP_ONCE 1u
#define POSEPACK_WRAP_PING_PONG 2u
#define POSEPACK_SEAM_CLOSED 0u /* last row blends into row 0 over an interval of the source */
#define POSEPACK_SEAM_OPEN 1u   /* the last key is a pose of its own: one more interval to row 0 */
#define POSEPACK_INTERPOLATION_LINEAR 0u
#define POSEPACK_INTERPOLATION_STEP 1u

/* STAT: state_count u32, default_state u32 (or NONE), then (name string u32, clip u32), by name. */
#define POSEPACK_STAT_HEAD_BYTES 8u
#define POSEPACK_STAT_RECORD_BYTES 8u

/* BONE: head, bone_count records, joint map (u16 bones, then zero bytes to a multiple of 4). */
#define POSEPACK_BONE_HEAD_BYTES 16u
#define POSEPACK_BONE_HEAD_COUNT 0           /* u32, equals the header's bone_count */
#define POSEPACK_BONE_HEAD_RECORD_BYTES 4    /* u32, 16 */
#define POSEPACK_BONE_HEAD_JOINT_MAP_COUNT 8 /* u32 */
#define POSEPACK_BONE_HEAD_RESERVED 12       /* u32, zero */
#define POSEPACK_BONE_RECORD_BYTES 16u
#define POSEPACK_BONE_NAME 0           /* u32 string */
#define POSEPACK_BONE_PARENT 4         /* u32 bone or NONE; following parents always ends */
#define POSEPACK_BONE_FLAGS 8          /* u32 */
#define POSEPACK_BONE_NODE 12          /* u32 glTF node */
#define POSEPACK_BONE_FLAG_WEIGHTED 1u /* some vertex has a weight on it */

/* SPAC: head, then mesh_count records. Matrices are 3x4, row-major, 12 f32. */
#define POSEPACK_SPAC_HEAD_BYTES 64u
#define POSEPACK_SPAC_MODEL_FROM_PALETTE 0 /* f32[12] */
#define POSEPACK_SPAC_FORWARD_AXIS 48      /* u32 */
#define POSEPACK_SPAC_METRES_PER_UNIT 52   /* f32 */
#define POSEPACK_SPAC_MESH_COUNT 56        /* u32 */
#define POSEPACK_SPAC_RECORD_SIZE 60       /* u32, 80 */
#define POSEPACK_MESH_RECORD_BYTES 80u
#define POSEPACK_MESH_NAME 0               /* u32 string */
#define POSEPACK_MESH_NODE 4               /* u32 glTF node */
#define POSEPACK_MESH_MESH 8               /* u32 glTF mesh */
#define POSEPACK_MESH_SKIN 12              /* u32 glTF skin */
#define POSEPACK_MESH_FIRST_JOINT 16       /* u32 index into the joint map */
#define POSEPACK_MESH_JOINT_COUNT 20       /* u32 */
#define POSEPACK_MESH_VERTEX_COUNT 24      /* u32: over its primitives, in order */
#define POSEPACK_MESH_RESERVED 28          /* u32, zero */
#define POSEPACK_MESH_PALETTE_FROM_MESH 32 /* f32[12] */

#define POSEPACK_FORWARD_PLUS_Z 0u
#define POSEPACK_FORWARD_MINUS_Z 1u
#define POSEPACK_FORWARD_PLUS_X 2u
#define POSEPACK_FORWARD_MINUS_X 3u

/*
 * RUNS: a u32 for every bone of every clip, clip by clip: where the bone's run begins, in bone-rows behind
 * the clip's first texel (20 bits), and its intervals (12 bits); a run of n intervals is n + 1 bone-rows.
 * Texels are addressed as one line: texel i is at column i % width of line i / width, and the width is a
 * power of two.
 */
#define POSEPACK_RUN_BYTES 4u
#define POSEPACK_RUN_OFFSET_BITS 20u
#define POSEPACK_RUN_OFFSET_MASK 0xFFFFFu
#define POSEPACK_RUN_MAX_INTERVALS 4095u
#define POSEPACK_RUNS_MIN_WIDTH 64u    /* texels */
#define POSEPACK_RUNS_MAX_HEIGHT 4096u /* lines: the width is the smallest that keeps below it */

/*
 * SLOT: two u32 for every clip, the number of slots before its own and that of its own; then all slots. A
 * slot is a row (u16), an offset and a span (u8 each): a share of the clip's period, all of equal length,
 * which goes from `offset` / `span` to (`offset` + 1) / `span` of the way from the row to the next, or, where
 * the span is 0, through `offset` whole intervals.
 */
#define POSEPACK_SLOT_HEAD_BYTES 8u /* of each clip */
#define POSEPACK_SLOT_BYTES 4u
/* STRS: count u32, offsets u32[count + 1] into the bytes that follow; sorted, unique UTF-8. */

#endif
