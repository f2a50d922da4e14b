// SPDX-License-Identifier: MIT
// A stress case as a row of data: why it is hard, how it is built, what bound it has and what must happen.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "menagerie/raw_model.hpp"
#include "recipe/catalog.hpp"
#include "stress/action.hpp"
#include "stress/reader.hpp"

namespace posepack::stress {

// The rows that a case starts from.
struct Start {
    std::optional<double> rate_hz{};  // nothing: the key grid of the clip
    recipe::Wrap wrap = recipe::Wrap::once;
    recipe::Seam seam = recipe::Seam::automatic;
};

// The default bound and a finer one: half a pixel, or a tenth, of an animal 200 pixels tall (p99.9).
inline constexpr Bound kUsual{2e-2, 5e-3};
inline constexpr Bound kFine{5e-3, 1e-3};

struct StressCase {
    std::string_view name;     // lower case, digits and _
    std::string_view trouble;  // why it is hard, without a full stop
    menagerie::RawModel (*build)();
    Expected expected;
    Start start{};
    Bound bound = kUsual;
    Reader reader{};
};

struct CaseGroup {
    std::string_view title;
    std::string_view lesson;  // what its cases show, in a sentence or two
    std::span<const StressCase> cases;
    bool in_both_spaces = false;  // the space of the rows matters: show all forms in both
};

// All cases; names are unique.
std::span<const CaseGroup> case_groups();

// The groups, each in a file of its own.
CaseGroup place_cases();
CaseGroup speed_cases();
CaseGroup shape_cases();
CaseGroup key_cases();
CaseGroup skin_cases();
CaseGroup fault_cases();
CaseGroup reader_cases();

// The entry that bakes a case at its start, in the form of the defaults.
recipe::AnimalEntry entry_of(const StressCase& stress_case);

// The wishes of `entry`, but for a bound: then the compiler chooses form and rows, and no rate is asked for.
recipe::AnimalEntry under_bound(recipe::AnimalEntry entry, const Bound& bound);

}  // namespace posepack::stress
