// SPDX-License-Identifier: MIT
// Writes containers: docs/format/posepack-1.md, byte for byte.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/sha256.hpp"
#include "palette/palette.hpp"

namespace posepack::palette {

// The whole container, sealed, without measured errors. `provenance` is the recipe text; its SHA-256 becomes
// the recipe digest of the header.
std::vector<std::uint8_t> write_container(const animal::Animal& animal, const Palette& palette,
                                          std::string_view provenance);

// Writes the measured error of every clip into `file`, made by write_container, and seals it again.
void store_errors(std::span<std::uint8_t> file, std::span<const ClipError> errors);

}  // namespace posepack::palette
