// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "base/text.hpp"
#include "output/html_text.hpp"
#include "output/log_axis.hpp"
#include "output/report_figures.hpp"
#include "output/report_heat.hpp"
#include "output/report_page.hpp"
#include "output/report_tables.hpp"
#include "output/report_writers.hpp"

namespace posepack::output {
namespace {

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
    std::string out =
        "<section class=\"all\" id=\"catalog\">\n<h2>Whole catalog</h2>\n<p class=\"sub\">Bytes are summed "
        "over the animals; errors, fractions of R, are those of the animal that errs most; run times are "
        "means.</p>\n";
    if (!comparable.left_out.empty())
        out += fmt::format(
            "<p class=\"note\">The charts compare the {} that can have every form. Left out: {}.</p>\n",
            base::counted(report.animals.size() - comparable.left_out.size(), "animal"),
            html_text(fmt::format("{}", fmt::join(comparable.left_out, ", ")), 1000));
    out += legend_html(series) + figures_html(comparable.totals, series);
    return out + "<h3>Forms and row schemes</h3>\n" + totals_table(totals) + "</section>\n" +
           "<section class=\"all\" id=\"overview\">\n<h2>Animals as chosen</h2>\n" + overview_table(report) +
           "</section>\n";
}

std::string worst_sentence(const ReportRow& row) {
    const recipe::ErrorRecord& e = row.error;
    return fmt::format(
        "<p>Chosen: <b>{}, {}</b>, {}. Largest error <b>{} R</b> = {}, in clip <b>{}</b> at {:.3f} s, "
        "mesh {}, vertex {}, because of bone <b>{}</b>.</p>\n",
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
    const ReportRow* chosen = chosen_row(animal);
    std::string out = fmt::format(
        "<section class=\"animal\" id=\"a{}\">\n<h2>{}</h2>\n<p class=\"sub\">{}, {}, {}, "
        "R = {:.3g} m</p>\n",
        index, html_text(animal.id, 64), base::counted(animal.bone_count, "bone"),
        base::counted(animal.vertex_count, "vertex", "vertices"), base::counted(animal.clips.size(), "clip"),
        animal.radius_m);
    if (chosen != nullptr) out += worst_sentence(*chosen);
    out += legend_html(series) + figures_html(animal, series) + heat_of(animal);
    if (!animal.clips.empty())
        out += "<details><summary>Clips, chosen rows</summary>\n" + clips_table(animal) + "</details>\n";
    out += "<details><summary>Forms and row schemes</summary>\n" + forms_table(animal) + "</details>\n";
    return out + refusals_of(animal) + "</section>\n";
}

// The page around the sections

// The buttons that choose what the charts show, and the bar of their labels. The buttons stand apart, before
// all that they rule: the style sheet looks at those that come first.
struct Bar {
    std::string buttons, nav;
};

Bar bar_of(const Report& report) {
    Bar bar;
    const auto add = [&](const char* title, const char* group, std::span<const Pick> picks) {
        bar.nav += fmt::format("<div class=\"seg\"><span>{}</span>", title);
        for (const Pick& pick : picks) {
            bar.buttons += fmt::format("<input class=\"pick\" type=\"radio\" name=\"{}\" id=\"{}\"{}>\n",
                                       group, pick.id, &pick == &picks.front() ? " checked" : "");
            bar.nav += fmt::format("<label for=\"{}\">{}</label>", pick.id, pick.name);
        }
        bar.nav += "</div>\n";
    };
    bar.nav = "<nav><div>\n";
    add("Error", "error", error_picks());
    add("Run time", "cost", run_time_picks());
    bar.nav +=
        "<div class=\"show\" hidden><label for=\"animal\">Show</label> <select id=\"animal\"><option "
        "value=\"\">all animals</option>";
    for (std::size_t a = 0; a < report.animals.size(); ++a)
        bar.nav += fmt::format("<option value=\"a{}\">{}</option>", a, html_text(report.animals[a].id, 48));
    bar.nav += "</select></div>\n</div></nav>\n";
    return bar;
}

constexpr std::string_view kFooter = R"html(<footer>
<p><b>R</b> is the radius of the sphere around the rest pose. Errors are those of the written bytes, read back by the
loader and compared with the source curves at rows, keys and the midpoints between them. <b>p99.9</b>: 99.9&#160;% of all
vertices and times err less. <b>Bytes</b>: texels of all stored rows. <b>CPU time</b>: two rows decoded and blended by the
loader and every vertex skinned, one thread of the machine that wrote this page. <b>Fetches</b> and <b>ALU</b> are
counted by hand for a vertex shader that moves a position and a normal. Times differ from run to run, nothing else
does.</p>
</footer>
)html";

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
    const Bar bar = bar_of(report);
    out += bar.buttons;
    out += fmt::format(
        "<header>\n<h1>Error against run time</h1>\n<p class=\"sub\">{}, every encoding and row scheme, "
        "measured on the written bytes</p>\n{}</header>\n",
        html_text(report.catalog), summary_of(report, totals));
    out += bar.nav;
    out += "<main>\n" + catalog_section(report, totals, series);
    for (std::size_t a = 0; a < report.animals.size(); ++a)
        out += animal_section(report.animals[a], a, series);
    out += "</main>\n";
    out += kFooter;
    return out + fmt::format("<script>{}</script>\n</body>\n</html>\n", report_script());
}

}  // namespace posepack::output
