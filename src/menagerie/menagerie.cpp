// SPDX-License-Identifier: MIT
#include "menagerie/menagerie.hpp"

#include <array>

#include "menagerie/glb_writer.hpp"
#include "menagerie/quadruped.hpp"
#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

struct Recipe {
    MenagerieAnimal animal;
    Model (*build)();
};

constexpr std::array kRecipes = {
    Recipe{{"goat", "goat.glb"}, goat},    Recipe{{"sparrow", "sparrow.glb"}, sparrow},
    Recipe{{"trout", "trout.glb"}, trout}, Recipe{{"viper", "viper.glb"}, viper},
    Recipe{{"wolf", "wolf.glb"}, wolf},
};

constexpr auto kAnimals = [] {
    std::array<MenagerieAnimal, kRecipes.size()> animals{};
    for (std::size_t index = 0; index < kRecipes.size(); ++index) animals[index] = kRecipes[index].animal;
    return animals;
}();

}  // namespace

std::span<const MenagerieAnimal> animals() {
    return kAnimals;
}

std::optional<Model> build_model(std::string_view id) {
    for (const Recipe& recipe : kRecipes) {
        if (recipe.animal.id == id) return recipe.build();
    }
    return std::nullopt;
}

std::vector<std::uint8_t> generate_glb(std::string_view id) {
    const std::optional<Model> model = build_model(id);
    return model ? write_glb(*model) : std::vector<std::uint8_t>{};
}

}  // namespace posepack::menagerie
