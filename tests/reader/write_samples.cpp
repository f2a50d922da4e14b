// SPDX-License-Identifier: MIT
// Writes containers for the two readers to agree on: every variant of the tiny container, of uniform rows and
// of runs, into FOLDER/good, and damaged ones with right checksums into FOLDER/damaged.
//
//     write_samples FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "changes.hpp"
#include "container_builder.hpp"
#include "run_cases.hpp"
#include "runs_builder.hpp"

namespace {

using namespace posepack::test;
namespace fs = std::filesystem;

void write(const fs::path& path, const Bytes& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

int write_good(const fs::path& folder) {
    int written = 0;
    for (std::uint32_t variant = 0; variant < 3 * 32 * kTinyRowCount; ++variant) {
        TinyOptions options;
        options.encoding = static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + variant % 3);
        options.texel_format = variant / 3 & 1 ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
        options.texel_order = variant / 3 & 2 ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
        options.pad_pitch = (variant / 3 & 4) != 0;
        options.measured = (variant / 3 & 8) != 0;
        options.closing_row = (variant / 3 & 16) != 0 && options.encoding == POSEPACK_ENCODING_DUALQUAT;
        options.rows_per_line = variant / 96 + 1;
        Bytes bytes = make_container(options);
        if (variant % 7 == 1) {  // a joint without a bone
            const std::size_t joints = section_offset(bytes, POSEPACK_SECTION_BONE) +
                                       POSEPACK_BONE_HEAD_BYTES + 3 * POSEPACK_BONE_RECORD_BYTES;
            put_u16(bytes, joints + 2 * (variant % 5), POSEPACK_NO_BONE);
            seal(bytes);
        }
        write(folder / ("variant_" + std::to_string(variant) + ".posepack"), bytes);
        ++written;
    }
    return written;
}

// What decides which rows a phase blends: wraps, steps, and a cut or none.
int write_good_clips(const fs::path& folder) {
    int written = 0;
    for (std::uint32_t variant = 0; variant < 3 * 3 * 2 * 2; ++variant) {
        TinyOptions options;
        options.encoding = static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + variant % 3);
        options.rows_per_line = 2;
        Parts parts = make_parts(options);
        parts[kClip][kWalk + POSEPACK_CLIP_WRAP] = static_cast<std::uint8_t>(variant / 3 % 3);
        parts[kClip][kWalk + POSEPACK_CLIP_INTERPOLATION] = variant / 9 & 1;
        if (variant / 18 != 0) {
            put_u32(parts[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 0);
            put_u32(parts[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 0);
            parts[kClip].resize(kCuts);
        }
        write(folder / ("clip_" + std::to_string(variant) + ".posepack"), assemble(parts));
        ++written;
    }
    return written;
}

// Runs in all pairs of encodings, and so many that the texture is wider than 64.
int write_good_runs(const fs::path& folder) {
    int written = 0;
    for (std::uint32_t variant = 0; variant < 9 * 2 * 3 * 2 * 2; ++variant) {
        RunOptions options = tiny_runs(static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + variant % 3),
                                       static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + variant / 3 % 3));
        options.texel_format = variant / 9 & 1 ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
        options.clips[0].wrap = static_cast<std::uint8_t>(variant / 18 % 3);
        options.clips[0].interpolation = variant / 54 & 1;
        // A run within another closes too.
        if (options.clips[0].wrap == POSEPACK_WRAP_LOOP) options.clips[0].runs[2] = run_word(0, 2);
        const bool turned = variant / 108 != 0;
        options.measured = !turned;
        if (turned && options.clips[1].encoding == POSEPACK_ENCODING_DUALQUAT) options.clips[1].turned = 2;
        write(folder / ("runs_" + std::to_string(variant) + ".posepack"), make_run_container(options));
        ++written;
    }
    write(folder / "runs_wide.posepack", make_run_container(many_runs(8, 4095)));
    return written + 1;
}

// Slots in every encoding, with every wrap and held rows.
int write_good_slots(const fs::path& folder) {
    int written = 0;
    for (std::uint32_t variant = 0; variant < 3 * 3 * 2 * 2; ++variant) {
        RunOptions options = tiny_slots(static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + variant % 3));
        options.clips[1].wrap = static_cast<std::uint8_t>(variant / 3 % 3);
        options.clips[1].interpolation = variant / 9 & 1;
        options.texel_format = variant / 18 & 1 ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
        write(folder / ("slots_" + std::to_string(variant) + ".posepack"), make_run_container(options));
        ++written;
    }
    return written;
}

