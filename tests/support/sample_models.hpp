// SPDX-License-Identifier: MIT
// The tiny models that tests share.
#pragma once

#include "animal/animal.hpp"
#include "support/model_spec.hpp"

namespace posepack::support {

// One joint at the origin, one vertex a position, all on that joint. No clip.
ModelSpec one_bone(std::vector<float> positions = {1, 0, 0, 0, 1, 0, 0, 0, 1});

// A tail of three joints below a turned root, with a scaled and turned plain node between the first two:
// 12 vertices with one to four influences and normals, and three clips: "Rig|Wag" (LINEAR rotations, a closed
// loop at 30 Hz), "Rig|Hop" (CUBICSPLINE translation and LINEAR scale, open) and "Rig|Blink" (STEP).
ModelSpec tail();

// A model of one skinned mesh, its body twice in one place: the second mesh has its vertices turned, moved
// and made 40 times smaller (by the inverse of X), and inverse binds that undo it, those of the first times
// X.
ModelSpec folded_twice(ModelSpec spec);
// The X of folded_twice(), column by column.
Matrix16 fold_matrix();

// Reads a GLB that must be good: throws what read_animal answers when it is not.
animal::Animal read_good(const Bytes& glb);
inline animal::Animal animal_of(const ModelSpec& spec) {
    return read_good(glb_of(spec));
}

}  // namespace posepack::support
