// SPDX-License-Identifier: MIT
#include "run_cases.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "changes.hpp"

namespace posepack::test {
namespace {

constexpr std::uint8_t kMat4 = POSEPACK_ENCODING_MAT4, kAffine = POSEPACK_ENCODING_AFFINE;
constexpr std::uint8_t kDualquat = POSEPACK_ENCODING_DUALQUAT;

const auto kAsItIs = [](Parts&) {};

// Of the tiny container with runs: offsets of the bytes of RGBA16F texels.
constexpr std::size_t kAffineRowBytes = 24, kMat4RowBytes = 32, kDualquatRowBytes = 16;
constexpr std::size_t kIdleRows = 4, kWalkRows = 19, kAllRows = kIdleRows + kWalkRows;

Section& section_of(Parts& p, std::uint32_t type) {
    return *std::find_if(p.sections.begin(), p.sections.end(),
                         [type](const Section& section) { return section.type == type; });
}

RunOptions with_idle_runs(const std::array<std::uint32_t, 3>& runs) {
    RunOptions options = tiny_runs();
    options.clips[0].runs = runs;
    return options;
}

// Every bone of walk keeps still in its only bone-row.
RunOptions with_still_walk() {
    RunOptions options = tiny_runs();
    options.clips[1].runs = {0, 0, 0};
    return options;
}

RunOptions turned_walk() {
    RunOptions options = tiny_runs(kDualquat, kDualquat);
    options.clips[1].turned = 2;
    return options;
}

// The header says that clips differ.
void mix(Parts& p) {
    p.header[POSEPACK_HDR_ENCODING] = POSEPACK_MIXED;
    p.header[POSEPACK_HDR_TEXELS_PER_BONE] = POSEPACK_MIXED;
    put_f32(p.header, POSEPACK_HDR_DUALQUAT_LENGTH, kTinyDualquatLength);
}

void append(std::vector<RunCase>& cases, std::vector<RunCase> more) {
    cases.insert(cases.end(), more.begin(), more.end());
}

std::vector<RunCase> framing() {
    return {
        {"T3", "RUNS twice", [](Parts& p) { p.sections.push_back(section_of(p, kRuns)); },
         POSEPACK_ERROR_SECTION_DUP},
        {"T6", "compressed RUNS", [](Parts& p) { section_of(p, kRuns).flags = POSEPACK_CODEC_ZSTD; },
         POSEPACK_ERROR_SECTION},
        {"T8", "RUNS at 16", [](Parts& p) { section_of(p, kRuns).align_log2 = 4; }, POSEPACK_ERROR_SECTION},
        {"T9", "no RUNS", [](Parts& p) { p.sections.erase(p.sections.end() - 2); },
         POSEPACK_ERROR_SECTION_MISSING},
        {"T9", "uniform rows that call themselves runs",
         [](Parts& p) {
             p = make_parts();
             p.header[POSEPACK_HDR_ROW_SCHEME] = POSEPACK_ROWS_RUNS;
         },
         POSEPACK_ERROR_SECTION_MISSING},
        {"T10", "RUNS behind PIXL", [](Parts& p) { p.move_to_end(kRuns); }, POSEPACK_OK},
        {"T11", "empty RUNS", resize(kRuns, -24), POSEPACK_ERROR_SECTION},
    };
}

std::vector<RunCase> header_values() {
    const RunOptions mixed = tiny_runs(kAffine, kDualquat);
    return {
        {"H1", "encoding 0", header_u8(POSEPACK_HDR_ENCODING, 0)},
        {"H1", "local", header_u8(POSEPACK_HDR_ENCODING, 4), POSEPACK_ERROR_UNSUPPORTED},
        {"H1", "packed", header_u8(POSEPACK_HDR_ENCODING, 5), POSEPACK_ERROR_UNSUPPORTED},
        {"H3", "transposed", header_u8(POSEPACK_HDR_TEXEL_ORDER, 2), POSEPACK_ERROR_UNSUPPORTED},
        {"H4", "slots in every clip", header_u8(POSEPACK_HDR_ROW_SCHEME, 1), POSEPACK_ERROR_UNSUPPORTED},
        {"H4", "row schemes that differ", header_u8(POSEPACK_HDR_ROW_SCHEME, 255),
         POSEPACK_ERROR_UNSUPPORTED},
        {"H5", "one encoding, texels that differ", header_u8(POSEPACK_HDR_TEXELS_PER_BONE, 255)},
        {"H5", "encodings that differ, three texels", header_u8(POSEPACK_HDR_TEXELS_PER_BONE, 3),
         POSEPACK_ERROR_SEMANTIC, mixed},
        {"H9", "encodings that differ, length 0", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, 0),
         POSEPACK_ERROR_SEMANTIC, mixed},
        {"H9", "encodings that differ, length NaN", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kNaN),
         POSEPACK_ERROR_SEMANTIC, mixed},
        {"H9", "length 0 though no clip is a dualquat", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, 0),
         POSEPACK_ERROR_SEMANTIC, tiny_runs(kMat4, kAffine)},
        {"H9", "a length for affine", header_u32(POSEPACK_HDR_DUALQUAT_LENGTH, kOne)},
        {"H10", "RUNS beside uniform rows, with which they agree",
         [](Parts& p) {
             Section runs = section_of(p, kRuns);
             const std::array<std::uint32_t, 6> words = {run_word(0, 0), run_word(1, 0), run_word(2, 0),
                                                         run_word(0, 3), run_word(4, 3), run_word(8, 3)};
             for (std::size_t i = 0; i < words.size(); ++i) put_u32(runs.bytes, 4 * i, words.at(i));
             p = make_parts();
             p.sections.push_back(runs);
         }},
    };
}

