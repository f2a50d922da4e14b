// SPDX-License-Identifier: MIT
// PNG output.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace posepack::render {

// Writes 8-bit RGB pixels, the lowest line first as OpenGL reads them back, as a PNG of 256 colours.
// Throws RenderError when the file cannot be written.
void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace posepack::render
