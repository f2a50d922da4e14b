// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>

#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "stress/run_cases.hpp"
#include "stress/stress_report.hpp"

namespace posepack::cli {
namespace {

struct Options {
    stress::RunOptions run;
    std::shared_ptr<Format> format = std::make_shared<Format>(Format::text);
    bool details = false;
    bool list = false;
};

int run(const Options& options) {
    if (options.list) {
        fmt::print("{}", stress::stress_list());
        return 0;
    }
    const auto results = stress::run_cases(options.run);
    if (!results) return fail(results.issue());
    if (*options.format == Format::json)
        fmt::print("{}\n", stress::stress_json(results.value(), options.run.bound_factor));
    else
        fmt::print("{}", options.details ? stress::stress_details(results.value())
                                         : stress::stress_text(results.value()));
    int exit_code = 0;
    for (const stress::CaseResult& result : results.value())
        if (!result.difference.empty())
            exit_code = fail(
                {base::IssueCode::stress_differs, std::string(result.stress_case->name), result.difference});
    return exit_code;
}

}  // namespace

Runner add_stress(CLI::App& app) {
    auto options = std::make_shared<Options>();
    app.add_option("--only", options->run.only, "Only these cases (names, comma-separated)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("CASE");
    app.add_option("--bound-factor", options->run.bound_factor,
                   "Multiply every bound: below 1 the compiler must do more, and cases may differ")
        ->check(number_between(1e-6, 1e6))
        ->type_name("X");
    app.add_option("--jobs", options->run.jobs, "Cases at work at once; default 0: one a core")
        ->check(whole_between(0, 1024))
        ->type_name("N");
    app.add_flag("--list", options->list, "Only name the cases, and say why they are hard");
    app.add_flag("--details", options->details, "Every figure of every form, in both spaces");
    add_format_option(app, options->format, false);
    return [options] { return run(*options); };
}

}  // namespace posepack::cli
