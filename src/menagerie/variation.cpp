// SPDX-License-Identifier: MIT
#include "menagerie/variation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace posepack::menagerie {
namespace {

// SplitMix64 (Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014).
class Dice {
 public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    // -1 .. 1
    double swing() {
        state_ += 0x9E3779B97F4A7C15u;
        std::uint64_t x = state_;
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
        x ^= x >> 31;
        return static_cast<double>(x >> 11) / 4503599627370496.0 - 1.0;
    }

 private:
    std::uint64_t state_;
};

template <typename Shape, std::size_t N>
using Lengths = std::array<double Shape::*, N>;
template <typename Shape, std::size_t N>
using Colours = std::array<Colour Shape::*, N>;

using Q = QuadrupedShape;
constexpr Lengths<Q, 28> kQuadrupedLengths = {
    &Q::hip_height,    &Q::shoulder_height, &Q::body_length, &Q::stance_width, &Q::chest_radius,
    &Q::chest_depth,   &Q::belly_radius,    &Q::belly_depth, &Q::rump_radius,  &Q::neck_length,
    &Q::neck_radius,   &Q::neck_base_depth, &Q::head_length, &Q::head_radius,  &Q::head_depth,
    &Q::muzzle_radius, &Q::muzzle_depth,    &Q::leg_radius,  &Q::thigh_radius, &Q::ear_length,
    &Q::ear_width,     &Q::tail_length,     &Q::tail_radius, &Q::horn_length,  &Q::beard_length,
    &Q::mane_length,   &Q::trunk_length,    &Q::tusk_length};
constexpr Lengths<Q, 12> kQuadrupedFree = {
    &Q::neck_length, &Q::neck_radius, &Q::head_length, &Q::ear_length,   &Q::ear_width,   &Q::tail_length,
    &Q::tail_radius, &Q::horn_length, &Q::leg_radius,  &Q::thigh_radius, &Q::mane_length, &Q::tusk_length};
constexpr Colours<Q, 14> kQuadrupedColours = {&Q::coat,     &Q::back, &Q::belly,       &Q::neck, &Q::face,
                                              &Q::muzzle,   &Q::leg,  &Q::sock,        &Q::ear,  &Q::horn,
                                              &Q::horn_tip, &Q::tail, &Q::mane_colour, &Q::hoof};

using B = BirdShape;
constexpr Lengths<B, 16> kBirdLengths = {&B::hip_height,   &B::body_length, &B::body_radius, &B::body_depth,
                                         &B::stance_width, &B::neck_length, &B::neck_radius, &B::head_radius,
                                         &B::beak_length,  &B::beak_radius, &B::wing_length, &B::wing_chord,
                                         &B::tail_length,  &B::tail_radius, &B::leg_radius,  &B::toe_length};
constexpr Lengths<B, 6> kBirdFree = {&B::neck_length, &B::beak_length, &B::wing_length,
                                     &B::wing_chord,  &B::tail_length, &B::tail_radius};
constexpr Colours<B, 11> kBirdColours = {&B::back, &B::side, &B::belly,    &B::cap,     &B::cheek, &B::bib,
                                         &B::nape, &B::wing, &B::wing_bar, &B::feather, &B::tail};

using F = FishShape;
constexpr Lengths<F, 11> kFishLengths = {&F::length,        &F::swim_height,    &F::body_radius,
                                         &F::body_depth,    &F::tail_depth,     &F::tail_fin_length,
                                         &F::dorsal_height, &F::dorsal_length,  &F::pectoral_length,
                                         &F::pelvic_length, &F::tail_fin_spread};
constexpr Lengths<F, 3> kFishFree = {&F::dorsal_length, &F::tail_fin_length, &F::body_radius};
constexpr Colours<F, 6> kFishColours = {&F::back, &F::side, &F::belly, &F::band, &F::fin, &F::fin_tip};

using S = SnakeShape;
constexpr Lengths<S, 7> kSnakeLengths = {&S::length,      &S::body_radius, &S::neck_radius,  &S::head_length,
                                         &S::head_radius, &S::head_depth,  &S::tongue_length};
constexpr Lengths<S, 2> kSnakeFree = {&S::head_length, &S::tongue_length};
constexpr Colours<S, 5> kSnakeColours = {&S::back, &S::side, &S::belly, &S::zigzag, &S::head};

using C = CrawlerShape;
constexpr Lengths<C, 20> kCrawlerLengths = {
    &C::body_height,    &C::thorax_length, &C::thorax_radius, &C::thorax_depth, &C::abdomen_length,
    &C::abdomen_radius, &C::abdomen_depth, &C::head_length,   &C::head_radius,  &C::head_depth,
    &C::leg_span,       &C::leg_arch,      &C::leg_radius,    &C::jaw_length,   &C::antenna_length,
    &C::claw_length,    &C::wing_length,   &C::wing_breadth,  &C::eye_radius,   &C::eye_stalk};
constexpr Lengths<C, 6> kCrawlerFree = {&C::abdomen_length, &C::antenna_length, &C::claw_length,
                                        &C::wing_length,    &C::wing_breadth,   &C::jaw_length};
constexpr Colours<C, 9> kCrawlerColours = {&C::back, &C::side, &C::belly,   &C::abdomen, &C::band,
                                           &C::head, &C::leg,  &C::leg_tip, &C::claw};

Colour lightened(Colour colour, double factor) {
    Colour out = 0;
    for (const int shift : {16, 8, 0}) {
        const double channel = static_cast<double>((colour >> shift) & 255u) * factor;
        out |= static_cast<Colour>(std::min(255.0, std::floor(channel + 0.5))) << shift;
    }
    return out;
}

template <typename Shape, std::size_t N>
Shape times(Shape shape, const Lengths<Shape, N>& lengths, double factor) {
    for (double Shape::*length : lengths) shape.*length *= factor;
    return shape;
}

template <typename Shape, std::size_t L, std::size_t F, std::size_t C>
Shape vary(Shape shape, const Variation& variation, const Lengths<Shape, L>& lengths,
           const Lengths<Shape, F>& free, const Colours<Shape, C>& colours) {
    if (variation.is_published()) return shape;
    Dice dice(variation.seed);
    shape = times(std::move(shape), lengths, 1.0 + 0.12 * dice.swing());
    for (double Shape::*length : free) shape.*length *= 1.0 + 0.07 * dice.swing();
    const double light = 1.0 + 0.15 * dice.swing();
    for (Colour Shape::*colour : colours) shape.*colour = lightened(shape.*colour, light);
    return shape;
}

}  // namespace

