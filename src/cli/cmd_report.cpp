// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bake/report.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "output/text_table.hpp"

namespace posepack::cli {
namespace {

struct Options {
    std::shared_ptr<bake::CatalogSource> source = std::make_shared<bake::CatalogSource>();
    std::shared_ptr<Format> format = std::make_shared<Format>(Format::text);
    std::vector<std::string> rates{"keys", "15", "30", "60"};
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

std::string worst_place(const recipe::ErrorRecord& error) {
    return fmt::format("{} {:.3f} s, vertex {}, {}", base::shortened(error.clip, 24), error.time_s,
                       error.vertex, base::shortened(error.bone, 24));
}

output::TextTable report_table(const std::vector<bake::ReportRow>& rows) {
    using output::Align;
    output::TextTable table;
    table.columns = {{"animal", Align::left},
                     {"encoding", Align::left},
                     {"texels", Align::left},
                     {"rate Hz"},
                     {"bytes"},
                     {"max / R"},
                     {"p99.9 / R"},
                     {"rms / R"},
                     {"max mm"},
                     {"normal max deg"},
                     {"decode ns/vertex"},
                     {"bake ms"},
                     {"worst place", Align::left}};
    for (const bake::ReportRow& row : rows)
        table.rows.push_back({row.id, row.encoding, row.texel_format, row.rate,
                              std::to_string(row.texel_bytes), output::readable_error(row.error.max),
                              output::readable_error(row.error.p999), output::readable_error(row.error.rms),
                              fmt::format("{:.3g}", static_cast<double>(row.error.max_m) * 1e3),
                              fmt::format("{:.3g}", row.error.normal_max_deg),
                              fmt::format("{:.2f}", row.decode_ns_per_vertex),
                              fmt::format("{:.2f}", row.bake_ms), worst_place(row.error)});
    return table;
}

nlohmann::json row_json(const bake::ReportRow& row) {
    const recipe::ErrorRecord& e = row.error;
    return {{"animal", row.id},
            {"encoding", row.encoding},
            {"texel_format", row.texel_format},
            {"rate", row.rate},
            {"bytes", row.texel_bytes},
            {"max", base::widened(e.max)},
            {"p999", base::widened(e.p999)},
            {"rms", base::widened(e.rms)},
            {"max_m", base::widened(e.max_m)},
            {"p999_m", base::widened(e.p999_m)},
            {"rms_m", base::widened(e.rms_m)},
            {"normal_max_deg", base::widened(e.normal_max_deg)},
            {"normal_p999_deg", base::widened(e.normal_p999_deg)},
            {"normal_rms_deg", base::widened(e.normal_rms_deg)},
            {"worst",
             {{"clip", e.clip},
              {"time_s", base::widened(e.time_s)},
              {"mesh", e.mesh},
              {"vertex", e.vertex},
              {"bone", e.bone}}},
            {"decode_ns_per_vertex", row.decode_ns_per_vertex},
            {"bake_ms", row.bake_ms}};
}

int run(const Options& options) {
    std::vector<std::optional<double>> rates_hz;
    for (const std::string& text : options.rates) rates_hz.push_back(rate_of(text));
    const auto report = bake::report_catalog(*options.source, rates_hz);
    if (!report) return fail(report.issue());
    // A form that an animal cannot have is a finding of the report, not its failure.
    print_issues(report.value().refused);
    if (*options.format == Format::json) {
        nlohmann::json list = nlohmann::json::array();
        for (const bake::ReportRow& row : report.value().rows) list.push_back(row_json(row));
        fmt::print("{}\n", nlohmann::json{{"schema", "posepack-report-1"}, {"rows", list}}.dump(1));
        return 0;
    }
    const auto table = report_table(report.value().rows);
    fmt::print("{}", *options.format == Format::csv ? format_csv(table) : format_text(table));
    return 0;
}

}  // namespace

Runner add_report(CLI::App& app) {
    auto options = std::make_shared<Options>();
    add_catalog_options(app, options->source);
    app.add_option("--rates", options->rates,
                   "Rates to try, in Hz, and 'keys' for each clip's own key grid (default: keys,15,30,60)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(rate_fault)
        ->type_name("LIST");
    add_format_option(app, options->format, true);
    return [options] { return run(*options); };
}

}  // namespace posepack::cli
