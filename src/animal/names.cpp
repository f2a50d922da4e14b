// SPDX-License-Identifier: MIT
#include "animal/names.hpp"

#include <fmt/format.h>

#include <set>

#include "base/text.hpp"

namespace posepack::animal {
namespace {

constexpr std::size_t kMaxNameBytes = 255;
constexpr std::size_t kEllipsisBytes = 3;  // what base::shortened may add

std::string without_controls(std::string_view name) {
    std::string out(name);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto byte = static_cast<unsigned char>(out[i]);
        const bool c1 = byte == 0xC2 && i + 1 < out.size() && static_cast<unsigned char>(out[i + 1]) < 0xA0;
        if (byte < 0x20 || byte == 0x7F) out[i] = '_';
        if (c1) out.replace(i, 2, "_");
    }
    return out;
}

}  // namespace

std::string_view after_last_bar(std::string_view name) {
    const std::size_t bar = name.rfind('|');
    return bar == std::string_view::npos ? name : name.substr(bar + 1);
}

std::vector<std::string> clip_names(const std::vector<std::string>& source_names) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (std::size_t i = 0; i < source_names.size(); ++i) {
        std::string plain = without_controls(after_last_bar(source_names[i]));
        if (plain.empty()) plain = fmt::format("clip_{}", i);
        std::string name = plain;
        for (int n = 2; !taken.insert(base::lowered(name)).second; ++n) {
            const std::string suffix = fmt::format("_{}", n);
            name = base::shortened(plain, kMaxNameBytes - suffix.size() - kEllipsisBytes) + suffix;
        }
        names.push_back(name);
    }
    return names;
}

base::Result<std::string> usable_name(std::string_view name, std::string_view fallback) {
    if (name.empty()) return std::string(fallback);
    if (name.size() > kMaxNameBytes)
        return base::Issue{
            base::IssueCode::lim_string, std::string(fallback),
            fmt::format("expected a name of at most {} bytes, found {}", kMaxNameBytes, name.size())};
    return without_controls(name);
}

}  // namespace posepack::animal
