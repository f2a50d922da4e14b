// SPDX-License-Identifier: MIT
// The looks and the behaviour of the HTML report: one style sheet and one script, both inside the page.
#pragma once

#include <string>
#include <string_view>

namespace posepack::output {

// Light and dark by the reader's system, light on paper. Classes: of the page, of charts (report_chart.hpp)
// and of heat maps (report_heat.hpp).
std::string_view report_style();

// Sorts tables by their columns, shows one animal alone, and opens what is folded before printing. It reads
// no data of its own and sends nothing.
std::string_view report_script();

// A policy for the page: no resource from anywhere, no script but `script`. "sha256-..." in base64.
std::string content_policy(std::string_view script);

}  // namespace posepack::output
