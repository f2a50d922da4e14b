// SPDX-License-Identifier: MIT
// What it costs that vertices keep some of their influences only: measured, recorded, and remarked on.
#pragma once

#include "bake/bake_animal.hpp"
#include "palette/palette.hpp"

namespace posepack::bake {

// Where a vertex lost influences: fills the record's reduction, and adds the figures to the last finding that
// says so (W-GLB-INFLUENCES). Errors: those of measure::measure_reduction.
base::Status measure_influences(const animal::Animal& animal, const palette::Palette& palette,
                                BakedAnimal& baked);

}  // namespace posepack::bake
