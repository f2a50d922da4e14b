// SPDX-License-Identifier: MIT
// Damage and hostility: truncation, growth, flipped bits, and bytes that change behind an open view. All
// reads happen in a buffer that ends at an unreadable page.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "container_builder.hpp"
#include "guarded_bytes.hpp"
#include "posepack/loader.h"
#include "runs_builder.hpp"

namespace posepack::test {
namespace {

void flip_bit(Bytes& bytes, std::size_t bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
}

// Adds up the bytes of a string, so that each one is read.
std::uint32_t touch(posepack_string text) {
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < text.size_bytes; ++i) sum += static_cast<std::uint8_t>(text.data[i]);
    return sum;
}

// Every clip, and one that is not there, at phases good and bad, as poses and bone by bone.
std::uint32_t sample_everything(const posepack_view& view) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::uint32_t sampled = 0;
    posepack_run run;
    float matrices[12 * kTinyBoneCount];
    for (std::uint32_t clip = 0; clip <= view.header.clip_count; ++clip) {
        for (const float phase : {0.f, 0.4f, 0.99999994f, 1.f, -2.f, nan}) {
            if (posepack_sample_pose(&view, clip, phase, matrices) == POSEPACK_OK) ++sampled;
            for (std::uint32_t bone = 0; bone <= view.header.bone_count; ++bone)
                posepack_sample_bone(&view, clip, phase, bone, matrices);
        }
        for (std::uint32_t bone = 0; bone <= view.header.bone_count; ++bone)
            if (posepack_get_run(&view, clip, bone, &run) == POSEPACK_OK) ++sampled;
    }
    return sampled;
}

// Calls every accessor with every index and some that are out of range, and reads all that comes back.
std::uint32_t read_everything(const posepack_view& view) {
    std::uint32_t sum = 0, index = 0, count = 0, clip_index = 0;
    posepack_clip clip;
    posepack_bone bone;
    posepack_state state;
    posepack_mesh mesh;
    posepack_space space;
    for (std::uint32_t i = 0; i <= view.header.clip_count; ++i) {
        if (posepack_get_cut(&view, i, 0, &index) == POSEPACK_OK) sum += index;
        if (posepack_get_clip(&view, i, &clip) != POSEPACK_OK) continue;
        sum += touch(clip.name) + touch(clip.source_name);
        for (std::uint32_t cut = 0; cut < 4; ++cut) {
            if (posepack_get_cut(&view, i, cut, &index) == POSEPACK_OK) sum += index;
        }
        if (posepack_get_cut(&view, i, clip.cut_count - 1, &index) == POSEPACK_OK) sum += index;
    }
    for (std::uint32_t i = 0; i <= view.header.bone_count; ++i) {
        if (posepack_get_bone(&view, i, &bone) == POSEPACK_OK) sum += touch(bone.name);
    }
    posepack_count_states(&view, &count, &index);
    for (std::uint32_t i = 0; i <= count; ++i) {
        if (posepack_get_state(&view, i, &state) == POSEPACK_OK) sum += touch(state.name);
    }
    posepack_get_space(&view, &space);
    for (std::uint32_t i = 0; i <= space.mesh_count; ++i) {
        if (posepack_map_joint(&view, i, 0, &index) == POSEPACK_OK) sum += index;
        if (posepack_get_mesh(&view, i, &mesh) != POSEPACK_OK) continue;
        sum += touch(mesh.name);
        for (const std::uint32_t joint : {0u, 1u, 2u, 5u, mesh.joint_count - 1}) {
            if (posepack_map_joint(&view, i, joint, &index) == POSEPACK_OK) {
                EXPECT_LT(index, view.header.bone_count);
            }
        }
    }
    for (const char* name : {"walk", "tail", "stand", "no such name"}) {
        posepack_find_clip(&view, name, &clip_index);
        posepack_find_state(&view, name, &clip_index);
        posepack_find_bone(&view, name, &clip_index);
    }
    for (std::uint32_t row = 0; row <= view.header.row_count; ++row) {
        float matrices[12 * kTinyBoneCount];
        posepack_decode_row(&view, row, matrices);
    }
    EXPECT_EQ(sample_everything(view), view.header.clip_count * (6 + view.header.bone_count));
    return sum;
}

