// SPDX-License-Identifier: MIT
#include "cli/diagnostics.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace posepack::cli {

DiagnosticStyle& diagnostic_style() {
    static DiagnosticStyle style;
    return style;
}

void print_issue(const base::Issue& issue) {
    const bool warning = issue_kind(issue.code).severity == base::Severity::warning;
    if (warning && diagnostic_style().quiet) return;
    if (diagnostic_style().json)
        fmt::print(stderr, "{}\n", format_issue_json(issue));
    else
        fmt::print(stderr, "posepack: {}\n", format_issue(issue));
}

void print_issues(std::span<const base::Issue> issues) {
    for (const base::Issue& issue : issues) print_issue(issue);
}

int exit_code_of(const base::Issue& issue) {
    return static_cast<int>(issue_kind(issue.code).exit_code);
}

int fail(const base::Issue& issue) {
    print_issue(issue);
    return exit_code_of(issue);
}

}  // namespace posepack::cli
