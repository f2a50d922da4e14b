// SPDX-License-Identifier: MIT
#include "output/report_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "output/html_text.hpp"
#include "output/report_chart.hpp"

namespace posepack::output {
namespace {

// A point of all charts of a section.
struct Candidate {
    std::string form, rows, encoding;
    bool is_hollow = false, is_chosen = false;
    std::array<double, 3> errors{};  // in the order of kErrors
    std::array<double, 4> costs{};   // in the order of kCosts
    double metres = 0.0;             // of a whole R
};

constexpr std::array<Pick, 3> kErrors{{{"e-max", "max"}, {"e-p999", "p99.9"}, {"e-rms", "rms"}}};
constexpr std::array<const char*, 3> kErrorTitles{
    "largest error, fraction of R", "p99.9 of the error, fraction of R", "rms error, fraction of R"};
constexpr std::array<Pick, 4> kCosts{
    {{"k-bytes", "bytes"}, {"k-ns", "CPU time"}, {"k-fetches", "texel fetches"}, {"k-alu", "ALU"}}};

// How costs are drawn.
struct CostLook {
    const char* title;  // of the axis
    AxisUnit unit;
    double least_ratio;  // of the axis: times of one machine differ by some per cent for nothing
    bool with_curves;
    const char* words;  // behind a number
};
constexpr std::array<CostLook, 4> kCostLooks{
    {{"bytes of texels", AxisUnit::bytes, 2.0, true, ""},
     {"CPU time to decode, blend and skin, ns a vertex", AxisUnit::nanoseconds, 1.6, false, " ns a vertex"},
     {"texel fetches of a vertex (4 influences, 2 rows)", AxisUnit::count, 2.0, false, " fetches"},
     {"multiply-adds of a vertex (4 influences, 2 rows), about", AxisUnit::count, 2.0, false,
      " multiply-adds"}}};

Candidate candidate_of(const ReportRow& row, double radius_m) {
    return {row.form,
            row.rows,
            row.encoding,
            row.texel_format == "rgba32f",
            row.is_chosen,
            {row.error.max, row.error.p999, row.error.rms},
            {static_cast<double>(row.bytes), row.decode_ns_per_vertex, static_cast<double>(row.fetches),
             static_cast<double>(row.alu_operations)},
            radius_m};
}

Candidate candidate_of(const ReportTotal& total) {
    return {
        total.form,
        total.rows,
        total.encoding,
        total.texel_format == "rgba32f",
        total.is_chosen,
        {total.max.worst, total.p999.worst, total.rms.worst},
        {static_cast<double>(total.bytes), total.decode_ns_per_vertex, total.fetches, total.alu_operations},
        0.0};
}

std::string title_of(const Candidate& candidate, std::size_t error, std::size_t cost) {
    const double value = candidate.costs[cost];
    const std::string costs = kCostLooks[cost].unit == AxisUnit::bytes
                                  ? decimal_bytes(value)
                                  : fmt::format("{:.3g}{}", value, kCostLooks[cost].words);
    const std::string metres =
        candidate.metres > 0 ? " = " + length_text(candidate.errors[error] * candidate.metres) : "";
    return fmt::format("{}, {}: {}, {} {} R{}", candidate.form, candidate.rows, costs, kErrors[error].name,
                       short_error(candidate.errors[error]), metres);
}

std::string chart_of(const std::vector<Candidate>& candidates, const Series& series, const std::string& name,
                     std::size_t error, std::size_t cost) {
    const CostLook& look = kCostLooks[cost];
    Chart chart;
    chart.name = fmt::format("{}: {} error against {}", name, kErrors[error].name, kCosts[cost].name);
    chart.cost_title = look.title;
    chart.error_title = kErrorTitles[error];
    chart.cost_unit = look.unit;
    chart.least_cost_ratio = look.least_ratio;
    chart.with_curves = look.with_curves;
    for (const Candidate& candidate : candidates)
        chart.points.push_back({candidate.costs[cost], candidate.errors[error], candidate.rows,
                                title_of(candidate, error, cost), series.of(candidate.encoding),
                                candidate.is_hollow, candidate.is_chosen});
    return chart_svg(chart);
}

std::string charts_of(const std::vector<Candidate>& candidates, const Series& series,
                      const std::string& name) {
    std::string bytes, run_time;
    for (std::size_t error = 0; error < kErrors.size(); ++error)
        for (std::size_t cost = 0; cost < kCosts.size(); ++cost)
            (cost == 0 ? bytes : run_time) +=
                fmt::format("<div class=\"{} {}\">\n{}</div>\n", kErrors[error].id, kCosts[cost].id,
                            chart_of(candidates, series, name, error, cost));
    return fmt::format(
        "<div class=\"charts\">\n<figure><figcaption>Error against bytes</figcaption>\n{}</figure>\n"
        "<figure><figcaption>Error against run time</figcaption>\n{}</figure>\n</div>\n",
        bytes, run_time);
}

}  // namespace

std::span<const Pick> error_picks() {
    return kErrors;
}

std::span<const Pick> run_time_picks() {
    return std::span(kCosts).subspan(1);
}

Series::Series(const Report& report) {
    for (const AnimalReport& animal : report.animals)
        for (const ReportRow& row : animal.rows)
            if (std::find(names_.begin(), names_.end(), row.encoding) == names_.end())
                names_.push_back(row.encoding);
}

unsigned Series::of(const std::string& encoding) const {
    constexpr unsigned kColours = 8;
    const auto found = std::find(names_.begin(), names_.end(), encoding);
    return static_cast<unsigned>(found - names_.begin()) % kColours;
}

std::string legend_html(const Series& series) {
    std::string out = "<ul class=\"legend\">";
    const auto add = [&](const std::string& drawing, const std::string& text) {
        out +=
            fmt::format("<li><svg viewBox=\"0 0 26 18\" aria-hidden=\"true\">{}</svg>{}</li>", drawing, text);
    };
    for (const std::string& name : series.names())
        add(fmt::format("<g class=\"p s{}\"><circle cx=\"13\" cy=\"9\" r=\"3.8\"/></g>", series.of(name)),
            html_text(name));
    add("<g class=\"p s0 o\"><circle cx=\"13\" cy=\"9\" r=\"5.6\"/></g>", "ring: RGBA32F, disc: RGBA16F");
    add("<path class=\"fr\" d=\"M1 4H13V14H25\"/>", "Pareto front: nothing is better in both");
    add("<g class=\"p\"><circle class=\"ch\" cx=\"13\" cy=\"9\" r=\"7\"/></g>",
        "what a bake of the catalog writes");
    return out + "</ul>\n";
}

std::string figures_html(const AnimalReport& animal, const Series& series) {
    std::vector<Candidate> candidates;
    for (const ReportRow& row : animal.rows)
        candidates.push_back(candidate_of(row, base::widened(animal.radius_m)));
    return charts_of(candidates, series, animal.id);
}

std::string figures_html(const std::vector<ReportTotal>& totals, const Series& series) {
    std::vector<Candidate> candidates;
    candidates.reserve(totals.size());
    for (const ReportTotal& total : totals) candidates.push_back(candidate_of(total));
    return charts_of(candidates, series, "Whole catalog");
}

}  // namespace posepack::output
