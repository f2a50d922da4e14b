// SPDX-License-Identifier: MIT
// The skin of a quadruped's head, apart from that of its body.
#pragma once

#include "menagerie/quadruped.hpp"
#include "menagerie/skin_builder.hpp"

namespace posepack::menagerie {

// Skull, jaw and beard, in the middle line.
void add_quadruped_head(SkinBuilder<Quadruped>& out);

// The left ear, horn and eye.
void add_quadruped_head_sides(SkinBuilder<Quadruped>& out);

}  // namespace posepack::menagerie
