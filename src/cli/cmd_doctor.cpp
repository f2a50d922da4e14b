// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "animal/read_animal.hpp"
#include "bake/doctor.hpp"
#include "base/files.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "output/doctor_report.hpp"

namespace posepack::cli {
namespace {

struct Options {
    std::string model;
    std::shared_ptr<Format> format = std::make_shared<Format>(Format::text);
    bool strict = false;
    bool no_measure = false;
};

int run(const Options& options) {
    const std::filesystem::path path = options.model;
    const auto bytes = base::read_file(path, animal::kMaxGlbBytes);
    if (!bytes) return fail(bytes.issue());
    bake::DoctorOptions doctor;
    doctor.strict = options.strict;
    doctor.measure = !options.no_measure;
    const output::Diagnosis diagnosis = bake::diagnose(path.filename().string(), bytes.value(), doctor);
    if (*options.format == Format::json)
        fmt::print("{}\n", output::doctor_json(diagnosis, 1));
    else
        fmt::print("{}", output::doctor_text(diagnosis));
    // The report holds the refusal: it is the result that was asked for, not a failure of the command.
    if (!diagnosis.refusal) return 0;
    return static_cast<int>(issue_kind(diagnosis.refusal->code).exit_code);
}

}  // namespace

Runner add_doctor(CLI::App& app) {
    auto options = std::make_shared<Options>();
    app.add_option("model", options->model, "GLB to examine")->required()->type_name("FILE");
    app.add_flag("--strict", options->strict,
                 "Judge as bake --strict does: what would be repaired is refused");
    app.add_flag("--no-measure", options->no_measure, "Do not measure the error of a bake (faster)");
    add_format_option(app, options->format, false);
    return [options] { return run(*options); };
}

}  // namespace posepack::cli
