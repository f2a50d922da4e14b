// SPDX-License-Identifier: MIT
// A clip as a glTF animation: translation, rotation and scale of every joint, as exporters write them.
#pragma once

#include "menagerie/glb_buffer.hpp"
#include "menagerie/model.hpp"

namespace posepack::menagerie {

// The animation object; keys and times go to the buffer. Channels that stay the same carry two keys, or all
// of them where the style says so.
Json animation_json(GlbBuffer& buffer, const Model& model, const Clip& clip);

}  // namespace posepack::menagerie
