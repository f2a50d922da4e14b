// SPDX-License-Identifier: MIT
// The rules about the texture and its texels (G, X).
#include <algorithm>

#include "rules.hpp"

namespace posepack::test {
namespace {

TEST(Rules, TextureGeometry) {
    run({
        {"G1", "no row a line, and no texel",
         [](Parts& p) {
             put_u32(p.header, POSEPACK_HDR_ROWS_PER_LINE, 0);
             put_u32(p.header, POSEPACK_HDR_TEXTURE_WIDTH, 0);
         }},
        {"G1", "more rows a line than rows",
         [](Parts& p) {
             put_u32(p.header, POSEPACK_HDR_ROWS_PER_LINE, 6);
             put_u32(p.header, POSEPACK_HDR_TEXTURE_WIDTH, 54);
             put_u32(p.header, POSEPACK_HDR_TEXTURE_HEIGHT, 1);
             put_u32(p.header, POSEPACK_HDR_ROW_PITCH, 432);
             const Bytes last_row(p[kPixl].end() - 72, p[kPixl].end());
             p[kPixl].insert(p[kPixl].end(), last_row.begin(), last_row.end());
         }},
        {"G2", "width", header_u32(POSEPACK_HDR_TEXTURE_WIDTH, 10)},
        {"G3", "a line too many",
         [](Parts& p) {
             put_u32(p.header, POSEPACK_HDR_TEXTURE_HEIGHT, 6);
             p[kPixl].resize(6 * 72);
         }},
        {"G4", "a pitch of one texel more", header_u32(POSEPACK_HDR_ROW_PITCH, 80)},
        {"G4", "P25 rounded up to 512",
         [](Parts& p) {
             put_u32(p.header, POSEPACK_HDR_ROW_PITCH, 512);
             p[kPixl].assign(512 * kTinyRowCount, 0);
         }},
        {"G5", "a line too few", resize(kPixl, -72)},
        {"G5", "eight bytes too many", resize(kPixl, 8)},
    });
}

TEST(Rules, Compression) {
    const auto zstd = [](std::uint64_t raw_bytes) {
        return [=](Parts& p) {
            Section& pixl = p.sections.back();
            pixl.flags = POSEPACK_CODEC_ZSTD;
            pixl.bytes.resize(100);
            pixl.raw_bytes = raw_bytes;
        };
    };
    run({
        {"G5", "P33 100 bytes that claim 1 GiB", zstd(std::uint64_t{1} << 30)},
        {"G5", "one byte more than the texture", zstd(72 * kTinyRowCount + 1)},
        {"X5", "a texture in 100 bytes", zstd(72 * kTinyRowCount), POSEPACK_ERROR_NEEDS_DECODE},
        {"X5", "meshoptimizer",
         [](Parts& p) {
             p.sections.back().flags = POSEPACK_CODEC_MESHOPT;
             p.sections.back().bytes.resize(90);
             p.sections.back().raw_bytes = 72 * kTinyRowCount;
         },
         POSEPACK_ERROR_NEEDS_DECODE},
    });
}

TEST(Rules, NumbersThatMakeTexelsOfNoBytes) {
    // With nothing to store, only the rule about the number itself can refuse the file.
    for (const std::size_t field : {POSEPACK_HDR_ENCODING, POSEPACK_HDR_TEXEL_FORMAT}) {
        Parts parts = make_parts();
        parts.header[field] = 0;
        put_u32(parts.header, POSEPACK_HDR_ROW_PITCH, 0);
        if (field == POSEPACK_HDR_ENCODING) {
            parts.header[POSEPACK_HDR_TEXELS_PER_BONE] = 0;
            put_u32(parts.header, POSEPACK_HDR_TEXTURE_WIDTH, 0);
            for (const std::size_t clip : {kIdle, kWalk}) {
                parts[kClip][clip + POSEPACK_CLIP_ENCODING] = 0;
                parts[kClip][clip + POSEPACK_CLIP_TEXELS_PER_BONE] = 0;
                put_u32(parts[kClip], clip + POSEPACK_CLIP_FIRST_TEXEL, 0);
            }
        }
        parts.sections.back().flags = POSEPACK_CODEC_ZSTD;
        Bytes bytes = assemble(parts);
        put_u64(bytes, entry_offset(bytes, kPixl) + POSEPACK_ENT_RAW_BYTES, 0);
        seal(bytes);
        EXPECT_EQ(open_name(bytes), "SEMANTIC") << "H1, H2: " << field;
    }
}

TEST(Rules, APaletteLargerThanAFileIsRefused) {
    // 65536 rows of 1024 bones would need 1.5 GiB of texels: raw_bytes says so and all else agrees.
    run({{"G6", "raw_bytes above 2^28", [](Parts& p) {
              const std::uint32_t rows = 65536, bones = 1024;
              put_u32(p.header, POSEPACK_HDR_BONE_COUNT, bones);
              put_u32(p.header, POSEPACK_HDR_ROW_COUNT, rows);
              put_u32(p.header, POSEPACK_HDR_TEXTURE_WIDTH, bones * 3);
              put_u32(p.header, POSEPACK_HDR_TEXTURE_HEIGHT, rows);
              put_u32(p.header, POSEPACK_HDR_ROW_PITCH, bones * 24);
              put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, rows - 1);
              put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_TEXEL, bones * 3);
              Bytes bone_table(POSEPACK_BONE_HEAD_BYTES + bones * POSEPACK_BONE_RECORD_BYTES);
              put_u32(bone_table, 0, bones);
              put_u32(bone_table, 4, POSEPACK_BONE_RECORD_BYTES);
              for (std::size_t i = 0; i < bones; ++i) {
                  put_u32(bone_table, POSEPACK_BONE_HEAD_BYTES + 16 * i + POSEPACK_BONE_PARENT,
                          POSEPACK_NONE);
              }
              p[kBone] = bone_table;
              for (const std::size_t mesh : {kMesh0, kMesh1}) {
                  put_u32(p[kSpac], mesh + POSEPACK_MESH_FIRST_JOINT, 0);
                  put_u32(p[kSpac], mesh + POSEPACK_MESH_JOINT_COUNT, 0);
              }
              p.sections.back().flags = POSEPACK_CODEC_ZSTD;
              p.sections.back().raw_bytes = std::uint64_t{rows} * bones * 24;
          }}});
}

