// SPDX-License-Identifier: MIT
// What the compiler does about a bound, and what was expected of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/issue.hpp"

namespace posepack::stress {

// Largest errors allowed, fractions of R.
struct Bound {
    double max = 0.0, p999 = 0.0;
};

// Without any of these the bound is met by dual quaternions in halves, in runs of no more bone-rows than the
// rows of the start have.
struct Action {
    bool switches_form = false;                // to matrices, or to floats
    bool adds_rows = false;                    // more bone-rows than the start has
    bool has_slots = false;                    // rows at uneven times
    bool cuts = false;                         // slots: a row ends in front of a jump
    bool misses = false;                       // what was chosen does not hold the bound in this reader
    std::optional<base::IssueCode> refuses{};  // then nothing else is set

    bool operator==(const Action&) const = default;
};

inline constexpr Action kMeets{};
inline constexpr Action kSwitchesForm{.switches_form = true};
inline constexpr Action kAddsRows{.adds_rows = true};
inline constexpr Action kSwitchesAndAddsRows{.switches_form = true, .adds_rows = true};
inline constexpr Action kSlots{.has_slots = true};
inline constexpr Action kCuts{.has_slots = true, .cuts = true};
inline constexpr Action kMisses{.misses = true};
constexpr Action refuses(base::IssueCode code) {
    Action action;
    action.refuses = code;
    return action;
}

// "meets the bound", "switches form, slots", "refuses: E-LIM-BOUND".
std::string text_of(const Action& action);

// What a case expects.
struct Expected {
    Action action;
    std::string_view says{};                   // words that the refusal must hold
    std::optional<base::IssueCode> warning{};  // of a bake at the start
};

// What happened.
struct Found {
    Action action;
    std::string refusal;                    // the sentence; empty where nothing is refused
    std::vector<base::IssueCode> warnings;  // of a bake at the start, each once
};

// What of `found` is not as expected, as a sentence; empty where all is.
std::string difference(const Expected& expected, const Found& found);

}  // namespace posepack::stress
