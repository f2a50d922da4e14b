// SPDX-License-Identifier: MIT
// The rules about what header fields, tables and texels mean. Every container here has right checksums. Rule
// numbers are those of docs/format/posepack-1.md; P and two digits number the list of bad containers that
// every release answers alike.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "container_builder.hpp"
#include "posepack/loader.h"

namespace posepack::test {
namespace {

struct Case {
    const char* rule;
    const char* what;
    std::function<void(Parts&)> change;
    posepack_result expected = POSEPACK_ERROR_SEMANTIC;
};

constexpr std::uint32_t kClip = POSEPACK_SECTION_CLIP;
constexpr std::uint32_t kStat = POSEPACK_SECTION_STAT;
constexpr std::uint32_t kBone = POSEPACK_SECTION_BONE;
constexpr std::uint32_t kSpac = POSEPACK_SECTION_SPAC;
constexpr std::uint32_t kStrs = POSEPACK_SECTION_STRS;
constexpr std::uint32_t kPixl = POSEPACK_SECTION_PIXL;
constexpr std::size_t kIdle = POSEPACK_CLIP_HEAD_BYTES;
constexpr std::size_t kWalk = kIdle + POSEPACK_CLIP_RECORD_BYTES;
constexpr std::size_t kCuts = kWalk + POSEPACK_CLIP_RECORD_BYTES;
constexpr std::size_t kMesh0 = POSEPACK_SPAC_HEAD_BYTES;
constexpr std::size_t kMesh1 = kMesh0 + POSEPACK_MESH_RECORD_BYTES;
constexpr std::uint32_t kNaN = 0x7FC00000u, kInfinity = 0x7F800000u, kMinusZero = 0x80000000u;
constexpr std::uint32_t kOne = 0x3F800000u, kMinusOne = 0xBF800000u;

std::string open_name(const Bytes& bytes) {
    posepack_view view;
    return posepack_result_name(posepack_open(&view, bytes.data(), bytes.size()));
}

void run(const std::vector<Case>& cases, const TinyOptions& options = {}) {
    ASSERT_EQ(open_name(make_container(options)), "OK");
    for (const Case& test : cases) {
        Parts parts = make_parts(options);
        test.change(parts);
        EXPECT_EQ(open_name(assemble(parts)), posepack_result_name(test.expected))
            << test.rule << ": " << test.what;
    }
}

// Changes of one field of the header or of a section.
std::function<void(Parts&)> header_u8(std::size_t offset, std::uint8_t value) {
    return [=](Parts& p) { p.header.at(offset) = value; };
}
std::function<void(Parts&)> header_u32(std::size_t offset, std::uint32_t value) {
    return [=](Parts& p) { put_u32(p.header, offset, value); };
}
std::function<void(Parts&)> u8(std::uint32_t type, std::size_t offset, std::uint8_t value) {
    return [=](Parts& p) { p[type].at(offset) = value; };
}
std::function<void(Parts&)> u16(std::uint32_t type, std::size_t offset, std::uint16_t value) {
    return [=](Parts& p) { put_u16(p[type], offset, value); };
}
std::function<void(Parts&)> u32(std::uint32_t type, std::size_t offset, std::uint32_t value) {
    return [=](Parts& p) { put_u32(p[type], offset, value); };
}
std::function<void(Parts&)> resize(std::uint32_t type, int more) {
    return [=](Parts& p) { p[type].resize(p[type].size() + static_cast<std::size_t>(more)); };
}

TEST(Rules, HeaderValues) {
    run({
        {"H1", "encoding 0", header_u8(POSEPACK_HDR_ENCODING, 0)},
        {"H1", "encoding 6", header_u8(POSEPACK_HDR_ENCODING, 6)},
        {"H1", "local", header_u8(POSEPACK_HDR_ENCODING, 4), POSEPACK_ERROR_UNSUPPORTED},
        {"H1", "packed", header_u8(POSEPACK_HDR_ENCODING, 5), POSEPACK_ERROR_UNSUPPORTED},
        {"H1", "mixed", header_u8(POSEPACK_HDR_ENCODING, 255), POSEPACK_ERROR_UNSUPPORTED},
        {"H2", "format 0", header_u8(POSEPACK_HDR_TEXEL_FORMAT, 0)},
        {"H2", "format 5", header_u8(POSEPACK_HDR_TEXEL_FORMAT, 5)},
        {"H2", "RGBA32UI", header_u8(POSEPACK_HDR_TEXEL_FORMAT, 3), POSEPACK_ERROR_UNSUPPORTED},
        {"H3", "order 3", header_u8(POSEPACK_HDR_TEXEL_ORDER, 3)},
        {"H3", "transposed", header_u8(POSEPACK_HDR_TEXEL_ORDER, 2), POSEPACK_ERROR_UNSUPPORTED},
        {"H4", "row scheme 3", header_u8(POSEPACK_HDR_ROW_SCHEME, 3)},
        {"H4", "slots", header_u8(POSEPACK_HDR_ROW_SCHEME, 1), POSEPACK_ERROR_UNSUPPORTED},
        {"H4", "mixed", header_u8(POSEPACK_HDR_ROW_SCHEME, 255), POSEPACK_ERROR_UNSUPPORTED},
        {"H5", "affine in 4 texels",
         [](Parts& p) {
             p = make_parts({.encoding = POSEPACK_ENCODING_MAT4});
             p.header[POSEPACK_HDR_ENCODING] = POSEPACK_ENCODING_AFFINE;
             p[kClip][kIdle + POSEPACK_CLIP_ENCODING] = POSEPACK_ENCODING_AFFINE;
             p[kClip][kWalk + POSEPACK_CLIP_ENCODING] = POSEPACK_ENCODING_AFFINE;
         }},
        {"H6", "an unknown space flag", header_u8(POSEPACK_HDR_SPACE_FLAGS, 3)},
        {"H7", "reserved byte 58", header_u8(POSEPACK_HDR_RESERVED, 1)},
        {"H7", "reserved byte 59", header_u8(POSEPACK_HDR_RESERVED + 1, 1)},
        {"H8", "radius 0", header_u32(POSEPACK_HDR_RADIUS_M, 0)},
        {"H8", "radius minus zero", header_u32(POSEPACK_HDR_RADIUS_M, kMinusZero)},
        {"H8", "negative radius", header_u32(POSEPACK_HDR_RADIUS_M, kMinusOne)},
        {"H8", "infinite radius", header_u32(POSEPACK_HDR_RADIUS_M, kInfinity)},
        {"H9", "dualquat_length 1", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kOne)},
        {"H9", "dualquat_length minus zero", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kMinusZero)},
    });
}

