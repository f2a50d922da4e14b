// SPDX-License-Identifier: MIT
// What the tables of four-legged animals have in common.
#pragma once

#include "menagerie/variation.hpp"

namespace posepack::menagerie {

// The model of a shape, varied, settled on the ground and kept above it.
Model built(const QuadrupedShape& shape, const Variation& variation, const ExportStyle& style, int rate_hz);

// One hue for all of the coat but the back, and another for belly and muzzle.
void paint(QuadrupedShape& shape, Colour coat, Colour back, Colour belly);

// A goat without what makes it one, `size` times as large.
QuadrupedShape hoofed(const char* name, double size);

}  // namespace posepack::menagerie
