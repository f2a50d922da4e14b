// SPDX-License-Identifier: MIT
#include "motion/key_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace posepack::motion {
namespace {

constexpr double kShareOnGrid = 0.98;
constexpr double kToleranceSteps = 1e-3;
constexpr double kLongestStepS = 1001.0 / 24000.0 * (1.0 + 1e-9);  // 23.976 Hz, and room for rounding
constexpr double kShortestStepS = 1.0 / 240.0 * (1.0 - 1e-9);
// Rates that tools use; they beat what the keys suggest: 24.0000003 Hz measured is 24 Hz meant.
constexpr std::array kUsualRatesHz{24.0,  25.0,  30.0,  48.0,           50.0,           60.0,          90.0,
                                   100.0, 120.0, 240.0, 24000.0 / 1001, 30000.0 / 1001, 60000.0 / 1001};

bool fits(std::span<const double> times_s, double step_s) {
    std::size_t on_grid = 0;
    for (const double t : times_s) {
        const double steps = t / step_s;
        // Times come as float32: half a unit in the last place of t must not count against the grid.
        const double slack = kToleranceSteps + t * 6e-8 / step_s;
        if (std::abs(steps - std::round(steps)) <= slack) ++on_grid;
    }
    return static_cast<double>(on_grid) >= kShareOnGrid * static_cast<double>(times_s.size());
}

// The most usual distance of neighbouring keys, fitted to the whole span.
std::optional<double> suggested_step_s(std::span<const double> times_s) {
    std::vector<double> gaps;
    gaps.reserve(times_s.size());
    for (std::size_t i = 1; i < times_s.size(); ++i) gaps.push_back(times_s[i] - times_s[i - 1]);
    if (gaps.empty()) return std::nullopt;
    std::nth_element(gaps.begin(), gaps.begin() + static_cast<long>(gaps.size() / 2), gaps.end());
    const double median_s = gaps[gaps.size() / 2];
    const double span_s = times_s.back() - times_s.front();
    return span_s / std::max(1.0, std::round(span_s / median_s));
}

}  // namespace

std::optional<double> key_step_s(std::span<const double> times_s) {
    if (times_s.size() < 2) return std::nullopt;
    std::vector<double> steps;
    steps.reserve(kUsualRatesHz.size() + 1);
    for (const double rate_hz : kUsualRatesHz) steps.push_back(1.0 / rate_hz);
    if (const auto suggested_s = suggested_step_s(times_s)) {
        const double step_s = *suggested_s / std::ceil(*suggested_s / kLongestStepS);
        const bool is_usual = std::any_of(steps.begin(), steps.end(), [&](double usual_s) {
            return std::abs(step_s - usual_s) <= kToleranceSteps * usual_s && fits(times_s, usual_s);
        });
        if (!is_usual) steps.push_back(step_s);
    }
    std::stable_sort(steps.begin(), steps.end(), std::greater<>());
    for (const double step_s : steps)
        if (step_s <= kLongestStepS && step_s >= kShortestStepS && fits(times_s, step_s)) return step_s;
    return std::nullopt;
}

}  // namespace posepack::motion