TEST(Rules, HeaderValuesOfDualQuaternions) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    run({{"H5", "three texels", header_u8(POSEPACK_HDR_TEXELS_PER_BONE, 3)},
         {"H9", "length 0", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, 0)},
         {"H9", "length minus zero", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kMinusZero)},
         {"H9", "negative length", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kMinusOne)},
         {"H9", "infinite length", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kInfinity)},
         {"H9", "length NaN", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kNaN)},
         {"H9", "another length", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kOne), POSEPACK_OK}},
        options);
}

TEST(Rules, ClosingRows) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    options.closing_row = true;
    const std::size_t last_row = 4 * 48;  // bytes of three bones of two RGBA16F texels, four rows before it
    run({{"C5", "closing_row 2", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 2)},
         {"C5", "of a clip that ends", u8(kClip, kWalk + POSEPACK_CLIP_WRAP, POSEPACK_WRAP_ONCE)},
         {"C6", "no place is left for it", u32(kClip, kWalk + POSEPACK_CLIP_ROW_COUNT, 4)},
         {"C6", "a row that belongs to no clip", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 0)},
         {"C7", "a cut at the closing row", u32(kClip, kCuts, 3)},
         {"X7", "another number", u16(kPixl, last_row + 8, 0x3C00)},
         {"X7", "one sign turned", u8(kPixl, last_row + 1, 0x80)},
         {"X7", "one sign turned back, of a bone that is turned", u8(kPixl, last_row + 16 + 7, 0x3A)}},
        options);
    for (const bool planar : {false, true})
        for (const bool floats : {false, true}) {
            options.texel_order = planar ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
            options.texel_format = floats ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
            run({{"X7", "the last number", [&](Parts& p) { p[kPixl].back() ^= 1; }}}, options);
        }
    run({{"C5", "of another encoding", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 1)}});
}

