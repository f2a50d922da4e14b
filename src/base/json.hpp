// SPDX-License-Identifier: MIT
// Strict JSON checks for text from strangers: one streaming pass, no tree.
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

// Hears what check_json reads, in the order of the text. Views end with the call. A fault may follow at any
// time: whoever listens uses nothing of what it heard unless the check found none.
class JsonVisitor {
 public:
    virtual ~JsonVisitor() = default;
    virtual void key(std::string_view name, std::size_t offset) = 0;  // offset: of its opening quote
    virtual void text(std::string_view value) = 0;
    virtual void number(double value) = 0;
    virtual void truth(bool value) = 0;
    virtual void open(bool is_array, std::size_t offset) = 0;  // an object or an array begins at its bracket
    virtual void close(std::size_t offset) = 0;                // the innermost one ends with this bracket
};

// Checks that `text` is one JSON value in well-formed UTF-8, that no object holds a key twice, that every
// number fits a finite double, and that nothing is nested more than kMaxJsonDepth deep.
// Cost: O(size), no more than 64 levels of recursion; memory: a copy of the text. A visitor spares another
// pass to those who look for something.
JsonCheck check_json(std::string_view text, JsonVisitor* visitor = nullptr);

}  // namespace posepack::base
