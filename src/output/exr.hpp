// SPDX-License-Identifier: MIT
// OpenEXR export: the texels of a palette as an image, its tables as attributes.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "posepack/loader.h"

namespace posepack::output {

// An OpenEXR file (lossless ZIP, one part, scan lines) with channels R, G, B, A: half for RGBA16F, float for
// RGBA32F, bit for bit the texels of the container. Pixel (x, y) is texel x of texture line y. String
// attributes posepack:clips, posepack:states, posepack:bones, posepack:space (JSON), posepack:encoding,
// posepack:texelOrder and int attributes posepack:boneCount, posepack:rowCount, posepack:texelsPerBone,
// posepack:rowsPerLine describe them. Errors: E-IO-WRITE when OpenEXR fails.
base::Result<std::vector<std::uint8_t>> export_exr(const posepack_view& view);

}  // namespace posepack::output
