// SPDX-License-Identifier: MIT
// The GLB shell: header and chunks (glTF 2.0 section 4.4).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/result.hpp"

namespace posepack::animal {

struct GlbFile {
    std::string_view json;              // the JSON chunk, trailing spaces included
    std::span<const std::uint8_t> bin;  // the BIN chunk; empty when there is none
    std::uint32_t unknown_chunk_count = 0;
};

// Splits `bytes` into its chunks; the result points into `bytes`.
// Errors: E-GLB-TRUNCATED, E-GLB-MAGIC, E-GLB-VERSION, E-GLB-LENGTH, E-GLB-TRAILING, E-GLB-CHUNK.
base::Result<GlbFile> split_glb(std::span<const std::uint8_t> bytes);

}  // namespace posepack::animal