TEST(Safety, EveryTruncationIsRefused) {
    const Bytes bytes = make_container();
    GuardedBytes memory(bytes.size());
    posepack_view view;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const posepack_result result = posepack_open(&view, memory.place(bytes.data(), size), size);
        ASSERT_EQ(result, size < POSEPACK_HEADER_BYTES ? POSEPACK_ERROR_TOO_SMALL : POSEPACK_ERROR_SIZE)
            << size;
    }
    EXPECT_EQ(posepack_open(&view, memory.place(bytes.data(), bytes.size()), bytes.size()), POSEPACK_OK);
}

TEST(Safety, EveryTruncationWithAnHonestSizeIsRefused) {
    const Bytes bytes = make_container();
    GuardedBytes memory(bytes.size());
    for (std::size_t size = POSEPACK_HEADER_BYTES; size < bytes.size(); ++size) {
        Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        put_u64(cut, POSEPACK_HDR_FILE_BYTES, size);
        seal_header(cut);
        posepack_view view;
        const posepack_result result = posepack_open(&view, memory.place(cut.data(), size), size);
        ASSERT_EQ(result, POSEPACK_ERROR_SECTION) << size;
    }
}

TEST(Safety, GrowthIsRefused) {
    Bytes bytes = make_container();
    const std::size_t size = bytes.size();
    bytes.resize(size + 4096);
    posepack_view view;
    for (std::size_t more = 1; more <= 4096; ++more) {
        ASSERT_EQ(posepack_open(&view, bytes.data(), size + more), POSEPACK_ERROR_SIZE) << more;
    }
}

TEST(Safety, EverySingleBitFlipIsRefused) {
    Bytes bytes = make_container();
    int refused = 0;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        flip_bit(bytes, bit);
        posepack_view view;
        ASSERT_NE(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK) << "bit " << bit;
        flip_bit(bytes, bit);
        ++refused;
    }
    EXPECT_EQ(refused, static_cast<int>(8 * bytes.size()));
}

// With every checksum repaired a flip may be legal, but nothing behind it may read outside the buffer.
TEST(Safety, SealedBitFlipsNeverReadOutside) {
    const Bytes good = make_container();
    GuardedBytes memory(good.size());
    int opened = 0;
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        if (bit / 8 >= 1200 && bit / 8 < 4096) continue;  // fill: covered by the test above
        Bytes bytes = good;
        flip_bit(bytes, bit);
        seal(bytes);
        posepack_view view;
        if (posepack_open(&view, memory.place(bytes.data(), bytes.size()), bytes.size()) == POSEPACK_OK) {
            read_everything(view);
            ++opened;
        }
    }
    EXPECT_GT(opened, 1000);  // recipe, node numbers, finite floats
}

TEST(Safety, SealedBitFlipsOfRunsNeverReadOutside) {
    const Bytes good = make_run_container(tiny_runs(POSEPACK_ENCODING_DUALQUAT, POSEPACK_ENCODING_MAT4));
    const std::size_t tables_end = section_offset(good, POSEPACK_SECTION_RUNS) + 24;
    GuardedBytes memory(good.size());
    int opened = 0;
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        if (bit / 8 >= tables_end && bit / 8 < section_offset(good, POSEPACK_SECTION_PIXL)) continue;
        Bytes bytes = good;
        flip_bit(bytes, bit);
        seal(bytes);
        posepack_view view;
        if (posepack_open(&view, memory.place(bytes.data(), bytes.size()), bytes.size()) == POSEPACK_OK) {
            read_everything(view);
            ++opened;
        }
    }
    EXPECT_GT(opened, 1000);
}

constexpr std::uint32_t kTables[] = {POSEPACK_SECTION_CLIP, POSEPACK_SECTION_STAT, POSEPACK_SECTION_BONE,
                                     POSEPACK_SECTION_SPAC, POSEPACK_SECTION_STRS};

