// SPDX-License-Identifier: MIT
// A report as text for people, CSV for spreadsheets, JSON for programs and one HTML page for everybody. Equal
// reports give equal texts.
#pragma once

#include <string>

#include "output/report_model.hpp"

namespace posepack::output {

// A line a form and row scheme of each animal, then the totals; ends with a newline. Names are escaped and
// cut.
std::string report_text(const Report& report);

// RFC 4180 with a line of titles; every row of every animal, numbers in full. Chosen rows have "yes" in the
// column "chosen".
std::string report_csv(const Report& report);

// One JSON object of schemas/report-1.schema.json, canonical: keys sorted, every key there.
//   indent  spaces a level; below 0: one line
std::string report_json(const Report& report, int indent);

// One HTML page that needs no other file and no network: charts, tables, heat maps. Without scripts it lacks
// sorting and the choice of an animal, and nothing else. docs/report.md says how to read it.
std::string report_html(const Report& report);

}  // namespace posepack::output
