// SPDX-License-Identifier: MIT
// Writes a model as binary glTF 2.0: one mesh, one skin, one buffer, every channel a LINEAR sampler.
#pragma once

#include <cstdint>
#include <vector>

#include "menagerie/model.hpp"

namespace posepack::menagerie {

// The bytes of the GLB. Equal models give equal bytes on every host: numbers in the JSON chunk are the
// shortest that read back as the float they stand for, and nothing is hashed or timed.
std::vector<std::uint8_t> write_glb(const Model& model);

}  // namespace posepack::menagerie
