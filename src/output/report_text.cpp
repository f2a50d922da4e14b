// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "base/text.hpp"
#include "output/choice_text.hpp"
#include "output/report_totals.hpp"
#include "output/report_writers.hpp"
#include "output/text_table.hpp"

namespace posepack::output {
namespace {

std::string worst_place(const recipe::ErrorRecord& error) {
    return fmt::format("{} {:.3f} s, vertex {}, {}", base::printable(base::shortened(error.clip, 24)),
                       error.time_s, error.vertex, base::printable(base::shortened(error.bone, 24)));
}

std::string millimetres(double metres) {
    return fmt::format("{:.3g}", metres * 1e3);
}

TextTable rows_table(const Report& report) {
    TextTable table;
    table.columns = {{"animal", Align::left},
                     {"form", Align::left},
                     {"rows", Align::left},
                     {"bytes"},
                     {"max / R"},
                     {"p99.9 / R"},
                     {"rms / R"},
                     {"max mm"},
                     {"normal max deg"},
                     {"decode ns/vertex"},
                     {"fetches"},
                     {"ALU"},
                     {"bake ms"},
                     {"chosen"},
                     {"worst place", Align::left}};
    for (const AnimalReport& animal : report.animals)
        for (const ReportRow& row : animal.rows)
            table.rows.push_back(
                {animal.id, row.form, row.rows, std::to_string(row.bytes), readable_error(row.error.max),
                 readable_error(row.error.p999), readable_error(row.error.rms), millimetres(row.error.max_m),
                 fmt::format("{:.3g}", row.error.normal_max_deg),
                 fmt::format("{:.2f}", row.decode_ns_per_vertex), std::to_string(row.fetches),
                 std::to_string(row.alu_operations), fmt::format("{:.2f}", row.bake_ms),
                 row.is_chosen ? "yes" : "", worst_place(row.error)});
    return table;
}

TextTable totals_table(const Report& report) {
    TextTable table;
    table.columns = {{"form", Align::left},
                     {"rows", Align::left},
                     {"animals"},
                     {"bytes"},
                     {"max median"},
                     {"max worst"},
                     {"worst animal", Align::left},
                     {"p99.9 worst"},
                     {"rms worst"},
                     {"decode ns/vertex"},
                     {"bake ms"},
                     {"chosen"}};
    for (const ReportTotal& total : report_totals(report))
        table.rows.push_back({total.form, total.rows, std::to_string(total.animal_count),
                              std::to_string(total.bytes), readable_error(total.max.median),
                              readable_error(total.max.worst), total.max.worst_animal,
                              readable_error(total.p999.worst), readable_error(total.rms.worst),
                              fmt::format("{:.2f}", total.decode_ns_per_vertex),
                              fmt::format("{:.2f}", total.bake_ms), total.is_chosen ? "yes" : ""});
    return table;
}

// Why each clip is as it is, where a bound chose.
std::string choices_text(const Report& report) {
    TextTable table;
    table.columns = {
        {"animal", Align::left}, {"clip", Align::left}, {"max / R"}, {"p99.9 / R"}, {"why", Align::left}};
    for (const AnimalReport& animal : report.animals)
        for (const recipe::ClipRecord& clip : animal.clips)
            if (!clip.tried.empty())
                table.rows.push_back({animal.id, base::printable(clip.name), readable_error(clip.error.max),
                                      readable_error(clip.error.p999), choice_sentence(clip)});
    return table.rows.empty() ? "" : "\nChosen by the bound:\n\n" + format_text(table);
}

// A float as JSON has it: the shortest text that reads back as the same.
std::string exact(float value) {
    return base::shortest(value);
}

}  // namespace

std::string report_text(const Report& report) {
    return format_text(rows_table(report)) + "\nAll animals:\n\n" + format_text(totals_table(report)) +
           choices_text(report);
}

std::string report_csv(const Report& report) {
    TextTable table;
    for (const char* title : {"animal",
                              "form",
                              "encoding",
                              "texel_format",
                              "rows",
                              "chosen",
                              "bytes",
                              "max",
                              "p999",
                              "rms",
                              "max_m",
                              "p999_m",
                              "rms_m",
                              "normal_max_deg",
                              "normal_p999_deg",
                              "normal_rms_deg",
                              "decode_ns_per_vertex",
                              "fetches",
                              "alu_operations",
                              "bake_ms",
                              "worst_clip",
                              "worst_time_s",
                              "worst_mesh",
                              "worst_vertex",
                              "worst_bone"})
        table.columns.push_back({title});
    for (const AnimalReport& animal : report.animals)
        for (const ReportRow& row : animal.rows) {
            const recipe::ErrorRecord& e = row.error;
            table.rows.push_back({animal.id,
                                  row.form,
                                  row.encoding,
                                  row.texel_format,
                                  row.rows,
                                  row.is_chosen ? "yes" : "",
                                  std::to_string(row.bytes),
                                  exact(e.max),
                                  exact(e.p999),
                                  exact(e.rms),
                                  exact(e.max_m),
                                  exact(e.p999_m),
                                  exact(e.rms_m),
                                  exact(e.normal_max_deg),
                                  exact(e.normal_p999_deg),
                                  exact(e.normal_rms_deg),
                                  fmt::format("{:.3f}", row.decode_ns_per_vertex),
                                  std::to_string(row.fetches),
                                  std::to_string(row.alu_operations),
                                  fmt::format("{:.3f}", row.bake_ms),
                                  base::printable(e.clip),
                                  exact(e.time_s),
                                  base::printable(e.mesh),
                                  std::to_string(e.vertex),
                                  base::printable(e.bone)});
        }
    return format_csv(table);
}

}  // namespace posepack::output
