// SPDX-License-Identifier: MIT
// The only door to meshoptimizer: streams of EXT_meshopt_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/result.hpp"

namespace posepack::animal {

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };

struct MeshoptStream {
    std::span<const std::uint8_t> bytes;
    std::size_t count = 0;         // of elements
    std::size_t stride_bytes = 0;  // of an element
    MeshoptMode mode = MeshoptMode::attributes;
    MeshoptFilter filter = MeshoptFilter::none;
};

// Checks what can be known before decoding: that count and stride fit mode and filter, that the stream's
// version is one that the library reads, and that its bytes can hold so many elements at all.
// Errors, with an empty `where`: E-GLB-MESHOPT; E-GLB-EXTENSION for a stream of a later version.
base::Status check_meshopt(const MeshoptStream& stream);

// Decodes a stream that check_meshopt accepted into `out`, which holds count x stride_bytes.
// Errors, with an empty `where`: E-GLB-MESHOPT.
base::Status decode_meshopt(const MeshoptStream& stream, std::span<std::uint8_t> out);

}  // namespace posepack::animal
