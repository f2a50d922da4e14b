// SPDX-License-Identifier: MIT
// Draws every baked animal of a folder in three clips, without a window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "render/error.hpp"
#include "render/headless.hpp"
#include "render/png_file.hpp"
#include "render/sheet.hpp"

namespace {

using namespace posepack;

constexpr std::uint64_t kMaxFileBytes = 512ull << 20;

struct Options {
    std::string models, palettes, output;
    std::vector<std::string> only;
    render::SheetOptions sheet;
};

base::Bytes read(const std::string& path) {
    auto bytes = base::read_file(path, kMaxFileBytes);
    render::require(static_cast<bool>(bytes), fmt::format("{} cannot be read", path));
    return std::move(bytes).value();
}

// Ids of the containers in a folder, sorted.
std::vector<std::string> ids_in(const std::string& folder) {
    std::vector<std::string> ids;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".posepack") ids.push_back(entry.path().stem().string());
    std::sort(ids.begin(), ids.end());
    return ids;
}

void render_sheet(const Options& options) {
    std::string why_not;
    const auto context = render::HeadlessContext::open(why_not);
    render::require(context != nullptr, fmt::format("no EGL device gives an OpenGL 3.3 context:{}", why_not));
    fmt::print("{}\n", context->description());
    std::vector<render::SheetAnimal> animals;
    for (const std::string& id : options.only.empty() ? ids_in(options.palettes) : options.only)
        animals.push_back(
            render::read_sheet_animal(id, read(fmt::format("{}/{}.glb", options.models, id)),
                                      read(fmt::format("{}/{}.posepack", options.palettes, id))));
    render::require(!animals.empty(), fmt::format("expected containers in {}", options.palettes));
    const render::Sheet sheet = render::draw_sheet(animals, options.sheet);
    render::write_png(options.output, sheet.width, sheet.height, sheet.rgb);
    fmt::print("drew {} animals into {}\n", animals.size(), options.output);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Draw animals of the menagerie in three clips each", "render_sheet"};
    app.add_option("--models", options.models, "Folder of the GLB files")->required();
    app.add_option("--palettes", options.palettes, "Folder of the containers")->required();
    app.add_option("-o,--output", options.output, "PNG file")->required();
    app.add_option("--only", options.only, "Only these animals (ids, comma-separated)")->delimiter(',');
    app.add_option("--columns", options.sheet.columns, "Animals beside each other")->check(CLI::Range(1, 32));
    app.add_option("--cell", options.sheet.cell_px, "Pixels of a cell, along each side")
        ->check(CLI::Range(16, 1024));
    CLI11_PARSE(app, argc, argv);
    try {
        render_sheet(options);
    } catch (const render::RenderError& error) {
        fmt::print(stderr, "render_sheet: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
