// SPDX-License-Identifier: MIT
// Fuzz target: bytes to the loader. They are opened as they are, and once more with every checksum made
// and draft number made right, so that what lies behind them is met too, and files of older drafts stay of
// use. Whatever opens is read completely.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "container_builder.hpp"
#include "fuzz/target.hpp"
#include "posepack/play.h"

namespace {

constexpr std::size_t kMaxInputBytes = 64u << 10;

void expect(bool is_right, const char* what) {
    if (is_right) return;
    std::fprintf(stderr, "open_container: expected %s\n", what);
    std::abort();
}

void read_tables(const posepack_view& view) {
    posepack_clip clip;
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        expect(posepack_get_clip(&view, c, &clip) == POSEPACK_OK, "every clip to be readable");
        expect(clip.first_row + clip.row_count <= view.header.row_count, "the rows of a clip in the palette");
        std::uint32_t row = 0;
        for (std::uint32_t cut = 0; cut < clip.cut_count; ++cut)
            expect(posepack_get_cut(&view, c, cut, &row) == POSEPACK_OK, "every cut to be readable");
    }
    std::uint32_t states = 0;
    std::uint32_t first = 0;
    expect(posepack_count_states(&view, &states, &first) == POSEPACK_OK, "states");
    posepack_state state;
    for (std::uint32_t s = 0; s < states; ++s)
        expect(posepack_get_state(&view, s, &state) == POSEPACK_OK && state.clip < view.header.clip_count,
               "every state to name a clip");
    posepack_bone bone;
    for (std::uint32_t b = 0; b < view.header.bone_count; ++b)
        expect(posepack_get_bone(&view, b, &bone) == POSEPACK_OK, "every bone to be readable");
    posepack_space space;
    expect(posepack_get_space(&view, &space) == POSEPACK_OK, "spaces");
    posepack_mesh mesh;
    for (std::uint32_t m = 0; m < space.mesh_count; ++m) {
        expect(posepack_get_mesh(&view, m, &mesh) == POSEPACK_OK, "every mesh to be readable");
        for (std::uint32_t j = 0; j < mesh.joint_count; ++j) {
            std::uint32_t mapped = 0;
            expect(posepack_map_joint(&view, m, j, &mapped) == POSEPACK_OK && mapped < view.header.bone_count,
                   "every joint to name a bone");
        }
    }
}

void read_poses(const posepack_view& view) {
    std::vector<float> matrices(std::size_t{view.header.bone_count} * 12);
    const bool uniform = view.header.row_scheme == POSEPACK_ROWS_UNIFORM;
    for (std::uint32_t row = 0; row < view.header.row_count; ++row)
        expect(posepack_decode_row(&view, row, matrices.data()) ==
                   (uniform ? POSEPACK_OK : POSEPACK_ERROR_UNSUPPORTED),
               "every row to decode, and none of runs");
    posepack_run run;
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        for (const float phase : {0.0f, 0.37f, 1.0f})
            expect(posepack_sample_pose(&view, c, phase, matrices.data()) == POSEPACK_OK,
                   "every clip to have poses");
        for (std::uint32_t b = 0; b < view.header.bone_count; ++b)
            expect(posepack_get_run(&view, c, b, &run) == POSEPACK_OK, "every bone to have a run");
    }
}

// Every clip plays and fades into the next; a clip of a period near 0 may be refused as too fast.
void play_clips(const posepack_view& view) {
    std::vector<float> matrices(std::size_t{view.header.bone_count} * 12);
    const posepack_limits limits = {16, 4096, POSEPACK_CLOCK_S};
    posepack_track track, next;
    posepack_play play;
    posepack_moment moment;
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        const std::uint32_t other = (c + 1) % view.header.clip_count;
        if (posepack_start_track(&view, c, 1.0, 0.3, 1e6, POSEPACK_CLOCK_S, &track) != POSEPACK_OK ||
            posepack_start_track(&view, other, -0.7, 0.9, 1e6 + 2.0, POSEPACK_CLOCK_S, &next) != POSEPACK_OK)
            continue;
        expect(posepack_start_play(&play, &track) == POSEPACK_OK &&
                   posepack_fade_play(&play, &next, 1.0) == POSEPACK_OK,
               "every clip to fade");
        for (const double time_s : {1e6, 1e6 + 2.4, 1e6 + 1e5})
            expect(posepack_find_moment(&view, &play, time_s, &moment) == POSEPACK_OK &&
                       posepack_show_pose(&view, &moment, matrices.data()) == POSEPACK_OK &&
                       moment.phase >= 0.0f && moment.phase <= 1.0f,
                   "every moment to be shown");
        std::uint64_t passes = 0;
        expect(posepack_count_passes(&view, &track, 0.5, 0.0, 2e6, &passes) == POSEPACK_OK, "passes");
        for (std::uint32_t layout = 0; layout <= POSEPACK_LAYOUT_GODOT; ++layout) {
            std::uint32_t breaks = 0;
            expect(posepack_check_packet(&view, &play, layout, &limits, &breaks) == POSEPACK_OK,
                   "every packet to be checked");
        }
    }
}

void open_and_read(const std::vector<std::uint8_t>& bytes) {
    posepack_view view;
    const posepack_result opened = posepack_open(&view, bytes.data(), bytes.size());
    posepack::fuzz::note_outcome(posepack_result_name(opened));
    if (opened != POSEPACK_OK) return;
    read_tables(view);
    read_poses(view);
    play_clips(view);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > kMaxInputBytes) return 0;
    std::vector<std::uint8_t> bytes(data, data + size);
    open_and_read(bytes);
    if (size < POSEPACK_HEADER_BYTES) return 0;
    posepack::test::put_u16(bytes, POSEPACK_HDR_MINOR, POSEPACK_FORMAT_MINOR);
    posepack::test::seal(bytes);
    open_and_read(bytes);
    return 0;
}
