// SPDX-License-Identifier: MIT
#include "palette/container_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "format/bytes.h"
#include "format/crc32c.h"
#include "format/texels.h"
#include "palette/byte_writer.hpp"
#include "posepack/format.h"

namespace posepack::palette {
namespace {

using animal::Animal;
using animal::kNone;

static_assert(kNone == POSEPACK_NONE);

// All strings of a container, sorted by bytes; a string is named by its place.
class StringTable {
 public:
    void add(const std::string& text) { strings_.insert(text); }
    void number() {
        std::uint32_t next = 0;
        for (const std::string& text : strings_) index_[text] = next++;
    }
    std::uint32_t at(const std::string& text) const { return index_.at(text); }

    std::vector<std::uint8_t> section() const {
        ByteWriter out;
        out.u32(static_cast<std::uint32_t>(strings_.size()));
        std::uint32_t offset = 0;
        for (const std::string& text : strings_) {
            out.u32(offset);
            offset += static_cast<std::uint32_t>(text.size());
        }
        out.u32(offset);
        for (const std::string& text : strings_)
            out.append({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        return out.take();
    }

 private:
    std::set<std::string> strings_;
    std::map<std::string, std::uint32_t> index_;
};

StringTable collect_strings(const Animal& animal, const Palette& palette) {
    StringTable strings;
    for (const PaletteClip& clip : palette.clips) {
        strings.add(animal.clips[clip.source].name);
        strings.add(animal.clips[clip.source].source_name);
    }
    for (const PaletteState& state : palette.states) strings.add(state.name);
    for (const animal::Bone& bone : animal.bones) strings.add(bone.name);
    for (const animal::Mesh& mesh : animal.meshes) strings.add(mesh.name);
    strings.number();
    return strings;
}

void write_error(ByteWriter& out, const ClipError& error) {
    out.f32(error.max);
    out.f32(error.p999);
    out.f32(error.rms);
    out.f32(error.time_s);
    out.u32(error.mesh);
    out.u32(error.vertex);
    out.u32(error.bone);
    out.f32(error.normal_max_deg);
    out.f32(error.normal_p999_deg);
    out.f32(error.normal_rms_deg);
    out.f32(error.normal_time_s);
    out.u32(error.normal_mesh);
    out.u32(error.normal_vertex);
    out.u32(error.normal_bone);
}

std::uint32_t wrap_value(recipe::Wrap wrap) {
    switch (wrap) {
        case recipe::Wrap::loop:
            return POSEPACK_WRAP_LOOP;
        case recipe::Wrap::ping_pong:
            return POSEPACK_WRAP_PING_PONG;
        default:
            return POSEPACK_WRAP_ONCE;
    }
}

// Floats that bound the box and its sphere from outside.
void write_bounds(ByteWriter& out, const Box& box) {
    std::array<float, 3> low{};
    std::array<float, 3> high{};
    for (std::size_t c = 0; c < 3 && !box.is_empty(); ++c) {
        low[c] = std::nextafter(static_cast<float>(box.low[c]), -HUGE_VALF);
        high[c] = std::nextafter(static_cast<float>(box.high[c]), HUGE_VALF);
    }
    for (const float value : low) out.f32(value);
    for (const float value : high) out.f32(value);
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto center = static_cast<float>(0.5 * (static_cast<double>(low[c]) + high[c]));
        const double reach =
            std::max(static_cast<double>(high[c]) - center, static_cast<double>(center) - low[c]);
        square += reach * reach;
        out.f32(center);
    }
    out.f32(std::nextafter(static_cast<float>(std::sqrt(square)), HUGE_VALF));
}

// What the row scheme says of a clip.
struct ClipRows {
    std::uint8_t encoding, row_scheme;
    std::uint32_t row_count;
    double rate_hz;
};

ClipRows rows_of(const Palette& palette, const PaletteClip& clip) {
    if (clip.runs.is_empty())
        return {palette.layout.encoding, POSEPACK_ROWS_UNIFORM, clip.plan.row_count, clip.plan.rate_hz};
    const std::uint8_t scheme = clip.runs.slots.empty() ? POSEPACK_ROWS_RUNS : POSEPACK_ROWS_SLOTS;
    return {clip.runs.encoding, scheme, clip.stored_rows(), clip.runs_rate_hz()};
}

void write_clip(ByteWriter& out, const Animal& animal, const Palette& palette, const PaletteClip& clip,
                std::uint32_t first_texel, const StringTable& strings) {
    const motion::RowPlan& plan = clip.plan;
    const ClipRows rows = rows_of(palette, clip);
    const std::size_t begin = out.size();
    out.u32(strings.at(animal.clips[clip.source].name));
    out.u32(strings.at(animal.clips[clip.source].source_name));
    out.u8(rows.encoding);
    out.u8(posepack_encoding_texels(rows.encoding));
    out.u8(rows.row_scheme);
    out.u8(wrap_value(plan.wrap));
    out.u8(plan.seam == recipe::Seam::open ? POSEPACK_SEAM_OPEN : POSEPACK_SEAM_CLOSED);
    out.u8(clip.closing_row ? 1 : 0);
    out.u8(plan.step ? POSEPACK_INTERPOLATION_STEP : POSEPACK_INTERPOLATION_LINEAR);
    out.u8(0);  // not measured yet
    out.u32(clip.first_row);
    out.u32(rows.row_count);
    out.u32(first_texel);
    out.u32(0);  // first cut
    out.u32(0);  // cut count
    out.f32(static_cast<float>(rows.rate_hz));
    out.f32(plan.row_count == 1 ? 0.0f : static_cast<float>(plan.period_s));
    out.f32(static_cast<float>(animal.clips[clip.source].start_s));
    out.f32(static_cast<float>(clip.speed_mps));
    out.f32(static_cast<float>(clip.stride_phase));
    write_bounds(out, clip.bounds);
    out.zeros(POSEPACK_CLIP_ERROR_MAX - POSEPACK_CLIP_TRANSLATION_MIN);  // the box of `packed` translations
    write_error(out, ClipError{});
    out.u32(POSEPACK_NONE);  // root motion track
    out.u32(0);
    out.f32(static_cast<float>(plan.seam_gap));
    out.zeros(begin + POSEPACK_CLIP_RECORD_BYTES - out.size());
}

std::vector<std::uint8_t> clip_section(const Animal& animal, const Palette& palette,
                                       const StringTable& strings) {
    ByteWriter out;
    out.u32(static_cast<std::uint32_t>(palette.clips.size()));
    out.u32(POSEPACK_CLIP_RECORD_BYTES);
    out.u32(0);
    out.u32(0);
    std::size_t run_texels = 0;
    for (const PaletteClip& clip : palette.clips) {
        const std::size_t first_texel =
            clip.runs.is_empty()
                ? std::size_t{clip.first_row} * palette.layout.bone_count * palette.layout.texels_per_bone
                : run_texels;
        write_clip(out, animal, palette, clip, static_cast<std::uint32_t>(first_texel), strings);
        run_texels += clip.runs.texels.size() / palette.layout.texel_bytes;
    }
    return out.take();
}

std::vector<std::uint8_t> runs_section(const Palette& palette) {
    ByteWriter out;
    for (const PaletteClip& clip : palette.clips)
        for (const std::uint32_t entry : clip.runs.entries) out.u32(entry);
    return out.take();
}

std::vector<std::uint8_t> slots_section(const Palette& palette) {
    ByteWriter out;
    std::size_t first = 0;
    for (const PaletteClip& clip : palette.clips) {
        out.u32(static_cast<std::uint32_t>(first));
        out.u32(static_cast<std::uint32_t>(clip.runs.slots.size()));
        first += clip.runs.slots.size();
    }
    for (const PaletteClip& clip : palette.clips)
        for (const std::uint32_t slot : clip.runs.slots) out.u32(slot);
    return out.take();
}

// Texels of all runs, then their last bone-row again up to the end of the texture.
std::vector<std::uint8_t> run_pixels(const Palette& palette) {
    std::vector<std::uint8_t> pixels;
    pixels.reserve(static_cast<std::size_t>(palette.layout.pixel_bytes()));
    for (const PaletteClip& clip : palette.clips)
        pixels.insert(pixels.end(), clip.runs.texels.begin(), clip.runs.texels.end());
    const std::size_t row_bytes = std::size_t{posepack_encoding_texels(palette.clips.back().runs.encoding)} *
                                  palette.layout.texel_bytes;
    while (pixels.size() < palette.layout.pixel_bytes()) pixels.push_back(pixels[pixels.size() - row_bytes]);
    return pixels;
}

std::vector<std::uint8_t> state_section(const Palette& palette, const StringTable& strings) {
    ByteWriter out;
    out.u32(static_cast<std::uint32_t>(palette.states.size()));
    out.u32(palette.default_state);
    for (const PaletteState& state : palette.states) {
        out.u32(strings.at(state.name));
        out.u32(state.clip);
    }
    return out.take();
}

std::vector<std::uint8_t> bone_section(const Animal& animal, const StringTable& strings) {
    ByteWriter out;
    out.u32(static_cast<std::uint32_t>(animal.bones.size()));
    out.u32(POSEPACK_BONE_RECORD_BYTES);
    out.u32(static_cast<std::uint32_t>(animal.joint_map.size()));
    out.u32(0);
    for (const animal::Bone& bone : animal.bones) {
        out.u32(strings.at(bone.name));
        out.u32(bone.parent);
        out.u32(bone.weighted ? POSEPACK_BONE_FLAG_WEIGHTED : 0);
        out.u32(bone.node);
    }
    for (const std::uint16_t bone : animal.joint_map) out.u16(bone);
    out.align(4);
    return out.take();
}

void write_affine(ByteWriter& out, const motion::Affine& map) {
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) out.f32(static_cast<float>(map.linear[c][r]));
        out.f32(static_cast<float>(map.translation[r]));
    }
}

std::vector<std::uint8_t> space_section(const Animal& animal, const Palette& palette,
                                        const StringTable& strings) {
    ByteWriter out;
    write_affine(out, palette.spaces.model_from_palette);
    out.u32(static_cast<std::uint32_t>(palette.forward));
    out.f32(static_cast<float>(palette.metres_per_unit));
    out.u32(static_cast<std::uint32_t>(animal.meshes.size()));
    out.u32(POSEPACK_MESH_RECORD_BYTES);
    for (std::size_t m = 0; m < animal.meshes.size(); ++m) {
        const animal::Mesh& mesh = animal.meshes[m];
        out.u32(strings.at(mesh.name));
        out.u32(mesh.node);
        out.u32(mesh.mesh);
        out.u32(mesh.skin);
        out.u32(mesh.first_joint);
        out.u32(mesh.joint_count);
        out.u32(mesh.vertex_count);
        out.u32(0);
        write_affine(out, palette.spaces.mesh_entry(m));
    }
    return out.take();
}
static_assert(static_cast<std::uint32_t>(recipe::ForwardAxis::plus_z) == POSEPACK_FORWARD_PLUS_Z);
static_assert(static_cast<std::uint32_t>(recipe::ForwardAxis::minus_z) == POSEPACK_FORWARD_MINUS_Z);
static_assert(static_cast<std::uint32_t>(recipe::ForwardAxis::plus_x) == POSEPACK_FORWARD_PLUS_X);
static_assert(static_cast<std::uint32_t>(recipe::ForwardAxis::minus_x) == POSEPACK_FORWARD_MINUS_X);

struct Section {
    std::uint32_t type;
    std::uint32_t align_log2;
    std::span<const std::uint8_t> bytes;
};

void write_header(ByteWriter& out, const Palette& palette, std::uint32_t section_count,
                  const base::Sha256& recipe) {
    const Layout& layout = palette.layout;
    constexpr std::uint8_t kMagic[8] = POSEPACK_MAGIC_BYTES;
    out.append(kMagic);
    out.u16(POSEPACK_FORMAT_MAJOR);
    out.u16(POSEPACK_FORMAT_MINOR);
    out.u32(POSEPACK_HEADER_BYTES);
    out.u64(0);  // file_bytes: known at the end
    out.u32(section_count);
    out.u32(POSEPACK_HEADER_BYTES);
    out.u32(0);  // required features
    out.u32(0);  // optional features: errors are not measured yet
    out.u32(layout.bone_count);
    out.u32(layout.row_count);
    out.u32(static_cast<std::uint32_t>(palette.clips.size()));
    out.u8(layout.encoding);
    out.u8(layout.texel_format);
    out.u8(layout.texels_per_bone);
    out.u8(layout.texel_order);
    out.u8(palette.has_runs() ? POSEPACK_ROWS_RUNS : POSEPACK_ROWS_UNIFORM);
    out.u8(palette.spaces.normalised ? POSEPACK_SPACE_NORMALISED : 0);
    out.u16(0);
    out.u32(layout.texture_width);
    out.u32(layout.texture_height);
    out.u32(layout.row_pitch_bytes);
    out.u32(layout.rows_per_line);
    out.f32(static_cast<float>(palette.radius * palette.metres_per_unit));
    out.f32(palette.dualquat_length);
    out.u32(POSEPACK_BAKE_ABI);
    out.append(recipe);
    out.u32(0);  // table CRC
    out.u32(0);  // header CRC
}

void seal(std::span<std::uint8_t> file) {
    const std::uint32_t count = posepack_read_u32(&file[POSEPACK_HDR_SECTION_COUNT]);
    const std::uint8_t* table = &file[POSEPACK_HEADER_BYTES];
    posepack_write_u32(&file[POSEPACK_HDR_TABLE_CRC],
                       posepack_crc32c(0, table, std::size_t{count} * POSEPACK_ENTRY_BYTES));
    posepack_write_u32(&file[POSEPACK_HDR_HEADER_CRC],
                       posepack_crc32c(0, file.data(), POSEPACK_HDR_HEADER_CRC));
}

}  // namespace

