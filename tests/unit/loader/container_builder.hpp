// SPDX-License-Identifier: MIT
// A tiny valid container made by hand, and the means to break it.
//
// The builder knows the byte layout of include/posepack/format.h and nothing of the compiler or the loader. A
// test changes `Parts` and assembles them, or changes the assembled bytes and seals them again: every
// checksum is then right, so that the loader must find the fault by its rules.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "posepack/format.h"

namespace posepack::test {

using Bytes = std::vector<std::uint8_t>;

/// What make_parts builds. Every combination is valid.
struct TinyOptions {
    std::uint8_t encoding = POSEPACK_ENCODING_AFFINE;
    std::uint8_t texel_format = POSEPACK_TEXEL_RGBA16F;
    std::uint8_t texel_order = POSEPACK_ORDER_BONE_MAJOR;
    std::uint32_t rows_per_line = 1;
    bool pad_pitch = false;    // round the pitch up to 256 bytes
    bool measured = true;      // clips carry measured errors
    bool closing_row = false;  // dualquat alone: the last of walk's four rows closes it, bone 1 turned
};

/// One section before it has a place. `raw_bytes` 0 means: as many as are stored.
struct Section {
    std::uint32_t type = 0;
    Bytes bytes;
    std::uint32_t flags = 0;
    std::uint32_t align_log2 = POSEPACK_TABLE_ALIGN_LOG2;
    std::uint64_t raw_bytes = 0;
};

/// A container in pieces; `header` is 128 bytes whose sizes and checksums assemble() fills in.
struct Parts {
    Bytes header;
    std::vector<Section> sections;

    /// Bytes of the section of a type, which must be there.
    Bytes& operator[](std::uint32_t type);

    /// Moves the section of a type behind all others, so that its last byte is the file's.
    void move_to_end(std::uint32_t type);
};

inline constexpr std::uint32_t kTinyBoneCount = 3;
inline constexpr std::uint32_t kTinyRowCount = 5;

/// Three bones ("root", "tail" under "leg", "leg" under "root"), two clips ("idle" of one row, "walk" of four
/// with a cut at its row 2), two states, two meshes over a joint map of five.
Parts make_parts(const TinyOptions& options = {});

/// Element `element` (0..11, row-major 3x4) of the matrix of a bone in a row; exact as a half.
float tiny_element(std::uint32_t row, std::uint32_t bone, std::uint32_t element);

/// Number `number` (0..7: real part, dual part) of a bone of a dualquat in a row; exact as a half. No unit
/// length.
float tiny_dualquat(std::uint32_t row, std::uint32_t bone, std::uint32_t number);
inline constexpr float kTinyDualquatLength = 2.0f;

/// Lays the sections out by the law of no holes, writes the table and seals.
Bytes assemble(const Parts& parts);

/// assemble(make_parts(options)).
Bytes make_container(const TinyOptions& options = {});

/// Recomputes section, table and header checksums from the bytes as they stand; what leaves the file is left.
void seal(Bytes& bytes);

/// Recomputes table and header checksums, and leaves what the entries say of their sections.
void seal_table(Bytes& bytes);

/// Recomputes the header checksum only.
void seal_header(Bytes& bytes);

/// Offset in the file of the table entry of a section, which must be there.
std::size_t entry_offset(const Bytes& bytes, std::uint32_t type);

/// Offset in the file of the first byte of a section, which must be there.
std::size_t section_offset(const Bytes& bytes, std::uint32_t type);

/// The strings of the tiny container: sorted by bytes, the empty one first.
const std::vector<std::string>& tiny_strings();

/// An STRS section of these strings, in this order, right or wrong.
Bytes string_section(const std::vector<std::string>& strings);

void put_u16(Bytes& bytes, std::size_t offset, std::uint16_t value);
void put_u32(Bytes& bytes, std::size_t offset, std::uint32_t value);
void put_u64(Bytes& bytes, std::size_t offset, std::uint64_t value);
void put_f32(Bytes& bytes, std::size_t offset, float value);
std::uint32_t get_u32(const Bytes& bytes, std::size_t offset);
std::uint64_t get_u64(const Bytes& bytes, std::size_t offset);

}  // namespace posepack::test
