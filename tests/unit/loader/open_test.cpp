// SPDX-License-Identifier: MIT
// Framing: magic, versions, sizes, limits, the section table and the places of sections. Rule numbers are
// those of docs/format/posepack-1.md; P and two digits number the list of bad containers that every release
// answers alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "container_builder.hpp"
#include "posepack/loader.h"

namespace posepack::test {
namespace {

// A container made wrong in one place; `break_it` leaves every checksum as the case wants it.
struct Case {
    const char* rule;
    const char* what;
    std::function<void(Bytes&)> break_it;
    posepack_result expected;
};

std::string open_name(const Bytes& bytes) {
    posepack_view view;
    return posepack_result_name(posepack_open(&view, bytes.data(), bytes.size()));
}

void run(const std::vector<Case>& cases) {
    const Bytes good = make_container();
    ASSERT_EQ(open_name(good), "OK");
    for (const Case& test : cases) {
        Bytes bytes = good;
        test.break_it(bytes);
        EXPECT_EQ(open_name(bytes), posepack_result_name(test.expected)) << test.rule << ": " << test.what;
    }
}

// Sets a u32 of the header and seals.
std::function<void(Bytes&)> header_u32(std::size_t field, std::uint32_t value) {
    return [=](Bytes& bytes) {
        put_u32(bytes, field, value);
        seal(bytes);
    };
}

// Sets a u32 or u64 of a section's table entry and seals.
std::function<void(Bytes&)> entry_u32(std::uint32_t type, std::size_t field, std::uint32_t value) {
    return [=](Bytes& bytes) {
        put_u32(bytes, entry_offset(bytes, type) + field, value);
        seal(bytes);
    };
}

std::function<void(Bytes&)> entry_u64(std::uint32_t type, std::size_t field, std::uint64_t value) {
    return [=](Bytes& bytes) {
        put_u64(bytes, entry_offset(bytes, type) + field, value);
        seal(bytes);
    };
}

std::function<void(Bytes&)> flip(std::size_t offset, bool sealed) {
    return [=](Bytes& bytes) {
        bytes.at(offset) ^= 1;
        if (sealed) seal_header(bytes);
    };
}

// Adds to the stored and raw size of a section and seals.
std::function<void(Bytes&)> entry_size(std::uint32_t type, std::uint64_t more) {
    return [=](Bytes& bytes) {
        const std::size_t entry = entry_offset(bytes, type);
        const std::uint64_t size = get_u64(bytes, entry + POSEPACK_ENT_STORED_BYTES) + more;
        put_u64(bytes, entry + POSEPACK_ENT_STORED_BYTES, size);
        put_u64(bytes, entry + POSEPACK_ENT_RAW_BYTES, size);
        seal(bytes);
    };
}

// Rebuilds the container from parts that a test has changed.
std::function<void(Bytes&)> parts(const std::function<void(Parts&)>& change) {
    return [=](Bytes& bytes) {
        Parts pieces = make_parts();
        change(pieces);
        bytes = assemble(pieces);
    };
}

void replace_line_feeds(Bytes& bytes) {
    Bytes changed;
    for (const std::uint8_t byte : bytes) {
        if (byte == 0x0A) changed.push_back(0x0D);
        changed.push_back(byte);
    }
    bytes = changed;
}

TEST(Open, ArgumentsAndShortBuffers) {
    const Bytes good = make_container();
    posepack_view view;
    EXPECT_EQ(posepack_open(&view, nullptr, 0), POSEPACK_ERROR_ARG);  // P01
    EXPECT_EQ(posepack_open(&view, nullptr, good.size()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_open(nullptr, good.data(), good.size()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_open(&view, good.data(), 0), POSEPACK_ERROR_TOO_SMALL);
    EXPECT_EQ(posepack_open(&view, good.data(), 127), POSEPACK_ERROR_TOO_SMALL);  // P02
}

TEST(Open, AFailureLeavesTheViewEmpty) {
    Bytes bytes = make_container();
    bytes.back() ^= 1;
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_ERROR_SECTION_CRC);
    EXPECT_EQ(view.bytes, nullptr);
    EXPECT_EQ(view.header.clip_count, 0u);
    EXPECT_EQ(view.sections[0].stored_bytes, 0u);
}

TEST(Open, EveryVariantOfTheTinyContainerIsGood) {
    int opened = 0;
    for (int i = 0; i < 2 * 2 * 2 * 5 * 2 * 2; ++i) {
        TinyOptions options;
        options.encoding = i & 1 ? POSEPACK_ENCODING_MAT4 : POSEPACK_ENCODING_AFFINE;
        options.texel_format = i & 2 ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
        options.texel_order = i & 4 ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
        options.pad_pitch = (i & 8) != 0;
        options.measured = (i & 16) != 0;
        options.rows_per_line = static_cast<std::uint32_t>(i / 32 + 1);
        EXPECT_EQ(open_name(make_container(options)), "OK") << i;
        ++opened;
    }
    EXPECT_EQ(opened, 160);
}

TEST(Open, HeaderRules) {
    run({
        {"F2", "P03 text-mode transfer", replace_line_feeds, POSEPACK_ERROR_MAGIC},
        {"F2", "first byte", flip(0, true), POSEPACK_ERROR_MAGIC},
        {"F2", "last byte of the magic", flip(7, true), POSEPACK_ERROR_MAGIC},
        {"F3", "P04 major 2",
         [](Bytes& bytes) {
             put_u16(bytes, POSEPACK_HDR_MAJOR, 2);
             seal(bytes);
         },
         POSEPACK_ERROR_VERSION},
        {"F3", "another draft",
         [](Bytes& bytes) {
             put_u16(bytes, POSEPACK_HDR_MINOR, POSEPACK_FORMAT_MINOR + 1);
             seal(bytes);
         },
         POSEPACK_ERROR_VERSION},
        {"F3", "another header size", header_u32(POSEPACK_HDR_HEADER_BYTES, 132), POSEPACK_ERROR_VERSION},
        {"F3", "the version comes before the checksum", flip(POSEPACK_HDR_MAJOR, false),
         POSEPACK_ERROR_VERSION},
        {"F5", "P06 one less",
         [](Bytes& bytes) {
             put_u64(bytes, POSEPACK_HDR_FILE_BYTES, bytes.size() - 1);
             seal(bytes);
         },
         POSEPACK_ERROR_SIZE},
        {"F5", "P06 one more",
         [](Bytes& bytes) {
             put_u64(bytes, POSEPACK_HDR_FILE_BYTES, bytes.size() + 1);
             seal(bytes);
         },
         POSEPACK_ERROR_SIZE},
        {"F5", "P07 a zero byte appended", [](Bytes& bytes) { bytes.push_back(0); }, POSEPACK_ERROR_SIZE},
        {"F7", "P09 no section", header_u32(POSEPACK_HDR_SECTION_COUNT, 0), POSEPACK_ERROR_LIMIT},
        {"F7", "P09 33 sections", header_u32(POSEPACK_HDR_SECTION_COUNT, 33), POSEPACK_ERROR_LIMIT},
        {"F7", "P09 all ones", header_u32(POSEPACK_HDR_SECTION_COUNT, 0xFFFFFFFF), POSEPACK_ERROR_LIMIT},
        {"F8", "P23 no bone", header_u32(POSEPACK_HDR_BONE_COUNT, 0), POSEPACK_ERROR_LIMIT},
        {"F8", "P23 1025 bones", header_u32(POSEPACK_HDR_BONE_COUNT, 1025), POSEPACK_ERROR_LIMIT},
        {"F9", "no row", header_u32(POSEPACK_HDR_ROW_COUNT, 0), POSEPACK_ERROR_LIMIT},
        {"F9", "65537 rows", header_u32(POSEPACK_HDR_ROW_COUNT, 65537), POSEPACK_ERROR_LIMIT},
        {"F10", "no clip", header_u32(POSEPACK_HDR_CLIP_COUNT, 0), POSEPACK_ERROR_LIMIT},
        {"F10", "4097 clips", header_u32(POSEPACK_HDR_CLIP_COUNT, 4097), POSEPACK_ERROR_LIMIT},
        {"F11", "a required feature", header_u32(POSEPACK_HDR_REQUIRED_FEATURES, 1u << 31),
         POSEPACK_ERROR_UNKNOWN_REQUIRED},
        {"F12", "table before the header ends", header_u32(POSEPACK_HDR_TABLE_OFFSET, 120),
         POSEPACK_ERROR_SECTION},
        {"F12", "table far outside", header_u32(POSEPACK_HDR_TABLE_OFFSET, 0xFFFFFFF0),
         POSEPACK_ERROR_SECTION},
    });
}

TEST(Open, AtTheLimitsTheAnswerIsAnotherOne) {
    run({
        {"F7", "32 sections read fill as entries", header_u32(POSEPACK_HDR_SECTION_COUNT, 32),
         POSEPACK_ERROR_SECTION},
        {"F8", "1024 bones", header_u32(POSEPACK_HDR_BONE_COUNT, 1024), POSEPACK_ERROR_SEMANTIC},
        {"F9", "65536 rows", header_u32(POSEPACK_HDR_ROW_COUNT, 65536), POSEPACK_ERROR_SEMANTIC},
        {"F10", "4096 clips", header_u32(POSEPACK_HDR_CLIP_COUNT, 4096), POSEPACK_ERROR_SEMANTIC},
    });
}

TEST(Open, AFileOver256MiBIsRefusedBeforeItIsRead) {
    // Only the header is there: a loader that read on would leave the buffer.
    Bytes header = make_container();
    header.resize(POSEPACK_HEADER_BYTES);
    put_u64(header, POSEPACK_HDR_FILE_BYTES, std::uint64_t{POSEPACK_MAX_FILE_BYTES} + 1);
    seal_header(header);
    posepack_view view;
    EXPECT_EQ(posepack_open(&view, header.data(), std::size_t{POSEPACK_MAX_FILE_BYTES} + 1),
              POSEPACK_ERROR_LIMIT);
}

TEST(Open, ATableThatLeavesTheFileIsRefused) {
    Bytes header = make_container();
    header.resize(POSEPACK_HEADER_BYTES + 6 * POSEPACK_ENTRY_BYTES - 1);
    put_u64(header, POSEPACK_HDR_FILE_BYTES, header.size());
    seal_header(header);
    EXPECT_EQ(open_name(header), "SECTION");  // F12
}

TEST(Open, AnyBitOfTheHeaderPastByte15) {  // P10
    Bytes bytes = make_container();
    for (std::size_t bit = 16 * 8; bit < POSEPACK_HEADER_BYTES * 8; ++bit) {
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        ASSERT_EQ(open_name(bytes), "HEADER_CRC") << "F4: bit " << bit;
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    }
}

TEST(Open, AnyBitOfTheTable) {  // P11
    Bytes bytes = make_container();
    const std::size_t end = POSEPACK_HEADER_BYTES + 6 * POSEPACK_ENTRY_BYTES;
    for (std::size_t bit = POSEPACK_HEADER_BYTES * 8; bit < end * 8; ++bit) {
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        ASSERT_EQ(open_name(bytes), "TABLE_CRC") << "F13: bit " << bit;
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    }
}

TEST(Open, EntryRules) {
    constexpr std::uint32_t kPixl = POSEPACK_SECTION_PIXL;
    constexpr std::uint32_t kClip = POSEPACK_SECTION_CLIP;
    run({
        {"T1", "reserved word", entry_u32(kClip, POSEPACK_ENT_RESERVED, 1), POSEPACK_ERROR_SECTION},
        {"T2", "P22 a digit", entry_u32(kClip, POSEPACK_ENT_TYPE, POSEPACK_FOURCC('C', 'L', '1', 'P')),
         POSEPACK_ERROR_SECTION},
        {"T2", "below 'A'", entry_u32(kClip, POSEPACK_ENT_TYPE, POSEPACK_FOURCC('@', 'L', 'I', 'P')),
         POSEPACK_ERROR_SECTION},
        {"T2", "past 'z'", entry_u32(kClip, POSEPACK_ENT_TYPE, POSEPACK_FOURCC('C', 'L', 'I', '{')),
         POSEPACK_ERROR_SECTION},
        {"T2", "past 'Z'", entry_u32(kClip, POSEPACK_ENT_TYPE, POSEPACK_FOURCC('C', 'L', 'I', '[')),
         POSEPACK_ERROR_SECTION},
        {"T3", "P17 PIXL twice", parts([](Parts& p) { p.sections.push_back(p.sections.back()); }),
         POSEPACK_ERROR_SECTION_DUP},
        {"T3", "an optional section twice", parts([](Parts& p) {
             p.sections.push_back({POSEPACK_SECTION_PROV, {'{', '}'}});
             p.sections.push_back({POSEPACK_SECTION_PROV, {'{', '}'}});
         }),
         POSEPACK_ERROR_SECTION_DUP},
        {"T4", "P19 ABCD", parts([](Parts& p) {
             p.sections.push_back({POSEPACK_FOURCC('A', 'B', 'C', 'D'), {1, 2, 3}});
         }),
         POSEPACK_ERROR_UNKNOWN_REQUIRED},
        {"T5", "codec 3", entry_u32(kPixl, POSEPACK_ENT_FLAGS, 3), POSEPACK_ERROR_SECTION},
        {"T5", "a flag above the codec", entry_u32(kPixl, POSEPACK_ENT_FLAGS, 16), POSEPACK_ERROR_SECTION},
        {"T6", "a compressed table", entry_u32(kClip, POSEPACK_ENT_FLAGS, POSEPACK_CODEC_ZSTD),
         POSEPACK_ERROR_SECTION},
        {"T7", "raw_bytes of a stored section", entry_u64(kClip, POSEPACK_ENT_RAW_BYTES, 1),
         POSEPACK_ERROR_SECTION},
        {"T7", "raw_crc of a stored section",
         [](Bytes& bytes) {
             const std::size_t entry = entry_offset(bytes, kClip);
             put_u32(bytes, entry + POSEPACK_ENT_RAW_CRC, get_u32(bytes, entry + POSEPACK_ENT_RAW_CRC) ^ 1);
             seal_table(bytes);
         },
         POSEPACK_ERROR_SECTION},
        {"T8", "a table at 16", parts([](Parts& p) { p.sections[0].align_log2 = 4; }),
         POSEPACK_ERROR_SECTION},
        {"T8", "PIXL at 2048", parts([](Parts& p) { p.sections.back().align_log2 = 11; }),
         POSEPACK_ERROR_SECTION},
        {"T8", "an optional section at 4", parts([](Parts& p) {
             p.sections.push_back({POSEPACK_SECTION_PROV, {'{', '}'}, 0, 2});
         }),
         POSEPACK_ERROR_SECTION},
        {"T8", "an optional section at 8192", parts([](Parts& p) {
             p.sections.push_back({POSEPACK_SECTION_PROV, {'{', '}'}, 0, 13});
         }),
         POSEPACK_ERROR_SECTION},
        {"T10", "P14 the offset wraps", entry_u64(kClip, POSEPACK_ENT_OFFSET, ~std::uint64_t{63}),
         POSEPACK_ERROR_SECTION},
        {"T10", "a section on top of another", entry_u64(kPixl, POSEPACK_ENT_OFFSET, 0),
         POSEPACK_ERROR_SECTION},
        {"T10", "P16 64 bytes of gap too many, all zero",
         [](Bytes& bytes) {
             const std::size_t entry = entry_offset(bytes, POSEPACK_SECTION_STRS);
             const std::uint64_t offset = get_u64(bytes, entry + POSEPACK_ENT_OFFSET);
             bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(offset), 64, 0);
             put_u64(bytes, entry + POSEPACK_ENT_OFFSET, offset + 64);
             bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(section_offset(bytes, kPixl)) - 64,
                         bytes.begin() + static_cast<std::ptrdiff_t>(section_offset(bytes, kPixl)));
             seal(bytes);
         },
         POSEPACK_ERROR_SECTION},
        {"T11", "one byte longer than the file", entry_size(kPixl, 1), POSEPACK_ERROR_SECTION},
        {"T11", "nearly 2^64 long", entry_size(kPixl, ~std::uint64_t{4096}), POSEPACK_ERROR_SECTION},
        {"T11", "an empty section", parts([](Parts& p) {
             p.sections.push_back({POSEPACK_SECTION_PROV, {}});
         }),
         POSEPACK_ERROR_SECTION},
        {"T12", "P13 fill before PIXL",
         [](Bytes& bytes) {
             bytes[section_offset(bytes, kPixl) - 1] = 1;
             seal(bytes);
         },
         POSEPACK_ERROR_PADDING},
        {"T13", "bytes behind the last section",
         [](Bytes& bytes) {
             bytes.resize(bytes.size() + 8);
             put_u64(bytes, POSEPACK_HDR_FILE_BYTES, bytes.size());
             seal(bytes);
         },
         POSEPACK_ERROR_SECTION},
        {"T14", "one bit of a table", flip(POSEPACK_HEADER_BYTES + 6 * POSEPACK_ENTRY_BYTES, false),
         POSEPACK_ERROR_SECTION_CRC},
    });
}

TEST(Open, EachOfTheSixSectionsMustBeThere) {
    for (std::size_t i = 0; i < 6; ++i) {
        Parts pieces = make_parts();
        pieces.sections.erase(pieces.sections.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_EQ(open_name(assemble(pieces)), "SECTION_MISSING") << "T9: section " << i;
    }
}

TEST(Open, SectionsBehindTheEndOfTheFileAreRefused) {
    // The file ends where the fill before PIXL would begin: PIXL's place is right, and outside.
    Bytes bytes = make_container();
    const std::size_t strs = entry_offset(bytes, POSEPACK_SECTION_STRS);
    bytes.resize(get_u64(bytes, strs + POSEPACK_ENT_OFFSET) +
                 get_u64(bytes, strs + POSEPACK_ENT_STORED_BYTES));
    put_u64(bytes, POSEPACK_HDR_FILE_BYTES, bytes.size());
    seal(bytes);
    EXPECT_EQ(open_name(bytes), "SECTION");  // T10
}

TEST(Open, ASizeThatWrapsBackToTheStartIsRefused) {
    // The end of `wRAP` wraps to 512, where `over` lies on all other sections and ends with the file.
    Parts pieces = make_parts();
    pieces.sections.push_back({POSEPACK_FOURCC('w', 'R', 'A', 'P'), {1}});
    pieces.sections.push_back({POSEPACK_FOURCC('o', 'v', 'e', 'r'), {1}});
    Bytes bytes = assemble(pieces);
    const std::size_t wrap = entry_offset(bytes, POSEPACK_FOURCC('w', 'R', 'A', 'P'));
    const std::size_t over = entry_offset(bytes, POSEPACK_FOURCC('o', 'v', 'e', 'r'));
    const std::uint64_t wrapped = 512 - get_u64(bytes, wrap + POSEPACK_ENT_OFFSET);
    for (const std::size_t field : {POSEPACK_ENT_STORED_BYTES, POSEPACK_ENT_RAW_BYTES}) {
        put_u64(bytes, wrap + field, wrapped);
        put_u64(bytes, over + field, bytes.size() - 512);
    }
    put_u64(bytes, over + POSEPACK_ENT_OFFSET, 512);
    seal(bytes);
    EXPECT_EQ(open_name(bytes), "SECTION");  // T11
}

TEST(Open, UnknownOptionalSectionsAndFeaturesAreSkipped) {  // P20
    Parts pieces = make_parts();
    pieces.sections.push_back({POSEPACK_FOURCC('a', 'b', 'C', 'd'), {1, 2, 3}});
    pieces.sections.push_back({POSEPACK_FOURCC('z', 'S', 'T', 'D'), {9}, POSEPACK_CODEC_ZSTD, 12, 77});
    put_u32(pieces.header, POSEPACK_HDR_OPTIONAL_FEATURES, POSEPACK_OPTIONAL_ERROR_MEASURED | 0x80000000u);
    Bytes bytes = assemble(pieces);
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    EXPECT_EQ(view.header.section_count, 8u);
    bytes.back() ^= 1;  // skipped, and still checked
    EXPECT_EQ(open_name(bytes), "SECTION_CRC");
}

TEST(Open, SectionsMayComeInAnyOrder) {
    Parts pieces = make_parts();
    std::reverse(pieces.sections.begin(), pieces.sections.end());
    EXPECT_EQ(open_name(assemble(pieces)), "OK");
}

TEST(Open, AsManySectionsAsTheLimitAllows) {
    Parts pieces = make_parts();
    for (char letter = 'a'; pieces.sections.size() < POSEPACK_MAX_SECTIONS; ++letter) {
        pieces.sections.push_back({POSEPACK_FOURCC('x', 'x', 'x', letter), {1}});
    }
    EXPECT_EQ(open_name(assemble(pieces)), "OK");
}

}  // namespace
}  // namespace posepack::test
