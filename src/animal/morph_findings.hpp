// SPDX-License-Identifier: MIT
// Animation of morph targets, which a palette of bones cannot hold: said of every clip that has some.
#pragma once

#include "animal/read_parts.hpp"

namespace posepack::animal {

// Notes one finding for each animation with channels that blend morph targets (by the path "weights", or a
// pointer of KHR_animation_pointer to weights), naming the animation and its meshes; of many, the first ones
// and how many more.
void note_morph_channels(ReadContext& context);

// True where the channel `pointer` of KHR_animation_pointer blends morph targets.
bool aims_at_weights(std::string_view pointer);

}  // namespace posepack::animal
