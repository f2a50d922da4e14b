// SPDX-License-Identifier: MIT
// Rules that a glTF must keep before a parser may build its tree: how much there may be of it, and values
// that tinygltf drops unsaid where their type is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace posepack::animal {

// Hears the JSON as it is read. Depth counts the open objects and arrays: keys of the root are at depth 1.
class GltfRules {
 public:
    void key(std::string_view name, std::size_t depth);
    void text(std::string_view value, std::size_t depth);
    void number(double value, std::size_t depth);
    void truth(std::size_t depth) { scalar(depth); }
    void open(std::size_t depth, bool is_array);

    // Errors: E-GLB-VERSION (asset.minVersion beyond 2.0, or none and a version that is not 2), E-LIM-COUNT
    // (more than 65,536 items in a list of the root, or 131,072 objects), E-GLB-SCHEMA (a node's list is no
    // list, or a child no whole number).
    base::Status status() const;

    // Whether there is too much already: what follows need not be kept.
    bool is_over() const { return !too_many_.empty(); }

    // Whether some channel says what it moves: a target's node, or a KHR_animation_pointer.
    bool has_target() const { return has_target_; }

 private:
    enum class Section : std::uint8_t { other, asset, nodes, animations };

    void scalar(std::size_t depth);

    Section section_ = Section::other;
    std::string section_name_, too_many_, wrong_type_, min_version_, own_version_;
    std::string GltfRules::*version_ = nullptr;  // of the two, where the next text of the asset goes
    std::string_view node_list_;  // the key of a node that stands at depth 3, where it wants a list
    std::size_t object_count_ = 0, item_count_ = 0;
    bool has_target_ = false;
};

}  // namespace posepack::animal
