// SPDX-License-Identifier: MIT
// The animals that posepack makes itself: skinned, animated models with the habits of real files, as binary
// glTF 2.0. Forward is +Z, up is +Y, feet stand at y = 0, lengths are metres.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
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

// The model of one animal, or nothing for an id that animals() does not list. Cost: about 10 ms.
std::optional<Model> build_model(std::string_view id);

// The bytes of its GLB: the same on every host and in every run; empty for an id that animals() does not
// list. Cost: about 20 ms and 1 MiB.
std::vector<std::uint8_t> generate_glb(std::string_view id);

}  // namespace posepack::menagerie
