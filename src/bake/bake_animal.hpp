// SPDX-License-Identifier: MIT
// One animal: from the bytes of its GLB to the bytes of its container.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "base/result.hpp"
#include "choose/choose_rows.hpp"
#include "measure/error_heat.hpp"
#include "recipe/catalog.hpp"
#include "recipe/manifest.hpp"

namespace posepack::bake {

struct AnimalOptions {
    bool strict = false;             // refuse what would be repaired
    bool measure = true;             // measure the error of the written bytes
    bool compare_vat = false;        // add the VRAM of the other forms to the record
    bool allow_data_uris = false;    // read buffers that stand as base64 in the JSON
    choose::Means means;             // where a bound chooses: all, but for measurements
    std::uint32_t heat_columns = 0;  // measure errors over time and bone too, in about so many bins of time
                                     // over all clips together; 0: not. Needs `measure`
};

struct BakedAnimal {
    base::Bytes container;
    recipe::BakeRecord record;
    std::vector<base::Issue> findings;  // warnings about the model and its clips
    double bake_s = 0.0;                // read, sample, encode, write; without the measurement
    double measure_s = 0.0;
    std::optional<measure::ErrorHeat> heat;  // of AnimalOptions::heat_columns
};

// Opens bytes that this program has just written. A refusal is our own fault, not that of a file that
// somebody gave. Errors: E-INTERNAL.
base::Status check_own_bytes(std::span<const std::uint8_t> container);

// Bakes `entry` from `glb`. A pure function of its arguments and the version of posepack, but for the times.
// Errors: those of read_animal, select_clips and choose_states, E-LIM-ROWS, E-LIM-TEXTURE, E-LIM-CONTAINER,
// E-LIM-HALF-RANGE, E-LIM-FLOAT-RANGE; E-INTERNAL where the loader refuses what was written.
base::Result<BakedAnimal> bake_animal(const recipe::AnimalEntry& entry, std::span<const std::uint8_t> glb,
                                      const AnimalOptions& options);

}  // namespace posepack::bake
