// SPDX-License-Identifier: MIT
#include "recipe/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "base/json.hpp"
#include "base/text.hpp"

namespace posepack::recipe {
namespace {

std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return fmt::format("line {}, column {}", line, offset - line_start + 1);
}

base::IssueCode code_of(base::JsonFault fault, const JsonFaultCodes& codes) {
    switch (fault) {
        case base::JsonFault::duplicate_key:
            return codes.duplicate;
        case base::JsonFault::number_range:
            return codes.range;
        case base::JsonFault::too_deep:
            return base::IssueCode::lim_json_depth;
        default:
            return codes.json;
    }
}

}  // namespace

base::Result<nlohmann::json> parse_json(std::string_view text, std::size_t limit_bytes,
                                        const JsonFaultCodes& codes) {
    if (text.size() > limit_bytes) {
        return base::Issue{base::IssueCode::lim_file, "",
                           fmt::format("expected at most {} bytes, found {}", base::grouped(limit_bytes),
                                       base::grouped(text.size()))};
    }
    const base::JsonCheck check = base::check_json(text);
    if (check.fault != base::JsonFault::none) {
        return base::Issue{code_of(check.fault, codes), line_and_column(text, check.offset), check.detail};
    }
    nlohmann::json parsed = nlohmann::json::parse(text, nullptr, false);
    if (parsed.is_discarded()) return base::Issue{codes.json, "", "expected valid JSON, found a fault in it"};
    return parsed;
}

}  // namespace posepack::recipe
