// SPDX-License-Identifier: MIT
// Many floats to halves and back: by the processor's F16C instructions where there are some, else in
// software.
#pragma once

#include <cstdint>
#include <span>

namespace posepack::palette {

// halves[i] becomes the half nearest to values[i] (posepack_half_from_float), and values[i] that half again.
// Both spans have one length. The result is the same on every host; no value may be NaN.
void round_to_halves(std::span<float> values, std::span<std::uint16_t> halves);

// The same without special instructions; tests compare the two.
void round_to_halves_in_software(std::span<float> values, std::span<std::uint16_t> halves);

}  // namespace posepack::palette
