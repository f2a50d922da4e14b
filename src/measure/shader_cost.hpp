// SPDX-License-Identifier: MIT
// What reading a palette costs a vertex shader, counted by hand.
#pragma once

#include <cstdint>

#include "recipe/catalog.hpp"

namespace posepack::measure {

// Of one vertex with four influences that blends two rows of each bone and moves a position and a normal.
// A reader that skips influences of weight zero does less: real vertices have 1.8 of them on average.
struct ShaderCost {
    std::uint32_t fetches = 0;         // texels read
    std::uint32_t alu_operations = 0;  // scalar multiply-adds, about
};

// The counts of the encoding's page in docs/encodings. They do not depend on the texel format.
ShaderCost shader_cost(recipe::Encoding encoding);

}  // namespace posepack::measure
