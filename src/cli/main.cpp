// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <system_error>
#include <vector>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/signals.hpp"

namespace posepack::cli {
namespace {

using base::ExitCode;
using base::IssueCode;

struct Registered {
    CLI::App* app;
    Runner run;
};

// What an app understands: its flags, or its subcommands.
std::vector<std::string> known_words(const CLI::App& app, bool flags) {
    std::vector<std::string> words;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            if (flags) words.push_back("--" + name);
    if (!flags)
        for (const Command& command : commands()) words.emplace_back(command.name);
    return words;
}

int refuse_word(const CLI::App& app, const std::string& word) {
    const bool flag = word.starts_with("-");
    const std::string near = base::nearest(word, known_words(app, flag));
    const std::string what = flag ? "option" : app.get_parent() == nullptr ? "command" : "argument";
    return fail({IssueCode::usage, app.get_name(),
                 fmt::format("expected a known {}, found '{}'{}", what, word,
                             near.empty() ? "" : fmt::format("; did you mean '{}'?", near))});
}

void set_up(CLI::App& app, std::vector<Registered>& registered) {
    app.set_version_flag("--version", std::string("posepack ") + POSEPACK_VERSION, "Show the version");
    app.add_flag("--json-errors", diagnostic_style().json, "Errors and warnings as JSON, one object a line");
    app.add_flag("-q,--quiet", diagnostic_style().quiet, "No warnings");
    app.footer(
        "Exit codes: 0 ok, 1 usage, 2 I/O, 3 malformed GLB, 4 malformed catalog, 5 unsupported, 6 over a "
        "limit,\n"
        "7 bad container or manifest, 8 mismatch, 9 some animals failed, 70 internal error, 130 "
        "interrupted.");
    app.allow_extras();
    for (const Command& command : commands()) {
        CLI::App* sub = app.add_subcommand(command.name, command.summary);
        sub->fallthrough();
        sub->allow_extras();
        registered.push_back({sub, command.add(*sub)});
    }
}

int parse_and_run(int argc, char** argv) {
    CLI::App app(
        "Animation palettes for crowds: every clip of every GLB sampled offline, with its error proven.",
        "posepack");
    std::vector<Registered> registered;
    set_up(app, registered);
    if (argc < 2) {
        fmt::print(stderr, "{}", app.help());
        return static_cast<int>(ExitCode::usage);
    }
    const auto chosen = [&]() -> const Registered* {
        for (const Registered& command : registered)
            if (command.app->parsed()) return &command;
        return nullptr;
    };
    // Words that nothing took; subcommands hand theirs up to the program.
    const auto refuse_extras = [&]() -> std::optional<int> {
        const std::vector<std::string> words = app.remaining(true);
        if (words.empty()) return std::nullopt;
        return refuse_word(chosen() != nullptr ? *chosen()->app : app, words.front());
    };
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request) {  // help or version
        return app.exit(request);
    } catch (const CLI::ParseError& error) {
        // A misspelt option often shows up as something else that is missing: name the word first.
        if (const auto refused = refuse_extras()) return *refused;
        const std::string what = error.what();
        const bool is_ours = what.find("expected ") != std::string::npos;
        return fail({IssueCode::usage, "",
                     is_ours ? what : "expected arguments as --help lists them, found: " + what});
    }
    if (const auto refused = refuse_extras()) return *refused;
    if (chosen() == nullptr) return fail({IssueCode::usage, "", "expected a command, found none"});
    return chosen()->run();
}

// Results that did not reach stdout (a full disk behind a pipe or a redirection) are a failure.
int flush_output(int exit_code) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
    return fail({IssueCode::io_write, "stdout",
                 "expected an open stream with room for the results, found one that takes no more"});
}

}  // namespace
}  // namespace posepack::cli

int main(int argc, char** argv) {
    using posepack::base::IssueCode;
    posepack::cli::install_signal_handlers();
    try {
        return posepack::cli::flush_output(posepack::cli::parse_and_run(argc, argv));
    } catch (const std::bad_alloc&) {
        return posepack::cli::fail(
            {IssueCode::memory, "", "expected more memory, found that an allocation failed"});
    } catch (const std::system_error& error) {
        return posepack::cli::fail({IssueCode::io_write, "", error.what()});
    } catch (const std::exception& exception) {
        return posepack::cli::fail({IssueCode::internal, "", exception.what()});
    }
}
