// SPDX-License-Identifier: MIT
#include "animal/gltf_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

// An object costs a parser's tree some hundred bytes, and the text two or three: what is refused must be
// refused before, to stay under 128 MiB. Real animals have up to 40,000 (eighty clips of forty joints).
constexpr std::size_t kMaxObjects = 131'072;
constexpr std::size_t kMaxListItems = 65'536;  // nodes, accessors, buffer views and so on

constexpr std::array<std::string_view, 5> kNodeLists{"translation", "rotation", "scale", "matrix",
                                                     "children"};

// Versions are "major.minor" (glTF 2.0 section 3.2); one digit each is all that has been given out.
bool is_beyond_2_0(std::string_view version) {
    const std::size_t dot = std::min(version.find('.'), version.size());
    const std::string_view major = version.substr(0, dot);
    const std::string_view minor = version.substr(std::min(dot + 1, version.size()));
    return major.size() > 1 || major > "2" || (major == "2" && !minor.empty() && minor != "0");
}

// A file that names no minVersion is for readers of its own major version. What is no number is another
// fault.
bool is_of_another_major(std::string_view version) {
    const std::string_view major = version.substr(0, std::min(version.find('.'), version.size()));
    return !major.empty() && major != "2" && major.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

void GltfRules::key(std::string_view name, std::size_t depth) {
    if (depth == 1) {
        section_name_ = name;
        item_count_ = 0;
        section_ = name == "asset"        ? Section::asset
                   : name == "nodes"      ? Section::nodes
                   : name == "animations" ? Section::animations
                                          : Section::other;
        return;
    }
    if (section_ == Section::nodes && depth == 3) {
        const auto* const list = std::find(kNodeLists.begin(), kNodeLists.end(), name);
        node_list_ = list == kNodeLists.end() ? std::string_view{} : *list;
    } else if (section_ == Section::asset && depth == 2) {
        version_ = name == "minVersion" ? &GltfRules::min_version_
                   : name == "version"  ? &GltfRules::own_version_
                                        : nullptr;
    } else if (section_ == Section::animations) {
        // animations/A/channels/C/target/node, and target/extensions/KHR_animation_pointer/pointer
        has_target_ = has_target_ || (depth == 6 && name == "node") || (depth == 8 && name == "pointer");
    }
}

void GltfRules::text(std::string_view value, std::size_t depth) {
    scalar(depth);
    if (section_ == Section::asset && depth == 2 && version_ != nullptr) this->*version_ = value;
}

void GltfRules::number(double value, std::size_t depth) {
    scalar(depth);
    // 1.0 is a whole number in JSON; tinygltf would cut 0.5 to 0.
    if (section_ == Section::nodes && depth == 4 && node_list_ == "children" && value != std::floor(value))
        wrong_type_ = node_list_;
}

void GltfRules::open(std::size_t depth, bool is_array) {
    if (section_ == Section::nodes && depth == 3 && !is_array) scalar(depth);
    if (is_array) return;
    if (depth == 2) ++item_count_;
    if ((++object_count_ > kMaxObjects || item_count_ > kMaxListItems) && too_many_.empty())
        too_many_ = section_name_;
}

void GltfRules::scalar(std::size_t depth) {
    if (section_ == Section::nodes && depth == 3 && !node_list_.empty()) wrong_type_ = node_list_;
}

base::Status GltfRules::status() const {
    if (!min_version_.empty() && is_beyond_2_0(min_version_))
        return Issue{IssueCode::glb_version, "asset/minVersion",
                     fmt::format("expected a file for readers of glTF 2.0, found one for {}",
                                 base::printable(base::shortened(min_version_, 64)))};
    if (min_version_.empty() && is_of_another_major(own_version_))
        return Issue{IssueCode::glb_version, "asset/version",
                     fmt::format("expected glTF 2.0, found version {}",
                                 base::printable(base::shortened(own_version_, 64)))};
    if (!too_many_.empty())
        return Issue{IssueCode::lim_count, base::printable(base::shortened(too_many_, 64)),
                     fmt::format("expected at most {} items in a list and {} objects in the file, found more",
                                 kMaxListItems, kMaxObjects)};
    if (!wrong_type_.empty())
        return Issue{IssueCode::glb_schema, "nodes",
                     fmt::format("expected a list of numbers as {}, found another value", wrong_type_)};
    return {};
}

}  // namespace posepack::animal
