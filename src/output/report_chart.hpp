// SPDX-License-Identifier: MIT
// Log-log charts of error against a cost, as inline SVG. Looks come from the page's style sheet
// (report_page.hpp), so that one chart serves light, dark and paper.
#pragma once

#include <string>
#include <vector>

#include "output/log_axis.hpp"

namespace posepack::output {

struct ChartPoint {
    double cost = 0.0, error = 0.0;  // numbers that are not positive lie on the edge of the chart
    std::string label;               // short, beside the point where it is on the front: "30 Hz"
    std::string title;               // shown on hovering
    unsigned series = 0;             // colour: 0 to 7
    bool is_hollow = false;          // a ring instead of a disc
    bool is_chosen = false;
};

struct Chart {
    std::string name;        // what it shows, for those who cannot see it
    std::string cost_title;  // of the axes
    std::string error_title;
    AxisUnit cost_unit = AxisUnit::count;
    double least_cost_ratio = 1.0;  // of the cost axis, see log_axis()
    bool with_curves = false;       // points of one series and kind are joined by rising cost
    std::vector<ChartPoint> points;
};

// An <svg> element without outside references: axes, points, the Pareto front as a staircase, the chosen
// point ringed and named. All texts are escaped. Points of the front have the class "f".
std::string chart_svg(const Chart& chart);

}  // namespace posepack::output
