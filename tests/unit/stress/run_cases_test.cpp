// SPDX-License-Identifier: MIT
// Cases at work. That all do what is expected is a test of the command; here expectations are falsified.
#include "stress/run_cases.hpp"

#include <gtest/gtest.h>

#include "stress/models.hpp"

namespace posepack::stress {
namespace {

using base::IssueCode;

const StressCase& case_named(std::string_view name) {
    for (const CaseGroup& group : case_groups())
        for (const StressCase& stress_case : group.cases)
            if (stress_case.name == name) return stress_case;
    throw std::invalid_argument(std::string(name));
}

CaseResult result_of(const StressCase& stress_case, double bound_factor = 1.0) {
    auto result = run_case(stress_case, "Group", bound_factor);
    if (!result) throw std::runtime_error(base::format_issue(result.issue()));
    return std::move(result).value();
}

TEST(RunCase, MeasuresEveryFormAndTheChosenOne) {
    const CaseResult result = result_of(case_named("one_metre"));
    ASSERT_EQ(result.forms.size(), all_forms().size());
    for (std::size_t i = 0; i < result.forms.size(); ++i) {
        const FormResult& form = result.forms[i];
        EXPECT_EQ(form.form, all_forms()[i]);
        EXPECT_FALSE(form.refusal);
        EXPECT_EQ(form.row_count, 31u);
        EXPECT_EQ(form.texel_bytes, 31u * 4 * bytes_of(form.form));
        EXPECT_GE(form.drawn.all.max, form.drawn.rows.max);
        EXPECT_NEAR(form.printed.max, form.drawn.all.max, 0.05 * form.drawn.all.max) << label_of(form.form);
    }
    ASSERT_TRUE(result.chosen);
    EXPECT_EQ(result.chosen->form, Form{});
    EXPECT_FALSE(result.chosen->has_slots);
    EXPECT_EQ(result.chosen->start_bone_row_count, 31u * 4);
    EXPECT_LT(result.chosen->bone_row_count, 31u * 4);
    EXPECT_GT(result.chosen->drawn.all.max, result.forms[5].drawn.all.max) << "what room there is is used";
    EXPECT_EQ(result.difference, "");
}

// Each expectation of these cases, replaced by another one.
TEST(RunCase, TellsWhenAnActionDiffers) {
    for (const char* name :
         {"one_metre", "shear", "spin_170_a_row", "travel_30_m", "falling_keys", "step_off_the_grid",
          "raw_clock_after_a_day", "spring_100_ms", "step_among_curves"}) {
        EXPECT_EQ(result_of(case_named(name)).difference, "") << name;
        for (const Action& other :
             {kMeets, kSwitchesForm, kAddsRows, kSlots, kCuts, kMisses, refuses(IssueCode::lim_work)}) {
            StressCase falsified = case_named(name);
            if (falsified.expected.action == other) continue;
            falsified.expected = {other};
            EXPECT_NE(result_of(falsified).difference, "") << name << ": " << text_of(other);
        }
    }
}

TEST(RunCase, TellsWhenASentenceOrAWarningIsMissing) {
    StressCase sentence = case_named("falling_keys");
    sentence.expected.says = "something else";
    EXPECT_NE(result_of(sentence).difference, "");
    StressCase warning = case_named("one_metre");
    warning.expected.warning = IssueCode::warn_rate;
    EXPECT_NE(result_of(warning).difference, "");
}

// Jumps at keys: each is a cut.
TEST(RunCase, CountsTheJumpsThatRowsEndInFrontOf) {
    EXPECT_EQ(result_of(case_named("step_among_curves")).chosen->cut_count, 1u);
    EXPECT_EQ(result_of(case_named("spring_100_ms")).chosen->cut_count, 0u);
    StressCase three = case_named("step_among_curves");
    three.build = [] {
        RawModel model = reed();
        std::vector<RawChannel> channels = swaying(model, grid(31, kKeyHz), kSwayDegrees, 1.0);
        channels.push_back(moving(0, grid(4, 3.0), [](double time_s) { return Vec3(time_s, 0.0, 0.0); }));
        channels.back().interpolation = Interpolation::step;
        return with_clip(model, channels);
    };
    three.start.wrap = recipe::Wrap::loop;
    EXPECT_EQ(result_of(three).chosen->cut_count, 3u) << "the last in front of an open seam";
}

// A rate is a start, and no wish beside a bound.
TEST(UnderABound, NoRateIsAskedFor) {
    const recipe::AnimalEntry entry = entry_of(case_named("spin_24_a_row"));
    ASSERT_TRUE(entry.clips.front().rate_hz);
    const recipe::AnimalEntry bounded = under_bound(entry, {2e-2, 5e-3});
    EXPECT_FALSE(bounded.clips.front().rate_hz);
    EXPECT_EQ(bounded.output.bound->max.value, 2e-2);
    EXPECT_EQ(bounded.output.bound->p999->value, 5e-3);
    EXPECT_FALSE(bounded.output.bound->rms);
}

TEST(RunCase, AFinerBoundAsksForMore) {
    const StressCase& stress_case = case_named("one_metre");
    const CaseResult result = result_of(stress_case, 0.02);
    EXPECT_DOUBLE_EQ(result.bound.max, stress_case.bound.max * 0.02);
    EXPECT_TRUE(result.found.action.adds_rows || result.found.action.refuses);
    EXPECT_NE(result.difference, "");
}

TEST(RunCases, AreInTheOrderOfTheTableWhateverIsAskedFor) {
    const auto results = run_cases({{"mirror", "one_metre"}, 1.0, 2});
    ASSERT_TRUE(results);
    ASSERT_EQ(results.value().size(), 2u);
    EXPECT_EQ(results.value()[0].stress_case->name, "one_metre");
    EXPECT_EQ(results.value()[1].stress_case->name, "mirror");
}

TEST(RunCases, AnUnknownNameIsRefusedWithTheNearest) {
    const auto results = run_cases({{"one_meter"}, 1.0, 1});
    ASSERT_FALSE(results);
    EXPECT_EQ(results.issue().code, IssueCode::usage);
    EXPECT_NE(results.issue().detail.find("one_metre"), std::string::npos);
}

}  // namespace
}  // namespace posepack::stress
