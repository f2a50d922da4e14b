// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "base/text.hpp"
#include "output/html_text.hpp"
#include "output/report_chart.hpp"
#include "output/report_heat.hpp"
#include "output/report_page.hpp"
#include "output/report_tables.hpp"
#include "output/report_writers.hpp"

namespace posepack::output {
namespace {

// A point of all charts of a section: an animal's row, or a total.
struct Candidate {
    std::string form, rows, encoding;
    bool is_hollow = false, is_chosen = false;
    std::array<double, 3> errors{};  // in the order of kErrors
    std::array<double, 4> costs{};   // in the order of kCosts
    double metres = 0.0;             // of a whole R
};

struct ErrorKind {
    const char* id;     // of its style class: "e-max"
    const char* name;   // "max"
    const char* title;  // of an axis
};
constexpr std::array<ErrorKind, 3> kErrors{{{"e-max", "max", "largest error, fraction of R"},
                                            {"e-p999", "p99.9", "p99.9 of the error, fraction of R"},
                                            {"e-rms", "rms", "rms error, fraction of R"}}};

struct CostKind {
    const char* id;
    const char* name;   // in the bar
    const char* title;  // of an axis
    AxisUnit unit;
    double least_ratio;  // of the axis: times of one machine differ by some per cent for nothing
    bool with_curves;
    const char* words;  // behind a number
};
constexpr std::array<CostKind, 4> kCosts{
    {{"k-bytes", "bytes", "bytes of texels", AxisUnit::bytes, 2.0, true, ""},
     {"k-ns", "CPU time", "CPU time to decode, blend and skin, ns a vertex", AxisUnit::nanoseconds, 1.6,
      false, " ns a vertex"},
     {"k-fetches", "texel fetches", "texel fetches of a vertex (4 influences, 2 rows)", AxisUnit::count, 2.0,
      false, " fetches"},
     {"k-alu", "ALU", "multiply-adds of a vertex (4 influences, 2 rows), about", AxisUnit::count, 2.0, false,
      " multiply-adds"}}};

// Colours of encodings, by the order in which they appear.
class Series {
 public:
    static constexpr unsigned kColours = 8;

    explicit Series(const Report& report) {
        for (const AnimalReport& animal : report.animals)
            for (const ReportRow& row : animal.rows)
                if (std::find(names_.begin(), names_.end(), row.encoding) == names_.end())
                    names_.push_back(row.encoding);
    }
    unsigned of(const std::string& encoding) const {
        const auto found = std::find(names_.begin(), names_.end(), encoding);
        return static_cast<unsigned>(found - names_.begin()) % kColours;
    }
    const std::vector<std::string>& names() const { return names_; }

