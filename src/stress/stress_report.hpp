// SPDX-License-Identifier: MIT
// Results of stress cases as text for people and as JSON for programs.
#pragma once

#include <span>
#include <string>

#include "stress/run_cases.hpp"

namespace posepack::stress {

// The names of all cases and why they are hard, a table a group.
std::string stress_list();

// A table a group, one line a case: the largest drawn error of each form at the start, the bound, and what
// the compiler does. Forms in the other space follow where that matters. Ends with a line of counts.
std::string stress_text(std::span<const CaseResult> results);

// Of each case all forms in both spaces, with all figures: a block a case.
std::string stress_details(std::span<const CaseResult> results);

// One object of schemas/stress-1.schema.json, every key there.
std::string stress_json(std::span<const CaseResult> results, double bound_factor);

}  // namespace posepack::stress
