// SPDX-License-Identifier: MIT
// Palettes of tiny animals, every clip baked, for the tests of what lies above the palette.
#pragma once

#include <vector>

#include "animal/animal.hpp"
#include "motion/row_plan.hpp"
#include "palette/palette.hpp"
#include "support/glb_builder.hpp"

namespace posepack::support {

struct Baked {
    palette::Palette palette;  // with its pixels
    Bytes container;
};

// Bakes every clip of `animal` by its wish (none: the default wish). Throws when a matrix does not fit.
Baked bake_all(const animal::Animal& animal, const recipe::OutputOptions& output = {},
               const std::vector<motion::RowWish>& wishes = {});

// RGBA32F affine, in which rounding is small.
recipe::OutputOptions in_floats();

}  // namespace posepack::support
