// SPDX-License-Identifier: MIT
// Draws a herd from baked palettes, without a window: one draw call for each kind of animal.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "render/error.hpp"
#include "render/headless.hpp"
#include "render/herd_renderer.hpp"
#include "render/herd_scene.hpp"
#include "render/png_file.hpp"

namespace {

using namespace posepack;

constexpr std::uint64_t kMaxFileBytes = 512ull << 20;

struct Options {
    std::string models, palettes, output;
    render::PictureOptions picture;
};

base::Bytes read(const std::string& path) {
    auto bytes = base::read_file(path, kMaxFileBytes);
    render::require(static_cast<bool>(bytes), fmt::format("{} cannot be read", path));
    return std::move(bytes).value();
}

void render_herd(const Options& options) {
    std::string why_not;
    const auto context = render::HeadlessContext::open(why_not);
    render::require(context != nullptr, fmt::format("no EGL device gives an OpenGL 3.3 context:{}", why_not));
    fmt::print("{}\n", context->description());
    const render::HerdScene scene = render::compose_herd();
    std::vector<render::AnimalCrowd> crowds;
    for (const render::Crowd& crowd : scene.crowds) {
        crowds.push_back(
            render::upload_crowd(crowd, read(fmt::format("{}/{}.glb", options.models, crowd.animal)),
                                 read(fmt::format("{}/{}.posepack", options.palettes, crowd.animal))));
        fmt::print("{:4} x {}\n", crowd.actors.size(), crowd.animal);
    }
    const render::Picture picture = render::draw_herd(scene, crowds, options.picture);
    render::write_png(options.output, options.picture.width, options.picture.height, picture.rgb);
    fmt::print("drew the animals in {} draw calls into {}\n", picture.draw_calls, options.output);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Draw a herd from palettes of the menagerie", "render_herd"};
    app.add_option("--models", options.models, "Folder of the GLB files")->required();
    app.add_option("--palettes", options.palettes, "Folder of the containers")->required();
    app.add_option("-o,--output", options.output, "PNG file")->required();
    app.add_option("--width", options.picture.width, "Pixels")->check(CLI::Range(16, 8192));
    app.add_option("--height", options.picture.height, "Pixels")->check(CLI::Range(16, 8192));
    app.add_option("--samples", options.picture.samples_a_side, "Samples a pixel, along each side")
        ->check(CLI::Range(1, 8));
    app.add_option("--time", options.picture.time_s, "Seconds since the herd set off");
    CLI11_PARSE(app, argc, argv);
    try {
        render_herd(options);
    } catch (const render::RenderError& error) {
        fmt::print(stderr, "render_herd: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
