// SPDX-License-Identifier: MIT
// SHA-256 (FIPS 180-4).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace posepack::base {

using Sha256 = std::array<std::uint8_t, 32>;

// Digest of `bytes`.
Sha256 sha256(std::span<const std::uint8_t> bytes);

// 64 lower-case hexadecimal digits.
std::string hexadecimal(std::span<const std::uint8_t> bytes);

}  // namespace posepack::base
