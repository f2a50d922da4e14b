// SPDX-License-Identifier: MIT
// The measures of the five birds of the default catalog, which those of the second catalog share.
#pragma once

#include "menagerie/variation.hpp"

namespace posepack::menagerie {

BirdShape crow_shape();
BirdShape duck_shape();
BirdShape eagle_shape();
BirdShape owl_shape();
BirdShape sparrow_shape();

// The model of a bird's shape, varied, bowing to the ground and kept above it.
Model built_bird(const BirdShape& shape, const Variation& variation, const ExportStyle& style, int rate_hz);

}  // namespace posepack::menagerie
