// SPDX-License-Identifier: MIT
#include "menagerie/catalog_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace posepack::menagerie {
namespace {

struct StatesOfAction {
    std::string_view action;
    std::string_view states;  // as JSON
};

// Walkers wander and flee at a gallop, birds hop and fly, fish swim and dart, snakes crawl and slither.
constexpr std::array kStates = {
    StatesOfAction{"Walk", R"("wander", "walk")"},   StatesOfAction{"Gallop", R"("flee", "gallop")"},
    StatesOfAction{"Run", R"("flee", "run")"},       StatesOfAction{"Hop", R"("wander", "hop")"},
    StatesOfAction{"Peck", R"("eat", "peck")"},      StatesOfAction{"Swim", R"("wander", "swim")"},
    StatesOfAction{"Swim_Fast", R"("chase")"},       StatesOfAction{"Dart", R"("flee", "dart")"},
    StatesOfAction{"Crawl", R"("wander", "crawl")"}, StatesOfAction{"Slither", R"("flee", "slither")"},
    StatesOfAction{"Rise", R"("threaten")"},         StatesOfAction{"Strike", R"("attack", "strike")"}};

std::string states_of(const Model& model, std::string_view action) {
    const auto has = [&model](std::string_view other) {
        return std::any_of(model.clips.begin(), model.clips.end(),
                           [other](const Clip& clip) { return clip.action == other; });
    };
    // Birds flee through the air, a bee on its feet: that one has a run.
    if (action == "Fly") return has("Run") ? R"("fly")" : R"("flee", "fly")";
    for (const StatesOfAction& row : kStates) {
        if (row.action == action) return std::string(row.states);
    }
    std::string state(action);
    std::transform(state.begin(), state.end(), state.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return '"' + state + '"';
}

std::string clip_row(const Model& model, const Clip& clip) {
    std::string row =
        fmt::format(R"(        {{"name": "{}", "states": [{}])", clip.name, states_of(model, clip.action));
    if (clip.ground_speed_mps > 0.0) {
        // Four decimals, and never fewer than four digits.
        const double unit = clip.ground_speed_mps < 0.1 ? 1e6 : 1e4;
        row += fmt::format(R"(, "speed_mps": {})", std::floor(clip.ground_speed_mps * unit + 0.5) / unit);
    }
    if (clip.ending == Ending::once) return row + R"(, "wrap": "once"})";
    return row + fmt::format(R"(, "wrap": "loop", "seam": "{}"}})",
                             clip.ending == Ending::open ? "open" : "closed");
}

constexpr std::string_view kHead = R"(  "schema": 1,
  "defaults": {
    "metres_per_unit": 1,
    "forward": "+z",
    "output": {"encoding": "affine", "texel_format": "rgba16f"}
  },
  "keywords": {
    "attack": ["attack", "bite", "strike"],
    "flee": ["gallop", "run", "dart", "slither", "fly"],
    "idle": ["idle"],
    "wander": ["walk", "crawl", "swim", "hop"]
  },
  "animals": {
)";

}  // namespace

CatalogAnimal catalog_animal(std::string id, const Model& model) {
    std::vector<std::string> rows;
    for (const Clip& clip : model.clips) rows.push_back(clip_row(model, clip));
    std::string file_name = id + ".glb";
    return {std::move(id), std::move(file_name), fmt::format("{}", fmt::join(rows, ",\n"))};
}

std::string catalog_text(const std::vector<CatalogAnimal>& animals, const std::string& schema_path) {
    std::vector<std::string> entries;
    entries.reserve(animals.size());
    for (const CatalogAnimal& animal : animals) {
        entries.push_back(
            fmt::format("    \"{}\": {{\n      \"model\": \"{}\",\n      \"default_state\": \"idle\",\n"
                        "      \"clips\": [\n{}\n      ]\n    }}",
                        animal.id, animal.file_name, animal.clips));
    }
    const std::string schema =
        schema_path.empty() ? "" : fmt::format("  \"$schema\": \"{}\",\n", schema_path);
    return fmt::format("{{\n{}{}{}\n  }}\n}}\n", schema, kHead, fmt::join(entries, ",\n"));
}

}  // namespace posepack::menagerie
