// SPDX-License-Identifier: MIT
// Strict JSON checks for text from strangers: one streaming pass, no tree, no recursion.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace posepack::base {

inline constexpr std::size_t kMaxJsonDepth = 64;

enum class JsonFault { none, syntax, utf8, number_range, duplicate_key, too_deep };

struct JsonCheck {
    JsonFault fault = JsonFault::none;
    std::size_t offset = 0;  // byte where it was found
    std::string detail;      // "expected ..., found ..." or the key
};

// Checks that `text` is one JSON value in well-formed UTF-8, that no object holds a key twice, that every
// number fits a finite double, and that nothing is nested more than kMaxJsonDepth deep.
// Cost: O(size); memory: the keys of the objects that are open.
JsonCheck check_json(std::string_view text);

}  // namespace posepack::base
