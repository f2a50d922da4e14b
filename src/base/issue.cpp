// SPDX-License-Identifier: MIT
#include "base/issue.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "base/text.hpp"

namespace posepack::base {
namespace {

constexpr std::array kKinds{
#define POSEPACK_ISSUE(name, id, severity, exit_code, meaning, advice) \
    IssueKind{IssueCode::name, id, Severity::severity, ExitCode::exit_code, meaning, advice},
#include "base/issue_table.def"
#undef POSEPACK_ISSUE
};

std::string_view severity_name(Severity severity) {
    return severity == Severity::error ? "error" : "warning";
}

}  // namespace

const IssueKind& issue_kind(IssueCode code) {
    return kKinds[static_cast<std::size_t>(code)];
}

std::span<const IssueKind> issue_kinds() {
    return kKinds;
}

std::string format_issue(const Issue& issue) {
    const IssueKind& kind = issue_kind(issue.code);
    std::string line = fmt::format("{}[{}]: ", severity_name(kind.severity), kind.id);
    if (!issue.where.empty()) line += printable(issue.where) + ": ";
    line += printable(issue.detail);
    if (!kind.advice.empty()) line += fmt::format("; try: {}", kind.advice);
    return line;
}

std::string format_issue_json(const Issue& issue) {
    const IssueKind& kind = issue_kind(issue.code);
    const nlohmann::json object{{"advice", kind.advice},
                                {"code", kind.id},
                                {"detail", printable(issue.detail)},
                                {"exit_code", static_cast<int>(kind.exit_code)},
                                {"severity", severity_name(kind.severity)},
                                {"where", printable(issue.where)}};
    return object.dump();
}

Issue at(std::string_view prefix, Issue issue) {
    issue.where = issue.where.empty() ? std::string(prefix) : fmt::format("{}: {}", prefix, issue.where);
    return issue;
}

}  // namespace posepack::base
