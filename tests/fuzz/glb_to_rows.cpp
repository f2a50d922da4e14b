// SPDX-License-Identifier: MIT
// Fuzz target: the bytes of a GLB, through reader, sampler, encoder, container writer, loader and
// measurement, to finished rows. One call of bake_animal is what `posepack bake` makes of a model; harnesses
// that stop at the parser miss what lies behind it.
//
// Beyond crashes and sanitizer reports it holds that whatever was baked opens, that every matrix read back is
// finite, and that no input leads to E-INTERNAL or to a container which our own loader refuses.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "animal/read_animal.hpp"
#include "bake/bake_animal.hpp"
#include "fuzz/target.hpp"
#include "posepack/loader.h"
#include "recipe/catalog.hpp"

namespace {

using namespace posepack;

// What one run may cost. Larger models are read, and then left: the same code would only run longer.
constexpr std::size_t kMaxInputBytes = 256u << 10;
constexpr std::size_t kMaxBones = 96;
constexpr std::size_t kMaxVertices = 1'024;
constexpr std::size_t kMaxClips = 12;
constexpr std::size_t kMaxKeys = 8'192;
constexpr double kMaxTotalS = 2.0;  // of all clips: at most 240 rows a second

bool is_quick(const animal::Animal& animal) {
    double total_s = 0.0;
    for (const animal::Clip& clip : animal.clips) total_s += clip.duration_s;
    return animal.bones.size() <= kMaxBones && animal.vertices.positions.size() <= kMaxVertices &&
           animal.clips.size() <= kMaxClips && animal.key_times.size() <= kMaxKeys && total_s <= kMaxTotalS;
}

// The bits of `choice` choose among all layouts, so that a corpus holds each of them.
recipe::AnimalEntry entry_of(unsigned choice) {
    recipe::AnimalEntry entry;
    entry.id = "animal";
    entry.model = "animal.glb";
    entry.keywords = recipe::default_keywords();
    entry.canonical_json = "{}";
    entry.output.encoding = choice & 1u ? recipe::Encoding::mat4 : recipe::Encoding::affine;
    entry.output.texel_format = choice & 2u ? recipe::TexelFormat::rgba32f : recipe::TexelFormat::rgba16f;
    entry.output.texel_order = choice & 4u ? recipe::TexelOrder::planar : recipe::TexelOrder::bone_major;
    entry.output.row_pitch = choice & 8u ? recipe::RowPitch::align256 : recipe::RowPitch::tight;
    entry.output.influences = choice & 32u ? 8 : 4;
    entry.output.unused_bones = choice & 64u ? recipe::UnusedBones::drop : recipe::UnusedBones::keep;
    if (choice & 128u) entry.output.bound = recipe::ErrorBound{{0.05}, recipe::ErrorLimit{0.02}, {}};
    return entry;
}

[[noreturn]] void fail(const char* what, const char* detail) {
    std::fprintf(stderr, "glb_to_rows: %s: %s\n", what, detail);
    std::abort();
}

void check_rows(const base::Bytes& container) {
    posepack_view view;
    const posepack_result opened = posepack_open(&view, container.data(), container.size());
    if (opened != POSEPACK_OK) fail("the container does not open", posepack_result_name(opened));
    std::vector<float> matrices(std::size_t{view.header.bone_count} * 12);
    const auto check_finite = [&] {
        for (const float value : matrices)
            if (!std::isfinite(value)) fail("expected finite matrices", "found another number");
    };
    const bool is_uniform = view.header.row_scheme == POSEPACK_ROWS_UNIFORM;
    for (std::uint32_t row = 0; row < view.header.row_count && is_uniform; ++row) {
        if (posepack_decode_row(&view, row, matrices.data()) != POSEPACK_OK)
            fail("expected every row to decode", "found one that does not");
        check_finite();
    }
    for (std::uint32_t clip = 0; clip < view.header.clip_count; ++clip)
        for (const float phase : {0.0f, 0.1f, 0.37f, 0.5f, 0.93f, 1.0f}) {
            if (posepack_sample_pose(&view, clip, phase, matrices.data()) != POSEPACK_OK)
                fail("expected every clip to have poses", "found one that has none");
            check_finite();
        }
}

void check_issue(const base::Issue& issue) {
    if (issue.code == base::IssueCode::internal || issue.code == base::IssueCode::pack_invalid)
        fail("expected a reason that lies in the input", issue.detail.c_str());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > kMaxInputBytes) return 0;
    // The last byte seldom means anything: JSON and BIN chunk both end in padding.
    const unsigned choice = size == 0 ? 0u : data[size - 1];
    const std::span<const std::uint8_t> glb(data, size);
    const bool strict = (choice & 16u) != 0;
    const auto animal = animal::read_animal(glb, {strict});
    fuzz::note_outcome(animal ? "read" : base::format_issue(animal.issue()));
    if (!animal) {
        check_issue(animal.issue());
        return 0;
    }
    if (!is_quick(animal.value())) return 0;
    bake::AnimalOptions options;
    options.strict = strict;
    options.compare_vat = true;
    const auto baked = bake::bake_animal(entry_of(choice), glb, options);
    if (!baked) {
        fuzz::note_outcome(base::format_issue(baked.issue()));
        check_issue(baked.issue());
        return 0;
    }
    fuzz::note_outcome("baked");
    for (const base::Issue& finding : baked.value().findings) fuzz::note_outcome(base::format_issue(finding));
    check_rows(baked.value().container);
    return 0;
}
