// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "output/text_table.hpp"

namespace posepack::cli {
namespace {

using output::Align;

struct Options {
    std::shared_ptr<bake::CatalogSource> source = std::make_shared<bake::CatalogSource>();
    std::shared_ptr<Format> format = std::make_shared<Format>(Format::text);
    bake::BakeOptions bake;
    bool no_measure = false, no_fsync = false;
};

std::string worst_place(const recipe::ErrorRecord& error) {
    return fmt::format("{} {:.2f} s, {}", base::shortened(error.clip, 24), error.time_s,
                       base::shortened(error.bone, 24));
}

std::string error_cell(const recipe::ErrorRecord& error, float value) {
    return error.measured ? output::readable_error(value) : "-";
}

output::TextTable summary_table(const bake::BakeOutcome& outcome, bool with_vat) {
    output::TextTable table;
    table.columns = {{"animal", Align::left},
                     {"clips"},
                     {"rows"},
                     {"bones"},
                     {"texture"},
                     {"texels"},
                     {"max / R"},
                     {"max mm"},
                     {"p99.9 / R"},
                     {"rms / R"},
                     {"worst place", Align::left},
                     {"ms"}};
    if (with_vat) table.columns.push_back({"VAT RGBA16F"});
    std::uint64_t clips = 0, rows = 0, bytes = 0, vat = 0;
    double ms = 0.0;
    for (std::size_t i = 0; i < outcome.manifest.records.size(); ++i) {
        const recipe::BakeRecord& record = outcome.manifest.records[i];
        const double animal_ms = (outcome.times[i].bake_s + outcome.times[i].measure_s) * 1e3;
        table.rows.push_back(
            {record.id, std::to_string(record.clips.size()), std::to_string(record.row_count),
             std::to_string(record.bone_count),
             fmt::format("{} x {}", record.texture_width, record.texture_height),
             output::readable_bytes(record.texel_bytes), error_cell(record.error, record.error.max),
             record.error.measured ? fmt::format("{:.2f}", static_cast<double>(record.error.max_m) * 1e3)
                                   : "-",
             error_cell(record.error, record.error.p999), error_cell(record.error, record.error.rms),
             record.error.measured ? worst_place(record.error) : "not measured",
             fmt::format("{:.1f}", animal_ms)});
        if (with_vat) table.rows.back().push_back(output::readable_bytes(record.vram.vat_rgba16f));
        clips += record.clips.size();
        rows += record.row_count;
        bytes += record.texel_bytes;
        vat += record.vram.vat_rgba16f;
        ms += animal_ms;
    }
    table.total = {base::counted(outcome.manifest.records.size(), "animal"),
                   std::to_string(clips),
                   std::to_string(rows),
                   "",
                   "",
                   output::readable_bytes(bytes),
                   "",
                   "",
                   "",
                   "",
                   "",
                   fmt::format("{:.1f}", ms)};
    if (with_vat) table.total.push_back(output::readable_bytes(vat));
    return table;
}

// A bound chooses what these would set.
base::Status check_choice(const Options& options) {
    const recipe::OutputOverrides& o = options.source->overrides;
    if (!o.bound) return {};
    const std::pair<bool, const char*> fixed[] = {{o.encoding.has_value(), "--encoding"},
                                                  {options.source->rate_hz.has_value(), "--rate"},
                                                  {o.texel_order.has_value(), "--texel-order"},
                                                  {o.row_pitch.has_value(), "--row-pitch"},
                                                  {options.bake.animal.compare_vat, "--compare-vat"}};
    for (const auto& [is_given, name] : fixed)
        if (is_given)
            return base::Issue{
                base::IssueCode::usage, name,
                fmt::format("expected --max-error, which chooses form and rows, or {}, found both", name)};
    return {};
}

int run(const Options& options) {
    if (const auto status = check_choice(options); !status) return fail(status.issue());
    const auto outcome = bake::bake_catalog(*options.source, options.bake);
    if (!outcome) return fail(outcome.issue());
    const bake::BakeOutcome& done = outcome.value();
    print_issues(done.findings);
    print_issues(done.failures);
    if (done.manifest.records.empty()) return exit_code_of(done.failures.front());
    if (*options.format == Format::json) {
        fmt::print("{}", write_manifest(done.manifest));
    } else {
        const auto table = summary_table(done, options.bake.animal.compare_vat);
        if (*options.format == Format::csv)
            fmt::print("{}", format_csv(table));
        else
            fmt::print("{}\nbaked {} of {} into {} in {:.2f} s\n", format_text(table),
                       done.manifest.records.size(),
                       base::counted(done.manifest.records.size() + done.failures.size(), "animal"),
                       options.bake.output.string(), done.elapsed_s);
    }
    return done.failures.empty() ? 0 : static_cast<int>(base::ExitCode::partial);
}

}  // namespace

Runner add_bake(CLI::App& app) {
    auto options = std::make_shared<Options>();
    add_catalog_options(app, options->source);
    app.add_option("-o,--output", options->bake.output, "Folder for palettes and manifest")
        ->required()
        ->type_name("DIR");
    add_output_options(app, options->source);
    add_bound_options(app, options->source);
    app.add_flag("--strict", options->bake.animal.strict, "Refuse what would be repaired");
    app.add_flag("--allow-data-uris", options->bake.animal.allow_data_uris,
                 "Read buffers that stand as base64 in a model's JSON");
    app.add_flag("--keep-going", options->bake.keep_going,
                 "Bake the rest when an animal fails (exit code 9)");
    app.add_flag("--compare-vat", options->bake.animal.compare_vat,
                 "Add the memory of the other forms to the manifest");
    app.add_flag("--no-measure", options->no_measure, "Do not measure the error: containers say so");
    app.add_flag("--no-fsync", options->no_fsync, "Do not wait for the disk");
    app.add_option("--jobs,-j", options->bake.jobs, "Threads (default: one a core)")
        ->check(whole_between(1, 1024))
        ->type_name("N");
    app.add_option("--lock-timeout", options->bake.lock_timeout_s,
                   "Seconds to wait for another bake (default: 10)")
        ->check(number_between(0.0, 86400.0))
        ->type_name("S");
    add_format_option(app, options->format, true);
    return [options] {
        options->bake.animal.measure = !options->no_measure;
        options->bake.sync_to_disk = !options->no_fsync;
        return run(*options);
    };
}

}  // namespace posepack::cli
