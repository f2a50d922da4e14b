// SPDX-License-Identifier: MIT
// Conservative bounds of a clip from the boxes that its bones carry: a skinned vertex is a weighted mean of
// its bones' images of it, and so is every blend of two rows; so all of them lie in the box of the images.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "animal/animal.hpp"

namespace posepack::palette {

struct Box {
    std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    std::array<double, 3> high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    bool is_empty() const { return low[0] > high[0]; }
    // True when the box and the sphere around it can be stored as floats.
    bool fits_floats() const;
};

// The box of the vertices that each bone moves, in mesh space; bones that move none have none.
class BoneBoxes {
 public:
    explicit BoneBoxes(const animal::Animal& animal);

    // Grows `box` by every bone's box under `matrices` (3x4 row-major, one a bone, as stored).
    void add(std::span<const float> matrices, Box& box) const;

 private:
    struct BoneBox {
        std::uint32_t bone;
        std::array<double, 3> center, half_size;
    };
    std::vector<BoneBox> boxes_;
};

}  // namespace posepack::palette