TEST(Rules, RealPartsOfDualQuaternions) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    // Bone 1 of row 3 in both orders: texel 0 is its real part.
    for (const bool planar : {false, true}) {
        options.texel_order = planar ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
        const std::size_t half_real = 3 * 48 + (planar ? 8 : 16);
        const auto halves = [&](std::uint16_t x) {
            return [=](Parts& p) {
                for (std::size_t c = 0; c < 4; ++c) put_u16(p[kPixl], half_real + 2 * c, c == 2 ? x : 0);
            };
        };
        options.texel_format = POSEPACK_TEXEL_RGBA16F;
        run({{"X6", "zero", halves(0)},
             {"X6", "just below a quarter", halves(0x33FF)},
             {"X6", "just above two", halves(0x4001)},
             {"X6", "a quarter", halves(0x3400), POSEPACK_OK},
             {"X6", "minus two", halves(0xC000), POSEPACK_OK}},
            options);
        options.texel_format = POSEPACK_TEXEL_RGBA32F;
        const std::size_t float_real = 2 * half_real;
        const auto floats = [&](std::uint32_t x) {
            return [=](Parts& p) {
                for (std::size_t c = 0; c < 4; ++c) put_u32(p[kPixl], float_real + 4 * c, c == 2 ? x : 0);
            };
        };
        run({{"X6", "just below a quarter", floats(0x3E7FFFFF)},
             {"X6", "just above two", floats(0x40000001)},
             {"X6", "minus a quarter", floats(0xBE800000), POSEPACK_OK},
             {"X6", "two", floats(0x40000000), POSEPACK_OK}},
            options);
    }
}

// The strings of the tiny container, `extra` behind them: all references stay good.
std::function<void(Parts&)> strings_and(const std::vector<std::string>& extra) {
    return [=](Parts& p) {
        std::vector<std::string> list = tiny_strings();
        list.insert(list.end(), extra.begin(), extra.end());
        p[kStrs] = string_section(list);
    };
}

// "zz" sorts behind every other string, so only the text itself can be wrong.
std::function<void(Parts&)> text(const std::string& last) {
    return strings_and({last});
}

// One empty string, which is every name; no state. The section states `count` strings.
std::function<void(Parts&)> only_the_empty_string(std::uint32_t count) {
    return [=](Parts& p) {
        p[kStrs] = string_section({""});
        put_u32(p[kStrs], 0, count);
        p[kStat] = Bytes(8);
        put_u32(p[kStat], 4, POSEPACK_NONE);
        for (const std::size_t clip : {kIdle, kWalk}) {
            put_u32(p[kClip], clip + POSEPACK_CLIP_NAME, 0);
            put_u32(p[kClip], clip + POSEPACK_CLIP_SOURCE_NAME, 0);
        }
        for (std::size_t bone = 0; bone < kTinyBoneCount; ++bone) {
            put_u32(p[kBone], POSEPACK_BONE_HEAD_BYTES + bone * POSEPACK_BONE_RECORD_BYTES, 0);
        }
        put_u32(p[kSpac], kMesh0 + POSEPACK_MESH_NAME, 0);
        put_u32(p[kSpac], kMesh1 + POSEPACK_MESH_NAME, 0);
    };
}

