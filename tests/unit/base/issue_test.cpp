// SPDX-License-Identifier: MIT
#include "base/issue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/json.hpp"
#include "base/result.hpp"

namespace posepack::base {
namespace {

TEST(IssueTable, HasUniqueIdsAndRowsThatFitTheirCode) {
    std::set<std::string_view> ids;
    std::size_t index = 0;
    for (const IssueKind& kind : issue_kinds()) {
        EXPECT_TRUE(ids.insert(kind.id).second) << kind.id;
        EXPECT_EQ(static_cast<std::size_t>(kind.code), index++) << kind.id;
        EXPECT_EQ(&issue_kind(kind.code), &kind) << kind.id;
    }
    EXPECT_GT(index, 50u);
}

TEST(IssueTable, GivesEveryErrorAnExitCode) {
    for (const IssueKind& kind : issue_kinds()) {
        const bool is_error = kind.severity == Severity::error;
        EXPECT_EQ(kind.exit_code != ExitCode::ok, is_error) << kind.id;
        EXPECT_TRUE(kind.id.starts_with(is_error ? "E-" : "W-")) << kind.id;
        EXPECT_TRUE(kind.meaning.ends_with(".")) << kind.id;
        EXPECT_FALSE(is_error && kind.advice.empty()) << kind.id << ": an error says what to try";
    }
}

TEST(IssueTable, UsesCapitalsDigitsAndDashesInIds) {
    for (const IssueKind& kind : issue_kinds()) {
        EXPECT_TRUE(std::all_of(kind.id.begin(), kind.id.end(), [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        })) << kind.id;
    }
}

TEST(FormatIssue, SaysCodePlaceDetailAndAdvice) {
    const Issue issue{IssueCode::glb_magic, "deer.glb", "expected 'glTF', found 'glTG'"};
    EXPECT_EQ(
        format_issue(issue),
        "error[E-GLB-MAGIC]: deer.glb: expected 'glTF', found 'glTG'; try: export as binary glTF (.glb)");
    EXPECT_EQ(format_issue({IssueCode::warn_glb_chunk, "", "chunk 'abcd'"}),
              "warning[W-GLB-CHUNK]: chunk 'abcd'");
}

TEST(FormatIssue, IsOneLineWhateverTheInputHolds) {
    const Issue issue{IssueCode::io_open, "a\nb\x1B[2J", "found \r\n\t\x7F\xFF\xC2\x9B"};
    const std::string line = format_issue(issue);
    EXPECT_TRUE(std::none_of(line.begin(), line.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    })) << line;
    EXPECT_NE(line.find("a\\x0ab\\x1b[2J"), std::string::npos) << line;
}

TEST(FormatIssue, StaysShortForLongInput) {
    const Issue issue{IssueCode::io_open, std::string(100'000, 'a'), std::string(100'000, 'b')};
    EXPECT_LT(format_issue(issue).size(), 4096u);
}

TEST(FormatIssueJson, IsValidJsonOnOneLine) {
    const std::string json = format_issue_json({IssueCode::cat_key, "/animals\n", "found '\xFF\"'"});
    EXPECT_EQ(check_json(json).fault, JsonFault::none) << json;
    EXPECT_EQ(json.find('\n'), std::string::npos);
    EXPECT_NE(json.find(R"("code":"E-CAT-KEY")"), std::string::npos);
    EXPECT_NE(json.find(R"("exit_code":4)"), std::string::npos);
}

TEST(At, PutsThePlaceInFront) {
    EXPECT_EQ(at("deer.glb", {IssueCode::glb_quat, "", ""}).where, "deer.glb");
    EXPECT_EQ(at("deer.glb", {IssueCode::glb_quat, "nodes/3", ""}).where, "deer.glb: nodes/3");
}

TEST(Result, HoldsAValueOrAnIssue) {
    const Result<int> good(7);
    const Result<int> bad(Issue{IssueCode::usage, "", "x"});
    EXPECT_TRUE(good);
    EXPECT_EQ(good.value(), 7);
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.issue().code, IssueCode::usage);
    EXPECT_TRUE(Status());
    EXPECT_FALSE(Status(Issue{IssueCode::usage, "", "x"}));
}

}  // namespace
}  // namespace posepack::base
