// SPDX-License-Identifier: MIT
// A form and row scheme over the whole catalog.
#pragma once

#include "output/report_model.hpp"

namespace posepack::output {

// A figure over all animals: the median (of an even number: the lower of the two in the middle) and the
// worst.
struct Spread {
    double median = 0.0, worst = 0.0;
    std::string worst_animal;
};

struct ReportTotal {
    std::string form, rows;  // both "as chosen" where the animals' chosen rows differ
    std::string encoding, texel_format;
    bool is_chosen = false;
    std::size_t animal_count = 0;  // that have such a row: of the others some form was refused
    std::uint64_t bytes = 0;       // sum
    Spread max, p999, rms;         // fractions of R
    Spread max_m;                  // metres
    Spread normal_max_deg;
    double decode_ns_per_vertex = 0.0, fetches = 0.0, alu_operations = 0.0;  // means over the animals
    double bake_ms = 0.0;                                                    // sum
};

// A total for every pair of form and rows, in the order in which they appear first; the chosen rows are one
// of them, or where they differ from animal to animal one more at the end.
std::vector<ReportTotal> report_totals(const Report& report);

// Totals that can be compared with each other: all over the same animals, those that have every pair that
// more than half of the animals have.
struct ComparableTotals {
    std::vector<ReportTotal> totals;
    std::vector<std::string> left_out;  // ids of the animals that lack such a pair
};
ComparableTotals comparable_totals(const Report& report);

}  // namespace posepack::output