TEST(Rules, Strings) {
    run({
        {"S1", "four bytes", [](Parts& p) { p[kStrs].resize(4); }},
        {"S1", "a count past the section", u32(kStrs, 0, 0xFFFFFFFF)},
        {"S1", "a count above the room there is", only_the_empty_string(2)},
        {"S2", "the first offset is 4", u32(kStrs, 4, 4)},
        {"S2", "an offset past the end", u32(kStrs, 16, 0x7FFFFFFF)},
        {"S2", "an offset that falls", u32(kStrs, 20, 1)},
        {"S2", "bytes behind the last string", resize(kStrs, 1)},
        {"S3", "not sorted", strings_and({"zz", "zy"})},
        {"S3", "twice the same", strings_and({"walk"})},
        {"S3", "the empty string twice",
         [](Parts& p) {
             std::vector<std::string> list = tiny_strings();
             list.insert(list.begin(), "");
             p[kStrs] = string_section(list);
         }},
        {"S3", "a prefix behind the longer string", strings_and({"zzz", "zz"})},
        {"S3", "sorted by signed bytes", strings_and({"z\xC3\xA9", "zz"})},
        {"S4", "256 bytes", text(std::string(256, 'z'))},
        {"S5", "a lone continuation byte", text("zz\x80")},
        {"S5", "a continuation byte as the first of two", text("zz\xBF\x80")},
        {"S5", "a lead byte at the end", text("zz\xC3")},
        {"S5", "a lead byte before a letter", text("zz\xC3z")},
        {"S5", "three bytes cut to two", text("zz\xE2\x82")},
        {"S5", "overlong two bytes", text("zz\xC1\xBF")},
        {"S5", "overlong three bytes", text("zz\xE0\x9F\xBF")},
        {"S5", "overlong four bytes", text("zz\xF0\x8F\xBF\xBF")},
        {"S5", "a surrogate", text("zz\xED\xA0\x80")},
        {"S5", "the last surrogate", text("zz\xED\xBF\xBF")},
        {"S5", "above U+10FFFF", text("zz\xF4\x90\x80\x80")},
        {"S5", "a lead byte above F4", text("zz\xF8\x90\x80\x80")},
        {"S5", "a lead byte of five", text("zz\xF8\x88\x80\x80\x80")},
        {"S6", "a tab", text("zz\t")},
        {"S6", "a zero byte", text(std::string("zz\0", 3))},
        {"S6", "delete", text("zz\x7F")},
        {"S6", "C1 control U+0085", text("zz\xC2\x85")},
    });
}

TEST(Rules, StringsThatAreGood) {
    run({
        {"S1", "one string", only_the_empty_string(1), POSEPACK_OK},
        {"S3", "by unsigned bytes", strings_and({"zz", "z\xC3\xA9"}), POSEPACK_OK},
        {"S4", "255 bytes", text(std::string(255, 'z')), POSEPACK_OK},
        {"S5", "the edges of two, three and four bytes",
         text("zz\xC2\xA0\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xEE\x80\x80\xEF\xBF\xBF\xF0\x90\x80\x80\xF4\x8F\xBF"
              "\xBF"),
         POSEPACK_OK},
        {"S6", "space and tilde", text("zz ~"), POSEPACK_OK},
    });
}

