// SPDX-License-Identifier: MIT
// Clips at a phase: the rows that the specification names, under uniform rows and under runs, to the bit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "changes.hpp"
#include "format/dualquat.h"
#include "posepack/loader.h"
#include "runs_builder.hpp"

namespace posepack::test {
namespace {

constexpr std::uint32_t kIdleClip = 0, kWalkClip = 1;
using Matrix = std::array<float, 12>;
using Pose = std::array<Matrix, kTinyBoneCount>;

float* floats(Pose& pose) {
    return pose[0].data();
}

bool same_bits(const Pose& a, const Pose& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// A container that stays in memory as long as its view.
struct Opened {
    explicit Opened(const Parts& parts) : bytes(assemble(parts)) {
        EXPECT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    }

    // The pose of a clip; that each bone by itself is the same is seen to.
    Pose sample(std::uint32_t clip, float phase) const {
        Pose pose{};
        EXPECT_EQ(posepack_sample_pose(&view, clip, phase, floats(pose)), POSEPACK_OK);
        for (std::uint32_t bone = 0; bone < kTinyBoneCount; ++bone) {
            Matrix one{};
            EXPECT_EQ(posepack_sample_bone(&view, clip, phase, bone, one.data()), POSEPACK_OK);
            EXPECT_EQ(one, pose.at(bone)) << bone;
        }
        return pose;
    }

    Bytes bytes;
    posepack_view view{};
};

// What section 11 of the specification says of a phase: rows of the palette, and the factor of the second.
struct Place {
    float phase;
    std::uint32_t row0, row1;
    float factor;
};

void expect_places(const Parts& parts, const std::vector<Place>& places, const char* what) {
    const Opened palette(parts);
    for (const Place& place : places) {
        Pose expected{};
        ASSERT_EQ(posepack_blend_row(&palette.view, place.row0, place.row1, place.factor, floats(expected)),
                  POSEPACK_OK);
        EXPECT_TRUE(same_bits(palette.sample(kWalkClip, place.phase), expected))
            << what << " at " << place.phase;
    }
}

// The tiny container with another wrap of walk, and without its cut where a test wants none.
Parts uniform(const TinyOptions& options, std::uint8_t wrap, bool cut) {
    Parts parts = make_parts(options);
    parts[kClip][kWalk + POSEPACK_CLIP_WRAP] = wrap;
    if (cut) return parts;
    put_u32(parts[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, 0);
    put_u32(parts[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, 0);
    parts[kClip].resize(kCuts);
    return parts;
}

// Every encoding, format, order and number of rows a line that uniform rows come in.
std::vector<TinyOptions> layouts() {
    std::vector<TinyOptions> all;
    for (std::uint32_t i = 0; i < 3 * 2 * 2 * 3; ++i) {
        TinyOptions options;
        options.encoding = static_cast<std::uint8_t>(POSEPACK_ENCODING_MAT4 + i % 3);
        options.texel_format = i / 3 % 2 ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
        options.texel_order = i / 6 % 2 ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
        options.rows_per_line = i / 12 + 1;
        options.pad_pitch = options.rows_per_line == 2;
        all.push_back(options);
    }
    return all;
}

TEST(SampleUniform, LoopsBlendTheirLastRowIntoTheFirst) {  // walk: rows 1 to 4
    for (const TinyOptions& options : layouts()) {
        expect_places(uniform(options, POSEPACK_WRAP_LOOP, false),
                      {{0.f, 1, 1, 0.f},
                       {0.125f, 1, 2, 0.5f},
                       {0.25f, 2, 2, 0.f},
                       {0.4375f, 2, 3, 0.75f},
                       {0.625f, 3, 4, 0.5f},
                       {0.75f, 4, 4, 0.f},
                       {0.9375f, 4, 1, 0.75f},
                       {1.f, 4, 1, 1.f}},
                      "loop");
    }
}

TEST(SampleUniform, OthersEndAtTheirLastRow) {
    for (const TinyOptions& options : layouts()) {
        for (const std::uint8_t wrap : {POSEPACK_WRAP_ONCE, POSEPACK_WRAP_PING_PONG}) {
            expect_places(uniform(options, wrap, false),
                          {{0.f, 1, 1, 0.f},
                           {0.25f, 1, 2, 0.75f},
                           {0.5f, 2, 3, 0.5f},
                           {0.75f, 3, 4, 0.25f},
                           {1.f, 3, 4, 1.f}},
                          "once");
        }
    }
}

TEST(SampleUniform, ARowAtACutIsHeld) {  // row 3 is the cut
    for (const TinyOptions& options : layouts()) {
        expect_places(
            uniform(options, POSEPACK_WRAP_LOOP, true),
            {{0.4375f, 2, 3, 0.75f}, {0.5f, 3, 3, 0.f}, {0.7421875f, 3, 3, 0.f}, {0.75f, 4, 4, 0.f}},
            "loop with a cut");
        expect_places(uniform(options, POSEPACK_WRAP_ONCE, true),
                      {{0.5f, 2, 3, 0.5f}, {0.75f, 3, 3, 0.f}, {0.96875f, 3, 3, 0.f}, {1.f, 4, 4, 0.f}},
                      "once with a cut");
    }
}

TEST(SampleUniform, EachOfManyCutsIsFound) {
    for (std::uint32_t cuts = 0; cuts < 16; ++cuts) {  // bit r: row r of walk is a cut
        Parts parts = uniform({}, POSEPACK_WRAP_LOOP, false);
        std::uint32_t count = 0;
        for (std::uint32_t row = 0; row < 4; ++row) {
            if ((cuts >> row & 1) == 0) continue;
            parts[kClip].resize(kCuts + 4 * ++count);
            put_u32(parts[kClip], kCuts + 4 * (count - 1), row);
        }
        put_u32(parts[kClip], POSEPACK_CLIP_HEAD_CUT_COUNT, count);
        put_u32(parts[kClip], kWalk + POSEPACK_CLIP_CUT_COUNT, count);
        std::vector<Place> places;
        for (std::uint32_t row = 0; row < 4; ++row) {
            const float phase = 0.25f * static_cast<float>(row) + 0.125f;
            const bool held = (cuts >> row & 1) != 0;
            places.push_back({phase, row + 1, (row + 1) % 4 + 1, held ? 0.f : 0.5f});
        }
        expect_places(parts, places, "cuts");
    }
}

TEST(SampleUniform, StepsHoldEveryRow) {
    for (const TinyOptions& options : layouts()) {
        Parts loop = uniform(options, POSEPACK_WRAP_LOOP, false);
        loop[kClip][kWalk + POSEPACK_CLIP_INTERPOLATION] = POSEPACK_INTERPOLATION_STEP;
        expect_places(
            loop,
            {{0.f, 1, 1, 0.f}, {0.24f, 1, 1, 0.f}, {0.25f, 2, 2, 0.f}, {0.99f, 4, 4, 0.f}, {1.f, 1, 1, 0.f}},
            "steps of a loop");
        Parts once = uniform(options, POSEPACK_WRAP_ONCE, false);
        once[kClip][kWalk + POSEPACK_CLIP_INTERPOLATION] = POSEPACK_INTERPOLATION_STEP;
        expect_places(once, {{0.3f, 1, 1, 0.f}, {0.5f, 2, 2, 0.f}, {0.99f, 3, 3, 0.f}, {1.f, 4, 4, 0.f}},
                      "steps that end");
    }
}

TEST(SampleUniform, AClosingRowEndsItsLoop) {  // walk: rows 1 to 3, row 4 closes it
    for (TinyOptions options : layouts()) {
        if (options.encoding != POSEPACK_ENCODING_DUALQUAT) continue;
        options.closing_row = true;
        Parts parts = uniform(options, POSEPACK_WRAP_LOOP, false);
        expect_places(parts,
                      {{0.f, 1, 1, 0.f}, {0.25f, 1, 2, 0.75f}, {0.875f, 3, 4, 0.625f}, {1.f, 3, 4, 1.f}},
                      "closing row");
        parts[kClip][kWalk + POSEPACK_CLIP_INTERPOLATION] = POSEPACK_INTERPOLATION_STEP;
        expect_places(parts, {{0.6f, 2, 2, 0.f}, {0.9f, 3, 3, 0.f}, {1.f, 4, 4, 0.f}}, "steps, closing row");
    }
}

TEST(SampleUniform, AClipOfOneRowShowsItAtEveryPhase) {
    for (const std::uint8_t wrap : {POSEPACK_WRAP_LOOP, POSEPACK_WRAP_ONCE, POSEPACK_WRAP_PING_PONG}) {
        Parts parts = make_parts();
        parts[kClip][kIdle + POSEPACK_CLIP_WRAP] = wrap;
        const Opened palette(parts);
        Pose expected{};
        ASSERT_EQ(posepack_decode_row(&palette.view, 0, floats(expected)), POSEPACK_OK);
        for (const float phase : {0.f, 0.5f, 1.f})
            EXPECT_TRUE(same_bits(palette.sample(kIdleClip, phase), expected)) << phase;
    }
}

// Matrix of a clip's bone between bone-rows `row` and `row + 1`, made from the numbers that the builder
// stores.
Matrix run_matrix(const RunClip& clip, std::uint32_t first, std::uint32_t second, bool turned, float factor) {
    Matrix out{};
    if (clip.encoding != POSEPACK_ENCODING_DUALQUAT) {
        for (std::uint32_t e = 0; e < 12; ++e) {
            const float a = run_number(clip, first, e), b = run_number(clip, second, e);
            out.at(e) = factor == 0.f ? a : a * (1.f - factor) + b * factor;
        }
        return out;
    }
    posepack_dualquat a{}, b{};
    for (std::uint32_t c = 0; c < 4; ++c) {
        a.real[c] = run_number(clip, first, c);
        a.dual[c] = run_number(clip, first, 4 + c);
        b.real[c] = (turned ? -1.f : 1.f) * run_number(clip, second, c);
        b.dual[c] = (turned ? -1.f : 1.f) * run_number(clip, second, 4 + c);
    }
    if (factor == 0.f)
        posepack_dualquat_decode(&a, kTinyDualquatLength, out.data());
    else
        posepack_dualquat_blend(&a, &b, factor, kTinyDualquatLength, out.data());
    return out;
}

std::vector<RunOptions> run_layouts() {
    std::vector<RunOptions> all;
    for (const std::uint8_t idle :
         {POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT})
        for (const std::uint8_t walk :
             {POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT})
            for (const std::uint8_t format : {POSEPACK_TEXEL_RGBA16F, POSEPACK_TEXEL_RGBA32F}) {
                all.push_back(tiny_runs(idle, walk));
                all.back().texel_format = format;
                if (walk == POSEPACK_ENCODING_DUALQUAT) all.back().clips[1].turned = 1;
            }
    return all;
}

TEST(SampleRuns, EachBoneIsAtItsOwnRow) {
    for (const RunOptions& options : run_layouts()) {
        const Opened palette(make_run_parts(options));
        const RunClip &idle = options.clips[0], &walk = options.clips[1];
        // idle: root has rows 0 to 2, tail row 3, leg rows 1 and 2.
        Pose pose = palette.sample(kIdleClip, 0.375f);
        EXPECT_EQ(pose[0], run_matrix(idle, 0, 1, false, 0.75f));
        EXPECT_EQ(pose[1], run_matrix(idle, 3, 3, false, 0.f));
        EXPECT_EQ(pose[2], run_matrix(idle, 1, 2, false, 0.375f));
        pose = palette.sample(kIdleClip, 0.5f);
        EXPECT_EQ(pose[0], run_matrix(idle, 1, 1, false, 0.f));
        pose = palette.sample(kIdleClip, 1.f);
        EXPECT_EQ(pose[0], run_matrix(idle, 1, 2, false, 1.f));
        EXPECT_EQ(pose[1], run_matrix(idle, 3, 3, false, 0.f));
        EXPECT_EQ(pose[2], run_matrix(idle, 1, 2, false, 1.f));
        // walk: root has rows 0 to 4, tail rows 5 to 18, leg row 2; the last of each is the first again, that
        // of root with signs turned where it is a dual quaternion.
        const bool turned = walk.turned == 1;
        pose = palette.sample(kWalkClip, 0.9375f);
        EXPECT_EQ(pose[0], run_matrix(walk, 3, 0, turned, 0.75f));
        EXPECT_EQ(pose[1], run_matrix(walk, 5 + 12, 5, false, 0.9375f * 13.f - 12.f));
        EXPECT_EQ(pose[2], run_matrix(walk, 2, 2, false, 0.f));
        pose = palette.sample(kWalkClip, 0.25f);
        EXPECT_EQ(pose[0], run_matrix(walk, 1, 1, false, 0.f));
        EXPECT_EQ(pose[1], run_matrix(walk, 5 + 3, 5 + 4, false, 0.25f));
        pose = palette.sample(kWalkClip, 1.f);
        EXPECT_EQ(pose[0], run_matrix(walk, 3, 0, turned, 1.f));
        EXPECT_EQ(pose[1], run_matrix(walk, 5 + 12, 5, false, 1.f));
    }
}

TEST(SampleRuns, StepsHoldEveryRow) {
    for (RunOptions options : run_layouts()) {
        options.clips[0].interpolation = POSEPACK_INTERPOLATION_STEP;
        const RunClip& idle = options.clips[0];
        const Opened palette(make_run_parts(options));
        Pose pose = palette.sample(kIdleClip, 0.9f);
        EXPECT_EQ(pose[0], run_matrix(idle, 1, 1, false, 0.f));
        EXPECT_EQ(pose[2], run_matrix(idle, 1, 1, false, 0.f));
        pose = palette.sample(kIdleClip, 1.f);
        EXPECT_EQ(pose[0], run_matrix(idle, 2, 2, false, 0.f));
        EXPECT_EQ(pose[1], run_matrix(idle, 3, 3, false, 0.f));
    }
}

TEST(Sample, PhasesOutOfRangeAreTheNearestOnes) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<Parts> all = {make_parts(), make_run_parts(tiny_runs())};
    all.push_back(make_run_parts(tiny_runs(POSEPACK_ENCODING_DUALQUAT, POSEPACK_ENCODING_AFFINE)));
    for (const Parts& parts : all) {
        const Opened palette(parts);
        for (const std::uint32_t clip : {kIdleClip, kWalkClip}) {
            const Pose first = palette.sample(clip, 0.f), last = palette.sample(clip, 1.f);
            for (const float phase : {nan, -nan, -infinity, -1.f, -1e-30f, -0.f})
                EXPECT_TRUE(same_bits(palette.sample(clip, phase), first)) << phase;
            for (const float phase : {1.0000001f, 2.f, 1e30f, infinity})
                EXPECT_TRUE(same_bits(palette.sample(clip, phase), last)) << phase;
            for (const float phase : {1e-45f, 1e-20f, 0.99999994f})
                for (const Matrix& matrix : palette.sample(clip, phase))
                    for (const float number : matrix) EXPECT_TRUE(std::isfinite(number)) << phase;
        }
    }
}

TEST(SampleSlots, SayWhichRowsATimeLiesBetween) {
    // Five slots of 0.2: halves of the first interval, intervals 1 to 3, row 4 held, the interval from row 5.
    const Opened palette(make_run_parts(tiny_slots()));
    struct Expected {
        float phase;
        std::uint32_t row0;
        float factor;
    };
    for (const Expected& expected :
         {Expected{0.f, 0, 0.f}, Expected{0.1f, 0, 0.25f}, Expected{0.3f, 0, 0.75f}, Expected{0.4f, 1, 0.f},
          Expected{0.45f, 1, 0.75f}, Expected{0.5f, 2, 0.5f}, Expected{0.55f, 3, 0.25f},
          Expected{0.6001f, 4, 0.f}, Expected{0.7f, 4, 0.f}, Expected{0.7999f, 4, 0.f},
          Expected{0.9f, 5, 0.5f}, Expected{1.f, 5, 1.f}, Expected{7.f, 5, 1.f}, Expected{NAN, 0, 0.f}}) {
        posepack_place place;
        for (const std::uint32_t bone : {0u, 1u}) {
            ASSERT_EQ(posepack_find_place(&palette.view, kWalkClip, expected.phase, bone, &place),
                      POSEPACK_OK);
            EXPECT_EQ(place.row0, expected.row0) << expected.phase;
            EXPECT_EQ(place.row1, expected.row0 + 1) << expected.phase;
            EXPECT_NEAR(place.factor, expected.factor, 1e-5f) << expected.phase;
        }
        ASSERT_EQ(posepack_find_place(&palette.view, kWalkClip, expected.phase, 2, &place), POSEPACK_OK);
        EXPECT_EQ(place.row0, 0u);  // leg keeps still
        EXPECT_EQ(place.factor, 0.f);
    }
}

TEST(SampleSlots, PosesAreThoseOfTheirRows) {
    // The same runs at even times: rows of the two are the same.
    RunOptions even = tiny_slots();
    even.clips[1].slots.clear();
    const Opened plain(make_run_parts(even));
    const Opened slots(make_run_parts(tiny_slots()));
    // Row 1 and a half of row 2, row 4, the middle between rows 5 and 6.
    for (const auto& [bent, straight] : {std::pair{0.5f, 2.5f / 6.f}, std::pair{0.7f, 4.f / 6.f},
                                         std::pair{0.9f, 5.5f / 6.f}, std::pair{1.f, 1.f}}) {
        const Pose a = slots.sample(kWalkClip, bent);
        const Pose b = plain.sample(kWalkClip, straight);
        for (std::uint32_t bone = 0; bone < kTinyBoneCount; ++bone)
            for (std::size_t i = 0; i < 12; ++i)
                EXPECT_NEAR(a.at(bone).at(i), b.at(bone).at(i), 2e-5f) << bent << " " << bone;
    }
    EXPECT_TRUE(same_bits(slots.sample(kIdleClip, 0.3f), plain.sample(kIdleClip, 0.3f)));
}

TEST(SampleSlots, HeldRowsStayHeld) {
    RunOptions options = tiny_slots();
    options.clips[1].interpolation = POSEPACK_INTERPOLATION_STEP;
    const Opened palette(make_run_parts(options));
    posepack_place place;
    for (const auto& [phase, row] : {std::pair{0.39f, 0u}, std::pair{0.41f, 1u}, std::pair{0.47f, 2u},
                                     std::pair{0.9f, 5u}, std::pair{1.f, 6u}}) {
        ASSERT_EQ(posepack_find_place(&palette.view, kWalkClip, phase, 1, &place), POSEPACK_OK);
        EXPECT_EQ(place.row0, row) << phase;
        EXPECT_EQ(place.factor, 0.f) << phase;
    }
}

TEST(SampleSlots, AreHandedOut) {
    const Opened palette(make_run_parts(tiny_slots()));
    posepack_clip clip;
    posepack_slot slot;
    ASSERT_EQ(posepack_get_clip(&palette.view, kWalkClip, &clip), POSEPACK_OK);
    EXPECT_EQ(clip.row_scheme, POSEPACK_ROWS_SLOTS);
    EXPECT_EQ(clip.slot_count, 5u);
    ASSERT_EQ(posepack_get_slot(&palette.view, kWalkClip, 2, &slot), POSEPACK_OK);
    EXPECT_EQ(slot.row, 1u);
    EXPECT_EQ(slot.offset, 3u);
    EXPECT_EQ(slot.span, 0u);
    ASSERT_EQ(posepack_get_clip(&palette.view, kIdleClip, &clip), POSEPACK_OK);
    EXPECT_EQ(clip.slot_count, 0u);
    EXPECT_EQ(posepack_get_slot(&palette.view, kIdleClip, 0, &slot), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_slot(&palette.view, kWalkClip, 5, &slot), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_slot(&palette.view, 2, 0, &slot), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_slot(&palette.view, kWalkClip, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_slot(nullptr, kWalkClip, 0, &slot), POSEPACK_ERROR_ARG);
}

TEST(SampleSlots, AreNotTrustedOnceTheBytesHaveChanged) {
    Opened palette(make_run_parts(tiny_slots()));
    const std::size_t slots = section_offset(palette.bytes, kSlot);
    for (const std::uint32_t hostile : {0xFFFFFFFFu, 0x00FFFFFFu, 0x01000000u, 0xFF00FFFFu}) {
        for (std::size_t at = slots; at < slots + 16 + 20; at += 4) {
            const Bytes before = palette.bytes;
            put_u32(palette.bytes, at, hostile);
            for (const float phase : {0.f, 0.3f, 0.5f, 1.f}) palette.sample(kWalkClip, phase);
            std::copy(before.begin(), before.end(), palette.bytes.begin());
        }
    }
}

TEST(Sample, RunsSayWhereRowsAre) {
    posepack_run run;
    const Opened uniform_rows(make_parts());
    ASSERT_EQ(posepack_get_run(&uniform_rows.view, kWalkClip, 2, &run), POSEPACK_OK);
    EXPECT_EQ(run.texel, 9u + 6u);
    EXPECT_EQ(run.texel_step, 9u);
    EXPECT_EQ(run.k_step, 1u);
    EXPECT_EQ(run.interval_count, 4u);
    EXPECT_EQ(run.wraps, 1u);
    ASSERT_EQ(posepack_get_run(&uniform_rows.view, kIdleClip, 2, &run), POSEPACK_OK);
    EXPECT_EQ(run.interval_count, 0u);
    EXPECT_EQ(run.wraps, 0u);

    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    options.texel_order = POSEPACK_ORDER_PLANAR;
    options.closing_row = true;
    const Opened closed(make_parts(options));
    ASSERT_EQ(posepack_get_run(&closed.view, kWalkClip, 2, &run), POSEPACK_OK);
    EXPECT_EQ(run.texel, 6u + 2u);
    EXPECT_EQ(run.texel_step, 6u);
    EXPECT_EQ(run.k_step, 3u);
    EXPECT_EQ(run.interval_count, 3u);
    EXPECT_EQ(run.wraps, 0u);

    const Opened runs(make_run_parts(tiny_runs(POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT)));
    ASSERT_EQ(posepack_get_run(&runs.view, kWalkClip, 1, &run), POSEPACK_OK);
    EXPECT_EQ(run.texel, 4u * 3u + 5u * 2u);
    EXPECT_EQ(run.texel_step, 2u);
    EXPECT_EQ(run.k_step, 1u);
    EXPECT_EQ(run.interval_count, 13u);
    EXPECT_EQ(run.wraps, 0u);
}

TEST(Sample, RefusesWhatIsNotThere) {
    const posepack_view empty{};
    posepack_run run;
    posepack_place place;
    Pose pose{};
    for (const Parts& parts : {make_parts(), make_run_parts(), make_run_parts(tiny_slots())}) {
        const Opened palette(parts);
        const posepack_view* view = &palette.view;
        EXPECT_EQ(posepack_get_run(nullptr, 0, 0, &run), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_get_run(&empty, 0, 0, &run), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_get_run(view, 0, 0, nullptr), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_get_run(view, 2, 0, &run), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_get_run(view, POSEPACK_NONE, 0, &run), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_get_run(view, 0, kTinyBoneCount, &run), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_find_place(nullptr, 0, 0.f, 0, &place), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_find_place(view, 0, 0.f, 0, nullptr), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_find_place(view, 2, 0.f, 0, &place), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_find_place(view, 0, 0.f, kTinyBoneCount, &place), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_sample_bone(nullptr, 0, 0.f, 0, floats(pose)), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_sample_bone(&empty, 0, 0.f, 0, floats(pose)), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_sample_bone(view, 0, 0.f, 0, nullptr), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_sample_bone(view, 2, 0.f, 0, floats(pose)), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_sample_bone(view, 0, 0.f, kTinyBoneCount, floats(pose)), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_sample_pose(nullptr, 0, 0.f, floats(pose)), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_sample_pose(&empty, 0, 0.f, floats(pose)), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_sample_pose(view, 0, 0.f, nullptr), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_sample_pose(view, 2, 0.f, floats(pose)), POSEPACK_ERROR_INDEX);
    }
}

TEST(SampleRuns, RowsAreNotShared) {
    const Opened palette(make_run_parts());
    Pose pose{};
    EXPECT_EQ(posepack_decode_bone(&palette.view, 0, 0, floats(pose)), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(posepack_decode_row(&palette.view, 0, floats(pose)), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(posepack_blend_bone(&palette.view, 0, 1, 0.5f, 0, floats(pose)), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(posepack_blend_row(&palette.view, 0, 1, 0.5f, floats(pose)), POSEPACK_ERROR_UNSUPPORTED);
    EXPECT_EQ(posepack_decode_row(&palette.view, 0, nullptr), POSEPACK_ERROR_ARG);
}

}  // namespace
}  // namespace posepack::test
