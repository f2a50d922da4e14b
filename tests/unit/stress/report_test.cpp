// SPDX-License-Identifier: MIT
// Results as text and as JSON.
#include "stress/stress_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace posepack::stress {
namespace {

std::vector<CaseResult> results_of(std::vector<std::string> names, double bound_factor = 1.0) {
    auto results = run_cases({std::move(names), bound_factor, 1});
    if (!results) throw std::runtime_error(base::format_issue(results.issue()));
    return std::move(results).value();
}

TEST(StressList, NamesEveryCase) {
    const std::string text = stress_list();
    for (const CaseGroup& group : case_groups()) {
        EXPECT_NE(text.find(std::string(group.title) + "\n"), std::string::npos);
        for (const StressCase& stress_case : group.cases) {
            EXPECT_NE(text.find("\n" + std::string(stress_case.name) + " "), std::string::npos);
            EXPECT_NE(text.find(std::string(stress_case.trouble) + "\n"), std::string::npos);
        }
    }
}

TEST(StressText, HasALineACaseAndSaysWhatHappens) {
    const std::string text = stress_text(
        results_of({"one_metre", "shear", "falling_keys", "spin_180_a_row", "step_among_curves"}));
    for (const char* part :
         {"Places and sizes\n", "\none_metre ", "meets the bound\n", "\nshear ", "SIMILARITY",
          "switches form to affine 16F\n", "refuses: E-GLB-TIMES\n", " of 44  adds rows\n",
          " of 124  slots, cuts\n", "5 cases: 5 as expected, 0 not."})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_EQ(text.find("Readers"), std::string::npos) << "groups without a case are left out";
}

TEST(StressText, MarksWhatDiffers) {
    const auto results = results_of({"one_metre", "no_size"}, 1e-6);
    const std::string text = stress_text(results);
    EXPECT_NE(text.find("DIFFERS: refuses: E-LIM-BOUND\n"), std::string::npos) << text;
    EXPECT_NE(text.find("2 cases: 1 as expected, 1 not."), std::string::npos) << text;
    EXPECT_NE(stress_details(results).find("DIFFERS: expected 'meets the bound', found"), std::string::npos);
}

TEST(StressDetails, HaveEveryFormAndTheSentence) {
    const std::string text = stress_details(results_of({"shear", "step_off_the_grid"}));
    for (const Form& form : all_forms()) EXPECT_NE(text.find("\n" + label_of(form)), std::string::npos);
    for (const char* part : {"E-LIM-SIMILARITY", "chosen: affine 16F, ", " of 155 bone-rows in runs, ",
                             "error[E-LIM-BOUND]: step_off_the_grid: ", "remark: W-CLIP-RATE"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(StressJson, SaysAllOfACase) {
    const auto json = nlohmann::json::parse(stress_json(results_of({"shear", "no_size"}), 1.0));
    EXPECT_EQ(json.at("schema"), "posepack-stress-1");
    EXPECT_EQ(json.at("ok"), true);
    const nlohmann::json& no_size = json.at("cases").at(1);
    EXPECT_EQ(no_size.at("found").at("refuses"), "E-GLB-NO-EXTENT");
    EXPECT_EQ(no_size.at("chosen"), nullptr);
    const nlohmann::json& shear = json.at("cases").at(0);
    EXPECT_EQ(shear.at("forms").size(), 12u);
    EXPECT_EQ(shear.at("chosen").at("encoding"), "affine");
    EXPECT_EQ(shear.at("chosen").at("row_scheme"), "runs");
    EXPECT_EQ(shear.at("chosen").at("bone_rows_at_start"), 155) << "31 rows of 5 bones";
    EXPECT_LT(shear.at("chosen").at("bone_rows"), 155);
    EXPECT_EQ(shear.at("found").at("switches_form"), true);
    EXPECT_EQ(shear.at("difference"), nullptr);
    const auto refused = std::count_if(shear.at("forms").begin(), shear.at("forms").end(),
                                       [](const auto& form) { return form.at("measured").is_null(); });
    EXPECT_EQ(refused, 4) << "dual quaternions";
}

}  // namespace
}  // namespace posepack::stress