TEST(Rules, Bones) {
    constexpr std::size_t kBone0 = POSEPACK_BONE_HEAD_BYTES;
    constexpr std::size_t kBone1 = kBone0 + POSEPACK_BONE_RECORD_BYTES;
    constexpr std::size_t kJoints = kBone0 + 3 * POSEPACK_BONE_RECORD_BYTES;
    run({
        {"B1", "shorter than its records", resize(kBone, -16)},
        {"B1", "count", u32(kBone, POSEPACK_BONE_HEAD_COUNT, 2)},
        {"B1", "record size", u32(kBone, POSEPACK_BONE_HEAD_RECORD_BYTES, 20)},
        {"B1", "reserved word", u32(kBone, POSEPACK_BONE_HEAD_RESERVED, 1)},
        {"B2", "a joint map past the section", u32(kBone, POSEPACK_BONE_HEAD_JOINT_MAP_COUNT, 7)},
        {"B2", "a joint map of 2^32 - 1", u32(kBone, POSEPACK_BONE_HEAD_JOINT_MAP_COUNT, 0xFFFFFFFF)},
        {"B2", "a joint map shorter than the section", u32(kBone, POSEPACK_BONE_HEAD_JOINT_MAP_COUNT, 4)},
        {"B2", "four bytes more", resize(kBone, 4)},
        {"B3", "a joint of no bone", u16(kBone, kJoints + 4, 3)},
        {"B4", "name", u32(kBone, kBone1 + POSEPACK_BONE_NAME, 11)},
        {"B4", "no name", u32(kBone, kBone1 + POSEPACK_BONE_NAME, POSEPACK_NONE)},
        {"B5", "a parent of no bone", u32(kBone, kBone1 + POSEPACK_BONE_PARENT, 3)},
        {"B5", "P28 its own parent", u32(kBone, kBone1 + POSEPACK_BONE_PARENT, 1)},
        {"B5", "three parents in a circle", u32(kBone, kBone0 + POSEPACK_BONE_PARENT, 1)},
        {"B6", "an unknown flag", u32(kBone, kBone1 + POSEPACK_BONE_FLAGS, 2)},
        {"B7", "fill behind an odd joint map", u16(kBone, kJoints + 10, 0x100), POSEPACK_ERROR_PADDING},
    });
}

TEST(Rules, Space) {
    run({
        {"M1", "shorter than its head", [](Parts& p) { p[kSpac].resize(60); }},
        {"M1", "shorter than its records", resize(kSpac, -4)},
        {"M1", "longer than its records", resize(kSpac, 4)},
        {"M1", "2^32 - 1 meshes", u32(kSpac, POSEPACK_SPAC_MESH_COUNT, 0xFFFFFFFF)},
        {"M1", "record size", u32(kSpac, POSEPACK_SPAC_RECORD_SIZE, 84)},
        {"M2", "model_from_palette", u32(kSpac, POSEPACK_SPAC_MODEL_FROM_PALETTE + 44, kNaN)},
        {"M3", "not the identity without the flag", header_u8(POSEPACK_HDR_SPACE_FLAGS, 0)},
        {"M4", "forward axis", u32(kSpac, POSEPACK_SPAC_FORWARD_AXIS, 4)},
        {"M5", "no metres", u32(kSpac, POSEPACK_SPAC_METRES_PER_UNIT, 0)},
        {"M5", "negative metres", u32(kSpac, POSEPACK_SPAC_METRES_PER_UNIT, kMinusOne)},
        {"M5", "infinite metres", u32(kSpac, POSEPACK_SPAC_METRES_PER_UNIT, kInfinity)},
        {"M6", "name", u32(kSpac, kMesh1 + POSEPACK_MESH_NAME, 11)},
        {"M7", "first joint behind the map", u32(kSpac, kMesh1 + POSEPACK_MESH_FIRST_JOINT, 6)},
        {"M7", "one joint too many", u32(kSpac, kMesh1 + POSEPACK_MESH_JOINT_COUNT, 3)},
        {"M7", "first + count wraps", u32(kSpac, kMesh1 + POSEPACK_MESH_JOINT_COUNT, 0xFFFFFFFE)},
        {"M8", "reserved word", u32(kSpac, kMesh0 + POSEPACK_MESH_RESERVED, 1)},
        {"M9", "palette_from_mesh", u32(kSpac, kMesh0 + POSEPACK_MESH_PALETTE_FROM_MESH, kInfinity)},
    });
}

