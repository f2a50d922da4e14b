// SPDX-License-Identifier: MIT
// Conservative bounds of a clip from the boxes that its bones carry: a skinned vertex is a weighted mean of
// its bones' images of it, and so is every blend of two rows; so all of them lie in the box of the images.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "animal/animal.hpp"
#include "motion/affine.hpp"

namespace posepack::palette {

struct Box {
    std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    std::array<double, 3> high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    bool is_empty() const { return low[0] > high[0]; }
    // True when the box and the sphere around it can be stored as floats.
    bool fits_floats() const;
};

struct Spaces;

// The box of the vertices that each bone moves, before it moves them; bones that move none have none.
class BoneBoxes {
 public:
    // Boxes where bones bind, for matrices of model space.
    explicit BoneBoxes(const animal::Animal& animal);
    // Boxes in the palette space of `spaces`, for matrices of that space.
    BoneBoxes(const animal::Animal& animal, const Spaces& spaces);

    // Grows `box` by every bone's box under `matrices` (3x4 row-major, one a bone, as stored).
    void add(std::span<const float> matrices, Box& box) const;
    void add(std::span<const motion::Affine> bones, Box& box) const;

    // Grows `box` by all blends of two rows of dual quaternions, which go along arcs.
    //   quarters  matrices as above at the factors 0, 1/4, 1/2, 3/4 and 1
    void add_arcs(std::span<const std::vector<float>, 5> quarters, Box& box) const;

 private:
    struct BoneBox {
        std::uint32_t bone;
        std::array<double, 3> center, half_size;
    };
    void grow(const BoneBox& bone, std::span<const float> matrices, double margin, Box& box) const;
    double bulge(const BoneBox& bone, std::span<const std::vector<float>, 5> quarters) const;

    std::vector<BoneBox> boxes_;
};

}  // namespace posepack::palette
