// SPDX-License-Identifier: MIT
// A GLB parsed by tinygltf: from bytes to its model, with every structural lie that tinygltf lets through
// still inside. Only the readers of this room may look at it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "animal/gltf_facts.hpp"
#include "animal/read_animal.hpp"
#include "animal/tinygltf.hpp"
#include "base/result.hpp"

namespace posepack::animal {

struct LoadedGltf {
    std::unique_ptr<tinygltf::Model> model;  // without all that GltfFacts hides
    GltfFacts facts;
    std::span<const std::uint8_t> bin;  // the BIN chunk; points into the file's bytes
    std::uint64_t file_bytes = 0;
    std::uint32_t unknown_chunk_count = 0;

    const tinygltf::Model& model_ref() const { return *model; }
};

// Checks the shell and the JSON of the GLB, then parses it. `bytes` must live as long as the result.
// Errors: those of split_glb and read_gltf_facts, E-LIM-FILE, E-GLB-SCHEMA.
base::Result<LoadedGltf> load_gltf(std::span<const std::uint8_t> bytes, const ReadOptions& options = {});

}  // namespace posepack::animal
