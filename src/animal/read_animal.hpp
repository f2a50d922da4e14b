// SPDX-License-Identifier: MIT
// Reads a skinned, animated GLB into an Animal, or says why it cannot.
#pragma once

#include <cstdint>
#include <span>

#include "animal/animal.hpp"
#include "base/result.hpp"

namespace posepack::animal {

inline constexpr std::uint64_t kMaxGlbBytes = 512ull << 20;

struct ReadOptions {
    bool strict = false;           // refuse what would be repaired
    bool allow_data_uris = false;  // read buffers that stand as base64 in the JSON
    std::size_t influences = 4;    // of a vertex that are kept: the largest; 1 to kMaxInfluences
};

// Reads the GLB in `bytes` (glTF 2.0, section 4.4). Buffers come from the BIN chunk alone (and from data URIs
// where they are allowed), no file is ever opened, and images are never decoded. Compressed data
// (KHR_draco_mesh_compression, EXT_meshopt_compression) is decoded where it is used. What the file gets wrong
// is repaired where a repair is safe (a warning in Animal::findings), else refused.
// Errors: E-GLB-*, E-LIM-*. `where` of an issue is the place in the glTF ("accessors/12").
base::Result<Animal> read_animal(std::span<const std::uint8_t> bytes, const ReadOptions& options = {});

}  // namespace posepack::animal
