// SPDX-License-Identifier: MIT
// What the tests of the format's rules share: one change of a good container, and the answer it must get.
// Every container has right checksums. Rule numbers are those of docs/format/posepack-1.md; P and two digits
// number the list of bad containers that every release answers alike.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "container_builder.hpp"
#include "posepack/loader.h"

namespace posepack::test {

struct Case {
    const char* rule;
    const char* what;
    std::function<void(Parts&)> change;
    posepack_result expected = POSEPACK_ERROR_SEMANTIC;
};

inline constexpr std::uint32_t kClip = POSEPACK_SECTION_CLIP;
inline constexpr std::uint32_t kStat = POSEPACK_SECTION_STAT;
inline constexpr std::uint32_t kBone = POSEPACK_SECTION_BONE;
inline constexpr std::uint32_t kSpac = POSEPACK_SECTION_SPAC;
inline constexpr std::uint32_t kStrs = POSEPACK_SECTION_STRS;
inline constexpr std::uint32_t kPixl = POSEPACK_SECTION_PIXL;
inline constexpr std::size_t kIdle = POSEPACK_CLIP_HEAD_BYTES;
inline constexpr std::size_t kWalk = kIdle + POSEPACK_CLIP_RECORD_BYTES;
inline constexpr std::size_t kCuts = kWalk + POSEPACK_CLIP_RECORD_BYTES;
inline constexpr std::size_t kMesh0 = POSEPACK_SPAC_HEAD_BYTES;
inline constexpr std::size_t kMesh1 = kMesh0 + POSEPACK_MESH_RECORD_BYTES;
inline constexpr std::uint32_t kNaN = 0x7FC00000u, kInfinity = 0x7F800000u, kMinusZero = 0x80000000u;
inline constexpr std::uint32_t kOne = 0x3F800000u, kMinusOne = 0xBF800000u;

inline std::string open_name(const Bytes& bytes) {
    posepack_view view;
    return posepack_result_name(posepack_open(&view, bytes.data(), bytes.size()));
}

inline void run(const std::vector<Case>& cases, const TinyOptions& options = {}) {
    ASSERT_EQ(open_name(make_container(options)), "OK");
    for (const Case& test : cases) {
        Parts parts = make_parts(options);
        test.change(parts);
        EXPECT_EQ(open_name(assemble(parts)), posepack_result_name(test.expected))
            << test.rule << ": " << test.what;
    }
}

// Changes of one field of the header or of a section.
inline std::function<void(Parts&)> header_u8(std::size_t offset, std::uint8_t value) {
    return [=](Parts& p) { p.header.at(offset) = value; };
}
inline std::function<void(Parts&)> header_u32(std::size_t offset, std::uint32_t value) {
    return [=](Parts& p) { put_u32(p.header, offset, value); };
}
inline std::function<void(Parts&)> u8(std::uint32_t type, std::size_t offset, std::uint8_t value) {
    return [=](Parts& p) { p[type].at(offset) = value; };
}
inline std::function<void(Parts&)> u16(std::uint32_t type, std::size_t offset, std::uint16_t value) {
    return [=](Parts& p) { put_u16(p[type], offset, value); };
}
inline std::function<void(Parts&)> u32(std::uint32_t type, std::size_t offset, std::uint32_t value) {
    return [=](Parts& p) { put_u32(p[type], offset, value); };
}
inline std::function<void(Parts&)> resize(std::uint32_t type, int more) {
    return [=](Parts& p) { p[type].resize(p[type].size() + static_cast<std::size_t>(more)); };
}

}  // namespace posepack::test
