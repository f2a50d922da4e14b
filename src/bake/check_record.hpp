// SPDX-License-Identifier: MIT
// A manifest's record against the container that it describes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/issue.hpp"
#include "posepack/loader.h"
#include "recipe/manifest.hpp"

namespace posepack::bake {

// Compares every field of `listed` that a container can answer with `bytes`, which `view` has opened: sizes,
// counts, layout, radius, clips, states, error figures, digests, texture memory. The pooled percentile and
// rms of an animal cannot be told from those of its clips: they must lie between them. Not compared, for the
// container does not hold them: id, model path and size, remarks. Gives E-MAN-FIELD for each field that
// differs, at "<container>: <field>", such as "clips/0/rate_hz"; none where all agree. `bake_abi` is the
// manifest's.
std::vector<base::Issue> check_record(const recipe::BakeRecord& listed, std::uint32_t bake_abi,
                                      std::span<const std::uint8_t> bytes, const posepack_view& view);

}  // namespace posepack::bake
