// SPDX-License-Identifier: MIT
// The rules about header values, strings, bones, spaces and meshes (H, S, B, M).
#include "rules.hpp"

namespace posepack::test {
namespace {

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
        {"B3", "a joint without a bone", u16(kBone, kJoints + 4, 0xFFFF), POSEPACK_OK},
        {"B3", "one below that", u16(kBone, kJoints + 4, 0xFFFE)},
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

}  // namespace
}  // namespace posepack::test
