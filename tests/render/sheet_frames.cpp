// SPDX-License-Identifier: MIT
// The contact sheet shows whole animals, whatever their size and the space of their palette: in every cell
// the coloured pixels of the animal reach neither an edge nor stay a speck. Exit code 77: no EGL device.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "bake/bake_animal.hpp"
#include "base/files.hpp"
#include "menagerie/menagerie.hpp"
#include "recipe/catalog.hpp"
#include "render/error.hpp"
#include "render/headless.hpp"
#include "render/sheet.hpp"

namespace {

using namespace posepack;
using render::require;

constexpr int kSkipped = 77;
constexpr int kCellPixels = 96;
constexpr int kShots = 3;
// Floor and shadow are grey; these animals are not. The crab has a radius of 0.2 m, the giraffe one of 2.5 m.
constexpr std::string_view kAnimals[] = {"crab", "crocodile", "fox", "giraffe", "goat"};
constexpr int kColouredSpread = 40;  // between the largest and the least of r, g, b
// The largest of three cells is filled to 1 / 1.12, the others are drawn at its scale.
constexpr int kLeastPixels = kCellPixels / 4;
constexpr int kLeastOfLargest = kCellPixels * 2 / 3;

template <class T>
T take(base::Result<T> result, std::string_view what) {
    require(static_cast<bool>(result), fmt::format("{}: {}", what, result ? "" : result.issue().detail));
    return std::move(result).value();
}

std::vector<render::SheetAnimal> baked_animals(recipe::Space space) {
    const base::Bytes text =
        take(base::read_file(POSEPACK_CATALOG, recipe::kMaxCatalogBytes), POSEPACK_CATALOG);
    recipe::OutputOverrides form;
    form.space = space;
    const auto catalog =
        take(recipe::read_catalog({reinterpret_cast<const char*>(text.data()), text.size()}, form),
             POSEPACK_CATALOG);
    bake::AnimalOptions options;
    options.measure = false;
    std::vector<render::SheetAnimal> animals;
    for (const recipe::AnimalEntry& entry : catalog.animals) {
        if (std::find(std::begin(kAnimals), std::end(kAnimals), entry.id) == std::end(kAnimals)) continue;
        const std::vector<std::uint8_t> glb = menagerie::generate_glb(entry.id);
        animals.push_back(render::read_sheet_animal(
            entry.id, glb, take(bake::bake_animal(entry, glb, options), entry.id).container));
    }
    return animals;
}

struct Extent {
    int left = kCellPixels, right = -1, bottom = kCellPixels, top = -1;

    int side() const { return std::max(right - left, top - bottom) + 1; }
    bool is_inside() const {
        return left > 0 && bottom > 0 && right < kCellPixels - 1 && top < kCellPixels - 1;
    }
};

Extent coloured_extent(const render::Sheet& sheet, int left, int bottom) {
    Extent extent;
    for (int y = 0; y < kCellPixels; ++y) {
        for (int x = 0; x < kCellPixels; ++x) {
            const std::uint8_t* rgb =
                &sheet.rgb[3 * (static_cast<std::size_t>(bottom + y) * static_cast<std::size_t>(sheet.width) +
                                static_cast<std::size_t>(left + x))];
            const auto [least, largest] = std::minmax({rgb[0], rgb[1], rgb[2]});
            if (largest - least < kColouredSpread) continue;
            extent.left = std::min(extent.left, x);
            extent.right = std::max(extent.right, x);
            extent.bottom = std::min(extent.bottom, y);
            extent.top = std::max(extent.top, y);
        }
    }
    return extent;
}

// Looks at every cell of a sheet with one animal a line. Returns the number of cells that are wrong.
int wrong_cells(recipe::Space space, int& looked_at) {
    const std::vector<render::SheetAnimal> animals = baked_animals(space);
    require(animals.size() == std::size(kAnimals), "expected every animal of the list in the catalog");
    render::SheetOptions options;
    options.columns = 1;
    options.cell_px = kCellPixels;
    options.samples_a_side = 1;
    const render::Sheet sheet = render::draw_sheet(animals, options);
    int wrong = 0;
    for (std::size_t index = 0; index < animals.size(); ++index) {
        const int bottom = sheet.height - (static_cast<int>(index) + 1) * kCellPixels;
        int largest = 0;
        for (int shot = 0; shot < kShots; ++shot, ++looked_at) {
            const Extent extent = coloured_extent(sheet, shot * kCellPixels, bottom);
            largest = std::max(largest, extent.side());
            if (extent.side() >= kLeastPixels && extent.is_inside()) continue;
            fmt::print("{}, cell {}: expected an animal inside, found x {} to {}, y {} to {}\n",
                       animals[index].id, shot, extent.left, extent.right, extent.bottom, extent.top);
            ++wrong;
        }
        if (largest >= kLeastOfLargest) continue;
        fmt::print("{}: expected a cell that it fills, found at most {} of {} pixels\n", animals[index].id,
                   largest, kCellPixels);
        ++wrong;
    }
    return wrong;
}

int look_at_sheets() {
    int looked_at = 0;
    const int wrong =
        wrong_cells(recipe::Space::model, looked_at) + wrong_cells(recipe::Space::normalised, looked_at);
    fmt::print("looked at {} cells, {} faults\n", looked_at, wrong);
    return looked_at > 0 && wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int without_device(const std::string& why_not) {
    fmt::print("no EGL device gives an OpenGL 3.3 context:{}\n", why_not);
    const char* ci = std::getenv("CI");
    return ci != nullptr && std::string_view(ci) == "true" ? EXIT_FAILURE : kSkipped;
}

}  // namespace

int main() {
    try {
        std::string why_not;
        const auto context = render::HeadlessContext::open(why_not);
        return context ? look_at_sheets() : without_device(why_not);
    } catch (const render::RenderError& error) {
        fmt::print("sheet_frames: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