std::vector<RunCase> clips() {
    const RunOptions mixed = tiny_runs(kAffine, kDualquat);
    return {
        {"C3", "a clip unlike the header",
         [](Parts& p) {
             p.header[POSEPACK_HDR_ENCODING] = kAffine;
             p.header[POSEPACK_HDR_TEXELS_PER_BONE] = 3;
             put_u32(p.header, POSEPACK_HDR_DUALQUAT_LENGTH, 0);
         },
         POSEPACK_ERROR_SEMANTIC, mixed},
        {"C3", "no clip is like the header",
         [](Parts& p) {
             p.header[POSEPACK_HDR_ENCODING] = kMat4;
             p.header[POSEPACK_HDR_TEXELS_PER_BONE] = 4;
         }},
        {"C3", "clips that do not differ", mix},
        {"C3", "encoding 0", u8(kClip, kIdle + POSEPACK_CLIP_ENCODING, 0), POSEPACK_ERROR_SEMANTIC, mixed},
        {"C3", "a clip of local", u8(kClip, kWalk + POSEPACK_CLIP_ENCODING, 4), POSEPACK_ERROR_SEMANTIC,
         mixed},
        {"C3", "a clip of clips that differ", u8(kClip, kWalk + POSEPACK_CLIP_ENCODING, 255),
         POSEPACK_ERROR_SEMANTIC, mixed},
        {"C3", "texels of another encoding", u8(kClip, kWalk + POSEPACK_CLIP_TEXELS_PER_BONE, 3),
         POSEPACK_ERROR_SEMANTIC, mixed},
        {"C3", "a clip of uniform rows", u8(kClip, kWalk + POSEPACK_CLIP_ROW_SCHEME, 0)},
        {"C5", "a closing row",
         [](Parts& p) {
             p[kClip][kWalk + POSEPACK_CLIP_CLOSING_ROW] = 1;
             put_u32(p.header, POSEPACK_HDR_ROW_COUNT, 3 + 14 + 1);
         },
         POSEPACK_ERROR_SEMANTIC, tiny_runs(kDualquat, kDualquat)},
        {"C6", "a row of no clip", header_u32(POSEPACK_HDR_ROW_COUNT, 3 + 14 + 1)},
        {"C6", "a gap between clips", u32(kClip, kWalk + POSEPACK_CLIP_FIRST_ROW, 4)},
        {"C7", "a cut",
         [](Parts& p) {
             p[kClip].resize(p[kClip].size() + 4);
             put_u32(p[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 1);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 1);
         }},
        {"C7", "a cut of no clip",
         [](Parts& p) {
             p[kClip].resize(p[kClip].size() + 4);
             put_u32(p[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 1);
         }},
        {"C8", "a rate though all bones keep still", u32(kClip, kIdle + POSEPACK_CLIP_RATE_HZ, kOne),
         POSEPACK_ERROR_SEMANTIC, with_idle_runs({0, 0, 0})},
        {"C8", "all bones keep still, on one bone-row", kAsItIs, POSEPACK_OK, with_idle_runs({0, 0, 0})},
    };
}

std::vector<RunCase> runs() {
    return {
        {"R1", "a word too few", resize(kRuns, -4)},
        {"R1", "a word too many", resize(kRuns, 4)},
        {"R1", "a byte too many", resize(kRuns, 1)},
        {"R2", "planar", header_u8(POSEPACK_HDR_TEXEL_ORDER, POSEPACK_ORDER_PLANAR)},
        {"R3", "the first run begins at 1", nullptr, POSEPACK_ERROR_SEMANTIC,
         with_idle_runs({run_word(1, 2), run_word(4, 0), run_word(1, 1)})},
        {"R3", "a bone-row of no run", nullptr, POSEPACK_ERROR_SEMANTIC,
         with_idle_runs({run_word(0, 2), run_word(4, 0), run_word(1, 1)})},
        {"R3", "runs not in order", nullptr, POSEPACK_ERROR_SEMANTIC,
         with_idle_runs({run_word(3, 2), run_word(0, 2), run_word(1, 1)})},
        {"R3", "a run that leaves the rows before it", nullptr, POSEPACK_ERROR_SEMANTIC,
         with_idle_runs({run_word(0, 2), run_word(2, 1), run_word(1, 1)})},
        {"R3", "the last run begins within and ends behind", nullptr, POSEPACK_ERROR_SEMANTIC,
         with_idle_runs({run_word(0, 2), run_word(3, 0), run_word(1, 3)})},
        {"R3", "far outside", u32(kRuns, 20, 0xFFFFFFFF)},
        {"R3", "a hole in the last clip, of texels that are all alike",
         [](Parts& p) {
             Bytes& pixels = p[kPixl];
             for (std::size_t i = kAffineRowBytes; i < pixels.size(); ++i)
                 pixels[i] = pixels[i - kAffineRowBytes];
             put_u32(p[kRuns], 20, run_word(2, 0));
         },
         POSEPACK_ERROR_SEMANTIC, with_still_walk()},
        {"R3", "all rows before it, of two runs", kAsItIs, POSEPACK_OK,
         with_idle_runs({run_word(0, 2), run_word(3, 0), run_word(0, 3)})},
        {"R3", "every bone reads one run", kAsItIs, POSEPACK_OK,
         with_idle_runs({run_word(0, 5), run_word(0, 5), run_word(0, 5)})},
        {"R4", "a row more than the longest run",
         [](Parts& p) {
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 15);
             put_u32(p.header, POSEPACK_HDR_ROW_COUNT, 3 + 15);
         }},
        {"R4", "a row less than the longest run",
         [](Parts& p) {
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_ROW_COUNT, 13);
             put_u32(p.header, POSEPACK_HDR_ROW_COUNT, 3 + 13);
         }},
        {"R4", "the longest run is an alias", kAsItIs, POSEPACK_OK,
         with_idle_runs({run_word(0, 1), run_word(2, 1), run_word(0, 3)})},
        {"R5", "the first clip begins at texel 3", u32(kClip, kIdle + POSEPACK_CLIP_FIRST_TEXEL, 3)},
        {"R5", "a clip begins where its rows would be uniform",
         u32(kClip, kWalk + POSEPACK_CLIP_FIRST_TEXEL, 3 * 3 * 3)},
    };
}

