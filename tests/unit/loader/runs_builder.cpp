// SPDX-License-Identifier: MIT
#include "runs_builder.hpp"

#include <algorithm>

#include "format/half.h"

namespace posepack::test {
namespace {

constexpr std::uint32_t kRowBones = kTinyBoneCount;

std::uint32_t offset_of(std::uint32_t run) {
    return run & POSEPACK_RUN_OFFSET_MASK;
}

std::uint32_t interval_count_of(std::uint32_t run) {
    return run >> POSEPACK_RUN_OFFSET_BITS;
}

std::uint32_t texels_of(std::uint8_t encoding) {
    if (encoding == POSEPACK_ENCODING_DUALQUAT) return 2;
    return encoding == POSEPACK_ENCODING_MAT4 ? 4 : 3;
}

std::uint32_t row_count(const RunClip& clip) {
    std::uint32_t longest = 0;
    for (const std::uint32_t run : clip.runs) longest = std::max(longest, interval_count_of(run));
    return longest + 1;
}

// Where the number of a bone-row comes from: the row itself, or the first of the loop that it closes.
struct Source {
    std::uint32_t bone_row;
    bool turned;
};

Source source_of(const RunClip& clip, std::uint32_t bone_row) {
    for (std::uint32_t bone = 0; bone < kRowBones && clip.wrap == POSEPACK_WRAP_LOOP; ++bone) {
        const std::uint32_t intervals = interval_count_of(clip.runs.at(bone));
        if (intervals > 0 && bone_row == offset_of(clip.runs.at(bone)) + intervals)
            return {offset_of(clip.runs.at(bone)), (clip.turned >> bone & 1) != 0};
    }
    return {bone_row, false};
}

// Component c of texel k.
float component(const RunClip& clip, std::uint32_t bone_row, std::uint32_t k, std::uint32_t c) {
    if (clip.encoding == POSEPACK_ENCODING_MAT4) {
        if (c == 3) return k == 3 ? 1.f : 0.f;
        return run_number(clip, bone_row, 4 * c + k);
    }
    return run_number(clip, bone_row, 4 * k + c);
}

void append_number(Bytes& bytes, std::uint8_t texel_format, float value) {
    const bool half = texel_format == POSEPACK_TEXEL_RGBA16F;
    bytes.resize(bytes.size() + (half ? 2 : 4));
    if (half)
        put_u16(bytes, bytes.size() - 2, posepack_half_from_float(value));
    else
        put_f32(bytes, bytes.size() - 4, value);
}

Bytes bone_rows(const RunClip& clip, std::uint8_t texel_format) {
    Bytes bytes;
    for (std::uint32_t row = 0; row < bone_row_count(clip); ++row) {
        const Source source = source_of(clip, row);
        for (std::uint32_t i = 0; i < 4 * texels_of(clip.encoding); ++i) {
            const float value = component(clip, source.bone_row, i / 4, i % 4);
            append_number(bytes, texel_format, source.turned ? -value : value);
        }
    }
    return bytes;
}

// The last bone-row repeated up to the end of the texture, whose geometry goes to the header.
void fill_texture(Bytes& pixels, Bytes& header, const RunOptions& options) {
    const std::size_t texel_bytes = options.texel_format == POSEPACK_TEXEL_RGBA32F ? 16 : 8;
    const std::size_t row_bytes = texels_of(options.clips.back().encoding) * texel_bytes;
    const std::size_t texel_count = (pixels.size() + row_bytes) / texel_bytes;
    std::size_t width = 64;
    while (texel_count > 4096 * width) width *= 2;
    const std::size_t height = (texel_count + width - 1) / width;
    const std::size_t size = width * height * texel_bytes;
    pixels.reserve(size);
    while (pixels.size() < size) pixels.push_back(pixels[pixels.size() - row_bytes]);
    put_u32(header, POSEPACK_HDR_TEXTURE_WIDTH, static_cast<std::uint32_t>(width));
    put_u32(header, POSEPACK_HDR_TEXTURE_HEIGHT, static_cast<std::uint32_t>(height));
    put_u32(header, POSEPACK_HDR_ROW_PITCH, static_cast<std::uint32_t>(width * texel_bytes));
    put_u32(header, POSEPACK_HDR_ROWS_PER_LINE, 1);
}

// The records of the tiny container with the fields that runs give another value; no cuts.
Bytes clip_section(const Bytes& tiny, const RunOptions& options) {
    Bytes section(tiny.begin(), tiny.begin() + POSEPACK_CLIP_HEAD_BYTES);
    put_u32(section, POSEPACK_CLIP_HEAD_COUNT, static_cast<std::uint32_t>(options.clips.size()));
    put_u32(section, POSEPACK_CLIP_HEAD_CUT_COUNT, 0);
    std::uint32_t next_row = 0, next_texel = 0;
    for (std::size_t i = 0; i < options.clips.size(); ++i) {
        const RunClip& clip = options.clips[i];
        const auto from = tiny.begin() + POSEPACK_CLIP_HEAD_BYTES + (i == 0 ? 0 : POSEPACK_CLIP_RECORD_BYTES);
        Bytes record(from, from + POSEPACK_CLIP_RECORD_BYTES);
        const bool moves = row_count(clip) > 1;
        record[POSEPACK_CLIP_ENCODING] = clip.encoding;
        record[POSEPACK_CLIP_TEXELS_PER_BONE] = static_cast<std::uint8_t>(texels_of(clip.encoding));
        record[POSEPACK_CLIP_ROW_SCHEME] = clip.slots.empty() ? POSEPACK_ROWS_RUNS : POSEPACK_ROWS_SLOTS;
        record[POSEPACK_CLIP_WRAP] = clip.wrap;
        record[POSEPACK_CLIP_INTERPOLATION] = clip.interpolation;
        put_u32(record, POSEPACK_CLIP_FIRST_ROW, next_row);
        put_u32(record, POSEPACK_CLIP_ROW_COUNT, row_count(clip));
        put_u32(record, POSEPACK_CLIP_FIRST_TEXEL, next_texel);
        put_u32(record, POSEPACK_CLIP_CUT_COUNT, 0);
        put_f32(record, POSEPACK_CLIP_RATE_HZ, moves ? 24.f : 0.f);
        put_f32(record, POSEPACK_CLIP_PERIOD_S, moves ? 0.5f : 0.f);
        section.insert(section.end(), record.begin(), record.end());
        next_row += row_count(clip);
        next_texel += bone_row_count(clip) * texels_of(clip.encoding);
    }
    return section;
}

Bytes runs_section(const RunOptions& options) {
    Bytes section;
    for (const RunClip& clip : options.clips) {
        for (const std::uint32_t run : clip.runs) {
            section.resize(section.size() + POSEPACK_RUN_BYTES);
            put_u32(section, section.size() - POSEPACK_RUN_BYTES, run);
        }
    }
    return section;
}

Bytes slot_section(const RunOptions& options) {
    std::vector<std::uint32_t> words;
    std::uint32_t first = 0;
    for (const RunClip& clip : options.clips) {
        words.push_back(first);
        words.push_back(static_cast<std::uint32_t>(clip.slots.size()));
        first += static_cast<std::uint32_t>(clip.slots.size());
    }
    for (const RunClip& clip : options.clips) words.insert(words.end(), clip.slots.begin(), clip.slots.end());
    Bytes section(4 * words.size());
    for (std::size_t i = 0; i < words.size(); ++i) put_u32(section, 4 * i, words[i]);
    return section;
}

void change_header(Bytes& header, const RunOptions& options) {
    const std::uint8_t encoding = options.clips.front().encoding;
    const bool mixed = std::any_of(options.clips.begin(), options.clips.end(),
                                   [&](const RunClip& clip) { return clip.encoding != encoding; });
    std::uint32_t rows = 0;
    for (const RunClip& clip : options.clips) rows += row_count(clip);
    put_u32(header, POSEPACK_HDR_ROW_COUNT, rows);
    put_u32(header, POSEPACK_HDR_CLIP_COUNT, static_cast<std::uint32_t>(options.clips.size()));
    header[POSEPACK_HDR_ROW_SCHEME] = POSEPACK_ROWS_RUNS;
    if (mixed) {
        header[POSEPACK_HDR_ENCODING] = POSEPACK_MIXED;
        header[POSEPACK_HDR_TEXELS_PER_BONE] = POSEPACK_MIXED;
        put_f32(header, POSEPACK_HDR_DUALQUAT_LENGTH, kTinyDualquatLength);
    }
}

}  // namespace

RunOptions tiny_runs(std::uint8_t idle_encoding, std::uint8_t walk_encoding) {
    RunClip idle{idle_encoding, POSEPACK_WRAP_ONCE};
    idle.runs = {run_word(0, 2), run_word(3, 0), run_word(1, 1)};
    RunClip walk{walk_encoding, POSEPACK_WRAP_LOOP};
    walk.runs = {run_word(0, 4), run_word(5, 13), run_word(2, 0)};
    RunOptions options;
    options.clips = {idle, walk};
    return options;
}

RunOptions tiny_slots(std::uint8_t walk_encoding) {
    RunOptions options = tiny_runs(POSEPACK_ENCODING_AFFINE, walk_encoding);
    RunClip& walk = options.clips[1];
    walk.runs = {run_word(0, 6), run_word(7, 6), run_word(3, 0)};
    walk.slots = {slot_word(0, 0, 2), slot_word(0, 1, 2), slot_word(1, 3, 0), slot_word(4, 0, 0),
                  slot_word(5, 0, 1)};
    return options;
}

RunOptions many_runs(std::size_t clip_count, std::uint32_t interval_count) {
    const std::uint32_t rows = interval_count + 1;
    RunClip clip{POSEPACK_ENCODING_AFFINE, POSEPACK_WRAP_ONCE};
    clip.runs = {run_word(0, interval_count), run_word(rows, interval_count),
                 run_word(2 * rows, interval_count)};
    RunOptions options;
    options.clips.assign(clip_count, clip);
    return options;
}

std::uint32_t bone_row_count(const RunClip& clip) {
    std::uint32_t end = 0;
    for (const std::uint32_t run : clip.runs)
        end = std::max(end, offset_of(run) + interval_count_of(run) + 1);
    return end;
}

float run_number(const RunClip& clip, std::uint32_t bone_row, std::uint32_t number) {
    if (clip.encoding == POSEPACK_ENCODING_DUALQUAT)
        return tiny_dualquat(bone_row % 16, bone_row % 3, number);
    return tiny_element(bone_row % 48, bone_row % 3, number);
}

Parts make_run_parts(const RunOptions& options) {
    TinyOptions tiny;
    tiny.encoding = options.clips.front().encoding;
    tiny.texel_format = options.texel_format;
    tiny.measured = options.measured;
    Parts parts = make_parts(tiny);
    Bytes pixels;
    for (const RunClip& clip : options.clips) {
        const Bytes rows = bone_rows(clip, options.texel_format);
        pixels.insert(pixels.end(), rows.begin(), rows.end());
    }
    change_header(parts.header, options);
    fill_texture(pixels, parts.header, options);
    parts[POSEPACK_SECTION_CLIP] = clip_section(parts[POSEPACK_SECTION_CLIP], options);
    parts[POSEPACK_SECTION_PIXL] = pixels;
    parts.sections.insert(parts.sections.end() - 1, {POSEPACK_SECTION_RUNS, runs_section(options)});
    if (std::any_of(options.clips.begin(), options.clips.end(),
                    [](const RunClip& clip) { return !clip.slots.empty(); }))
        parts.sections.insert(parts.sections.end() - 1, {POSEPACK_SECTION_SLOT, slot_section(options)});
    return parts;
}

Bytes make_run_container(const RunOptions& options) {
    return assemble(make_run_parts(options));
}

}  // namespace posepack::test
