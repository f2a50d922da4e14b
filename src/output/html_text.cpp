// SPDX-License-Identifier: MIT
#include "output/html_text.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace posepack::output {
namespace {

// The character of three bytes at the start of well-formed UTF-8; 0 where another length begins.
unsigned three_byte_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.size() < 3 || (byte(0) & 0xF0u) != 0xE0u) return 0;
    return (byte(0) & 0x0Fu) << 12 | (byte(1) & 0x3Fu) << 6 | (byte(2) & 0x3Fu);
}

// Marks that reorder text (Unicode's bidirectional algorithm), and what XML has no place for.
bool is_unwelcome(unsigned character) {
    return (character >= 0x202A && character <= 0x202E) || (character >= 0x2066 && character <= 0x2069) ||
           character == 0xFFFE || character == 0xFFFF;
}

}  // namespace

std::string html_text(std::string_view text, std::size_t limit) {
    const std::string safe = base::printable(base::shortened(text, limit));
    std::string out;
    for (std::size_t i = 0; i < safe.size(); ++i) {
        const char c = safe[i];
        if (const unsigned found = three_byte_character(std::string_view(safe).substr(i));
            is_unwelcome(found)) {
            out += fmt::format("\\u{:04x}", found);
            i += 2;
        } else if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else if (c == '"') {
            out += "&quot;";
        } else if (c == '\'') {
            out += "&#39;";
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace posepack::output
