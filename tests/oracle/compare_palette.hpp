// SPDX-License-Identifier: MIT
// The bone matrices of an opened palette against those of a ReferenceAnimal, at every row of every clip.
//
// The difference of two matrices is what it does to the body: the largest distance between M_reference p and
// M_palette p over the corners and the centre of the box of the vertices that the joint moves. A difference
// is affine in p, so no vertex in the box is further off than its corners.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "posepack/loader.h"
#include "reference_animal.hpp"

namespace posepack::oracle {

struct Comparison {
    std::size_t clips = 0, rows = 0, matrices = 0;
    std::size_t rows_left_out = 0;  // of open loops, behind the last key: glTF says nothing about them
    double error = 0.0;             // the largest difference, as a fraction of the radius R
    std::string place;              // its clip, row and bone
    double roundings = 0.0;  // the largest, in parts of what rounding to single precision may cost there
    std::vector<std::string> faults;  // clips whose start or period is not the GLB's, bones never compared
};

// Compares a palette in RGBA32F with the model that it was baked from. Throws std::runtime_error where the
// two have too little in common: an animation or joint that is missing, a refusal of the loader.
Comparison compare_palette(const ReferenceAnimal& animal, const posepack_view& view);

}  // namespace posepack::oracle
