// SPDX-License-Identifier: MIT
#include "animal/data_uri.hpp"

#include <fmt/format.h>

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

// Value of a base64 letter, or -1.
int sextet(char letter) {
    if (letter >= 'A' && letter <= 'Z') return letter - 'A';
    if (letter >= 'a' && letter <= 'z') return letter - 'a' + 26;
    if (letter >= '0' && letter <= '9') return letter - '0' + 52;
    if (letter == '+') return 62;
    return letter == '/' ? 63 : -1;
}

}  // namespace

base::Result<std::vector<std::uint8_t>> decode_data_uri(std::string_view uri, DecodeBudget& budget) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
        return Issue{IssueCode::glb_uri, "", "expected a data URI in base64"};
    std::string_view text = uri.substr(comma + 1);
    while (text.ends_with('=')) text.remove_suffix(1);
    if (text.size() % 4 == 1) return Issue{IssueCode::glb_uri, "", "the base64 text is cut off"};
    const std::size_t size = text.size() / 4 * 3 + (text.size() % 4 == 0 ? 0 : text.size() % 4 - 1);
    if (auto status = budget.take(1, size); !status) return status.issue();
    std::vector<std::uint8_t> out;
    out.reserve(size);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int value = sextet(text[i]);
        if (value < 0)
            return Issue{IssueCode::glb_uri, "", fmt::format("letter {} of the data URI is no base64", comma + 1 + i)};
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if (i % 4 == 3)
            for (int shift = 16; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
    // Two or three letters are left: 12 or 18 bits, of which the first 8 or 16 count.
    if (text.size() % 4 == 2) out.push_back(static_cast<std::uint8_t>(bits >> 4));
    if (text.size() % 4 == 3) {
        out.push_back(static_cast<std::uint8_t>(bits >> 10));
        out.push_back(static_cast<std::uint8_t>(bits >> 2));
    }
    return out;
}

}  // namespace posepack::animal
