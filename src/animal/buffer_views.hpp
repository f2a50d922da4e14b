// SPDX-License-Identifier: MIT
// BufferViews: the bytes of each buffer view, wherever they come from: the BIN chunk, a data URI, or a stream of
// EXT_meshopt_compression, decoded when its view is first asked for.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "animal/decode_budget.hpp"
#include "animal/load_gltf.hpp"
#include "animal/meshopt.hpp"

namespace posepack::animal {

class BufferViews {
 public:
    // Both must live longer than this.
    BufferViews(const LoadedGltf& gltf, DecodeBudget& budget) : gltf_(gltf), budget_(budget) {}

    // The bytes of a view; they live as long as this. A compressed view is always decoded, even where plain
    // bytes lie beside its stream. Errors, with the view's own place in `where`: E-GLB-REFERENCE,
    // E-GLB-VIEW-RANGE, E-GLB-URI, E-GLB-MESHOPT, E-GLB-EXTENSION, E-GLB-SCHEMA, E-LIM-DECODED.
    base::Result<std::span<const std::uint8_t>> bytes(int view_index);

 private:
    using Bytes = std::vector<std::uint8_t>;

    base::Result<std::span<const std::uint8_t>> buffer(double index);
    base::Result<std::span<const std::uint8_t>> slice(double buffer_index, double offset, double length);
    base::Result<std::span<const std::uint8_t>> decode(const tinygltf::BufferView& view,
                                                       const tinygltf::Value& extension, int view_index);
    base::Result<MeshoptStream> stream_of(const tinygltf::BufferView& view, const tinygltf::Value& extension);

    const LoadedGltf& gltf_;
    DecodeBudget& budget_;
    std::map<int, Bytes> decoded_views_;
    std::map<std::size_t, Bytes> data_uris_;
};

}  // namespace posepack::animal
