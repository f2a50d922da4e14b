// SPDX-License-Identifier: MIT
#include "output/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace posepack::output {
namespace {

// Columns that a terminal gives to UTF-8 text: one a character, which is right for the names we print.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<std::uint8_t>(c) & 0xC0) != 0x80; }));
}

void append_line(std::string& out, const TextTable& table, const std::vector<std::string>& cells,
                 const std::vector<std::size_t>& widths) {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const std::string fill(widths[c] - width_of(cells[c]), ' ');
        if (c > 0) line += "  ";
        line += table.columns[c].align == Align::left ? cells[c] + fill : fill + cells[c];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

}  // namespace

std::string format_text(const TextTable& table) {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        std::size_t width = width_of(table.columns[c].title);
        for (const auto& row : table.rows) width = std::max(width, width_of(row[c]));
        if (!table.total.empty()) width = std::max(width, width_of(table.total[c]));
        widths.push_back(width);
    }
    std::size_t rule = 0;
    for (const std::size_t width : widths) rule += width + 2;
    std::vector<std::string> titles;
    for (const Column& column : table.columns) titles.push_back(column.title);
    std::string out;
    append_line(out, table, titles, widths);
    out += std::string(rule > 2 ? rule - 2 : 0, '-') + "\n";
    for (const auto& row : table.rows) append_line(out, table, row, widths);
    if (!table.total.empty()) {
        out += std::string(rule > 2 ? rule - 2 : 0, '-') + "\n";
        append_line(out, table, table.total, widths);
    }
    return out;
}

std::string format_csv(const TextTable& table) {
    std::string out;
    const auto append = [&](const auto& cells, auto text_of) {
        for (std::size_t c = 0; c < cells.size(); ++c) out += (c == 0 ? "" : ",") + quoted(text_of(cells[c]));
        out += "\n";
    };
    append(table.columns, [](const Column& column) { return column.title; });
    for (const auto& row : table.rows) append(row, [](const std::string& text) { return text; });
    return out;
}

std::string readable_bytes(unsigned long long bytes) {
    if (bytes < 1024) return fmt::format("{} B", bytes);
    const char* const units[] = {"KiB", "MiB", "GiB"};
    double value = static_cast<double>(bytes) / 1024.0;
    std::size_t unit = 0;
    while (value >= 1024.0 && unit < 2) {
        value /= 1024.0;
        ++unit;
    }
    return fmt::format("{:.1f} {}", value, units[unit]);
}

std::string readable_error(double value) {
    return value == 0.0 ? "0" : fmt::format("{:.2e}", value);
}

}  // namespace posepack::output
