// SPDX-License-Identifier: MIT
// Reads the generator's GLBs for its tests, knowing nothing of the generator: JSON, accessors, joint places.
#pragma once

#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace posepack::menagerie {

class GlbProbe {
 public:
    explicit GlbProbe(const std::vector<std::uint8_t>& glb);

    const nlohmann::json& document() const { return document_; }
    std::size_t binary_size() const { return binary_.size(); }

    // Elements of an accessor, each as its components.
    const std::vector<std::vector<double>>& values(int accessor) const;

    // The animation whose name ends in `name` after the last bar.
    const nlohmann::json& animation(std::string_view name) const;

    // Longest list of key times of an animation, seconds.
    std::vector<double> key_times(const nlohmann::json& animation) const;

    // Global transforms of all nodes at a key of an animation (channels with two keys are constant).
    std::vector<glm::dmat4> globals(const nlohmann::json& animation, std::size_t key) const;

    // Index of the node with this name; fails the test when there is none.
    std::size_t node(std::string_view name) const;

    // The farthest that any joint lies apart at two keys.
    double largest_gap_m(const nlohmann::json& animation, std::size_t key_a, std::size_t key_b) const;

 private:
    nlohmann::json document_;
    std::string binary_;
    mutable std::map<int, std::vector<std::vector<double>>> known_;  // accessors already read
};

}  // namespace posepack::menagerie
