// SPDX-License-Identifier: MIT
// A GLB parsed by tinygltf: from bytes to its model, with every structural lie that tinygltf lets through
// still inside. Only the readers of this room may look at it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "animal/tinygltf.hpp"
#include "base/result.hpp"

namespace posepack::animal {

struct LoadedGltf {
    std::unique_ptr<tinygltf::Model> model;
    std::uint64_t file_bytes = 0;
    std::uint32_t unknown_chunk_count = 0;
};

// Checks the shell and the JSON of the GLB, then parses it.
// Errors: those of split_glb and check_gltf_facts, E-GLB-JSON*, E-GLB-NUMBER, E-LIM-JSON-DEPTH, E-LIM-FILE,
// E-GLB-SCHEMA.
base::Result<LoadedGltf> load_gltf(std::span<const std::uint8_t> bytes);

}  // namespace posepack::animal
