// SPDX-License-Identifier: MIT
// The tables of the HTML report.
#pragma once

#include <string>

#include "output/report_model.hpp"
#include "output/report_totals.hpp"

namespace posepack::output {

// Every form and row scheme of one animal; the chosen row is marked.
std::string forms_table(const AnimalReport& animal);

// Every form and row scheme over the catalog.
std::string totals_table(const std::vector<ReportTotal>& totals);

// A line an animal, at its chosen row, with links to the animals' sections ("#a0", "#a1"...).
std::string overview_table(const Report& report);

// A line a clip of the chosen row.
std::string clips_table(const AnimalReport& animal);

}  // namespace posepack::output