std::vector<RunCase> slots() {
    // SLOT of tiny_slots: idle's words at 0, walk's at 8, its five slots from 16 on.
    const auto with_slots = [](std::vector<std::uint32_t> words) {
        RunOptions options = tiny_slots();
        options.clips[1].slots = std::move(words);
        return options;
    };
    const RunOptions good = tiny_slots();
    std::vector<RunCase> cases = {
        {"H10", "SLOT beside uniform rows",
         [](Parts& p) {
             Section slots = section_of(p, kSlot);
             p = make_parts();
             p.sections.push_back(slots);
         }},
        {"C3", "a clip of slots among uniform rows",
         [](Parts& p) {
             p = make_parts();
             p[kClip][kWalk + POSEPACK_CLIP_ROW_SCHEME] = POSEPACK_ROWS_SLOTS;
         }},
        {"C7", "a cut in a clip with slots",
         [](Parts& p) {
             p[kClip].resize(p[kClip].size() + 4);
             put_u32(p[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 1);
             put_u32(p[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 1);
         }},
        {"L1", "slots without SLOT",
         [](Parts& p) {
             std::erase_if(p.sections, [](const Section& section) { return section.type == kSlot; });
         }},
        {"L1", "SLOT without slots", u8(kClip, kWalk + POSEPACK_CLIP_ROW_SCHEME, POSEPACK_ROWS_RUNS)},
        {"L2", "no room for a clip", resize(kSlot, -24)},
        {"L3", "the first clip begins at slot 1", u32(kSlot, 0, 1)},
        {"L3", "the second clip begins at slot 1", u32(kSlot, 8, 1)},
        {"L3", "a slot of a clip without", u32(kSlot, 4, 1)},
        {"L3", "a clip of slots that has none", u32(kSlot, 12, 0)},
        {"L3", "more slots than there are", u32(kSlot, 12, 6)},
        {"L3", "slots without end", u32(kSlot, 12, 0xFFFFFFFF)},
        {"L4", "the offset is the span", u32(kSlot, 16, slot_word(0, 2, 2))},
        {"L4", "from the last row on", u32(kSlot, 32, slot_word(6, 0, 1))},
        {"L4", "far behind the last row", u32(kSlot, 32, slot_word(0xFFFF, 0, 255))},
        {"L4", "intervals behind the last row", u32(kSlot, 32, slot_word(5, 2, 0))},
        {"L4", "the last row held", u32(kSlot, 32, slot_word(6, 0, 0)), POSEPACK_OK},
        {"L4", "all intervals in one slot", u32(kSlot, 32, slot_word(0, 6, 0)), POSEPACK_OK},
        {"L4", "one of 255 slots", u32(kSlot, 32, slot_word(5, 254, 255)), POSEPACK_OK},
        {"L4", "a held row behind the last", u32(kSlot, 32, slot_word(7, 0, 0))},
        {"L5", "a run of fewer intervals", u32(kRuns, 16, run_word(7, 5))},
        {"L5", "one held row", kAsItIs, POSEPACK_OK, with_slots({slot_word(0, 0, 0)})},
        {"L6", "a slot too many", resize(kSlot, 4)},
        {"L6", "a byte too many", resize(kSlot, 1)},
        {"T6", "compressed SLOT", [](Parts& p) { section_of(p, kSlot).flags = POSEPACK_CODEC_ZSTD; },
         POSEPACK_ERROR_SECTION},
        {"T10", "SLOT behind PIXL", [](Parts& p) { p.move_to_end(kSlot); }, POSEPACK_OK},
    };
    for (RunCase& test : cases)
        if (test.options.clips[1].slots.empty()) test.options = good;
    return cases;
}

// Makes the pixels of affine halves so long: longer by what is behind the last bone-row anyway.
void repeat_last_row(Bytes& pixels, std::size_t size) {
    while (pixels.size() < size) pixels.push_back(pixels[pixels.size() - kAffineRowBytes]);
    pixels.resize(size);
}

// Makes the texture so wide and high, and PIXL as long, its last bone-row repeated.
std::function<void(Parts&)> texture(std::uint32_t width, std::uint32_t height) {
    return [=](Parts& p) {
        put_u32(p.header, POSEPACK_HDR_TEXTURE_WIDTH, width);
        put_u32(p.header, POSEPACK_HDR_TEXTURE_HEIGHT, height);
        put_u32(p.header, POSEPACK_HDR_ROW_PITCH, width * 8);
        repeat_last_row(p[kPixl], std::size_t{width} * height * 8);
    };
}

// 11 clips of 1,024 bones of 1,024 bone-rows: 2^20 x 11 x 3 texels. Nothing is stored of them.
void make_huge(Parts& p) {
    const std::uint32_t bones = 1024, rows = 1024, clips = 11, width = 16384;
    const std::uint64_t texels = std::uint64_t{bones} * rows * clips * 3 + 3;
    const auto height = static_cast<std::uint32_t>((texels + width - 1) / width);
    put_u32(p.header, POSEPACK_HDR_BONE_COUNT, bones);
    put_u32(p.header, POSEPACK_HDR_ROW_COUNT, rows * clips);
    put_u32(p.header, POSEPACK_HDR_TEXTURE_WIDTH, width);
    put_u32(p.header, POSEPACK_HDR_TEXTURE_HEIGHT, height);
    put_u32(p.header, POSEPACK_HDR_ROW_PITCH, width * 8);
    p[kRuns].assign(std::size_t{POSEPACK_RUN_BYTES} * bones * clips, 0);
    for (std::uint32_t clip = 0; clip < clips; ++clip) {
        const std::size_t record = kIdle + clip * POSEPACK_CLIP_RECORD_BYTES;
        put_u32(p[kClip], record + POSEPACK_CLIP_FIRST_ROW, rows * clip);
        put_u32(p[kClip], record + POSEPACK_CLIP_ROW_COUNT, rows);
        put_u32(p[kClip], record + POSEPACK_CLIP_FIRST_TEXEL, bones * rows * clip * 3);
        for (std::uint32_t bone = 0; bone < bones; ++bone)
            put_u32(p[kRuns], POSEPACK_RUN_BYTES * (clip * bones + bone), run_word(rows * bone, rows - 1));
    }
    p[kBone] = Bytes(POSEPACK_BONE_HEAD_BYTES + bones * POSEPACK_BONE_RECORD_BYTES);
    put_u32(p[kBone], POSEPACK_BONE_HEAD_COUNT, bones);
    put_u32(p[kBone], POSEPACK_BONE_HEAD_RECORD_BYTES, POSEPACK_BONE_RECORD_BYTES);
    for (std::size_t bone = 0; bone < bones; ++bone)
        put_u32(p[kBone], POSEPACK_BONE_HEAD_BYTES + POSEPACK_BONE_RECORD_BYTES * bone + POSEPACK_BONE_PARENT,
                POSEPACK_NONE);
    for (const std::size_t mesh : {kMesh0, kMesh1}) {
        put_u32(p[kSpac], mesh + POSEPACK_MESH_FIRST_JOINT, 0);
        put_u32(p[kSpac], mesh + POSEPACK_MESH_JOINT_COUNT, 0);
    }
    section_of(p, kPixl).flags = POSEPACK_CODEC_ZSTD;
    section_of(p, kPixl).raw_bytes = std::uint64_t{width} * 8 * height;
}

RunOptions clips_of_affine(std::size_t count) {
    RunOptions options = tiny_runs();
    options.clips.resize(count, options.clips[0]);
    return options;
}

// Its bone-rows end with the first line: the row behind the last needs another.
RunOptions full_line() {
    RunOptions options = tiny_runs(kDualquat, kDualquat);
    options.clips[1].runs[1] = run_word(5, 22);
    return options;
}

std::vector<RunCase> geometry() {
    return {
        {"G1", "no row a line", header_u32(POSEPACK_HDR_ROWS_PER_LINE, 0)},
        {"G1", "two rows a line", header_u32(POSEPACK_HDR_ROWS_PER_LINE, 2)},
        {"G2", "wider than it must be", texture(128, 1)},
        {"G2", "narrower than 64", texture(32, 3)},
        {"G3", "a line too many", texture(64, 3)},
        {"G3", "a line too few", texture(64, 1)},
        {"G3", "no line for the row behind the last",
         [](Parts& p) {
             put_u32(p.header, POSEPACK_HDR_TEXTURE_HEIGHT, 1);
             p[kPixl].resize(512);
         },
         POSEPACK_ERROR_SEMANTIC, full_line()},
        {"G3", "a line for the row behind the last", kAsItIs, POSEPACK_OK, full_line()},
        {"G4", "a pitch of 256 bytes more",
         [](Parts& p) {
             repeat_last_row(p[kPixl], 2 * 768);
             put_u32(p.header, POSEPACK_HDR_ROW_PITCH, 768);
         }},
        {"G5", "eight bytes too many", [](Parts& p) { repeat_last_row(p[kPixl], 2 * 512 + 8); }},
        {"G5", "a line less", resize(kPixl, -512)},
        {"G6", "more than 2^28 bytes of texels", make_huge, POSEPACK_ERROR_SEMANTIC, clips_of_affine(11)},
    };
}

std::vector<RunCase> texels() {
    const auto compress = [](Parts& p) {
        section_of(p, kPixl).raw_bytes = p[kPixl].size();
        section_of(p, kPixl).flags = POSEPACK_CODEC_ZSTD;
        p[kPixl].resize(100);
    };
    const std::size_t walk = kIdleRows * kAffineRowBytes, end = kAllRows * kAffineRowBytes;
    return {
        {"X5", "compressed", compress, POSEPACK_ERROR_NEEDS_DECODE},
        {"X5", "compressed, and a run too long",
         [=](Parts& p) {
             compress(p);
             put_u32(p[kRuns], 0, run_word(0, 3));
         }},
        {"X1", "NaN in the first texel", u16(kPixl, 0, 0x7E00)},
        {"X1", "infinity in the middle", u16(kPixl, walk + 24, 0x7C00)},
        {"X1", "the largest half", u16(kPixl, 24, 0x7BFF), POSEPACK_OK},
        {"X3", "the first byte behind the last row", u8(kPixl, end, 1)},
        {"X3", "the last byte", [](Parts& p) { p[kPixl].back() ^= 1; }},
        {"X3", "zero bytes", [=](Parts& p) { std::fill(p[kPixl].begin() + end, p[kPixl].end(), 0); }},
        {"X8", "root of the loop does not close", u16(kPixl, walk + 4 * 24, 0x3C00)},
        {"X8", "tail's last number differs",
         [=](Parts& p) {
             p[kPixl][end - 1] ^= 1;
             for (std::size_t i = end; i < p[kPixl].size(); ++i) p[kPixl][i] = p[kPixl][i - 24];
         }},
        {"X8", "an affine closes with all signs turned",
         [=](Parts& p) {
             for (std::size_t i = walk + 4 * 24 + 1; i < walk + 5 * 24; i += 2) p[kPixl][i] ^= 0x80;
         }},
        {"X8", "a run within the loop's that does not close", u32(kRuns, 20, run_word(1, 2))},
    };
}

std::vector<RunCase> texels_of_mat4() {
    const RunOptions options = tiny_runs(kMat4, kMat4);
    // The fourth component of texel k of a bone-row.
    const auto fourth = [](std::size_t row, std::size_t k, std::uint16_t bits) {
        return u16(kPixl, row * kMat4RowBytes + 8 * k + 6, bits);
    };
    std::vector<RunCase> cases;
    for (const std::size_t row : {std::size_t{0}, std::size_t{2}, std::size_t{3}, kIdleRows + 7}) {
        for (std::size_t k = 0; k < 4; ++k) {
            cases.push_back({"X2", "half a unit", fourth(row, k, 0x3800), POSEPACK_ERROR_SEMANTIC, options});
            cases.push_back({"X2", "minus zero", fourth(row, k, 0x8000), POSEPACK_ERROR_SEMANTIC, options});
        }
    }
    return cases;
}

std::vector<RunCase> texels_of_dualquat() {
    const RunOptions options = tiny_runs(kDualquat, kDualquat);
    const auto real = [](std::size_t row, std::uint16_t x) {
        return [=](Parts& p) {
            for (std::size_t c = 0; c < 4; ++c)
                put_u16(p[kPixl], row * kDualquatRowBytes + 2 * c, c == 2 ? x : 0);
        };
    };
    const std::size_t middle = kIdleRows + 7, last = (kAllRows - 1) * kDualquatRowBytes;
    // Walk's tail ends at the last bone-row, of which the fill is made.
    const auto in_the_end = [=](std::size_t byte, std::uint8_t bits) {
        return [=](Parts& p) {
            for (std::size_t at = last + byte; at < p[kPixl].size(); at += kDualquatRowBytes)
                p[kPixl][at] ^= bits;
        };
    };
    return {
        {"X6", "zero", real(middle, 0), POSEPACK_ERROR_SEMANTIC, options},
        {"X6", "just below a quarter", real(middle, 0x33FF), POSEPACK_ERROR_SEMANTIC, options},
        {"X6", "just above two", real(1, 0x4001), POSEPACK_ERROR_SEMANTIC, options},
        {"X6", "zero in the first row", real(0, 0), POSEPACK_ERROR_SEMANTIC, options},
        {"X6", "zero in the last row of a run", real(2, 0), POSEPACK_ERROR_SEMANTIC, options},
        {"X6", "zero in the row of a bone that keeps still", real(3, 0), POSEPACK_ERROR_SEMANTIC, options},
        {"X6", "minus two", real(middle, 0xC000), POSEPACK_OK, options},
        {"X8", "one sign turned", in_the_end(7, 0x80), POSEPACK_ERROR_SEMANTIC, options},
        {"X8", "one sign turned back", in_the_end(15, 0x80), POSEPACK_ERROR_SEMANTIC, turned_walk()},
        {"X8", "turned, and another number", in_the_end(6, 0x01), POSEPACK_ERROR_SEMANTIC, turned_walk()},
        {"X8", "all signs turned", kAsItIs, POSEPACK_OK, turned_walk()},
    };
}

}  // namespace

std::vector<RunCase> run_cases() {
    std::vector<RunCase> cases;
    for (const auto& family :
         {framing, header_values, clips, runs, slots, geometry, texels, texels_of_mat4, texels_of_dualquat})
        append(cases, family());
    return cases;
}

}  // namespace posepack::test
