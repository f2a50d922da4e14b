// SPDX-License-Identifier: MIT
#include "container_builder.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "format/bytes.h"
#include "format/crc32c.h"
#include "format/half.h"

namespace posepack::test {
namespace {

// Sorted by bytes; the empty name of the second mesh comes first.
const std::vector<std::string> kStrings = {"",     "Armature|Walk", "Rig|Idle", "body", "idle", "leg",
                                           "root", "rosé",          "stand",    "tail", "walk"};

std::uint32_t string_index(const std::string& text) {
    return static_cast<std::uint32_t>(std::find(kStrings.begin(), kStrings.end(), text) - kStrings.begin());
}

void append_u16(Bytes& bytes, std::uint16_t value) {
    bytes.resize(bytes.size() + 2);
    put_u16(bytes, bytes.size() - 2, value);
}

void append_u32(Bytes& bytes, std::uint32_t value) {
    bytes.resize(bytes.size() + 4);
    put_u32(bytes, bytes.size() - 4, value);
}

void append_f32(Bytes& bytes, float value) {
    append_u32(bytes, posepack_bits_from_float(value));
}

// A row-major 3x4 translation.
void append_translation(Bytes& bytes, float x, float y, float z) {
    for (float value : {1.f, 0.f, 0.f, x, 0.f, 1.f, 0.f, y, 0.f, 0.f, 1.f, z}) append_f32(bytes, value);
}

std::uint32_t texels_per_bone(const TinyOptions& options) {
    if (options.encoding == POSEPACK_ENCODING_DUALQUAT) return 2;
    return options.encoding == POSEPACK_ENCODING_MAT4 ? 4 : 3;
}

std::uint32_t texel_bytes(const TinyOptions& options) {
    return options.texel_format == POSEPACK_TEXEL_RGBA32F ? 16 : 8;
}

std::uint32_t row_pitch(const TinyOptions& options) {
    const std::uint32_t tight =
        options.rows_per_line * kTinyBoneCount * texels_per_bone(options) * texel_bytes(options);
    return options.pad_pitch ? (tight + 255) / 256 * 256 : tight;
}

std::uint32_t line_count(const TinyOptions& options) {
    return (kTinyRowCount + options.rows_per_line - 1) / options.rows_per_line;
}

Bytes make_header(const TinyOptions& options) {
    constexpr std::array<std::uint8_t, 8> kMagic = POSEPACK_MAGIC_BYTES;
    Bytes header(POSEPACK_HEADER_BYTES);
    std::copy(kMagic.begin(), kMagic.end(), header.begin());
    put_u16(header, POSEPACK_HDR_MAJOR, POSEPACK_FORMAT_MAJOR);
    put_u16(header, POSEPACK_HDR_MINOR, POSEPACK_FORMAT_MINOR);
    put_u32(header, POSEPACK_HDR_HEADER_BYTES, POSEPACK_HEADER_BYTES);
    put_u32(header, POSEPACK_HDR_TABLE_OFFSET, POSEPACK_HEADER_BYTES);
    put_u32(header, POSEPACK_HDR_OPTIONAL_FEATURES, options.measured ? POSEPACK_OPTIONAL_ERROR_MEASURED : 0);
    put_u32(header, POSEPACK_HDR_BONE_COUNT, kTinyBoneCount);
    put_u32(header, POSEPACK_HDR_ROW_COUNT, kTinyRowCount);
    put_u32(header, POSEPACK_HDR_CLIP_COUNT, 2);
    header[POSEPACK_HDR_ENCODING] = options.encoding;
    header[POSEPACK_HDR_TEXEL_FORMAT] = options.texel_format;
    header[POSEPACK_HDR_TEXELS_PER_BONE] = static_cast<std::uint8_t>(texels_per_bone(options));
    header[POSEPACK_HDR_TEXEL_ORDER] = options.texel_order;
    header[POSEPACK_HDR_SPACE_FLAGS] = POSEPACK_SPACE_NORMALISED;
    put_u32(header, POSEPACK_HDR_TEXTURE_WIDTH,
            options.rows_per_line * kTinyBoneCount * texels_per_bone(options));
    put_u32(header, POSEPACK_HDR_TEXTURE_HEIGHT, line_count(options));
    put_u32(header, POSEPACK_HDR_ROW_PITCH, row_pitch(options));
    put_u32(header, POSEPACK_HDR_ROWS_PER_LINE, options.rows_per_line);
    put_f32(header, POSEPACK_HDR_RADIUS_M, 0.75f);
    if (options.encoding == POSEPACK_ENCODING_DUALQUAT)
        put_f32(header, POSEPACK_HDR_DUALQUAT_LENGTH, kTinyDualquatLength);
    put_u32(header, POSEPACK_HDR_BAKE_ABI, POSEPACK_BAKE_ABI);
    for (std::size_t i = 0; i < 32; ++i) {
        header[POSEPACK_HDR_RECIPE_SHA256 + i] = static_cast<std::uint8_t>(7 * i + 1);
    }
    return header;
}

void put_error(Bytes& clip, std::size_t offset, bool measured) {
    put_u32(clip, offset + 16, measured ? 0 : POSEPACK_NONE);
    put_u32(clip, offset + 20, measured ? 5 : POSEPACK_NONE);
    put_u32(clip, offset + 24, measured ? 1 : POSEPACK_NONE);
    if (!measured) return;
    const std::array<float, 4> values = {0.02f, 0.015f, 0.003f, 0.125f};  // max, p99.9, rms, time
    for (std::size_t i = 0; i < values.size(); ++i) put_f32(clip, offset + 4 * i, values[i]);
}

Bytes make_clip(const TinyOptions& options, const char* name, const char* source, std::uint32_t first_row,
                std::uint32_t row_count) {
    Bytes clip(POSEPACK_CLIP_RECORD_BYTES);
    put_u32(clip, POSEPACK_CLIP_NAME, string_index(name));
    put_u32(clip, POSEPACK_CLIP_SOURCE_NAME, string_index(source));
    clip[POSEPACK_CLIP_ENCODING] = options.encoding;
    clip[POSEPACK_CLIP_TEXELS_PER_BONE] = static_cast<std::uint8_t>(texels_per_bone(options));
    clip[POSEPACK_CLIP_WRAP] = row_count == 1 ? POSEPACK_WRAP_ONCE : POSEPACK_WRAP_LOOP;
    clip[POSEPACK_CLIP_SEAM] = POSEPACK_SEAM_CLOSED;
    clip[POSEPACK_CLIP_FLAGS] = options.measured ? POSEPACK_CLIP_FLAG_MEASURED : 0;
    put_u32(clip, POSEPACK_CLIP_FIRST_ROW, first_row);
    put_u32(clip, POSEPACK_CLIP_ROW_COUNT, row_count);
    put_u32(clip, POSEPACK_CLIP_FIRST_TEXEL, first_row * kTinyBoneCount * texels_per_bone(options));
    put_f32(clip, POSEPACK_CLIP_RATE_HZ, row_count == 1 ? 0.f : 24.f);
    put_f32(clip, POSEPACK_CLIP_PERIOD_S, row_count == 1 ? 0.f : static_cast<float>(row_count) / 24.f);
    put_f32(clip, POSEPACK_CLIP_START_S, 0.5f);
    put_f32(clip, POSEPACK_CLIP_SPEED_MPS, 1.25f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        put_f32(clip, POSEPACK_CLIP_BOX_MIN + 4 * axis, -1.5f - static_cast<float>(axis));
        put_f32(clip, POSEPACK_CLIP_BOX_MAX + 4 * axis, 1.f + static_cast<float>(axis));
        put_f32(clip, POSEPACK_CLIP_SPHERE_CENTER + 4 * axis, 0.125f * static_cast<float>(axis));
    }
    put_f32(clip, POSEPACK_CLIP_SPHERE_RADIUS, 2.f);
    put_error(clip, POSEPACK_CLIP_ERROR_MAX, options.measured);
    put_error(clip, POSEPACK_CLIP_NORMAL_MAX_DEG, options.measured);
    put_u32(clip, POSEPACK_CLIP_FIRST_ROOT_MOTION, POSEPACK_NONE);
    put_f32(clip, POSEPACK_CLIP_SEAM_GAP, 0.0005f);
    return clip;
}

Bytes make_clips(const TinyOptions& options) {
    Bytes idle = make_clip(options, "idle", "Rig|Idle", 0, 1);
    Bytes walk = make_clip(options, "walk", "Armature|Walk", 1, options.closing_row ? 3 : 4);
    walk[POSEPACK_CLIP_CLOSING_ROW] = options.closing_row ? 1 : 0;
    put_u32(walk, POSEPACK_CLIP_CUT_COUNT, 1);
    Bytes section;
    for (std::uint32_t value : {2u, POSEPACK_CLIP_RECORD_BYTES, 1u, 0u}) append_u32(section, value);
    section.insert(section.end(), idle.begin(), idle.end());
    section.insert(section.end(), walk.begin(), walk.end());
    append_u32(section, 2);
    return section;
}

Bytes make_states() {
    Bytes section;
    for (std::uint32_t value : {2u, 1u, string_index("stand"), 0u, string_index("walk"), 1u}) {
        append_u32(section, value);
    }
    return section;
}

Bytes make_bones() {
    Bytes section;
    for (std::uint32_t value : {kTinyBoneCount, POSEPACK_BONE_RECORD_BYTES, 5u, 0u})
        append_u32(section, value);
    for (std::uint32_t value : {string_index("root"), POSEPACK_NONE, 0u, 4u}) append_u32(section, value);
    for (std::uint32_t value : {string_index("tail"), 2u, POSEPACK_BONE_FLAG_WEIGHTED, 6u}) {
        append_u32(section, value);
    }
    for (std::uint32_t value : {string_index("leg"), 0u, POSEPACK_BONE_FLAG_WEIGHTED, 5u}) {
        append_u32(section, value);
    }
    for (std::uint16_t bone : {0, 1, 2, 2, 1}) append_u16(section, bone);
    append_u16(section, 0);
    return section;
}

Bytes make_space() {
    Bytes section;
    append_translation(section, 0.5f, 1.f, -0.25f);
    append_u32(section, POSEPACK_FORWARD_MINUS_Z);
    append_f32(section, 0.01f);
    append_u32(section, 2);
    append_u32(section, POSEPACK_MESH_RECORD_BYTES);
    for (std::uint32_t value : {string_index("body"), 8u, 0u, 0u, 0u, 3u, 40u, 0u})
        append_u32(section, value);
    append_translation(section, -0.5f, -1.f, 0.25f);
    for (std::uint32_t value : {string_index(""), 9u, 1u, 1u, 3u, 2u, 12u, 0u}) append_u32(section, value);
    append_translation(section, -0.5f, 3.f, 0.25f);
    return section;
}

// Component c of texel k of a bone: column k of a mat4, row k of an affine.
float texel_component(const TinyOptions& options, std::uint32_t row, std::uint32_t bone, std::uint32_t k,
                      std::uint32_t c) {
    if (options.encoding == POSEPACK_ENCODING_DUALQUAT) {
        const bool closes = options.closing_row && row + 1 == kTinyRowCount;
        const float number = tiny_dualquat(closes ? 1 : row, bone, 4 * k + c);
        return closes && bone == 1 ? -number : number;
    }
    if (options.encoding == POSEPACK_ENCODING_AFFINE) return tiny_element(row, bone, 4 * k + c);
    if (c == 3) return k == 3 ? 1.f : 0.f;
    return tiny_element(row, bone, 4 * c + k);
}

// Written from the addressing rules of the format, not through src/format/texels.c.
Bytes make_pixels(const TinyOptions& options) {
    const std::uint32_t texels = texels_per_bone(options);
    Bytes section(static_cast<std::size_t>(row_pitch(options)) * line_count(options));
    for (std::uint32_t place = 0; place < options.rows_per_line * line_count(options); ++place) {
        const std::uint32_t row = std::min(place, kTinyRowCount - 1);  // places left over repeat the last row
        for (std::uint32_t i = 0; i < kTinyBoneCount * texels * 4; ++i) {
            const std::uint32_t texel = i / 4;
            const bool planar = options.texel_order == POSEPACK_ORDER_PLANAR;
            const std::uint32_t bone = planar ? texel % kTinyBoneCount : texel / texels;
            const std::uint32_t k = planar ? texel / kTinyBoneCount : texel % texels;
            const float value = texel_component(options, row, bone, k, i % 4);
            const std::size_t line = place / options.rows_per_line * row_pitch(options);
            const std::size_t column =
                place % options.rows_per_line * kTinyBoneCount * texels * texel_bytes(options);
            const std::size_t offset = line + column + i * texel_bytes(options) / 4;
            if (options.texel_format == POSEPACK_TEXEL_RGBA32F) {
                put_f32(section, offset, value);
            } else {
                put_u16(section, offset, posepack_half_from_float(value));
            }
        }
    }
    return section;
}

}  // namespace

Bytes& Parts::operator[](std::uint32_t type) {
    for (Section& section : sections) {
        if (section.type == type) return section.bytes;
    }
    std::abort();  // a mistake in a test
}

void Parts::move_to_end(std::uint32_t type) {
    std::stable_partition(sections.begin(), sections.end(),
                          [type](const Section& section) { return section.type != type; });
}

const std::vector<std::string>& tiny_strings() {
    return kStrings;
}

float tiny_element(std::uint32_t row, std::uint32_t bone, std::uint32_t element) {
    return static_cast<float>((row * kTinyBoneCount + bone) * 12 + element) / 64.f - 1.f;
}

float tiny_dualquat(std::uint32_t row, std::uint32_t bone, std::uint32_t number) {
    const auto r = static_cast<float>(row);
    const auto b = static_cast<float>(bone);
    const std::array<float, 8> numbers = {0.25f * b,        -0.5f, 0.125f * r - 0.25f, 0.75f,
                                          0.5f - 0.25f * b, 0.0f,  1.5f + 0.25f * r,   -0.125f * r};
    return numbers.at(number);
}

Bytes string_section(const std::vector<std::string>& strings) {
    Bytes section;
    std::uint32_t end = 0;
    append_u32(section, static_cast<std::uint32_t>(strings.size()));
    append_u32(section, end);
    for (const std::string& text : strings) {
        end += static_cast<std::uint32_t>(text.size());
        append_u32(section, end);
    }
    for (const std::string& text : strings) section.insert(section.end(), text.begin(), text.end());
    return section;
}

Parts make_parts(const TinyOptions& options) {
    Parts parts;
    parts.header = make_header(options);
    parts.sections = {{POSEPACK_SECTION_CLIP, make_clips(options)},
                      {POSEPACK_SECTION_STAT, make_states()},
                      {POSEPACK_SECTION_BONE, make_bones()},
                      {POSEPACK_SECTION_SPAC, make_space()},
                      {POSEPACK_SECTION_STRS, string_section(kStrings)}};
    parts.sections.push_back(
        {POSEPACK_SECTION_PIXL, make_pixels(options), POSEPACK_CODEC_NONE, POSEPACK_PIXL_ALIGN_LOG2});
    return parts;
}

Bytes assemble(const Parts& parts) {
    const std::size_t count = parts.sections.size();
    Bytes bytes = parts.header;
    bytes.resize(POSEPACK_HEADER_BYTES + count * POSEPACK_ENTRY_BYTES);
    for (std::size_t i = 0; i < count; ++i) {
        const Section& section = parts.sections[i];
        const std::size_t align = std::size_t{1} << section.align_log2;
        const std::size_t offset = (bytes.size() + align - 1) / align * align;
        const std::size_t entry = POSEPACK_HEADER_BYTES + i * POSEPACK_ENTRY_BYTES;
        bytes.resize(offset);
        bytes.insert(bytes.end(), section.bytes.begin(), section.bytes.end());
        put_u32(bytes, entry + POSEPACK_ENT_TYPE, section.type);
        put_u32(bytes, entry + POSEPACK_ENT_FLAGS, section.flags);
        put_u64(bytes, entry + POSEPACK_ENT_OFFSET, offset);
        put_u64(bytes, entry + POSEPACK_ENT_STORED_BYTES, section.bytes.size());
        put_u64(bytes, entry + POSEPACK_ENT_RAW_BYTES,
                section.raw_bytes == 0 ? section.bytes.size() : section.raw_bytes);
        put_u32(bytes, entry + POSEPACK_ENT_ALIGN_LOG2, section.align_log2);
    }
    put_u32(bytes, POSEPACK_HDR_SECTION_COUNT, static_cast<std::uint32_t>(count));
    put_u64(bytes, POSEPACK_HDR_FILE_BYTES, bytes.size());
    seal(bytes);
    return bytes;
}

Bytes make_container(const TinyOptions& options) {
    return assemble(make_parts(options));
}

void seal_header(Bytes& bytes) {
    put_u32(bytes, POSEPACK_HDR_HEADER_CRC, posepack_crc32c_table(0, bytes.data(), POSEPACK_HDR_HEADER_CRC));
}

// Offsets of the table entries that lie in the file; none where the count is absurd.
static std::vector<std::size_t> entries(const Bytes& bytes) {
    std::vector<std::size_t> offsets;
    const std::size_t count = get_u32(bytes, POSEPACK_HDR_SECTION_COUNT);
    if (count > (bytes.size() - POSEPACK_HEADER_BYTES) / POSEPACK_ENTRY_BYTES) return offsets;
    for (std::size_t i = 0; i < count; ++i)
        offsets.push_back(POSEPACK_HEADER_BYTES + i * POSEPACK_ENTRY_BYTES);
    return offsets;
}

void seal_table(Bytes& bytes) {
    const std::size_t table_bytes = entries(bytes).size() * POSEPACK_ENTRY_BYTES;
    put_u32(bytes, POSEPACK_HDR_TABLE_CRC,
            posepack_crc32c_table(0, bytes.data() + POSEPACK_HEADER_BYTES, table_bytes));
    seal_header(bytes);
}

void seal(Bytes& bytes) {
    for (const std::size_t entry : entries(bytes)) {
        const std::uint64_t offset = get_u64(bytes, entry + POSEPACK_ENT_OFFSET);
        const std::uint64_t size = get_u64(bytes, entry + POSEPACK_ENT_STORED_BYTES);
        if (offset > bytes.size() || size > bytes.size() - offset) continue;
        const std::uint32_t crc = posepack_crc32c_table(0, bytes.data() + offset, size);
        put_u32(bytes, entry + POSEPACK_ENT_CRC, crc);
        put_u32(bytes, entry + POSEPACK_ENT_RAW_CRC, crc);
    }
    seal_table(bytes);
}

std::size_t entry_offset(const Bytes& bytes, std::uint32_t type) {
    for (std::uint32_t i = 0; i < get_u32(bytes, POSEPACK_HDR_SECTION_COUNT); ++i) {
        const std::size_t entry = POSEPACK_HEADER_BYTES + i * POSEPACK_ENTRY_BYTES;
        if (get_u32(bytes, entry + POSEPACK_ENT_TYPE) == type) return entry;
    }
    std::abort();  // a mistake in a test
}

std::size_t section_offset(const Bytes& bytes, std::uint32_t type) {
    return static_cast<std::size_t>(get_u64(bytes, entry_offset(bytes, type) + POSEPACK_ENT_OFFSET));
}

void put_u16(Bytes& bytes, std::size_t offset, std::uint16_t value) {
    posepack_write_u16(&bytes.at(offset), value);
}
void put_u32(Bytes& bytes, std::size_t offset, std::uint32_t value) {
    posepack_write_u32(&bytes.at(offset), value);
}
void put_u64(Bytes& bytes, std::size_t offset, std::uint64_t value) {
    posepack_write_u64(&bytes.at(offset), value);
}
void put_f32(Bytes& bytes, std::size_t offset, float value) {
    posepack_write_f32(&bytes.at(offset), value);
}
std::uint32_t get_u32(const Bytes& bytes, std::size_t offset) {
    return posepack_read_u32(&bytes.at(offset));
}
std::uint64_t get_u64(const Bytes& bytes, std::size_t offset) {
    return posepack_read_u64(&bytes.at(offset));
}

}  // namespace posepack::test
