// SPDX-License-Identifier: MIT
// Issues on stderr, one line each, and the exit code that follows.
#pragma once

#include <span>

#include "base/issue.hpp"

namespace posepack::cli {

// How issues are printed; set once by main, from the global options.
struct DiagnosticStyle {
    bool json = false;   // one JSON object a line
    bool quiet = false;  // no warnings
};
DiagnosticStyle& diagnostic_style();

void print_issue(const base::Issue& issue);
void print_issues(std::span<const base::Issue> issues);

int exit_code_of(const base::Issue& issue);

// Prints `issue` and gives its exit code.
int fail(const base::Issue& issue);

}  // namespace posepack::cli
