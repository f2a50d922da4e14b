// SPDX-License-Identifier: MIT
// Text of strangers inside HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace posepack::output {

// `text` as character data or as the content of a quoted attribute, in HTML and in XML: & < > " ' as numeric
// or XML entities, control characters and malformed UTF-8 as \xNN, marks that reorder text (U+202A to U+202E,
// U+2066 to U+2069) and what XML forbids (U+FFFE, U+FFFF) as \uNNNN; cut with "..." after `limit` bytes.
std::string html_text(std::string_view text, std::size_t limit = 256);

}  // namespace posepack::output
