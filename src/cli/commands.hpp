// SPDX-License-Identifier: MIT
// The table of commands: each is named once, here, and registers its own options.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <span>

namespace posepack::cli {

// Runs a parsed command; the result is the exit code of the program.
using Runner = std::function<int()>;

struct Command {
    const char* name;
    const char* summary;
    Runner (*add)(CLI::App& app);  // adds the options to `app`, which lives as long as the runner
};

std::span<const Command> commands();

Runner add_bake(CLI::App& app);
Runner add_compare(CLI::App& app);
Runner add_doctor(CLI::App& app);
Runner add_export(CLI::App& app);
Runner add_inspect(CLI::App& app);
Runner add_menagerie(CLI::App& app);
Runner add_report(CLI::App& app);
Runner add_stress(CLI::App& app);
Runner add_verify(CLI::App& app);

}  // namespace posepack::cli
