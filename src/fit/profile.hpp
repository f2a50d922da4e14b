// SPDX-License-Identifier: MIT
// What a polyline costs the eye: the error of the vertices that a bone moves, before rounding.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "animal/animal.hpp"
#include "fit/polyline.hpp"
#include "fit/tracks.hpp"
#include "motion/skin_set.hpp"

namespace posepack::fit {

// Some of the vertices of one bone, in palette space, with their weights on it: its outermost ones, and
// others that stand for all. Both are a multiple of kPointsAtOnce, filled up with points of no weight.
inline constexpr std::size_t kPointsAtOnce = 4;
struct BonePoints {
    std::vector<float> x, y, z, weight;
    std::size_t counted = 0;    // the first ones, which stand for all
    std::size_t outermost = 0;  // the first of those that reach farthest, which are last
    double share = 0.0;         // vertices of the bone for each of the counted that has a weight
    bool is_empty() const { return x.empty(); }
};
std::vector<BonePoints> bone_points(const motion::SkinSet& points, const palette::Spaces& spaces,
                                    std::size_t bone_count);

// Distances that one bone alone makes, in units of palette space.
class Profile {
 public:
    // Distances up to `floor` are summed, but not counted.
    explicit Profile(double floor) : floor_square_(floor * floor) {}

    double max = 0.0;
    double square_sum = 0.0;  // over (vertices x samples)

    // (Vertices x samples) that are off by more than `distance`, at least the floor.
    double count_above(double distance) const;
    void count(float square, double share);

 private:
    static constexpr std::size_t kBins = 64;  // eight an octave
    double floor_square_;
    std::array<double, kBins> counts_{};
};

// The profile of a polyline for the vertices of `bone`, whose exact motion is in `tracks`. The polyline may
// be another bone's.
//   enough  where a distance is larger, the rest is left out: fraction of R
//   sample_errors  receives the largest distance at each known sample
//   reach  R in units of palette space: distances are told as fractions of it
Profile profile_of(const Tracks& tracks, const Polyline& line, std::size_t bone, const BonePoints& points,
                   double reach, double floor, double enough = HUGE_VAL,
                   std::vector<float>* sample_errors = nullptr);

// The largest square of a distance, fraction of R, that numbers make of the outermost points at a sample of a
// bone's exact motion.
//   scale  1 / R in units of palette space
float largest_square(const Tracks& tracks, std::size_t bone, std::size_t sample, const double* numbers,
                     const BonePoints& points, float scale);

// How far two bones carry the vertices of the second apart, at a few samples, fraction of R: nothing where
// they move alike. Stops above `enough`.
double distance_between(const Tracks& tracks, std::size_t first, std::size_t second, const BonePoints& points,
                        double reach, double enough);

}  // namespace posepack::fit
