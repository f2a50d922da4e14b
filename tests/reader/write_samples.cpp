// SPDX-License-Identifier: MIT
// Writes containers for the two readers to agree on: every variant of the tiny container into FOLDER/good,
// and damaged ones with right checksums into FOLDER/damaged.
//
//     write_samples FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "container_builder.hpp"

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

// Every 61st bit flipped, and every word of header and tables set to a hostile value, all sealed again.
int write_damaged(const fs::path& folder, std::uint8_t encoding) {
    const std::string suffix = "_" + std::to_string(encoding) + ".posepack";
    TinyOptions options;
    options.encoding = encoding;
    options.closing_row = encoding == POSEPACK_ENCODING_DUALQUAT;
    options.texel_order = POSEPACK_ORDER_PLANAR;
    options.rows_per_line = 2;
    options.pad_pitch = true;
    const Bytes good = make_container(options);
    const std::size_t tables_end = section_offset(good, POSEPACK_SECTION_STRS);
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

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::fprintf(stderr, "usage: write_samples FOLDER\n");
        return 1;
    }
    const fs::path folder = arguments[1];
    fs::create_directories(folder / "good");
    fs::create_directories(folder / "damaged");
    const int good = write_good(folder / "good");
    const int damaged = write_damaged(folder / "damaged", POSEPACK_ENCODING_MAT4) +
                        write_damaged(folder / "damaged", POSEPACK_ENCODING_DUALQUAT);
    std::printf("wrote %d good and %d damaged containers\n", good, damaged);
    return 0;
}
