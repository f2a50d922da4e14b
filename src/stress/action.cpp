// SPDX-License-Identifier: MIT
#include "stress/action.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace posepack::stress {

std::string text_of(const Action& action) {
    if (action.refuses) return fmt::format("refuses: {}", issue_kind(*action.refuses).id);
    std::string text;
    const auto add = [&text](bool is_so, std::string_view words) {
        if (!is_so) return;
        if (!text.empty()) text += ", ";
        text += words;
    };
    add(action.switches_form, "switches form");
    add(action.adds_rows, "adds rows");
    add(action.has_slots, "slots");
    add(action.cuts, "cuts");
    add(action.misses, "misses the bound");
    return text.empty() ? "meets the bound" : text;
}

std::string difference(const Expected& expected, const Found& found) {
    if (expected.action != found.action)
        return fmt::format("expected '{}', found '{}'", text_of(expected.action), text_of(found.action));
    if (found.refusal.find(expected.says) == std::string::npos)
        return fmt::format("expected a refusal that says '{}', found '{}'", expected.says, found.refusal);
    if (expected.warning &&
        std::find(found.warnings.begin(), found.warnings.end(), *expected.warning) == found.warnings.end())
        return fmt::format("expected the warning {}, found none", issue_kind(*expected.warning).id);
    return {};
}

}  // namespace posepack::stress