TEST(Rules, TexelsOfHalves) {
    for (const std::uint32_t rows_per_line : {1u, 2u, 5u}) {
        TinyOptions options;
        options.rows_per_line = rows_per_line;
        const std::size_t last = 72 * kTinyRowCount - 2;
        run({{"X1", "P31 NaN in the first texel", u16(kPixl, 0, 0x7E00)},
             {"X1", "infinity", u16(kPixl, 36, 0x7C00)},
             {"X1", "minus infinity", u16(kPixl, 70, 0xFC00)},
             {"X1", "the smallest NaN, in the last texel", u16(kPixl, last, 0x7C01)},
             {"X1", "the largest half", u16(kPixl, 36, 0x7BFF), POSEPACK_OK},
             {"X1", "minus the largest half", u16(kPixl, 36, 0xFBFF), POSEPACK_OK}},
            options);
    }
}

TEST(Rules, TexelsOfFloats) {
    TinyOptions options;
    options.texel_format = POSEPACK_TEXEL_RGBA32F;
    run({{"X1", "NaN in the first texel", u32(kPixl, 0, kNaN)},
         {"X1", "minus infinity", u32(kPixl, 68, 0xFF800000u)},
         {"X1", "the smallest NaN, in the last texel", u32(kPixl, 144 * kTinyRowCount - 4, 0x7F800001u)},
         {"X1", "the largest float", u32(kPixl, 68, 0x7F7FFFFFu), POSEPACK_OK}},
        options);
}

TEST(Rules, BottomRowOfMat4) {
    // The fourth component of texel k of bone 1 in row 0, in both orders and formats.
    for (const bool planar : {false, true}) {
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t texel = planar ? k * kTinyBoneCount + 1 : 4 + k;
            TinyOptions options;
            options.encoding = POSEPACK_ENCODING_MAT4;
            options.texel_order = planar ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
            run({{"X2", "half a unit", u16(kPixl, 8 * texel + 6, 0x3800)},
                 {"X2", "minus zero", u16(kPixl, 8 * texel + 6, 0x8000)}},
                options);
            options.texel_format = POSEPACK_TEXEL_RGBA32F;
            run({{"X2", "half a unit", u32(kPixl, 16 * texel + 12, 0x3F000000u)}}, options);
        }
    }
}

TEST(Rules, PlacesBehindTheLastRowRepeatIt) {
    TinyOptions options;
    options.rows_per_line = 3;  // five rows: one place is left
    run({{"X3", "the first byte", u16(kPixl, 72 * 5, 0x3C00)},
         {"X3", "the last byte", u16(kPixl, 72 * 6 - 2, 0x3C00)},
         {"X3", "zero bytes", [](Parts& p) { std::fill(p[kPixl].end() - 72, p[kPixl].end(), 0); }}},
        options);
}

TEST(Rules, FillBehindALineIsZero) {
    TinyOptions options;
    options.pad_pitch = true;
    run({{"X4", "the first byte", u8(kPixl, 72, 1), POSEPACK_ERROR_PADDING},
         {"X4", "the last byte of the file", u8(kPixl, 256 * kTinyRowCount - 1, 1), POSEPACK_ERROR_PADDING}},
        options);
}

}  // namespace
}  // namespace posepack::test