TEST(Rules, SpaceWithoutTheFlagIsTheIdentity) {
    run({{"M3", "the identity",
          [](Parts& p) {
              p.header[POSEPACK_HDR_SPACE_FLAGS] = 0;
              for (std::size_t i = 0; i < 12; ++i) {
                  put_f32(p[kSpac], POSEPACK_SPAC_MODEL_FROM_PALETTE + 4 * i, i % 5 == 0 ? 1.f : 0.f);
              }
          },
          POSEPACK_OK},
         {"M7", "an empty range behind the last joint",
          [](Parts& p) {
              put_u32(p[kSpac], kMesh1 + POSEPACK_MESH_FIRST_JOINT, 5);
              put_u32(p[kSpac], kMesh1 + POSEPACK_MESH_JOINT_COUNT, 0);
          },
          POSEPACK_OK}});
}

TEST(Rules, ClipTableAndKinds) {
    run({
        {"C1", "shorter than its records", [](Parts& p) { p[kClip].resize(kCuts - 4); }},
        {"C1", "count", u32(kClip, POSEPACK_CLIP_HEAD_COUNT, 1)},
        {"C1", "record size", u32(kClip, POSEPACK_CLIP_HEAD_RECORD_BYTES, 196)},
        {"C1", "reserved word", u32(kClip, POSEPACK_CLIP_HEAD_RESERVED, 1)},
        {"C1", "one cut fewer than stored", u32(kClip, POSEPACK_CLIP_HEAD_CUT_COUNT, 0)},
        {"C1", "cuts past the section", u32(kClip, POSEPACK_CLIP_HEAD_CUT_COUNT, 0x40000001)},
        {"C1", "four bytes behind the cuts", resize(kClip, 4)},
        {"C2", "name", u32(kClip, kIdle + POSEPACK_CLIP_NAME, 11)},
        {"C2", "source name", u32(kClip, kIdle + POSEPACK_CLIP_SOURCE_NAME, POSEPACK_NONE)},
        {"C3", "encoding unlike the header's", u8(kClip, kWalk + POSEPACK_CLIP_ENCODING, 1)},
        {"C3", "texels unlike the header's", u8(kClip, kWalk + POSEPACK_CLIP_TEXELS_PER_BONE, 4)},
        {"C3", "row scheme unlike the header's", u8(kClip, kWalk + POSEPACK_CLIP_ROW_SCHEME, 1)},
        {"C4", "wrap", u8(kClip, kWalk + POSEPACK_CLIP_WRAP, 3)},
        {"C4", "seam", u8(kClip, kWalk + POSEPACK_CLIP_SEAM, 2)},
        {"C4", "interpolation", u8(kClip, kWalk + POSEPACK_CLIP_INTERPOLATION, 2)},
        {"C4", "flags", u8(kClip, kWalk + POSEPACK_CLIP_FLAGS, 3)},
        {"C5", "closing row", u8(kClip, kWalk + POSEPACK_CLIP_CLOSING_ROW, 1)},
        {"C5", "translation box", u32(kClip, kWalk + POSEPACK_CLIP_TRANSLATION_MAX + 8, kOne)},
        {"C5", "root motion", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_ROOT_MOTION, 0)},
        {"C5", "root motion count", u32(kClip, kWalk + POSEPACK_CLIP_ROOT_MOTION_COUNT, 1)},
        {"C5", "reserved word", u32(kClip, kWalk + POSEPACK_CLIP_RESERVED, 1)},
    });
}