std::vector<std::uint8_t> write_container(const Animal& animal, const Palette& palette,
                                          std::string_view provenance) {
    const StringTable strings = collect_strings(animal, palette);
    const auto clips = clip_section(animal, palette, strings);
    const auto states = state_section(palette, strings);
    const auto bones = bone_section(animal, strings);
    const auto space = space_section(animal, palette, strings);
    const auto texts = strings.section();
    const std::span recipe(reinterpret_cast<const std::uint8_t*>(provenance.data()), provenance.size());
    const auto runs = runs_section(palette);
    const auto pixels = palette.has_runs() ? run_pixels(palette) : std::vector<std::uint8_t>{};
    const std::span<const std::uint8_t> texels = palette.has_runs() ? pixels : palette.pixels;
    std::vector<Section> sections = {{POSEPACK_SECTION_CLIP, POSEPACK_TABLE_ALIGN_LOG2, clips},
                                     {POSEPACK_SECTION_STAT, POSEPACK_TABLE_ALIGN_LOG2, states},
                                     {POSEPACK_SECTION_BONE, POSEPACK_TABLE_ALIGN_LOG2, bones},
                                     {POSEPACK_SECTION_SPAC, POSEPACK_TABLE_ALIGN_LOG2, space},
                                     {POSEPACK_SECTION_STRS, POSEPACK_TABLE_ALIGN_LOG2, texts},
                                     {POSEPACK_SECTION_PIXL, POSEPACK_PIXL_ALIGN_LOG2, texels}};
    if (palette.has_runs()) sections.push_back({POSEPACK_SECTION_RUNS, POSEPACK_TABLE_ALIGN_LOG2, runs});
    const auto slots = slots_section(palette);
    if (palette.has_slots()) sections.push_back({POSEPACK_SECTION_SLOT, POSEPACK_TABLE_ALIGN_LOG2, slots});
    sections.push_back({POSEPACK_SECTION_PROV, POSEPACK_TABLE_ALIGN_LOG2, recipe});
    ByteWriter out;
    write_header(out, palette, static_cast<std::uint32_t>(std::size(sections)), base::sha256(recipe));
    std::size_t offset = POSEPACK_HEADER_BYTES + std::size(sections) * POSEPACK_ENTRY_BYTES;
    for (const Section& section : sections) {
        const std::size_t alignment = std::size_t{1} << section.align_log2;
        offset = (offset + alignment - 1) / alignment * alignment;
        const std::uint32_t crc = posepack_crc32c(0, section.bytes.data(), section.bytes.size());
        out.u32(section.type);
        out.u32(POSEPACK_CODEC_NONE);
        out.u64(offset);
        out.u64(section.bytes.size());
        out.u64(section.bytes.size());
        out.u32(section.align_log2);
        out.u32(crc);
        out.u32(crc);
        out.u32(0);
        offset += section.bytes.size();
    }
    out.reserve(offset);
    for (const Section& section : sections) {
        out.align(std::size_t{1} << section.align_log2);
        out.append(section.bytes);
    }
    posepack_write_u64(&out.bytes()[POSEPACK_HDR_FILE_BYTES], out.size());
    seal(out.bytes());
    return out.take();
}

