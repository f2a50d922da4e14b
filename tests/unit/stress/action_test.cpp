// SPDX-License-Identifier: MIT
// What is expected of a case against what it did.
#include "stress/action.hpp"

#include <gtest/gtest.h>

namespace posepack::stress {
namespace {

using base::IssueCode;

TEST(Action, IsNamedInWords) {
    EXPECT_EQ(text_of(kMeets), "meets the bound");
    EXPECT_EQ(text_of(kSwitchesForm), "switches form");
    EXPECT_EQ(text_of(kSwitchesAndAddsRows), "switches form, adds rows");
    EXPECT_EQ(text_of(kSlots), "slots");
    EXPECT_EQ(text_of({.adds_rows = true, .has_slots = true, .cuts = true}), "adds rows, slots, cuts");
    EXPECT_EQ(text_of(kMisses), "misses the bound");
    EXPECT_EQ(text_of(refuses(IssueCode::lim_bound)), "refuses: E-LIM-BOUND");
}

TEST(Difference, IsNothingWhereAllIsAsExpected) {
    EXPECT_EQ(difference({kMeets}, {kMeets, "", {}}), "");
    EXPECT_EQ(difference({kAddsRows, "", IssueCode::warn_rate},
                         {kAddsRows, "", {IssueCode::warn_weights, IssueCode::warn_rate}}),
              "");
    EXPECT_EQ(difference({refuses(IssueCode::glb_times), "rising key times"},
                         {refuses(IssueCode::glb_times), "expected rising key times, found", {}}),
              "");
}

TEST(Difference, NamesEveryKind) {
    const Action all[] = {kMeets,
                          kSwitchesForm,
                          kAddsRows,
                          kSwitchesAndAddsRows,
                          kMisses,
                          kSlots,
                          kCuts,
                          refuses(IssueCode::lim_bound),
                          refuses(IssueCode::glb_quat)};
    for (const Action& expected : all)
        for (const Action& found : all) {
            const std::string text = difference({expected}, {found, "", {}});
            EXPECT_EQ(text.empty(), &expected == &found) << text_of(expected) << " and " << text_of(found);
            if (text.empty()) continue;
            EXPECT_NE(text.find(text_of(expected)), std::string::npos) << text;
            EXPECT_NE(text.find(text_of(found)), std::string::npos) << text;
        }
}

TEST(Difference, NamesASentenceAndAWarningThatAreMissing) {
    const Found refused{refuses(IssueCode::glb_times), "expected rising key times", {}};
    EXPECT_NE(difference({refuses(IssueCode::glb_times), "from 0 s on"}, refused), "");
    EXPECT_NE(difference({kMeets, "", IssueCode::warn_rate}, {kMeets, "", {IssueCode::warn_seam}})
                  .find("W-CLIP-RATE"),
              std::string::npos);
}

}  // namespace
}  // namespace posepack::stress