TEST(Rules, ClipRowsAndCuts) {
    run({
        {"C6", "the first clip begins at row 1", u32(kClip, kIdle + POSEPACK_CLIP_FIRST_ROW, 1)},
        {"C6", "P26 row_count wraps",
         [](Parts& p) {
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_ROW, 4);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 0xFFFFFFFE);
         }},
        {"C6", "a gap between clips", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_ROW, 2)},
        {"C6", "no row", u32(kClip, kIdle + POSEPACK_CLIP_ROW_COUNT, 0)},
        {"C6", "a row too many", u32(kClip, kWalk + POSEPACK_CLIP_ROW_COUNT, 5)},
        {"C6", "a row of no clip", u32(kClip, kWalk + POSEPACK_CLIP_ROW_COUNT, 3)},
        {"C6", "a clip without rows before one with all",
         [](Parts& p) {
             put_u32(p[kClip], kIdle + POSEPACK_CLIP_ROW_COUNT, 0);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_RATE_HZ, 1.f);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_PERIOD_S, 1.f);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_ROW, 0);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_TEXEL, 0);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 5);
         }},
        {"C6", "the sum of all rows wraps to the right number",
         [](Parts& p) {
             put_u32(p[kClip], kIdle + POSEPACK_CLIP_ROW_COUNT, 0xFFFFFFFF);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_RATE_HZ, 1.f);
             put_f32(p[kClip], kIdle + POSEPACK_CLIP_PERIOD_S, 1.f);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_ROW, 0xFFFFFFFF);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_FIRST_TEXEL, 0xFFFFFFFFu * 9);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 6);
         }},
        {"C6", "first texel", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_TEXEL, 0)},
        {"C7", "first cut", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_CUT, 1)},
        {"C7", "a cut too many", u32(kClip, kWalk + POSEPACK_CLIP_CUT_COUNT, 2)},
        {"C7", "a cut of no clip", u32(kClip, kWalk + POSEPACK_CLIP_CUT_COUNT, 0)},
        {"C7", "cut count wraps", u32(kClip, kWalk + POSEPACK_CLIP_CUT_COUNT, 0xFFFFFFFF)},
        {"C7", "a cut at row_count", u32(kClip, kCuts, 4)},
        {"C7", "two cuts at one row",
         [](Parts& p) {
             put_u32(p[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 2);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 2);
             p[kClip].resize(kCuts + 8);
             put_u32(p[kClip], kCuts + 4, 2);
         }},
        {"C7", "two cuts that rise",
         [](Parts& p) {
             put_u32(p[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 2);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 2);
             p[kClip].resize(kCuts + 8);
             put_u32(p[kClip], kCuts + 4, 3);
         },
         POSEPACK_OK},
    });
}

TEST(Rules, ClipTimeAndBounds) {
    run({
        {"C8", "a rate for one row", u32(kClip, kIdle + POSEPACK_CLIP_RATE_HZ, kOne)},
        {"C8", "no rate for four rows", u32(kClip, kWalk + POSEPACK_CLIP_RATE_HZ, 0)},
        {"C8", "a negative rate", u32(kClip, kWalk + POSEPACK_CLIP_RATE_HZ, kMinusOne)},
        {"C8", "an infinite rate", u32(kClip, kWalk + POSEPACK_CLIP_RATE_HZ, kInfinity)},
        {"C8", "no period for four rows", u32(kClip, kWalk + POSEPACK_CLIP_PERIOD_S, 0)},
        {"C8", "a negative period", u32(kClip, kIdle + POSEPACK_CLIP_PERIOD_S, kMinusOne)},
        {"C9", "start", u32(kClip, kWalk + POSEPACK_CLIP_START_S, kNaN)},
        {"C9", "speed", u32(kClip, kWalk + POSEPACK_CLIP_SPEED_MPS, kInfinity)},
        {"C9", "negative speed", u32(kClip, kWalk + POSEPACK_CLIP_SPEED_MPS, kMinusOne)},
        {"C9", "stride phase", u32(kClip, kWalk + POSEPACK_CLIP_STRIDE_PHASE, kNaN)},
        {"C9", "seam gap", u32(kClip, kWalk + POSEPACK_CLIP_SEAM_GAP, kNaN)},
        {"C9", "negative seam gap", u32(kClip, kWalk + POSEPACK_CLIP_SEAM_GAP, kMinusOne)},
        {"C10", "box", u32(kClip, kWalk + POSEPACK_CLIP_BOX_MIN, kNaN)},
        {"C10", "box_min above box_max", u32(kClip, kWalk + POSEPACK_CLIP_BOX_MAX + 8, 0xC1000000u)},
        {"C10", "sphere centre", u32(kClip, kWalk + POSEPACK_CLIP_SPHERE_CENTER + 8, kInfinity)},
        {"C10", "sphere radius", u32(kClip, kWalk + POSEPACK_CLIP_SPHERE_RADIUS, kMinusOne)},
        {"C10", "infinite sphere", u32(kClip, kWalk + POSEPACK_CLIP_SPHERE_RADIUS, kInfinity)},
    });
}