// Each rule about runs broken once, and what just keeps it.
int write_run_cases(const fs::path& folder) {
    int written = 0;
    for (const RunCase& test : run_cases()) {
        Parts parts = make_run_parts(test.options);
        if (test.change != nullptr) test.change(parts);
        const fs::path kind = folder / (test.expected == POSEPACK_OK ? "good" : "damaged");
        write(kind / ("rule_" + std::to_string(written) + "_" + test.rule + ".posepack"), assemble(parts));
        ++written;
    }
    return written;
}

// Every 61st bit flipped, and every word of header and tables set to a hostile value, all sealed again.
// Tables end at offset `tables_end`, within the first 1,200 bytes; fill reaches to 4,096.
int write_damaged(const fs::path& folder, const std::string& name, const Bytes& good,
                  std::size_t tables_end) {
    const std::string suffix = "_" + name + ".posepack";
    int written = 0;
    for (std::size_t bit = 0; bit < 8 * good.size(); bit += bit < 8 * 1200 || bit >= 8 * 4096 ? 61 : 1009) {
        Bytes bytes = good;
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        seal(bytes);
        write(folder / ("bit_" + std::to_string(bit) + suffix), bytes);
        ++written;
    }
    for (std::size_t offset = 16; offset < tables_end; offset += 4) {
        constexpr std::uint32_t kHostile[] = {0, 1, 0x7F800000, 0x7FC00000, 0x80000000, 0xFFFFFFFF};
        Bytes bytes = good;
        put_u32(bytes, offset, kHostile[offset / 4 % 6]);
        seal(bytes);
        write(folder / ("word_" + std::to_string(offset) + suffix), bytes);
        ++written;
    }
    return written;
}

int write_damaged_rows(const fs::path& folder, std::uint8_t encoding) {
    TinyOptions options;
    options.encoding = encoding;
    options.closing_row = encoding == POSEPACK_ENCODING_DUALQUAT;
    options.texel_order = POSEPACK_ORDER_PLANAR;
    options.rows_per_line = 2;
    options.pad_pitch = true;
    const Bytes good = make_container(options);
    return write_damaged(folder, std::to_string(encoding), good, section_offset(good, POSEPACK_SECTION_STRS));
}

// Also every bit of RUNS and SLOT, which lies behind it.
int write_damaged_runs(const fs::path& folder, const std::string& name, const RunOptions& options) {
    const Bytes good = make_run_container(options);
    const std::size_t runs = section_offset(good, kRuns);
    std::size_t runs_end = runs + 2 * kTinyBoneCount * POSEPACK_RUN_BYTES;
    for (const RunClip& clip : options.clips)
        if (!clip.slots.empty())
            runs_end = section_offset(good, kSlot) + 2 * POSEPACK_SLOT_HEAD_BYTES +
                       clip.slots.size() * POSEPACK_SLOT_BYTES;
    int written = 0;
    for (std::size_t bit = 8 * runs; bit < 8 * runs_end; ++bit) {
        Bytes bytes = good;
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        seal(bytes);
        write(folder / ("run_bit_" + std::to_string(bit) + "_" + name + ".posepack"), bytes);
        ++written;
    }
    return written + write_damaged(folder, name, good, runs_end);
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::fprintf(stderr, "usage: write_samples FOLDER\n");
        return 1;
    }
    const fs::path folder = arguments[1];
    for (const char* kind : {"good", "damaged"}) {
        fs::remove_all(folder / kind);  // of another version of this program
        fs::create_directories(folder / kind);
    }
    const int good = write_good(folder / "good") + write_good_clips(folder / "good") +
                     write_good_runs(folder / "good") + write_good_slots(folder / "good");
    const int damaged =
        write_damaged_rows(folder / "damaged", POSEPACK_ENCODING_MAT4) +
        write_damaged_rows(folder / "damaged", POSEPACK_ENCODING_DUALQUAT) +
        write_damaged_runs(folder / "damaged", "runs_11",
                           tiny_runs(POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_MAT4)) +
        write_damaged_runs(folder / "damaged", "runs_23",
                           tiny_runs(POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT)) +
        write_damaged_runs(folder / "damaged", "slots", tiny_slots(POSEPACK_ENCODING_DUALQUAT));
    const int rules = write_run_cases(folder);
    std::printf("wrote %d good and %d damaged containers, and %d about rules of runs\n", good, damaged,
                rules);
    return 0;
}
