// SPDX-License-Identifier: MIT
// Small text helpers: safe printing of input text, names without case, wildcard patterns, near misses.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace posepack::base {

// True when `text` is well-formed UTF-8 (RFC 3629: no surrogates, no overlong forms).
bool is_utf8(std::string_view text);

// `text` with control characters and malformed UTF-8 bytes as \xNN; cut with "..." after 1,024 bytes.
std::string printable(std::string_view text);

// At most `limit` bytes of `text`, cut at a character, with "..." where something was cut.
std::string shortened(std::string_view text, std::size_t limit);

// ASCII letters lowered; other bytes unchanged. Independent of the locale.
std::string lowered(std::string_view text);

// True when `text` matches `pattern`, where * stands for any bytes and ? for one; case-sensitive.
bool matches_pattern(std::string_view text, std::string_view pattern);

// The candidate nearest to `word` by edit distance, or empty when none is within a third of its length.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

// Shortest decimal text that reads back as exactly this float ("0.1", not "0.100000001").
std::string shortest(float value);

// The double whose shortest decimal text is that of `value`: floats written to JSON stay short.
double widened(float value);

// 1234567 -> "1,234,567".
std::string grouped(unsigned long long value);

// A count with its noun: "1 animal", "30 animals"; thousands are grouped. `plural`: where it is not noun +
// "s".
std::string counted(std::uint64_t count, std::string_view noun, std::string_view plural = {});

}  // namespace posepack::base
