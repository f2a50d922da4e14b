// SPDX-License-Identifier: MIT
#include "output/report_tables.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "output/choice_text.hpp"
#include "output/html_text.hpp"
#include "output/log_axis.hpp"
#include "output/text_table.hpp"

namespace posepack::output {
namespace {

// A table in the making. Cells are HTML: whoever adds a text of strangers escapes it.
class HtmlTable {
 public:
    explicit HtmlTable(std::vector<Column> columns) : columns_(std::move(columns)) {
        out_ = "<div class=\"wide\"><table>\n<thead><tr>";
        for (const Column& column : columns_)
            out_ += cell("th scope=\"col\"", column.align, column.title, "th");
        out_ += "</tr></thead>\n<tbody>\n";
    }
    void add(const std::vector<std::string>& cells, bool is_marked = false) {
        out_ += is_marked ? "<tr class=\"c\">" : "<tr>";
        for (std::size_t c = 0; c < cells.size(); ++c) out_ += cell("td", columns_[c].align, cells[c], "td");
        out_ += "</tr>\n";
    }
    std::string finish() const { return out_ + "</tbody>\n</table></div>\n"; }

 private:
    static std::string cell(const char* open, Align align, const std::string& text, const char* tag) {
        return fmt::format("<{}{}>{}</{}>", open, align == Align::left ? " class=\"l\"" : "", text, tag);
    }
    std::vector<Column> columns_;
    std::string out_;
};

std::string three_digits(double value) {
    return fmt::format("{:.3g}", value);
}

std::string millimetres(float metres) {
    const double mm = base::widened(metres) * 1e3;
    return mm >= 999.5 ? fmt::format("{:.0f}", mm) : three_digits(mm);
}

std::string place_of(const recipe::ErrorRecord& error) {
    return fmt::format("{} {:.2f} s, {}", html_text(error.clip, 24), error.time_s, html_text(error.bone, 24));
}

}  // namespace

std::string forms_table(const AnimalReport& animal) {
    HtmlTable table({{"form", Align::left},
                     {"rows", Align::left},
                     {"bytes"},
                     {"max / R"},
                     {"p99.9 / R"},
                     {"rms / R"},
                     {"max mm"},
                     {"normal max \u00b0"},
                     {"normal p99.9 \u00b0"},
                     {"CPU ns"},
                     {"fetches"},
                     {"ALU"},
                     {"bake ms"},
                     {"worst place", Align::left}});
    for (const ReportRow& row : animal.rows) {
        const recipe::ErrorRecord& e = row.error;
        table.add({html_text(row.form), html_text(row.rows) + (row.is_chosen ? " (chosen)" : ""),
                   base::grouped(row.bytes), short_error(e.max), short_error(e.p999), short_error(e.rms),
                   millimetres(e.max_m), three_digits(base::widened(e.normal_max_deg)),
                   three_digits(base::widened(e.normal_p999_deg)),
                   fmt::format("{:.2f}", row.decode_ns_per_vertex), std::to_string(row.fetches),
                   std::to_string(row.alu_operations), fmt::format("{:.1f}", row.bake_ms), place_of(e)},
                  row.is_chosen);
    }
    return table.finish();
}

std::string totals_table(const std::vector<ReportTotal>& totals) {
    HtmlTable table({{"form", Align::left},
                     {"rows", Align::left},
                     {"animals"},
                     {"bytes"},
                     {"max median"},
                     {"max worst"},
                     {"worst animal", Align::left},
                     {"p99.9 median"},
                     {"p99.9 worst"},
                     {"rms median"},
                     {"rms worst"},
                     {"normal worst \u00b0"},
                     {"CPU ns"},
                     {"fetches"},
                     {"ALU"},
                     {"bake ms"}});
    for (const ReportTotal& t : totals)
        table.add({html_text(t.form), html_text(t.rows) + (t.is_chosen ? " (chosen)" : ""),
                   std::to_string(t.animal_count), base::grouped(t.bytes), short_error(t.max.median),
                   short_error(t.max.worst), html_text(t.max.worst_animal, 24), short_error(t.p999.median),
                   short_error(t.p999.worst), short_error(t.rms.median), short_error(t.rms.worst),
                   three_digits(t.normal_max_deg.worst), fmt::format("{:.2f}", t.decode_ns_per_vertex),
                   three_digits(t.fetches), three_digits(t.alu_operations), fmt::format("{:.1f}", t.bake_ms)},
                  t.is_chosen);
    return table.finish();
}

std::string overview_table(const Report& report) {
    HtmlTable table({{"animal", Align::left},
                     {"bones"},
                     {"vertices"},
                     {"clips"},
                     {"R, m"},
                     {"form", Align::left},
                     {"rows", Align::left},
                     {"bytes"},
                     {"max / R"},
                     {"p99.9 / R"},
                     {"rms / R"},
                     {"max mm"},
                     {"normal p99.9 \u00b0"},
                     {"worst place", Align::left}});
    for (std::size_t a = 0; a < report.animals.size(); ++a) {
        const AnimalReport& animal = report.animals[a];
        const ReportRow* row = chosen_row(animal);
        if (row == nullptr) continue;
        table.add({fmt::format("<a href=\"#a{}\">{}</a>", a, html_text(animal.id, 48)),
                   std::to_string(animal.bone_count), base::grouped(animal.vertex_count),
                   std::to_string(animal.clips.size()), three_digits(base::widened(animal.radius_m)),
                   html_text(row->form), html_text(row->rows), base::grouped(row->bytes),
                   short_error(row->error.max), short_error(row->error.p999), short_error(row->error.rms),
                   millimetres(row->error.max_m), three_digits(base::widened(row->error.normal_p999_deg)),
                   place_of(row->error)});
    }
    return table.finish();
}

std::string clips_table(const AnimalReport& animal) {
    HtmlTable table({{"clip", Align::left},
                     {"form", Align::left},
                     {"rows"},
                     {"rate, Hz"},
                     {"period, s"},
                     {"wrap", Align::left},
                     {"max / R"},
                     {"p99.9 / R"},
                     {"rms / R"},
                     {"max mm"},
                     {"normal max \u00b0"},
                     {"worst at, s"},
                     {"bone", Align::left},
                     {"why", Align::left}});
    for (const recipe::ClipRecord& clip : animal.clips)
        table.add({html_text(clip.name, 48), html_text(clip.encoding + ", " + clip.row_scheme),
                   std::to_string(clip.row_count), three_digits(base::widened(clip.rate_hz)),
                   three_digits(base::widened(clip.period_s)), html_text(clip.wrap),
                   short_error(clip.error.max), short_error(clip.error.p999), short_error(clip.error.rms),
                   millimetres(clip.error.max_m), three_digits(base::widened(clip.error.normal_max_deg)),
                   fmt::format("{:.2f}", clip.error.time_s), html_text(clip.error.bone, 48),
                   html_text(choice_sentence(clip))});
    return table.finish();
}

}  // namespace posepack::output
