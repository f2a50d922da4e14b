// SPDX-License-Identifier: MIT
// A picture in 256 colours, so that its file is small.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace posepack::render {

using Rgb = std::array<std::uint8_t, 3>;

struct IndexedPicture {
    std::vector<Rgb> colours;           // at most 256
    std::vector<std::uint8_t> indices;  // a pixel each
};

// Chooses the colours that fit the picture best and gives every pixel the nearest, or the one of its
// neighbour where that is almost as near: runs compress well. `rgb` holds lines of `width` pixels.
IndexedPicture reduce_colours(std::span<const std::uint8_t> rgb, int width);

}  // namespace posepack::render