 private:
    std::vector<std::string> names_;
};

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
    const std::string costs = kCosts[cost].unit == AxisUnit::bytes
                                  ? decimal_bytes(value)
                                  : fmt::format("{:.3g}{}", value, kCosts[cost].words);
    const std::string metres =
        candidate.metres > 0 ? " = " + length_text(candidate.errors[error] * candidate.metres) : "";
    return fmt::format("{}, {}: {}, {} {} R{}", candidate.form, candidate.rows, costs, kErrors[error].name,
                       short_error(candidate.errors[error]), metres);
}

std::string chart_of(const std::vector<Candidate>& candidates, const Series& series, const std::string& name,
                     std::size_t error, std::size_t cost) {
    const CostKind& kind = kCosts[cost];
    Chart chart;
    chart.name = fmt::format("{}: {} error against {}", name, kErrors[error].name, kind.name);
    chart.cost_title = kind.title;
    chart.error_title = kErrors[error].title;
    chart.cost_unit = kind.unit;
    chart.least_cost_ratio = kind.least_ratio;
    chart.with_curves = kind.with_curves;
    for (const Candidate& candidate : candidates)
        chart.points.push_back({candidate.costs[cost], candidate.errors[error], candidate.rows,
                                title_of(candidate, error, cost), series.of(candidate.encoding),
                                candidate.is_hollow, candidate.is_chosen});
    return chart_svg(chart);
}

// All charts of a section; the bar above decides which of them are seen.
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

std::string legend_of(const Series& series) {
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

std::string heat_key() {
    std::string out = "<ul class=\"legend heatkey\">";
    for (std::size_t k = 0; k <= heat_edges().size(); ++k)
        out += fmt::format(
            "<li><i class=\"h{}\"></i>{}</li>", k,
            k == 0 ? std::string("less") : tick_text(AxisUnit::fraction, base::widened(heat_edges()[k - 1])));
    return out + "</ul>\n";
}

// Tiles

struct Tile {
    std::string name, value, remark;  // HTML
};

std::string tiles_html(const std::vector<Tile>& tiles) {
    std::string out = "<dl class=\"tiles\">\n";
    for (const Tile& tile : tiles)
        out += fmt::format("<div><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n", tile.name, tile.value,
                           tile.remark);
    return out + "</dl>\n";
}

const ReportTotal* find_total(const std::vector<ReportTotal>& totals, auto is_it) {
    const auto found = std::find_if(totals.begin(), totals.end(), is_it);
    return found == totals.end() ? nullptr : &*found;
}

// How many times the bytes of the published technique (mat4 RGBA32F, 30 rows a second) the chosen rows spare.
std::string ratio_remark(const Report& report, const std::vector<ReportTotal>& totals,
                         const ReportTotal& chosen) {
    const ReportTotal* baseline = find_total(totals, [](const ReportTotal& total) {
        return total.form == "mat4 rgba32f" && total.rows == "30 Hz";
    });
    if (baseline == nullptr || baseline->animal_count != report.animals.size() ||
        chosen.animal_count != report.animals.size() || chosen.bytes == 0)
        return "texels of the chosen rows";
    return fmt::format("{:.1f} times less than mat4 RGBA32F at 30 Hz",
                       static_cast<double>(baseline->bytes) / static_cast<double>(chosen.bytes));
}

std::string summary_of(const Report& report, const std::vector<ReportTotal>& totals) {
    std::size_t clips = 0;
    for (const AnimalReport& animal : report.animals) clips += animal.clips.size();
    std::vector<Tile> tiles{{"Animals", base::grouped(report.animals.size()), base::counted(clips, "clip")}};
    const ReportTotal* chosen = find_total(totals, [](const ReportTotal& total) { return total.is_chosen; });
    if (chosen != nullptr) {
        tiles.push_back({"Chosen", html_text(chosen->form), html_text("rows: " + chosen->rows)});
        tiles.push_back({"Size", decimal_bytes(static_cast<double>(chosen->bytes)),
                         ratio_remark(report, totals, *chosen)});
        tiles.push_back(
            {"Largest error", short_error(chosen->max.worst) + " R",
             fmt::format("{}; median of the animals {} R", html_text(chosen->max.worst_animal, 32),
                         short_error(chosen->max.median))});
        tiles.push_back({"p99.9", short_error(chosen->p999.worst) + " R",
                         fmt::format("{}; median {} R", html_text(chosen->p999.worst_animal, 32),
                                     short_error(chosen->p999.median))});
        tiles.push_back({"CPU decode", fmt::format("{:.2f} ns", chosen->decode_ns_per_vertex),
                         "a vertex, one thread, this machine"});
    }
    return tiles_html(tiles);
}

// Sections

std::string catalog_section(const Report& report, const std::vector<ReportTotal>& totals,
                            const Series& series) {
    const ComparableTotals comparable = comparable_totals(report);
    std::vector<Candidate> candidates;
    for (const ReportTotal& total : comparable.totals) candidates.push_back(candidate_of(total));
    std::string out =
        "<section class=\"all\" id=\"catalog\">\n<h2>Whole catalog</h2>\n<p class=\"sub\">Bytes are summed "
        "over the animals; errors, fractions of R, are those of the animal that errs most; run times are "
        "means.</p>\n";
    if (!comparable.left_out.empty())
        out += fmt::format(
            "<p class=\"note\">The charts compare the {} that can have every form. Left out: {}.</p>\n",
            base::counted(report.animals.size() - comparable.left_out.size(), "animal"),
            html_text(fmt::format("{}", fmt::join(comparable.left_out, ", ")), 1000));
    out += legend_of(series) + charts_of(candidates, series, "Whole catalog");
    return out + "<h3>Forms and row schemes</h3>\n" + totals_table(totals) + "</section>\n" +
           "<section class=\"all\" id=\"overview\">\n<h2>Animals as chosen</h2>\n" + overview_table(report) +
           "</section>\n";
}

std::string worst_sentence(const ReportRow& row) {
    const recipe::ErrorRecord& e = row.error;
    return fmt::format(
        "<p>Chosen: <b>{}, {}</b>, {}. Largest error <b>{} R</b> = {}, in clip <b>{}</b> at {:.3f} s, "
        "mesh {}, "
        "vertex {}, because of bone <b>{}</b>.</p>\n",
        html_text(row.form), html_text(row.rows), decimal_bytes(static_cast<double>(row.bytes)),
        short_error(e.max), length_text(base::widened(e.max_m)), html_text(e.clip, 64), e.time_s,
        html_text(e.mesh, 64), e.vertex, html_text(e.bone, 64));
}

std::string refusals_of(const AnimalReport& animal) {
    std::string out;
    for (const RefusedForm& form : animal.refused)
        out += fmt::format("<li>{}, {}: {}</li>\n", html_text(form.form), html_text(form.rows),
                           html_text(base::format_issue(form.issue), 1000));
    return out.empty() ? out : "<h3>Forms it cannot have</h3>\n<ul class=\"note\">\n" + out + "</ul>\n";
}

std::string heat_of(const AnimalReport& animal) {
    if (!animal.heat || animal.heat->bones.empty() || animal.heat->clips.empty()) return "";
    std::string out = fmt::format(
        "<h3>Largest error over time and bone, chosen rows, fraction of R</h3>\n{}<div "
        "class=\"wide\">{}</div>\n",
        heat_key(), heat_svg(*animal.heat, animal.id, base::widened(animal.radius_m)));
    if (animal.heat->bones.size() > kHeatBones)
        out += fmt::format("<p class=\"note\">The {} of {} bones that err most.</p>\n", kHeatBones,
                           animal.heat->bones.size());
    return out;
}

std::string animal_section(const AnimalReport& animal, std::size_t index, const Series& series) {
    std::vector<Candidate> candidates;
    for (const ReportRow& row : animal.rows)
        candidates.push_back(candidate_of(row, base::widened(animal.radius_m)));
    const ReportRow* chosen = chosen_row(animal);
    std::string out = fmt::format(
        "<section class=\"animal\" id=\"a{}\">\n<h2>{}</h2>\n<p class=\"sub\">{}, {}, {}, "
        "R = {:.3g} m</p>\n",
        index, html_text(animal.id, 64), base::counted(animal.bone_count, "bone"),
        base::counted(animal.vertex_count, "vertex", "vertices"), base::counted(animal.clips.size(), "clip"),
        animal.radius_m);
    if (chosen != nullptr) out += worst_sentence(*chosen);
    out += legend_of(series) + charts_of(candidates, series, animal.id) + heat_of(animal);
    if (!animal.clips.empty())
        out += "<details><summary>Clips, chosen rows</summary>\n" + clips_table(animal) + "</details>\n";
    out += "<details><summary>Forms and row schemes</summary>\n" + forms_table(animal) + "</details>\n";
    return out + refusals_of(animal) + "</section>\n";
}

// The page around the sections

std::string bar_of(const Report& report) {
    std::string picks, bar;
    const auto add = [&](const char* group, const char* id, const char* name, bool is_first) {
        picks += fmt::format("<input class=\"pick\" type=\"radio\" name=\"{}\" id=\"{}\"{}>\n", group, id,
                             is_first ? " checked" : "");
        bar += fmt::format("<label for=\"{}\">{}</label>", id, name);
    };
    bar += "<nav><div>\n<div class=\"seg\"><span>Error</span>";
    for (const ErrorKind& kind : kErrors) add("error", kind.id, kind.name, &kind == &kErrors.front());
    bar += "</div>\n<div class=\"seg\"><span>Run time</span>";
    for (std::size_t k = 1; k < kCosts.size(); ++k) add("cost", kCosts[k].id, kCosts[k].name, k == 1);
    bar +=
        "</div>\n<div class=\"show\" hidden><label for=\"animal\">Show</label> <select "
        "id=\"animal\"><option value=\"\">all "
        "animals</option>";
    for (std::size_t a = 0; a < report.animals.size(); ++a)
        bar += fmt::format("<option value=\"a{}\">{}</option>", a, html_text(report.animals[a].id, 48));
    return picks + bar + "</select></div>\n</div></nav>\n";
}

constexpr std::string_view kFooter =
    "<footer>\n<p><b>R</b> is the radius of the sphere around the rest pose. Errors are those of the written "
    "bytes, read "
    "back by the loader and compared with the source curves at rows, keys and the midpoints between them. "
    "<b>p99.9</b>: "
    "99.9&#160;% of all vertices and times err less. <b>Bytes</b>: texels of all stored rows. <b>CPU "
    "time</b>: two rows "
    "decoded and blended by the loader and every vertex skinned, one thread of the machine that wrote this "
    "page. "
    "<b>Fetches</b> and <b>ALU</b> are counted by hand for a vertex shader that moves a position and a "
    "normal. Times "
    "differ from run to run, nothing else does.</p>\n</footer>\n";

}  // namespace

std::string report_html(const Report& report) {
    const std::vector<ReportTotal> totals = report_totals(report);
    const Series series(report);
    std::string out = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>posepack report: {}</title>\n<style>{}</style>\n</head>\n<body>\n",
        content_policy(report_script()), html_text(report.catalog), report_style());
    const std::string bar = bar_of(report);
    const std::size_t nav = bar.find("<nav>");
    out += bar.substr(0, nav);
    out += fmt::format(
        "<header>\n<h1>Error against run time</h1>\n<p class=\"sub\">{}, every encoding and row scheme, "
        "measured on the written bytes</p>\n{}</header>\n",
        html_text(report.catalog), summary_of(report, totals));
    out += bar.substr(nav);
    out += "<main>\n" + catalog_section(report, totals, series);
    for (std::size_t a = 0; a < report.animals.size(); ++a)
        out += animal_section(report.animals[a], a, series);
    out += "</main>\n";
    out += kFooter;
    return out + fmt::format("<script>{}</script>\n</body>\n</html>\n", report_script());
}

}  // namespace posepack::output
