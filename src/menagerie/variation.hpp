// SPDX-License-Identifier: MIT
// One of a kind: measures and colours of a shape, changed a little by a seed.
#pragma once

#include <cstdint>

#include "menagerie/bird.hpp"
#include "menagerie/crawler.hpp"
#include "menagerie/fish.hpp"
#include "menagerie/quadruped.hpp"
#include "menagerie/snake.hpp"

namespace posepack::menagerie {

// Seed 0 is the animal as published.
struct Variation {
    std::uint64_t seed = 0;

    bool is_published() const { return seed == 0; }
};

// All lengths of a shape times `factor`; angles and counts stay.
QuadrupedShape scaled(QuadrupedShape shape, double factor);
BirdShape scaled(BirdShape shape, double factor);
FishShape scaled(FishShape shape, double factor);
SnakeShape scaled(SnakeShape shape, double factor);
CrawlerShape scaled(CrawlerShape shape, double factor);

// The shape that a seed makes of this one: 0.88 to 1.12 times as large, up to 7 % more or less in the parts
// that may change without breaking others, and up to 15 % lighter or darker. The published one comes back as
// it is.
QuadrupedShape varied(QuadrupedShape shape, const Variation& variation);
BirdShape varied(BirdShape shape, const Variation& variation);
FishShape varied(FishShape shape, const Variation& variation);
SnakeShape varied(SnakeShape shape, const Variation& variation);
CrawlerShape varied(CrawlerShape shape, const Variation& variation);

}  // namespace posepack::menagerie
