// SPDX-License-Identifier: MIT
// How messy an animal is: numbers by which generated files are held against real ones.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "menagerie/model.hpp"

namespace posepack::menagerie {

struct Statistics {
    std::size_t joints = 0;
    std::size_t root_joints = 0;  // joints directly under the armature
    std::size_t depth = 0;        // of the joint tree
    std::size_t vertices = 0;
    std::size_t clips = 0;
    double mean_influences = 0.0;         // joints a vertex
    double weightless_share = 0.0;        // joints that no vertex follows
    double constant_channel_share = 0.0;  // of translation, rotation and scale of every joint and clip
    std::size_t json_bytes = 0;           // of the JSON chunk
    int rate_hz = 0;
    double step_p50_degrees = 0.0;  // turns between neighbouring keys that turn at all (over 0.05 degrees)
    double step_p99_degrees = 0.0;  // of all
    double step_max_degrees = 0.0;
};

// `json_bytes` is taken from the file: pass the size of its JSON chunk.
Statistics statistics_of(const Model& model, std::size_t json_bytes);

// The same numbers over the nine four-legged animals of Quaternius' Animated Animal Pack (CC0), least and
// greatest: alpaca, bull, deer, donkey, fox, horse, husky, stag and wolf.
struct RealRange {
    std::string_view name;
    double least = 0.0;
    double greatest = 0.0;
};

const std::array<RealRange, 10>& real_ranges();

}  // namespace posepack::menagerie
