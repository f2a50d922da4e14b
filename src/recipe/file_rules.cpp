// SPDX-License-Identifier: MIT
#include "recipe/file_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.hpp"

namespace posepack::recipe {
namespace {

constexpr std::size_t kDetailBytes = 128;

std::string shown(std::string_view text) {
    return base::printable(base::shortened(text, kDetailBytes));
}

// Whether Windows opens a device for this name, whatever extension follows it.
bool is_device_name(std::string_view name) {
    constexpr std::array<std::string_view, 4> kPlain{"con", "prn", "aux", "nul"};
    const std::string stem = base::lowered(name.substr(0, name.find('.')));
    if (std::find(kPlain.begin(), kPlain.end(), stem) != kPlain.end()) return true;
    const bool is_port = stem.starts_with("com") || stem.starts_with("lpt");
    return is_port && stem.size() == 4 && stem[3] >= '1' && stem[3] <= '9';
}

bool is_id_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

bool is_path_character(char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F && c != '\\' && c != ':';
}

std::string part_fault(std::string_view part) {
    if (part.empty()) return "an empty part";
    if (part == "." || part == "..") return fmt::format("'{}'", part);
    if (is_device_name(part)) return fmt::format("the device name '{}'", shown(part));
    if (part.back() == '.' || part.back() == ' ') return "a part that ends in a dot or a space";
    return {};
}

}  // namespace

std::string id_fault(std::string_view id) {
    constexpr std::string_view kExpected = "expected an id of letters, digits, '_' and '-'";
    if (id.empty()) return fmt::format("{}, found none", kExpected);
    if (id.size() > kMaxIdBytes) {
        return fmt::format("expected an id of at most {} bytes, found {}", kMaxIdBytes, id.size());
    }
    if (!std::all_of(id.begin(), id.end(), is_id_character)) {
        return fmt::format("{}, found '{}'", kExpected, shown(id));
    }
    if (id.front() == '-') return fmt::format("expected an id that begins with no '-', found '{}'", id);
    if (is_device_name(id)) return fmt::format("expected no device name of Windows, found '{}'", id);
    return {};
}

std::string path_fault(std::string_view path) {
    constexpr std::string_view kExpected = "expected a relative path with '/'";
    if (path.empty()) return fmt::format("{}, found none", kExpected);
    if (path.size() > kMaxPathBytes) {
        return fmt::format("expected a path of at most {} bytes, found {}", kMaxPathBytes, path.size());
    }
    if (path.front() == '/') return fmt::format("{}, found the absolute path '{}'", kExpected, shown(path));
    if (!std::all_of(path.begin(), path.end(), is_path_character)) {
        return fmt::format("{} and without '\\', ':' and control characters, found '{}'", kExpected,
                           shown(path));
    }
    for (std::string_view rest = path;;) {
        const std::size_t slash = rest.find('/');
        if (const std::string fault = part_fault(rest.substr(0, slash)); !fault.empty()) {
            return fmt::format("{}, found {} in '{}'", kExpected, fault, shown(path));
        }
        if (slash == std::string_view::npos) return {};
        rest.remove_prefix(slash + 1);
    }
}

}  // namespace posepack::recipe
