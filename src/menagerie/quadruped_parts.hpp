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

// Trunk and mane, in the middle line; nothing for an animal without them.
void add_quadruped_extras(SkinBuilder<Quadruped>& out);

// The left horn that moves with the head, and the left tusk.
void add_quadruped_side_extras(SkinBuilder<Quadruped>& out);

}  // namespace posepack::menagerie