// Each table in turn lies at the end of the file, cut to every length.
TEST(Safety, TablesThatAreTooShortAreNotReadPastTheirEnd) {
    GuardedBytes memory(16384);
    int refused = 0;
    for (const std::uint32_t type : kTables) {
        Parts parts = make_parts();
        parts.move_to_end(type);
        for (std::size_t size = parts[type].size() - 1; size > 0; --size) {
            parts[type].resize(size);
            const Bytes bytes = assemble(parts);
            posepack_view view;
            ASSERT_EQ(posepack_open(&view, memory.place(bytes.data(), bytes.size()), bytes.size()),
                      POSEPACK_ERROR_SEMANTIC)
                << size;
            ++refused;
        }
    }
    EXPECT_GT(refused, 800);
}

TEST(Safety, CountsAreNotFollowedPastTheEndOfATable) {
    GuardedBytes memory(16384);
    const std::size_t walk = POSEPACK_CLIP_HEAD_BYTES + POSEPACK_CLIP_RECORD_BYTES;
    Parts cuts = make_parts();
    cuts.move_to_end(POSEPACK_SECTION_CLIP);
    put_u32(cuts[POSEPACK_SECTION_CLIP], walk + POSEPACK_CLIP_CUT_COUNT, 2000);
    Parts text = make_parts();
    text.move_to_end(POSEPACK_SECTION_STRS);
    std::vector<std::string> strings = tiny_strings();
    strings.push_back("zz\xF0");  // three bytes would have to follow
    text[POSEPACK_SECTION_STRS] = string_section(strings);
    for (const Parts& parts : {cuts, text}) {
        const Bytes bytes = assemble(parts);
        posepack_view view;
        EXPECT_EQ(posepack_open(&view, memory.place(bytes.data(), bytes.size()), bytes.size()),
                  POSEPACK_ERROR_SEMANTIC);
    }
}

TEST(Safety, AccessorsDoNotReadPastTheEndOfATable) {
    GuardedBytes memory(16384);
    for (const std::uint32_t type : kTables) {
        Parts parts = make_parts();
        parts.move_to_end(type);
        const Bytes bytes = assemble(parts);
        posepack_view view;
        ASSERT_EQ(posepack_open(&view, memory.place(bytes.data(), bytes.size()), bytes.size()), POSEPACK_OK);
        read_everything(view);
    }
}

TEST(Safety, AZeroByteThatAppearsInANameDoesNotLeadPastTheNameLookedFor) {
    Bytes bytes = make_container();
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    posepack_clip clip;
    ASSERT_EQ(posepack_get_clip(&view, 1, &clip), POSEPACK_OK);
    const auto* start = reinterpret_cast<const std::uint8_t*>(clip.name.data);
    std::fill_n(bytes.begin() + (start - bytes.data()) + 2, 2, 0);  // "wa", two zero bytes
    GuardedBytes memory(16);
    const auto* name =
        reinterpret_cast<const char*>(memory.place(reinterpret_cast<const std::uint8_t*>("wa"), 3));
    std::uint32_t index = 0;
    EXPECT_EQ(posepack_find_clip(&view, name, &index), POSEPACK_ERROR_NOT_FOUND);
}

TEST(Safety, BytesThatChangeAfterOpenNeverReadOutside) {
    const Bytes good = make_container();
    constexpr unsigned kSeed = 20240229;
    std::mt19937 random(kSeed);
    GuardedBytes memory(good.size());
    posepack_view view;
    for (int round = 0; round < 4000; ++round) {
        std::uint8_t* bytes = memory.place(good.data(), good.size());
        ASSERT_EQ(posepack_open(&view, bytes, good.size()), POSEPACK_OK);
        const std::uint32_t changes = 1 + random() % 64;
        for (std::uint32_t i = 0; i < changes; ++i) {
            constexpr std::uint8_t kHostile[] = {0x00, 0x01, 0x7F, 0x80, 0xFF};
            bytes[random() % 1200] = kHostile[random() % 5];
        }
        read_everything(view);
    }
    SUCCEED() << "seed " << kSeed;
}

