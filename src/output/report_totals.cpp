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

using Members = std::vector<Member>;

template <class Figure>
Spread spread_of(Members members, Figure figure) {
    std::stable_sort(members.begin(), members.end(),
                     [&](const Member& a, const Member& b) { return figure(*a.row) < figure(*b.row); });
    return {figure(*members[(members.size() - 1) / 2].row), figure(*members.back().row),
            members.back().animal->id};
}

ReportTotal total_of(const Members& members) {
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

std::vector<const AnimalReport*> all_animals(const Report& report) {
    std::vector<const AnimalReport*> animals;
    for (const AnimalReport& animal : report.animals) animals.push_back(&animal);
    return animals;
}

// The rows of the animals by form and row scheme, in the order of their first appearance.
std::vector<Members> groups_of(const std::vector<const AnimalReport*>& animals) {
    std::vector<Members> groups;
    for (const AnimalReport* animal : animals)
        for (const ReportRow& row : animal->rows) {
            const Member member{animal, &row};
            const auto group = std::find_if(groups.begin(), groups.end(), [&](const Members& members) {
                return is_same_scheme(members.front(), member);
            });
            if (group == groups.end())
                groups.push_back({member});
            else
                group->push_back(member);
        }
    return groups;
}

std::vector<ReportTotal> totals_over(const std::vector<const AnimalReport*>& animals) {
    Members chosen;
    for (const AnimalReport* animal : animals)
        if (const ReportRow* row = chosen_row(*animal)) chosen.push_back({animal, row});
    const bool is_one_scheme = std::all_of(chosen.begin(), chosen.end(), [&](const Member& member) {
        return is_same_scheme(chosen.front(), member);
    });
    std::vector<ReportTotal> totals;
    for (const Members& members : groups_of(animals)) {
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

}  // namespace

const ReportRow* chosen_row(const AnimalReport& animal) {
    const auto found = std::find_if(animal.rows.begin(), animal.rows.end(),
                                    [](const ReportRow& row) { return row.is_chosen; });
    return found == animal.rows.end() ? nullptr : &*found;
}

std::vector<ReportTotal> report_totals(const Report& report) {
    return totals_over(all_animals(report));
}

ComparableTotals comparable_totals(const Report& report) {
    std::vector<const AnimalReport*> animals = all_animals(report);
    std::vector<Members> common = groups_of(animals);
    std::erase_if(common, [&](const Members& members) { return 2 * members.size() <= animals.size(); });
    ComparableTotals out;
    std::erase_if(animals, [&](const AnimalReport* animal) {
        const bool lacks_one = std::any_of(common.begin(), common.end(), [&](const Members& members) {
            return std::none_of(members.begin(), members.end(),
                                [&](const Member& member) { return member.animal == animal; });
        });
        if (lacks_one) out.left_out.push_back(animal->id);
        return lacks_one;
    });
    out.totals = totals_over(animals);
    std::erase_if(out.totals, [&](const ReportTotal& total) { return total.animal_count != animals.size(); });
    return out;
}

}  // namespace posepack::output
