// SPDX-License-Identifier: MIT
// Runs stress cases: measures every form, lets the compiler choose under the bound, and compares what it does
// with what is expected.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "stress/drawn_error.hpp"
#include "stress/form.hpp"
#include "stress/stress_case.hpp"

namespace posepack::stress {

// One form of a case at its start.
struct FormResult {
    Form form;
    std::optional<base::Issue> refusal;  // then nothing else is set
    std::uint32_t row_count = 0;
    std::uint64_t texel_bytes = 0;
    DrawnError drawn;
    Amounts printed;  // as a bake prints it
    double normal_max_deg = 0.0;
};

// What the compiler chose. Form and slots are those of the first clip.
struct Chosen {
    Form form;
    bool has_slots = false;
    std::uint32_t cut_count = 0;             // jumps that a row ends in front of
    std::uint64_t bone_row_count = 0;        // shared ones once
    std::uint64_t start_bone_row_count = 0;  // of the rows that the case starts from
    std::uint64_t texel_bytes = 0;
    DrawnError drawn;
};

struct CaseResult {
    const StressCase* stress_case = nullptr;
    std::string_view group;
    Bound bound;                    // the case's, times the factor
    std::vector<FormResult> forms;  // in the order of all_forms()
    std::optional<Chosen> chosen;   // nothing where it refuses
    Found found;
    std::string difference;  // empty: as expected
};

struct RunOptions {
    std::vector<std::string> only;  // names of cases; empty: all
    double bound_factor = 1.0;      // above 0
    unsigned jobs = 0;              // threads; 0: one a core
};

// Results in the order of the groups, whatever the number of threads.
// Errors: E-USAGE for a name that no case has; E-INTERRUPTED; E-INTERNAL.
base::Result<std::vector<CaseResult>> run_cases(const RunOptions& options);

// One case, as above. Errors: E-INTERNAL.
base::Result<CaseResult> run_case(const StressCase& stress_case, std::string_view group, double bound_factor);

}  // namespace posepack::stress
