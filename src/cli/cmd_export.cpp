// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>

#include "cli/commands.hpp"
#include "cli/container_file.hpp"
#include "cli/diagnostics.hpp"
#include "output/exr.hpp"

namespace posepack::cli {
namespace {

struct Options {
    std::string container;
    std::string output;
    bool exr = false;
};

int run(const Options& options) {
    const auto file = open_container(options.container);
    if (!file) return fail(file.issue());
    const auto exr = output::export_exr(file.value().view);
    if (!exr) return fail(exr.issue());
    std::filesystem::path path = options.output;
    if (path.empty()) path = std::filesystem::path(options.container).replace_extension(".exr");
    if (const auto status = base::write_file(path, exr.value()); !status) return fail(status.issue());
    fmt::print("wrote {} ({} bytes)\n", path.string(), exr.value().size());
    return 0;
}

}  // namespace

Runner add_export(CLI::App& app) {
    auto options = std::make_shared<Options>();
    app.add_option("container", options->container, "Container to export")->required()->type_name("FILE");
    app.add_flag("--exr", options->exr, "As OpenEXR: channels R G B A, tables as attributes")->required();
    app.add_option("-o,--output", options->output, "File to write (default: the container's name with .exr)")
        ->type_name("FILE");
    return [options] { return run(*options); };
}

}  // namespace posepack::cli