void store_errors(std::span<std::uint8_t> file, std::span<const ClipError> errors) {
    std::uint8_t* entry = &file[POSEPACK_HEADER_BYTES];  // CLIP comes first
    const std::size_t offset = posepack_read_u64(entry + POSEPACK_ENT_OFFSET);
    const std::size_t size = posepack_read_u64(entry + POSEPACK_ENT_STORED_BYTES);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        std::uint8_t* record = &file[offset + POSEPACK_CLIP_HEAD_BYTES + i * POSEPACK_CLIP_RECORD_BYTES];
        ByteWriter fields;
        write_error(fields, errors[i]);
        std::copy_n(fields.bytes().begin(), fields.size(), record + POSEPACK_CLIP_ERROR_MAX);
        record[POSEPACK_CLIP_FLAGS] |= POSEPACK_CLIP_FLAG_MEASURED;
    }
    const std::uint32_t crc = posepack_crc32c(0, &file[offset], size);
    posepack_write_u32(entry + POSEPACK_ENT_CRC, crc);
    posepack_write_u32(entry + POSEPACK_ENT_RAW_CRC, crc);
    posepack_write_u32(&file[POSEPACK_HDR_OPTIONAL_FEATURES], POSEPACK_OPTIONAL_ERROR_MEASURED);
    seal(file);
}

}  // namespace posepack::palette
