// SPDX-License-Identifier: MIT
// The charts of a section of the HTML report, every kind of error against every kind of cost. The page shows
// one against bytes and one against run time: which, is picked with the bar on top.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "output/report_model.hpp"
#include "output/report_totals.hpp"

namespace posepack::output {

// A kind of error or of run time that can be picked: the id of its button, which is also the style class of
// its charts, and the word on it.
struct Pick {
    const char* id;
    const char* name;
};
std::span<const Pick> error_picks();
std::span<const Pick> run_time_picks();

// Colours of encodings, by the order in which a report has them.
class Series {
 public:
    explicit Series(const Report& report);

    unsigned of(const std::string& encoding) const;  // 0 to 7
    const std::vector<std::string>& names() const { return names_; }

 private:
    std::vector<std::string> names_;
};

// What colours and marks mean, as a list.
std::string legend_html(const Series& series);

// The charts of one animal, a point a row; or of totals, a point a total, with the error of the worst animal.
std::string figures_html(const AnimalReport& animal, const Series& series);
std::string figures_html(const std::vector<ReportTotal>& totals, const Series& series);

}  // namespace posepack::output
