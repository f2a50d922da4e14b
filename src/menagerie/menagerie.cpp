// SPDX-License-Identifier: MIT
#include "menagerie/menagerie.hpp"

#include <fmt/format.h>

#include <array>

#include "menagerie/glb_writer.hpp"
#include "menagerie/shapes.hpp"

namespace posepack::menagerie {
namespace {

struct Recipe {
    MenagerieAnimal animal;
    Model (*build)(const Variation& variation);
};

constexpr std::array kRecipes = {
    Recipe{{"bear", "bear.glb"}, bear},
    Recipe{{"bee", "bee.glb"}, bee},
    Recipe{{"bull", "bull.glb"}, bull},
    Recipe{{"cat", "cat.glb"}, cat},
    Recipe{{"cow", "cow.glb"}, cow},
    Recipe{{"crab", "crab.glb"}, crab},
    Recipe{{"crocodile", "crocodile.glb"}, crocodile},
    Recipe{{"crow", "crow.glb"}, crow},
    Recipe{{"deer", "deer.glb"}, deer},
    Recipe{{"donkey", "donkey.glb"}, donkey},
    Recipe{{"duck", "duck.glb"}, duck},
    Recipe{{"eagle", "eagle.glb"}, eagle},
    Recipe{{"elephant", "elephant.glb"}, elephant},
    Recipe{{"fox", "fox.glb"}, fox},
    Recipe{{"giraffe", "giraffe.glb"}, giraffe},
    Recipe{{"goat", "goat.glb"}, goat},
    Recipe{{"horse", "horse.glb"}, horse},
    Recipe{{"lion", "lion.glb"}, lion},
    Recipe{{"mouse", "mouse.glb"}, mouse},
    Recipe{{"owl", "owl.glb"}, owl},
    Recipe{{"pig", "pig.glb"}, pig},
    Recipe{{"rabbit", "rabbit.glb"}, rabbit},
    Recipe{{"shark", "shark.glb"}, shark},
    Recipe{{"sheep", "sheep.glb"}, sheep},
    Recipe{{"sparrow", "sparrow.glb"}, sparrow},
    Recipe{{"spider", "spider.glb"}, spider},
    Recipe{{"stag", "stag.glb"}, stag},
    Recipe{{"trout", "trout.glb"}, trout},
    Recipe{{"viper", "viper.glb"}, viper},
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

std::optional<Model> build_model(std::string_view id, std::uint64_t seed) {
    for (const Recipe& recipe : kRecipes) {
        if (recipe.animal.id == id) return recipe.build({seed});
    }
    return std::nullopt;
}

std::vector<std::uint8_t> generate_glb(std::string_view id) {
    const std::optional<Model> model = build_model(id);
    return model ? write_glb(*model) : std::vector<std::uint8_t>{};
}

std::vector<HerdMember> herd(std::size_t count, std::uint64_t seed) {
    std::vector<HerdMember> members;
    for (std::size_t index = 0; index < count; ++index) {
        const std::string_view kind = kAnimals[index % kAnimals.size()].id;
        if (index < kAnimals.size()) {
            members.push_back({std::string(kind), kind, 0});
            continue;
        }
        // Neighbouring seeds and numbers shall have nothing in common; 0 is the published animal's.
        const std::uint64_t mixed = (seed + 1) * 0x9E3779B97F4A7C15u ^ (index + 1) * 0xD1B54A32D192ED03u;
        members.push_back({fmt::format("{}_{:04}", kind, index + 1), kind, mixed | 1u});
    }
    return members;
}

}  // namespace posepack::menagerie