// Containers with runs: PIXL last, so that a texel too far is in the guard, and RUNS last.
std::vector<Bytes> run_containers() {
    Parts runs_last = make_run_parts(tiny_runs(POSEPACK_ENCODING_DUALQUAT, POSEPACK_ENCODING_AFFINE));
    runs_last.move_to_end(POSEPACK_SECTION_RUNS);
    return {make_run_container(), assemble(runs_last),
            make_run_container(tiny_runs(POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_DUALQUAT))};
}

TEST(Safety, RunsThatChangeAfterOpenNeverReadOutside) {
    constexpr std::uint32_t kHostile[] = {0,          0x000FFFFF, 0xFFF00000, 0xFFFFFFFF,
                                          0x80000000, 0x00100001, 0x00080000, 0x7FF00018};
    std::mt19937 random(20250330);
    posepack_view view;
    for (const Bytes& good : run_containers()) {
        GuardedBytes memory(good.size());
        std::uint8_t* bytes = memory.place(good.data(), good.size());
        ASSERT_EQ(posepack_open(&view, bytes, good.size()), POSEPACK_OK);
        const std::size_t runs = section_offset(good, POSEPACK_SECTION_RUNS);
        const std::size_t size =
            get_u64(good, entry_offset(good, POSEPACK_SECTION_RUNS) + POSEPACK_ENT_RAW_BYTES);
        ASSERT_EQ(size, 2u * 3u * 4u);
        for (std::size_t bit = 0; bit < 8 * size; ++bit) {
            bytes[runs + bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
            read_everything(view);
            bytes[runs + bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        }
        for (int round = 0; round < 2000; ++round) {
            for (std::size_t at = runs; at < runs + size; at += 4) {
                const auto word =
                    static_cast<std::uint32_t>(random() % 2 == 0 ? kHostile[random() % 8] : random());
                for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(word >> 8 * i);
            }
            read_everything(view);
        }
    }
}

TEST(Safety, ClipsWithRunsThatChangeAfterOpenNeverReadOutside) {
    std::mt19937 random(20250331);
    posepack_view view;
    for (const Bytes& good : run_containers()) {
        GuardedBytes memory(good.size());
        for (int round = 0; round < 2000; ++round) {
            std::uint8_t* bytes = memory.place(good.data(), good.size());
            ASSERT_EQ(posepack_open(&view, bytes, good.size()), POSEPACK_OK);
            const std::size_t clips = section_offset(good, POSEPACK_SECTION_CLIP);
            for (std::uint32_t i = 0; i <= random() % 48; ++i) {
                constexpr std::uint8_t kHostile[] = {0x00, 0x01, 0x04, 0x05, 0x7F, 0x80, 0xFF};
                bytes[clips + random() % 400] = kHostile[random() % 7];  // head and both records
            }
            read_everything(view);
        }
    }
}

// A file whose bytes change may state an encoding that open refuses: no number is made of it.
TEST(Safety, AnEncodingThatAppearsAfterOpenGivesZeros) {
    for (Bytes bytes : {make_container(), make_run_container()}) {
        posepack_view view;
        ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
        const std::size_t record = section_offset(bytes, POSEPACK_SECTION_CLIP) + POSEPACK_CLIP_HEAD_BYTES;
        for (const std::uint8_t encoding : {0, 4, 5, 6, 255}) {
            bytes[record + POSEPACK_CLIP_ENCODING] = encoding;
            float matrix[12];
            std::fill_n(matrix, 12, 7.f);
            EXPECT_EQ(posepack_sample_bone(&view, 0, 0.3f, 0, matrix), POSEPACK_OK);
            for (const float number : matrix) EXPECT_EQ(number, 0.f) << int{encoding};
        }
    }
}

TEST(Safety, TablesFilledWithOnesOrZerosAfterOpen) {
    const Bytes good = make_container();
    GuardedBytes memory(good.size());
    posepack_view view;
    for (const std::uint8_t fill : {0x00, 0xFF}) {
        for (const std::uint32_t type : kTables) {
            std::uint8_t* bytes = memory.place(good.data(), good.size());
            ASSERT_EQ(posepack_open(&view, bytes, good.size()), POSEPACK_OK);
            const std::size_t begin = section_offset(good, type);
            const std::size_t size = get_u64(good, entry_offset(good, type) + POSEPACK_ENT_STORED_BYTES);
            std::fill_n(bytes + begin, size, fill);
            read_everything(view);
        }
    }
}

TEST(Safety, ANameThatMovedOutOfItsSectionReadsAsEmpty) {
    Bytes bytes = make_container();
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    const std::size_t clip = section_offset(bytes, POSEPACK_SECTION_CLIP) + POSEPACK_CLIP_HEAD_BYTES;
    put_u32(bytes, clip + POSEPACK_CLIP_NAME, 11);
    posepack_clip read;
    ASSERT_EQ(posepack_get_clip(&view, 0, &read), POSEPACK_OK);
    EXPECT_EQ(read.name.size_bytes, 0u);
    EXPECT_NE(read.name.data, nullptr);
}

TEST(Safety, IndicesThatChangeAfterOpenAreCheckedAgain) {
    Bytes bytes = make_container();
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    const std::size_t walk =
        section_offset(bytes, POSEPACK_SECTION_CLIP) + POSEPACK_CLIP_HEAD_BYTES + POSEPACK_CLIP_RECORD_BYTES;
    const std::size_t bones = section_offset(bytes, POSEPACK_SECTION_BONE);
    const std::size_t joints = bones + POSEPACK_BONE_HEAD_BYTES + 3 * POSEPACK_BONE_RECORD_BYTES;
    const std::size_t body = section_offset(bytes, POSEPACK_SECTION_SPAC) + POSEPACK_SPAC_HEAD_BYTES;
    std::uint32_t value = 0, default_state = 0;

    put_u32(bytes, walk + POSEPACK_CLIP_FIRST_CUT, 1);
    EXPECT_EQ(posepack_get_cut(&view, 1, 0, &value), POSEPACK_ERROR_INDEX);
    put_u32(bytes, walk + POSEPACK_CLIP_FIRST_CUT, 0);
    put_u32(bytes, walk + POSEPACK_CLIP_CUT_COUNT, 2);
    EXPECT_EQ(posepack_get_cut(&view, 1, 1, &value), POSEPACK_ERROR_INDEX);

    put_u32(bytes, section_offset(bytes, POSEPACK_SECTION_STAT) + 4, 2);
    EXPECT_EQ(posepack_count_states(&view, &value, &default_state), POSEPACK_OK);
    EXPECT_EQ(default_state, POSEPACK_NONE);

    put_u16(bytes, joints, 3);
    EXPECT_EQ(posepack_map_joint(&view, 0, 0, &value), POSEPACK_ERROR_INDEX);
    put_u16(bytes, joints, POSEPACK_NO_BONE);
    EXPECT_EQ(posepack_map_joint(&view, 0, 0, &value), POSEPACK_ERROR_NOT_FOUND);
    EXPECT_EQ(value, POSEPACK_NONE);
    put_u32(bytes, body + POSEPACK_MESH_JOINT_COUNT, 0xFFFFFFFF);
    EXPECT_EQ(posepack_map_joint(&view, 0, 5, &value), POSEPACK_ERROR_INDEX);
    put_u32(bytes, body + POSEPACK_MESH_FIRST_JOINT, 5);
    EXPECT_EQ(posepack_map_joint(&view, 0, 0, &value), POSEPACK_ERROR_INDEX);
    put_u32(bytes, body + POSEPACK_MESH_FIRST_JOINT, 0);
    put_u32(bytes, bones + POSEPACK_BONE_HEAD_JOINT_MAP_COUNT, 0xFFFFFFFF);
    EXPECT_EQ(posepack_map_joint(&view, 0, 6, &value), POSEPACK_ERROR_INDEX);
}

}  // namespace
}  // namespace posepack::test
