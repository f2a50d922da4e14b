// SPDX-License-Identifier: MIT
// The error of a palette as it is drawn: a reader's arithmetic in 32-bit float from the texels to the vertex
// in model space, against the source curves in double precision.
//
// Beside measure/ this is a second measurement: it reads the container alone through the loader (whatever its
// row scheme), makes phases of times in float as a reader does (docs/format/posepack-1.md, section 11), skins
// in float with both fixed matrices, and looks at many more times. Halves below 2^-14 count as zero, as on
// some GPUs.
#pragma once

#include <span>

#include "animal/animal.hpp"
#include "base/files.hpp"
#include "base/result.hpp"
#include "stress/reader.hpp"

namespace posepack::stress {

// Fractions of R, over (vertices x times) of all clips.
struct Amounts {
    double max = 0.0, p999 = 0.0, rms = 0.0;
};

struct DrawnError {
    Amounts rows;  // at uniform rows alone; zeros under runs, whose bones share none
    Amounts all;   // at the rows and between them
};

// Measures `container`, the palette of every clip of `animal` in their order: at uniform rows, and between
// two rows (of any bone) or keys at 4 to 17 times, by their number. Errors: E-INTERNAL when the loader
// refuses the bytes.
base::Result<DrawnError> measure_drawn(const animal::Animal& animal, std::span<const std::uint8_t> container,
                                       const Reader& reader);

}  // namespace posepack::stress