TEST(Rules, ClipErrors) {
    for (const std::size_t error : {POSEPACK_CLIP_ERROR_MAX, POSEPACK_CLIP_NORMAL_MAX_DEG}) {
        const std::size_t at = kWalk + error;
        run({
            {"C11", "max", u32(kClip, at, kMinusOne)},
            {"C11", "p99.9", u32(kClip, at + 4, kNaN)},
            {"C11", "rms", u32(kClip, at + 8, kInfinity)},
            {"C11", "time", u32(kClip, at + 12, kNaN)},
            {"C11", "mesh", u32(kClip, at + 16, 2)},
            {"C11", "vertex", u32(kClip, at + 20, 40)},
            {"C11", "a vertex of no mesh", u32(kClip, at + 16, POSEPACK_NONE)},
            {"C11", "bone", u32(kClip, at + 24, 3)},
            {"C11", "the last vertex of the second mesh",
             [at](Parts& p) {
                 put_u32(p[kClip], at + 16, 1);
                 put_u32(p[kClip], at + 20, 11);
             },
             POSEPACK_OK},
            {"C11", "a worst place nobody found",
             [at](Parts& p) {
                 for (std::size_t i = 16; i < 28; i += 4) put_u32(p[kClip], at + i, POSEPACK_NONE);
             },
             POSEPACK_OK},
        });
        TinyOptions unmeasured;
        unmeasured.measured = false;
        run({{"C12", "an amount", u32(kClip, at + 8, kOne)},
             {"C12", "a time", u32(kClip, at + 12, kMinusZero)},
             {"C12", "a mesh", u32(kClip, at + 16, 0)},
             {"C12", "a vertex", u32(kClip, at + 20, 0)},
             {"C12", "a bone", u32(kClip, at + 24, 0)}},
            unmeasured);
    }
}

TEST(Rules, MeasuredFeatureBit) {
    TinyOptions unmeasured;
    unmeasured.measured = false;
    run({{"C13", "not all clips are measured",
          [](Parts& p) {
              const Parts other = make_parts({.measured = false});
              const Bytes& clips = other.sections[0].bytes;
              std::copy(clips.begin() + kIdle, clips.begin() + kWalk, p[kClip].begin() + kIdle);
          }},
         {"C13", "all clips are measured, the bit is clear", header_u32(POSEPACK_HDR_OPTIONAL_FEATURES, 0)}});
    run({{"C13", "no clip is measured, the bit is set",
          header_u32(POSEPACK_HDR_OPTIONAL_FEATURES, POSEPACK_OPTIONAL_ERROR_MEASURED)}},
        unmeasured);
}

TEST(Rules, States) {
    run({
        {"A1", "four bytes", [](Parts& p) { p[kStat].resize(4); }},
        {"A1", "longer than its records", resize(kStat, 8)},
        {"A1", "2^32 - 1 states", u32(kStat, 0, 0xFFFFFFFF)},
        {"A2", "the default state", u32(kStat, 4, 2)},
        {"A2", "no default state", u32(kStat, 4, POSEPACK_NONE), POSEPACK_OK},
        {"A3", "name", u32(kStat, 16, 11)},
        {"A3", "not sorted", u32(kStat, 16, 0)},
        {"A3", "twice the same", u32(kStat, 16, 8)},
        {"A4", "clip", u32(kStat, 20, 2)},
        {"A1", "no state at all",
         [](Parts& p) {
             p[kStat] = Bytes(8);
             put_u32(p[kStat], 4, POSEPACK_NONE);
         },
         POSEPACK_OK},
    });
}

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
