// SPDX-License-Identifier: MIT
// Spaces: the coordinates in which rows are stored, and the matrices that lead in and out of them.
//
// A reader skins p_model = model_from_palette * sum w M' * palette_from_mesh * p. In the normalised space
// palette_from_mesh carries the similarity B that the bones of a mesh share when they bind (an armature 100
// times too large, swapped axes), the centre of all that moves is the origin, and R is 1; so M' is near the
// identity where nothing moves, its numbers are of the size of 1, and halves hold them best. In model space
// both matrices are the identity. In both, the palette_from_mesh of a folded skin ends in its X
// (animal::Fold).
#pragma once

#include <vector>

#include "animal/animal.hpp"
#include "motion/affine.hpp"
#include "motion/row_plan.hpp"
#include "motion/skin_set.hpp"

namespace posepack::palette {

struct Spaces {
    bool normalised = false;
    motion::Affine model_from_palette;               // every number is a float, as stored
    motion::Affine palette_from_model;               // its inverse
    std::vector<motion::Affine> palette_from_mesh;   // one a mesh, floats too; empty: identities
    std::vector<motion::Affine> palette_from_bound;  // one a bone: that of the meshes that use it, without X
    std::vector<motion::Affine> bound_from_palette;  // one a bone: the inverse

    // Mesh space to palette space for the vertices of mesh `mesh`.
    motion::Affine mesh_entry(std::size_t mesh) const {
        return palette_from_mesh.empty() ? motion::Affine{} : palette_from_mesh[mesh];
    }
    // Where bones bind to palette space for what bone `bone` moves.
    motion::Affine bone_entry(std::size_t bone) const {
        return palette_from_bound.empty() ? motion::Affine{} : palette_from_bound[bone];
    }
    // Skinning matrices in model space (joint global x inverse bind) become those of palette space.
    void enter(std::span<motion::Affine> bones) const;
    // A matrix that was read from a palette, back in model space.
    motion::Affine leave(std::size_t bone, const motion::Affine& stored) const;
};

// Model space for an animal: all identities but for folded skins.
Spaces model_space(const animal::Animal& animal);

// A clip that will be baked: what it plays and at which times.
struct PlannedClip {
    const animal::Clip* clip;
    const motion::RowPlan* plan;
};

// The normalised space of an animal. Meshes that share a bone share a similarity B: of the weighted bones at
// rest the one that the others agree with most, with the median of their scales over the clips. The centre is
// that of the box of all rows (of long clips every few). Only choices of coordinates depend on this: any
// result is right, a bad one rounds worse.
//   radius  R in model units, above zero
Spaces normalise(const animal::Animal& animal, std::span<const PlannedClip> clips, double radius);

}  // namespace posepack::palette
