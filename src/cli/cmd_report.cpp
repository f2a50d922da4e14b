// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <cstdio>

#include "bake/report.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "output/report_writers.hpp"

namespace posepack::cli {
namespace {

enum class ReportFormat { text, csv, json, html };
constexpr std::pair<const char*, ReportFormat> kFormats[] = {{"text", ReportFormat::text},
                                                             {"csv", ReportFormat::csv},
                                                             {"json", ReportFormat::json},
                                                             {"html", ReportFormat::html}};

struct Options {
    std::shared_ptr<bake::CatalogSource> source = std::make_shared<bake::CatalogSource>();
    std::string output;  // empty: stdout
    std::string format;  // empty: by the output's name, else text
    std::vector<std::string> rates{"keys", "15", "30", "60"};
    bool with_heat = false;
};

// What is wrong with one of the rates; empty where nothing is.
std::string rate_fault(const std::string& text) {
    if (text == "keys" || number_between(1.0, 1000.0)(text).empty()) return {};
    return fmt::format("expected 'keys' or a number from 1 to 1000, found '{}'", text);
}

// Reads a rate without fault: rows a second, or nothing for the key grids.
std::optional<double> rate_of(const std::string& text) {
    if (text == "keys") return std::nullopt;
    double rate_hz = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), rate_hz);
    return rate_hz;
}

std::optional<ReportFormat> format_named(std::string_view name) {
    for (const auto& [known, format] : kFormats)
        if (name == known) return format;
    return std::nullopt;
}

// The format that --format names, else the one of the output's extension (.txt is text).
std::optional<ReportFormat> format_of(const Options& options) {
    if (!options.format.empty()) return format_named(options.format);
    if (options.output.empty()) return ReportFormat::text;
    const std::string extension = base::lowered(std::filesystem::path(options.output).extension().string());
    if (extension == ".txt") return ReportFormat::text;
    return extension.empty() ? std::nullopt : format_named(extension.substr(1));
}

std::string written(const output::Report& report, ReportFormat format) {
    switch (format) {
        case ReportFormat::csv:
            return report_csv(report);
        case ReportFormat::json:
            return report_json(report, 1) + "\n";
        case ReportFormat::html:
            return report_html(report);
        case ReportFormat::text:
            break;
    }
    return report_text(report);
}

// A form that an animal cannot have is a finding of the report, not its failure.
void print_refusals(const output::Report& report) {
    for (const output::AnimalReport& animal : report.animals)
        for (const output::RefusedForm& form : animal.refused)
            print_issue(base::at(form.form + ", " + form.rows, form.issue));
}

int run(const Options& options) {
    const auto format = format_of(options);
    if (!format)
        return fail(
            {base::IssueCode::usage, "--output",
             fmt::format("expected a name that ends with .html, .csv, .json or .txt, or --format, found '{}'",
                         options.output)});
    bake::ReportOptions how;
    for (const std::string& text : options.rates) how.rates_hz.push_back(rate_of(text));
    how.with_heat = options.with_heat || *format == ReportFormat::html;
    if (options.with_heat && *format != ReportFormat::json && *format != ReportFormat::html)
        return fail({base::IssueCode::usage, "--heat-map",
                     "expected it with the formats json and html, found text or csv"});
    const auto report = bake::report_catalog(*options.source, how);
    if (!report) return fail(report.issue());
    print_refusals(report.value());
    const std::string text = written(report.value(), *format);
    if (options.output.empty()) {
        fmt::print("{}", text);
        return 0;
    }
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    if (const auto status = base::write_file(options.output, bytes); !status) return fail(status.issue());
    fmt::print("wrote {} ({} bytes)\n", base::printable(options.output), text.size());
    return 0;
}

}  // namespace

Runner add_report(CLI::App& app) {
    auto options = std::make_shared<Options>();
    add_catalog_options(app, options->source);
    add_bound_options(app, options->source);
    app.add_option("--rates", options->rates,
                   "Rates to try, in Hz, and 'keys' for each clip's own key grid (default: keys,15,30,60)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(rate_fault)
        ->type_name("LIST");
    app.add_option("-o,--output", options->output,
                   "File to write: .html, .csv, .json or .txt (default: stdout)")
        ->type_name("FILE");
    app.add_option("--format", options->format,
                   "text, csv, json, html (default: by the name of the output, else text)")
        ->check([](const std::string& text) {
            return format_named(text)
                       ? std::string()
                       : fmt::format("expected one of text, csv, json, html, found '{}'", text);
        })
        ->type_name("NAME");
    app.add_flag("--heat-map", options->with_heat,
                 "JSON: add the error over time and bone of the chosen rows (HTML always has it)");
    return [options] { return run(*options); };
}

}  // namespace posepack::cli
