// SPDX-License-Identifier: MIT
// What the CPU shows of a moment: one clip, or the fade of two, against the definition in double.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "played.hpp"

namespace posepack::test {
namespace {

using Matrix = std::array<float, 12>;
using Numbers = std::array<double, 9>;  // real, dual, scale

Matrix sample(const posepack_view& view, std::uint32_t clip, float phase, std::uint32_t bone) {
    Matrix matrix{};
    EXPECT_EQ(posepack_sample_bone(&view, clip, phase, bone, matrix.data()), POSEPACK_OK);
    return matrix;
}

// One bone at a moment; that the whole pose has the same bits is seen to.
Matrix show(const posepack_view& view, const posepack_moment& moment, std::uint32_t bone) {
    Matrix matrix{};
    std::array<Matrix, kTinyBoneCount> pose{};
    EXPECT_EQ(posepack_show_bone(&view, &moment, bone, matrix.data()), POSEPACK_OK);
    EXPECT_EQ(posepack_show_pose(&view, &moment, pose[0].data()), POSEPACK_OK);
    EXPECT_EQ(std::memcmp(&matrix, &pose.at(bone), sizeof matrix), 0);
    return matrix;
}

// The numbers of a bone-row of runs, its scale taken out (section 10 of the specification).
Numbers row_numbers(const RunClip& clip, std::uint32_t row) {
    Numbers n{};
    double along = 0.0, square = 0.0;
    for (std::uint32_t c = 0; c < 4; ++c) {
        n.at(c) = static_cast<double>(run_number(clip, row, c));
        n.at(4 + c) = static_cast<double>(run_number(clip, row, 4 + c));
        along += n.at(c) * n.at(4 + c);
        square += n.at(c) * n.at(c);
    }
    along /= square;
    for (std::uint32_t c = 0; c < 4; ++c) n.at(4 + c) -= along * n.at(c);
    n[8] = 1.0 + 2.0 * along / static_cast<double>(kTinyDualquatLength);
    return n;
}

Numbers mix(const Numbers& a, const Numbers& b, double factor, double sign) {
    Numbers out{};
    for (std::size_t i = 0; i < 9; ++i)
        out.at(i) = a.at(i) * (1.0 - factor) + (i < 8 ? sign : 1.0) * b.at(i) * factor;
    return out;
}

double real_dot(const Numbers& a, const Numbers& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// Rotation by quaternion sandwich of the axes, translation 2 dual conj(real) / |real|^2.
std::array<double, 12> matrix_of(const Numbers& n) {
    const double x = n[0], y = n[1], z = n[2], w = n[3], h = 2.0 / real_dot(n, n);
    std::array<double, 12> m = {1 - h * (y * y + z * z), h * (x * y - w * z),     h * (x * z + w * y),     0,
                                h * (x * y + w * z),     1 - h * (x * x + z * z), h * (y * z - w * x),     0,
                                h * (x * z - w * y),     h * (y * z + w * x),     1 - h * (x * x + y * y), 0};
    for (std::size_t i = 0; i < 12; ++i) m.at(i) *= n[8];
    m[3] = h * (w * n[4] - n[7] * x + y * n[6] - z * n[5]);
    m[7] = h * (w * n[5] - n[7] * y + z * n[4] - x * n[6]);
    m[11] = h * (w * n[6] - n[7] * z + x * n[5] - y * n[4]);
    return m;
}

posepack_moment fade_of(float phase, float before_phase, float factor) {
    return {kWalkClip, kIdleClip, phase, before_phase, factor};
}

TEST(Poses, OfOneClipAreThoseOfThePhase) {
    for (const Parts& parts : {make_parts(), make_run_parts(tiny_runs()), make_run_parts(tiny_slots())}) {
        const Played palette(parts);
        for (std::uint32_t clip = 0; clip < 2; ++clip)
            for (float phase = 0.f; phase <= 1.f; phase += 0.0625f)
                for (std::uint32_t bone = 0; bone < kTinyBoneCount; ++bone)
                    EXPECT_EQ(show(palette.view, {clip, POSEPACK_NONE, phase, 0.f, 1.f}, bone),
                              sample(palette.view, clip, phase, bone));
    }
}

TEST(Poses, FadeMatricesEntryByEntry) {
    std::vector<Parts> all = {make_parts(), make_run_parts(tiny_slots())};
    for (const std::uint8_t idle :
         {POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT})
        for (const std::uint8_t walk :
             {POSEPACK_ENCODING_MAT4, POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT})
            if (idle != POSEPACK_ENCODING_DUALQUAT || walk != idle)
                all.push_back(make_run_parts(tiny_runs(idle, walk)));
    for (const Parts& parts : all) {
        const Played palette(parts);
        for (float factor = 0.0625f; factor < 1.f; factor += 0.1875f)
            for (std::uint32_t bone = 0; bone < kTinyBoneCount; ++bone) {
                const Matrix before = sample(palette.view, kIdleClip, 0.3f, bone);
                const Matrix now = sample(palette.view, kWalkClip, 0.7f, bone);
                const Matrix shown = show(palette.view, fade_of(0.7f, 0.3f, factor), bone);
                for (std::size_t i = 0; i < 12; ++i)
                    EXPECT_EQ(shown.at(i), before.at(i) * (1.f - factor) + now.at(i) * factor);
            }
    }
}

TEST(Poses, FadeDualQuaternionsInOneHemisphere) {
    // idle's root has rows 0 to 2, its tail row 3, leg rows 1 and 2; walk's rows are 0 to 4, 5 to 18, and 2.
    const RunOptions options = tiny_runs(POSEPACK_ENCODING_DUALQUAT, POSEPACK_ENCODING_DUALQUAT);
    const Played palette(make_run_parts(options));
    RunOptions turned_options = options;
    Parts turned_parts = make_run_parts(options);
    Bytes& texels = turned_parts[kPixl];  // every number of walk with its sign turned; idle has 4 bone-rows
    for (std::size_t i = 4 * 16 + 1; i < texels.size(); i += 2) texels[i] ^= 0x80;
    const Played turned(turned_parts);
    for (const float factor : {0.125f, 0.5f, 0.875f}) {
        for (const float phase : {0.f, 0.25f, 0.3125f, 0.75f}) {
            const auto row = static_cast<std::uint32_t>(phase * 4.f);  // of walk's root
            const float along = phase * 4.f - static_cast<float>(row);
            const Numbers now = mix(row_numbers(options.clips[1], row),
                                    row_numbers(options.clips[1], (row + 1) % 4), along, 1.0);
            const Numbers before =
                mix(row_numbers(options.clips[0], 0), row_numbers(options.clips[0], 1), 0.5, 1.0);
            const double sign = real_dot(before, now) < 0.0 ? -1.0 : 1.0;
            const std::array<double, 12> expected = matrix_of(mix(before, now, factor, sign));
            const posepack_moment moment = fade_of(phase, 0.25f, factor);
            const Matrix shown = show(palette.view, moment, 0);
            for (std::size_t i = 0; i < 12; ++i)
                EXPECT_NEAR(static_cast<double>(shown.at(i)), expected.at(i), 2e-6 * 8.0) << i;
            // The signs of a clip mean nothing: turned, its bones are in the other hemisphere, and turned
            // back.
            for (std::uint32_t bone = 0; bone < kTinyBoneCount; ++bone)
                EXPECT_EQ(show(turned.view, moment, bone), show(palette.view, moment, bone));
        }
    }
}

TEST(Poses, BeginAndEndAFadeWithoutAJump) {
    for (const std::uint8_t walk : {POSEPACK_ENCODING_AFFINE, POSEPACK_ENCODING_DUALQUAT}) {
        const Played palette(make_run_parts(tiny_runs(POSEPACK_ENCODING_DUALQUAT, walk)));
        for (std::uint32_t bone = 0; bone < kTinyBoneCount; ++bone) {
            const Matrix first = show(palette.view, fade_of(0.4f, 0.6f, 1e-6f), bone);
            const Matrix last = show(palette.view, fade_of(0.4f, 0.6f, 0.999999f), bone);
            const Matrix before = sample(palette.view, kIdleClip, 0.6f, bone);
            const Matrix now = sample(palette.view, kWalkClip, 0.4f, bone);
            for (std::size_t i = 0; i < 12; ++i) {
                EXPECT_NEAR(first.at(i), before.at(i), 1e-4f);
                EXPECT_NEAR(last.at(i), now.at(i), 1e-4f);
            }
        }
    }
}

TEST(Poses, FollowAPlay) {
    const Played palette(make_run_parts(tiny_runs()));
    posepack_track idle{}, walk{};
    posepack_play play{};
    posepack_moment moment{};
    ASSERT_EQ(posepack_start_track(&palette.view, kIdleClip, 1, 0, 0, 0, &idle), POSEPACK_OK);
    ASSERT_EQ(posepack_start_track(&palette.view, kWalkClip, 1, 0, 10, 0, &walk), POSEPACK_OK);
    ASSERT_EQ(posepack_start_play(&play, &idle), POSEPACK_OK);
    ASSERT_EQ(posepack_fade_play(&play, &walk, 1.0), POSEPACK_OK);
    const double frame_s = 1.0 / 64.0;
    Matrix shown{};
    for (double t = 9.5; t < 12.0; t += frame_s) {  // what was shown is what was the previous pose later
        ASSERT_EQ(posepack_find_moment(&palette.view, &play, t - frame_s, &moment), POSEPACK_OK);
        if (t > 9.5) {
            EXPECT_EQ(show(palette.view, moment, 0), shown);
        }
        ASSERT_EQ(posepack_find_moment(&palette.view, &play, t, &moment), POSEPACK_OK);
        shown = show(palette.view, moment, 0);
    }
}

TEST(Poses, AreZeroWhereBytesHaveChanged) {
    Played palette(make_run_parts(tiny_runs(POSEPACK_ENCODING_DUALQUAT, POSEPACK_ENCODING_DUALQUAT)));
    const std::size_t clips = section_offset(palette.bytes, kClip);
    for (const std::size_t record : {kIdle, kWalk}) {
        const std::uint32_t before = get_u32(palette.bytes, clips + record + POSEPACK_CLIP_FIRST_TEXEL);
        put_u32(palette.bytes, clips + record + POSEPACK_CLIP_FIRST_TEXEL, 0x7FFFFFFF);
        const Matrix shown = show(palette.view, fade_of(0.4f, 0.6f, 0.5f), 0);
        const Matrix other =
            sample(palette.view, record == kIdle ? kWalkClip : kIdleClip, record == kIdle ? 0.4f : 0.6f, 0);
        for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(shown.at(i), 0.5f * other.at(i));
        put_u32(palette.bytes, clips + record + POSEPACK_CLIP_FIRST_TEXEL, before);
    }
}

TEST(Poses, RefuseWrongArguments) {
    const Played palette(make_parts());
    const posepack_moment moment = fade_of(0.f, 0.f, 0.5f);
    const posepack_view closed{};
    std::array<Matrix, kTinyBoneCount> pose{};
    float* floats = pose[0].data();
    for (const posepack_view* view : std::array<const posepack_view*, 2>{nullptr, &closed}) {
        EXPECT_EQ(posepack_show_bone(view, &moment, 0, floats), POSEPACK_ERROR_ARG);
        EXPECT_EQ(posepack_show_pose(view, &moment, floats), POSEPACK_ERROR_ARG);
    }
    EXPECT_EQ(posepack_show_bone(&palette.view, nullptr, 0, floats), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_show_bone(&palette.view, &moment, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_show_bone(&palette.view, &moment, kTinyBoneCount, floats), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_show_pose(&palette.view, nullptr, floats), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_show_pose(&palette.view, &moment, nullptr), POSEPACK_ERROR_ARG);
    for (const posepack_moment& bad :
         {posepack_moment{2, POSEPACK_NONE, 0, 0, 1}, posepack_moment{0, 2, 0, 0, 0.5f}}) {
        EXPECT_EQ(posepack_show_bone(&palette.view, &bad, 0, floats), POSEPACK_ERROR_INDEX);
        EXPECT_EQ(posepack_show_pose(&palette.view, &bad, floats), POSEPACK_ERROR_INDEX);
    }
}

}  // namespace
}  // namespace posepack::test
