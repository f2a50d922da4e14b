// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "output/text_table.hpp"
#include "stress/stress_report.hpp"

namespace posepack::stress {
namespace {

using output::Align;
using output::TextTable;

std::string amount(double value) {
    return value == 0.0 ? "0" : fmt::format("{:.1e}", value);
}

// An error, or the end of the id of what refuses it: "SIMILARITY" of E-LIM-SIMILARITY.
std::string cell(const FormResult& form) {
    if (!form.refusal) return amount(form.drawn.all.max);
    const std::string_view id = issue_kind(form.refusal->code).id;
    return std::string(id.substr(id.find('-', 2) + 1));
}

// The action, with the form that was chosen: "switches form to affine 32F, slots".
std::string verdict(const CaseResult& result) {
    std::string text = text_of(result.found.action);
    constexpr std::string_view kSwitches = "switches form";
    if (result.chosen && result.found.action.switches_form)
        text.insert(kSwitches.size(), " to " + label_of(result.chosen->form));
    return result.difference.empty() ? text : "DIFFERS: " + text;
}

// "14 of 124": how many of those that the rows of the start have.
std::string bone_rows(const Chosen& chosen) {
    return fmt::format("{} of {}", chosen.bone_row_count, chosen.start_bone_row_count);
}

std::vector<output::Column> form_columns(bool of_default_space) {
    std::vector<output::Column> columns{{"case", Align::left}};
    for (const Form& form : all_forms()) {
        if (is_default_space(form) != of_default_space) continue;
        Form named = form;
        if (!of_default_space)
            named.space =
                named.space == recipe::Space::model ? recipe::Space::normalised : recipe::Space::model;
        columns.push_back({label_of(named)});
    }
    return columns;
}

std::vector<std::string> form_cells(const CaseResult& result, bool of_default_space) {
    std::vector<std::string> cells{std::string(result.stress_case->name)};
    for (const FormResult& form : result.forms)
        if (is_default_space(form.form) == of_default_space) cells.push_back(cell(form));
    return cells;
}

std::string main_table(std::span<const CaseResult> results) {
    TextTable table;
    table.columns = form_columns(true);
    for (const char* title : {"bound", "reached", "bone-rows"}) table.columns.push_back({title});
    table.columns.push_back({"what happens", Align::left});
    for (const CaseResult& result : results) {
        std::vector<std::string> cells = form_cells(result, true);
        cells.push_back(amount(result.bound.max));
        cells.push_back(result.chosen ? amount(result.chosen->drawn.all.max) : "-");
        cells.push_back(result.chosen ? bone_rows(*result.chosen) : "-");
        cells.push_back(verdict(result));
        table.rows.push_back(std::move(cells));
    }
    return format_text(table);
}

std::string other_space_table(std::span<const CaseResult> results) {
    TextTable table;
    table.columns = form_columns(false);
    for (const CaseResult& result : results) table.rows.push_back(form_cells(result, false));
    return format_text(table);
}

// Calls `print` with the results of each group in turn.
template <class Print>
void for_each_group(std::span<const CaseResult> results, const Print& print) {
    for (const CaseGroup& group : case_groups()) {
        const auto is_of_group = [&group](const CaseResult& result) { return result.group == group.title; };
        const auto first = std::find_if(results.begin(), results.end(), is_of_group);
        const auto last = std::find_if_not(first, results.end(), is_of_group);
        if (first != last) print(group, std::span<const CaseResult>(first, last));
    }
}

TextTable details_table(const CaseResult& result) {
    TextTable table;
    table.columns = {{"form", Align::left},
                     {"rows"},
                     {"bytes"},
                     {"max at rows"},
                     {"max"},
                     {"p99.9"},
                     {"rms"},
                     {"printed max"},
                     {"printed p99.9"},
                     {"printed rms"},
                     {"normals deg"},
                     {"refused with", Align::left}};
    for (const FormResult& form : result.forms) {
        if (form.refusal) {
            std::vector<std::string> cells(table.columns.size(), "-");
            cells.front() = label_of(form.form);
            cells.back() = issue_kind(form.refusal->code).id;
            table.rows.push_back(std::move(cells));
            continue;
        }
        table.rows.push_back({label_of(form.form), std::to_string(form.row_count),
                              std::to_string(form.texel_bytes), amount(form.drawn.rows.max),
                              amount(form.drawn.all.max), amount(form.drawn.all.p999),
                              amount(form.drawn.all.rms), amount(form.printed.max), amount(form.printed.p999),
                              amount(form.printed.rms), fmt::format("{:.2g}", form.normal_max_deg), ""});
    }
    return table;
}

std::string outcome_text(const CaseResult& result) {
    std::string text =
        fmt::format("bound: max {} R, p99.9 {} R\nwhat happens: {}\n", amount(result.bound.max),
                    amount(result.bound.p999), text_of(result.found.action));
    if (result.chosen)
        text += fmt::format("chosen: {}, {} bone-rows in {}, {} bytes: max {} R, p99.9 {} R\n",
                            label_of(result.chosen->form), bone_rows(*result.chosen),
                            result.chosen->has_slots ? "slots" : "runs",
                            base::grouped(result.chosen->texel_bytes), amount(result.chosen->drawn.all.max),
                            amount(result.chosen->drawn.all.p999));
    if (!result.found.refusal.empty()) text += result.found.refusal + "\n";
    for (const base::IssueCode code : result.found.warnings)
        text += fmt::format("remark: {}\n", issue_kind(code).id);
    if (!result.difference.empty()) text += "DIFFERS: " + result.difference + "\n";
    return text;
}

std::string counts(std::span<const CaseResult> results) {
    const auto differing = std::count_if(results.begin(), results.end(),
                                         [](const CaseResult& result) { return !result.difference.empty(); });
    return fmt::format(
        "{}: {} as expected, {} not. Errors are the largest, as drawn in 32-bit float, in "
        "fractions of R.\n",
        base::counted(results.size(), "case"), results.size() - static_cast<std::size_t>(differing),
        differing);
}

}  // namespace

std::string stress_list() {
    std::string text;
    for (const CaseGroup& group : case_groups()) {
        TextTable table;
        table.columns = {{"case", Align::left}, {"why it is hard", Align::left}};
        for (const StressCase& stress_case : group.cases)
            table.rows.push_back({std::string(stress_case.name), std::string(stress_case.trouble)});
        text += fmt::format("{}{}\n\n{}", text.empty() ? "" : "\n", group.title, format_text(table));
    }
    return text;
}

std::string stress_text(std::span<const CaseResult> results) {
    std::string text;
    for_each_group(results, [&text](const CaseGroup& group, std::span<const CaseResult> of_group) {
        text += fmt::format("{}\n\n{}\n", group.title, main_table(of_group));
        if (!group.in_both_spaces) return;
        text += fmt::format(
            "The same in the other space: mat4 normalised, affine and dualquat in model space\n\n{}\n",
            other_space_table(of_group));
    });
    return text + counts(results);
}

std::string stress_details(std::span<const CaseResult> results) {
    std::string text;
    for (const CaseResult& result : results)
        text += fmt::format("{}: {}\n{}{}\n", result.stress_case->name, result.stress_case->trouble,
                            format_text(details_table(result)), outcome_text(result));
    return text + counts(results);
}

}  // namespace posepack::stress
