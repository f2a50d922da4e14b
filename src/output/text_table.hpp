// SPDX-License-Identifier: MIT
// Tables for people and for programs: aligned text, or CSV.
#pragma once

#include <string>
#include <vector>

namespace posepack::output {

enum class Align { left, right };

struct Column {
    std::string title;
    Align align = Align::right;
};

struct TextTable {
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;  // one text a column
    std::vector<std::string> total;              // a last row under a rule; empty: none
};

// Columns aligned and two spaces apart, a rule under the titles; ends with a newline.
std::string format_text(const TextTable& table);

// RFC 4180: titles first, commas, texts quoted where they need it, CRLF-free (LF) line ends.
std::string format_csv(const TextTable& table);

// 12,345 bytes as "12.1 KiB"; below 1,024 as "12 B".
std::string readable_bytes(unsigned long long bytes);

// A fraction of R, or another small number, in three digits: "1.23e-04", "0" for zero.
std::string readable_error(double value);

}  // namespace posepack::output
