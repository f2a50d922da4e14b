// SPDX-License-Identifier: MIT
// The compiler's answer to a bound: the smallest palette that holds it. All that stress cases know of
// choosing is behind this function.
#pragma once

#include <cstdint>
#include <span>

#include "base/files.hpp"
#include "base/result.hpp"
#include "recipe/catalog.hpp"
#include "stress/action.hpp"

namespace posepack::stress {

// The bytes of the smallest container whose measured error (as bake_animal measures it) stays within `bound`
// in every clip; the wishes of `entry` name the clips and the rate to start from. Errors: E-LIM-BOUND with
// the clip, the time, the bone and the best error where none does; those of bake_animal where nothing can be
// baked.
base::Result<base::Bytes> choose_palette(const recipe::AnimalEntry& entry, std::span<const std::uint8_t> glb,
                                         const Bound& bound);

}  // namespace posepack::stress
