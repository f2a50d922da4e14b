// SPDX-License-Identifier: MIT
// The tiny container with runs instead of uniform rows: every bone of every clip has bone-rows of its own.
#pragma once

#include <array>
#include <vector>

#include "container_builder.hpp"

namespace posepack::test {

/// A word of RUNS: bone-rows before the run, counted from the clip's first, and its intervals.
constexpr std::uint32_t run_word(std::uint32_t offset, std::uint32_t interval_count) {
    return offset | interval_count << POSEPACK_RUN_OFFSET_BITS;
}

/// A slot, as SLOT has it.
constexpr std::uint32_t slot_word(std::uint32_t row, std::uint32_t offset, std::uint32_t span) {
    return row | offset << 16 | span << 24;
}

/// One clip; the first of a container is called "idle", all others "walk".
struct RunClip {
    std::uint8_t encoding = POSEPACK_ENCODING_AFFINE;
    std::uint8_t wrap = POSEPACK_WRAP_LOOP;
    std::uint8_t interpolation = POSEPACK_INTERPOLATION_LINEAR;
    std::array<std::uint32_t, kTinyBoneCount> runs{};  // words of RUNS
    std::uint32_t turned =
        0;  // bit b: of a loop of dualquat, the last bone-row of bone b is its first turned
    std::vector<std::uint32_t> slots{};  // words of SLOT; none: a clip of plain runs
};

/// What make_run_parts builds. Every combination is valid where the runs are.
struct RunOptions {
    std::uint8_t texel_format = POSEPACK_TEXEL_RGBA16F;
    bool measured = true;
    std::vector<RunClip> clips;
};

/// Two clips. "idle": root has 2 intervals, tail keeps still, leg reads the last 2 rows of root: 4 bone-rows.
/// "walk", a loop: root has 4 intervals, tail 13, leg keeps still in row 2 of root: 19 bone-rows.
RunOptions tiny_runs(std::uint8_t idle_encoding = POSEPACK_ENCODING_AFFINE,
                     std::uint8_t walk_encoding = POSEPACK_ENCODING_AFFINE);

/// The same, but that walk has five slots: root and tail have 6 intervals each, leg keeps still. The first
/// two slots share row 0's interval, the third holds three, in the fourth row 4 is held, the last begins at
/// row 5.
RunOptions tiny_slots(std::uint8_t walk_encoding = POSEPACK_ENCODING_AFFINE);

/// So many clips that do not loop, in which each bone has a run of its own of so many intervals: with affine
/// 9 texels a row.
RunOptions many_runs(std::size_t clip_count, std::uint32_t interval_count);

/// As make_parts; RUNS, and SLOT where a clip has slots, lie in front of PIXL.
Parts make_run_parts(const RunOptions& options = tiny_runs());

/// assemble(make_run_parts(options)).
Bytes make_run_container(const RunOptions& options = tiny_runs());

/// Bone-rows of a clip: one behind the last that its runs name.
std::uint32_t bone_row_count(const RunClip& clip);

/// Number `number` (rows of a matrix, or real and dual part) of bone-row `bone_row` of a clip, without the
/// rows that close a loop; exact as a half.
float run_number(const RunClip& clip, std::uint32_t bone_row, std::uint32_t number);

}  // namespace posepack::test