QuadrupedShape scaled(QuadrupedShape shape, double factor) {
    return times(std::move(shape), kQuadrupedLengths, factor);
}

QuadrupedShape varied(QuadrupedShape shape, const Variation& variation) {
    return vary(std::move(shape), variation, kQuadrupedLengths, kQuadrupedFree, kQuadrupedColours);
}

BirdShape scaled(BirdShape shape, double factor) {
    return times(std::move(shape), kBirdLengths, factor);
}

BirdShape varied(BirdShape shape, const Variation& variation) {
    return vary(std::move(shape), variation, kBirdLengths, kBirdFree, kBirdColours);
}

FishShape scaled(FishShape shape, double factor) {
    return times(std::move(shape), kFishLengths, factor);
}

FishShape varied(FishShape shape, const Variation& variation) {
    return vary(std::move(shape), variation, kFishLengths, kFishFree, kFishColours);
}

SnakeShape scaled(SnakeShape shape, double factor) {
    return times(std::move(shape), kSnakeLengths, factor);
}

SnakeShape varied(SnakeShape shape, const Variation& variation) {
    return vary(std::move(shape), variation, kSnakeLengths, kSnakeFree, kSnakeColours);
}

CrawlerShape scaled(CrawlerShape shape, double factor) {
    return times(std::move(shape), kCrawlerLengths, factor);
}

CrawlerShape varied(CrawlerShape shape, const Variation& variation) {
    return vary(std::move(shape), variation, kCrawlerLengths, kCrawlerFree, kCrawlerColours);
}

}  // namespace posepack::menagerie
