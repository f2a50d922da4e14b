// SPDX-License-Identifier: MIT
// The animals that posepack makes itself: skinned, animated models with the habits of real files, as binary
// glTF 2.0. Forward is +Z, up is +Y, feet stand at y = 0, lengths are metres.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "menagerie/model.hpp"

namespace posepack::menagerie {

struct MenagerieAnimal {
    std::string_view id;         // as in catalogs: "goat"
    std::string_view file_name;  // "goat.glb"
};

// Every animal there is, sorted by id.
std::span<const MenagerieAnimal> animals();

// The model of one animal, or nothing for an id that animals() does not list. Seed 0 is the animal as
// published, every other one a neighbour of its kind (variation.hpp). Cost: about 10 ms.
std::optional<Model> build_model(std::string_view id, std::uint64_t seed = 0);

// The bytes of its GLB: the same on every host and in every run; empty for an id that animals() does not
// list. Cost: about 20 ms and 1 MiB.
std::vector<std::uint8_t> generate_glb(std::string_view id);

// The birds of the second catalog, catalogs/birds.json. Five of them share each rig, those of the crow, the
// duck, the eagle, the owl and the sparrow.
std::span<const std::string_view> birds();

// The model of one of birds(), or nothing for another id.
std::optional<Model> build_bird(std::string_view id);

// A toy horse whose parts hang under its joints without a skin, as in many small models.
Model build_toy();

// A herd for measurements: the animals as published, then others of each kind in turn.
struct HerdMember {
    std::string id;          // "goat", "goat_0046"
    std::string_view kind;   // an id of animals()
    std::uint64_t seed = 0;  // for build_model
};

// `count` members; equal arguments give equal herds, and a longer herd begins with the shorter one.
std::vector<HerdMember> herd(std::size_t count, std::uint64_t seed);

}  // namespace posepack::menagerie
