// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "bake/verify.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"

namespace posepack::cli {
namespace {

struct Options {
    std::string path;
    bool strict = false;
    std::shared_ptr<Format> format = std::make_shared<Format>(Format::text);
};

int run(const Options& options) {
    const auto outcome = bake::verify(options.path, options.strict);
    if (!outcome) return fail(outcome.issue());
    int exit_code = 0;
    nlohmann::json findings = nlohmann::json::array();
    for (const base::Issue& issue : outcome.value().findings) {
        print_issue(issue);
        findings.push_back(nlohmann::json::parse(format_issue_json(issue)));
        if (exit_code == 0) exit_code = static_cast<int>(issue_kind(issue.code).exit_code);
    }
    if (*options.format == Format::json) {
        const nlohmann::json out{{"schema", "posepack-verify-1"},
                                 {"containers", outcome.value().container_count},
                                 {"bytes", outcome.value().byte_count},
                                 {"ok", exit_code == 0},
                                 {"findings", findings}};
        fmt::print("{}\n", out.dump(1));
    } else {
        fmt::print("{}: {}, {} bytes checked\n", exit_code == 0 ? "ok" : "FAILED",
                   base::counted(outcome.value().container_count, "container"),
                   base::grouped(outcome.value().byte_count));
    }
    return exit_code;
}

}  // namespace

Runner add_verify(CLI::App& app) {
    auto options = std::make_shared<Options>();
    app.add_option("path", options->path, "Folder with a manifest, or one container")
        ->required()
        ->type_name("DIR|FILE");
    app.add_flag("--strict", options->strict, "A container that the manifest does not list is an error");
    add_format_option(app, options->format, false);
    return [options] { return run(*options); };
}

}  // namespace posepack::cli
