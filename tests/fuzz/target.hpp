// SPDX-License-Identifier: MIT
// What fuzz targets share: an entry point, and a place to say what became of an input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

// The entry point that libFuzzer calls, and replay.cpp in its stead. Always returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace posepack::fuzz {

// Receives every outcome of a run where set; libFuzzer runs set none.
inline std::function<void(const std::string&)> outcome_sink;

inline void note_outcome(const std::string& outcome) {
    if (outcome_sink) outcome_sink(outcome);
}

}  // namespace posepack::fuzz
