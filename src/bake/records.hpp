// SPDX-License-Identifier: MIT
// The manifest's record of a baked animal.
#pragma once

#include "animal/animal.hpp"
#include "choose/choose_rows.hpp"
#include "measure/measure_error.hpp"
#include "palette/palette.hpp"
#include "recipe/catalog.hpp"
#include "recipe/manifest.hpp"

namespace posepack::bake {

// Everything but digests and sizes of files. `stats` is null when the error was not measured.
recipe::BakeRecord describe(const recipe::AnimalEntry& entry, const animal::Animal& animal,
                            const palette::Palette& palette, const measure::ErrorStats* stats);

// What was tried for a clip, for the manifest.
std::vector<recipe::TryRecord> tried(const std::vector<choose::Attempt>& attempts);

// Texture memory of all forms at these counts.
recipe::VramRecord vram_of(std::uint64_t row_count, std::uint64_t bone_count, std::uint64_t vertex_count);

}  // namespace posepack::bake
