// SPDX-License-Identifier: MIT
// Changes of one field of a container in pieces, and the places of the tiny container's records.
#pragma once

#include <functional>

#include "container_builder.hpp"

namespace posepack::test {

inline constexpr std::uint32_t kClip = POSEPACK_SECTION_CLIP;
inline constexpr std::uint32_t kStat = POSEPACK_SECTION_STAT;
inline constexpr std::uint32_t kBone = POSEPACK_SECTION_BONE;
inline constexpr std::uint32_t kSpac = POSEPACK_SECTION_SPAC;
inline constexpr std::uint32_t kStrs = POSEPACK_SECTION_STRS;
inline constexpr std::uint32_t kPixl = POSEPACK_SECTION_PIXL;
inline constexpr std::uint32_t kRuns = POSEPACK_SECTION_RUNS;
inline constexpr std::uint32_t kSlot = POSEPACK_SECTION_SLOT;
inline constexpr std::size_t kIdle = POSEPACK_CLIP_HEAD_BYTES;
inline constexpr std::size_t kWalk = kIdle + POSEPACK_CLIP_RECORD_BYTES;
inline constexpr std::size_t kCuts = kWalk + POSEPACK_CLIP_RECORD_BYTES;
inline constexpr std::size_t kMesh0 = POSEPACK_SPAC_HEAD_BYTES;
inline constexpr std::size_t kMesh1 = kMesh0 + POSEPACK_MESH_RECORD_BYTES;
inline constexpr std::uint32_t kNaN = 0x7FC00000u, kInfinity = 0x7F800000u, kMinusZero = 0x80000000u;
inline constexpr std::uint32_t kOne = 0x3F800000u, kMinusOne = 0xBF800000u;

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
