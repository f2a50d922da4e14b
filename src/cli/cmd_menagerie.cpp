// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "base/files.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "menagerie/menagerie.hpp"

namespace posepack::cli {
namespace {

struct Options {
    std::string folder;
    std::vector<std::string> only;
};

base::Status check_ids(const std::vector<std::string>& ids) {
    std::vector<std::string> known;
    for (const auto& animal : menagerie::animals()) known.emplace_back(animal.id);
    for (const std::string& id : ids)
        if (std::find(known.begin(), known.end(), id) == known.end())
            return base::Issue{base::IssueCode::usage, "--only",
                               fmt::format("expected one of {}, found '{}'", fmt::join(known, ", "), id)};
    return {};
}

int run(const Options& options) {
    if (const auto status = check_ids(options.only); !status) return fail(status.issue());
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error)
        return fail(
            {base::IssueCode::io_write, options.folder, "cannot make the folder: " + error.message()});
    std::size_t count = 0;
    for (const auto& animal : menagerie::animals()) {
        if (!options.only.empty() &&
            std::find(options.only.begin(), options.only.end(), animal.id) == options.only.end())
            continue;
        const auto glb = menagerie::generate_glb(animal.id);
        if (const auto status =
                base::write_file(std::filesystem::path(options.folder) / animal.file_name, glb);
            !status)
            return fail(status.issue());
        fmt::print("{:<12} {:>9} bytes\n", animal.file_name, base::grouped(glb.size()));
        ++count;
    }
    fmt::print("wrote {} animals into {}\n", count, options.folder);
    return 0;
}

}  // namespace

Runner add_menagerie(CLI::App& app) {
    auto options = std::make_shared<Options>();
    app.add_option("folder", options->folder, "Folder for the GLB files")->required()->type_name("DIR");
    app.add_option("--only", options->only, "Only these animals (ids, comma-separated)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("ID");
    return [options] { return run(*options); };
}

}  // namespace posepack::cli
