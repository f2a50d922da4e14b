// SPDX-License-Identifier: MIT
// JSON text to a tree, after the strict checks of base/json.hpp.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "base/result.hpp"

namespace posepack::recipe {

// The codes that faults of the text are reported by. Too deep nesting is E-LIM-JSON-DEPTH for every file.
struct JsonFaultCodes {
    base::IssueCode json;       // syntax and UTF-8
    base::IssueCode duplicate;  // a key twice in one object
    base::IssueCode range;      // a number that no double holds
};

// Parses at most `limit_bytes` of JSON. `where` in an issue is "line 3, column 7", counted in bytes from 1.
// Errors: E-LIM-FILE, E-LIM-JSON-DEPTH, and those of `codes`.
base::Result<nlohmann::json> parse_json(std::string_view text, std::size_t limit_bytes,
                                        const JsonFaultCodes& codes);

}  // namespace posepack::recipe
