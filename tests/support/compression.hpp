// SPDX-License-Identifier: MIT
// Compressed forms of a GlbBuilder's data, written with the encoders of meshoptimizer and Draco themselves.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "support/glb_builder.hpp"

namespace posepack::support {

// A stream of EXT_meshopt_compression in the BIN chunk, and a view on it whose plain bytes would lie in a
// fallback buffer that has none. Returns the index of the view.
int add_meshopt_view(GlbBuilder& glb, std::span<const std::uint8_t> stream, std::size_t count,
                     std::size_t stride_bytes, const std::string& mode, const std::string& filter = "NONE");

// Streams of each mode. Elements are `stride_bytes` long.
Bytes meshopt_attributes(std::span<const std::uint8_t> elements, std::size_t stride_bytes);
Bytes meshopt_triangles(const std::vector<std::uint32_t>& indices);
Bytes meshopt_indices(const std::vector<std::uint32_t>& indices);

// What the three filters make of floats, ahead of meshopt_attributes: four floats an element of 8 bytes for
// quaternions and octahedral normals, three an element of 12 bytes for the exponential one.
Bytes filter_quaternions(const std::vector<float>& values, int bits);
Bytes filter_normals(const std::vector<float>& values, int bits);
Bytes filter_exponential(const std::vector<float>& values, int bits);

// Moves the data of an accessor, which must have a tightly packed view of its own, into a stream of
// ATTRIBUTES.
void compress_accessor(GlbBuilder& glb, std::size_t accessor);

struct DracoOptions {
    bool edgebreaker = true;  // else sequential
    // Replaces what the stream says of an attribute by another: "POSITION" -> an accessor's index.
    std::map<std::string, int> stored_instead = {};
};

// Moves the attributes of the first primitive of a mesh into a Draco stream, without loss; vertices are taken
// in threes as faces. Their accessors stay, without a view; indices get one as well. Ids of the stream's
// attributes begin at 10.
void compress_primitive(GlbBuilder& glb, std::size_t mesh, const DracoOptions& options);

// The first byte of a view's data in `glb.bin`.
std::uint8_t* view_data(GlbBuilder& glb, int view);

}  // namespace posepack::support
