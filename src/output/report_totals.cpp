// SPDX-License-Identifier: MIT
#include "output/report_totals.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace posepack::output {
namespace {

// One animal's row among those of a total.
struct Member {
    const AnimalReport* animal;
    const ReportRow* row;
};

template <class Figure>
Spread spread_of(std::vector<Member> members, Figure figure) {
    std::stable_sort(members.begin(), members.end(),
                     [&](const Member& a, const Member& b) { return figure(*a.row) < figure(*b.row); });
    return {figure(*members[(members.size() - 1) / 2].row), figure(*members.back().row),
            members.back().animal->id};
}

ReportTotal total_of(const std::vector<Member>& members) {
    const ReportRow& first = *members.front().row;
    ReportTotal total;
    total.form = first.form;
    total.rows = first.rows;
    total.encoding = first.encoding;
    total.texel_format = first.texel_format;
    total.animal_count = members.size();
    const double share = 1.0 / static_cast<double>(members.size());
    for (const Member& member : members) {
        total.bytes += member.row->bytes;
        total.decode_ns_per_vertex += member.row->decode_ns_per_vertex * share;
        total.fetches += member.row->fetches * share;
        total.alu_operations += member.row->alu_operations * share;
        total.bake_ms += member.row->bake_ms;
    }
    total.max = spread_of(members, [](const ReportRow& row) { return base::widened(row.error.max); });
    total.p999 = spread_of(members, [](const ReportRow& row) { return base::widened(row.error.p999); });
    total.rms = spread_of(members, [](const ReportRow& row) { return base::widened(row.error.rms); });
    total.max_m = spread_of(members, [](const ReportRow& row) { return base::widened(row.error.max_m); });
    total.normal_max_deg =
        spread_of(members, [](const ReportRow& row) { return base::widened(row.error.normal_max_deg); });
    return total;
}

bool is_same_scheme(const Member& a, const Member& b) {
    return a.row->form == b.row->form && a.row->rows == b.row->rows;
}

}  // namespace

const ReportRow* chosen_row(const AnimalReport& animal) {
    const auto found = std::find_if(animal.rows.begin(), animal.rows.end(),
                                    [](const ReportRow& row) { return row.is_chosen; });
    return found == animal.rows.end() ? nullptr : &*found;
}

std::vector<ReportTotal> report_totals(const Report& report) {
    std::vector<std::vector<Member>> groups;
    std::vector<Member> chosen;
    for (const AnimalReport& animal : report.animals)
        for (const ReportRow& row : animal.rows) {
            const Member member{&animal, &row};
            if (row.is_chosen) chosen.push_back(member);
            const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& members) {
                return is_same_scheme(members.front(), member);
            });
            if (group == groups.end())
                groups.push_back({member});
            else
                group->push_back(member);
        }
    const bool is_one_scheme = std::all_of(chosen.begin(), chosen.end(), [&](const Member& member) {
        return is_same_scheme(chosen.front(), member);
    });
    std::vector<ReportTotal> totals;
    for (const auto& members : groups) {
        totals.push_back(total_of(members));
        totals.back().is_chosen =
            is_one_scheme && !chosen.empty() && is_same_scheme(chosen.front(), members.front());
    }
    if (!is_one_scheme) {
        totals.push_back(total_of(chosen));
        ReportTotal& total = totals.back();
        total.form = total.rows = "as chosen";
        total.encoding = total.texel_format = "";
        total.is_chosen = true;
    }
    return totals;
}

}  // namespace posepack::output
