// SPDX-License-Identifier: MIT
// What must be known of a glTF before a parser may see it, and what that parser does not tell.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "animal/storage_facts.hpp"
#include "base/result.hpp"

namespace posepack::animal {

struct BufferFacts {
    double byte_length = -1.0;  // as declared; below 0 when it is not
    bool has_uri = false;
    bool is_fallback = false;  // of EXT_meshopt_compression: its bytes are never needed
    std::string uri;           // verbatim where it is a data URI, else its first bytes for messages
};

// A channel that KHR_animation_pointer aims, which may have no target node.
struct PointerChannel {
    std::size_t animation = 0, channel = 0;  // channel: among all channels of the animation
    int sampler = -1;
    std::string pointer;  // "/nodes/3/rotation"
};

struct PrimitiveIndices {
    std::size_t mesh = 0, primitive = 0;
    int accessor = -1;
};

struct GltfFacts {
    bool root_is_object = false;
    std::vector<BufferFacts> buffers;
    std::vector<PointerChannel> pointers;
    std::vector<PrimitiveIndices> indices;  // in the order of the file
    std::uint32_t image_count = 0, outside_image_count = 0;
    bool has_target = false;        // some channel says what it moves
    std::string unknown_extension;  // required, but not read; empty: none
    std::vector<AccessorFacts> accessors;
    std::vector<ViewFacts> views;
    // What tinygltf must not see: where the contents of the lists "accessors", "bufferViews", "buffers" and
    // "images" begin and end, which are read here or by nobody; and where the keys "indices" of primitives
    // begin, since it refuses accessors that it does not know.
    std::vector<std::pair<std::size_t, std::size_t>> hidden_lists;
    std::vector<std::size_t> hidden_keys;

    // The accessor of a primitive's indices, or -1.
    int indices_of(std::size_t mesh, std::size_t primitive) const;
};

// Checks the JSON chunk and gathers its facts, in one streaming pass.
// Errors: E-GLB-JSON*, E-GLB-NUMBER, E-LIM-JSON-DEPTH; E-GLB-JSON when the root is no object; E-GLB-EXTENSION
// for a required extension that posepack neither reads nor may ignore; E-GLB-URI for a buffer outside the
// file, unless it is a fallback, or a data URI and `allow_data_uris` is set; E-GLB-SCHEMA for a
// buffer, buffer view or accessor that lacks what it must have; those of GltfRules.
base::Result<GltfFacts> read_gltf_facts(std::string_view json, bool allow_data_uris);

// The text again as tinygltf may see it: hidden lists are empty, hidden keys have another first letter.
std::string text_for_parser(std::string_view json, const GltfFacts& facts);

}  // namespace posepack::animal
