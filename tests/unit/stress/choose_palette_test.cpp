// SPDX-License-Identifier: MIT
// The smallest palette under a bound.
#include "stress/choose_palette.hpp"

#include <gtest/gtest.h>

#include "posepack/loader.h"
#include "stress/models.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {
namespace {

const StressCase& case_named(std::string_view name) {
    for (const CaseGroup& group : case_groups())
        for (const StressCase& stress_case : group.cases)
            if (stress_case.name == name) return stress_case;
    throw std::invalid_argument(std::string(name));
}

base::Result<base::Bytes> chosen(std::string_view name, const Bound& bound) {
    const StressCase& stress_case = case_named(name);
    return choose_palette(entry_of(stress_case), write_glb(stress_case.build()), bound);
}

// Bytes of the texels of a container that holds `bound` in every clip, by its own record.
std::size_t texel_bytes(const base::Bytes& container, const Bound& bound) {
    posepack_view view;
    EXPECT_EQ(posepack_open(&view, container.data(), container.size()), POSEPACK_OK);
    for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
        posepack_clip clip;
        EXPECT_EQ(posepack_get_clip(&view, c, &clip), POSEPACK_OK);
        EXPECT_EQ(clip.measured, 1);
        EXPECT_LE(static_cast<double>(clip.error.max), bound.max);
        EXPECT_LE(static_cast<double>(clip.error.p999), bound.p999);
    }
    posepack_texels texels;
    EXPECT_EQ(posepack_get_texels(&view, &texels), POSEPACK_OK);
    return texels.size_bytes;
}

TEST(ChoosePalette, AFinerBoundNeverGivesFewerBytes) {
    for (const char* name : {"one_metre", "spin_72_a_row", "shear", "travel_30_m", "two_turns_a_loop"}) {
        std::size_t before = 0;
        for (const double max : {1.0, 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4}) {
            const Bound bound{max, max / 4};
            const auto container = chosen(name, bound);
            if (!container) {
                EXPECT_EQ(container.issue().code, base::IssueCode::lim_bound) << name;
                before = SIZE_MAX;
                continue;
            }
            const std::size_t bytes = texel_bytes(container.value(), bound);
            EXPECT_GE(bytes, before) << name << " under " << max;
            before = bytes;
        }
    }
}

TEST(ChoosePalette, ABoundOutOfReachIsRefusedWithThePlaceAndTheBest) {
    const auto container = chosen("spring_1_ms", {2e-2, 5e-3});
    ASSERT_FALSE(container);
    EXPECT_EQ(container.issue().code, base::IssueCode::lim_bound);
    EXPECT_EQ(container.issue().where, "spring_1_ms: Move");
    for (const char* part : {"0.02 R", "0.005 R", "bone 'joint ", "dualquat 16F", "rows a second"})
        EXPECT_NE(container.issue().detail.find(part), std::string::npos) << container.issue().detail;
}

TEST(ChoosePalette, WhatNoFormMendsIsRefusedAsItIs) {
    EXPECT_EQ(chosen("falling_keys", kUsual).issue().code, base::IssueCode::glb_times);
    EXPECT_EQ(chosen("no_size", kUsual).issue().code, base::IssueCode::glb_no_extent);
    EXPECT_EQ(chosen("ten_minutes_at_240_hz", kUsual).issue().code, base::IssueCode::lim_rows);
}

// Clips of one file have grids of their own; both get the same multiple of theirs.
TEST(ChoosePalette, KeepsTheRatesOfTheClipsInProportion) {
    RawModel model = reed();
    model.clips.push_back({"Slow", swaying(model, grid(31, 30.0), 10.0, 1.0)});
    model.clips.push_back({"Quick", swaying(model, grid(61, 60.0), 60.0, 0.25)});
    recipe::AnimalEntry entry = entry_of(case_named("one_metre"));
    const auto container = choose_palette(entry, write_glb(model), {2e-2, 5e-3});
    ASSERT_TRUE(container) << base::format_issue(container.issue());
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, container.value().data(), container.value().size()), POSEPACK_OK);
    posepack_clip slow, quick;
    ASSERT_EQ(posepack_get_clip(&view, 0, &slow), POSEPACK_OK);
    ASSERT_EQ(posepack_get_clip(&view, 1, &quick), POSEPACK_OK);
    EXPECT_GT(slow.row_count, 31u);
    EXPECT_NEAR(static_cast<double>(quick.rate_hz / slow.rate_hz), 2.0, 1e-3);
}

}  // namespace
}  // namespace posepack::stress
