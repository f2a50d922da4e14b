// SPDX-License-Identifier: MIT
#include "output/log_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace posepack::output {
namespace {

constexpr double kAir = 0.06;                   // of the axis, beyond its outermost values
constexpr std::size_t kFewCounts = 6;           // different counts that are ticks themselves
constexpr double kDecadesForDecadeTicks = 2.6;  // beyond: 1, 10, 100; below: 1, 2, 5, 10

// 1, 2 or 5 times a power of ten: the least that is not below `least`.
double nice_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
    return 10.0 * power;
}

// Multiples of a step: for ranges within a decade, where 1, 2, 5 would be too few.
void add_even_ticks(LogAxis& axis) {
    const double step = nice_step((axis.high - axis.low) / 8.0);
    for (double i = std::ceil(axis.low / step); i * step <= axis.high; ++i) axis.ticks.push_back(i * step);
}

void add_decade_ticks(LogAxis& axis, bool with_two_and_five) {
    const int first = static_cast<int>(std::floor(std::log10(axis.low)));
    const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
    for (int exponent = first; exponent <= last; ++exponent)
        for (int digit = 1; digit <= 9; ++digit) {
            // By decimal text, so that a tick is the number that is written beside it.
            const double value = std::stod(fmt::format("{}e{}", digit, exponent));
            if (value < axis.low || value > axis.high) continue;
            const bool is_written = digit == 1 || (with_two_and_five && (digit == 2 || digit == 5));
            (is_written ? axis.ticks : axis.minor_ticks).push_back(value);
        }
}

void add_ticks(LogAxis& axis, std::vector<double> positive) {
    std::sort(positive.begin(), positive.end());
    positive.erase(std::unique(positive.begin(), positive.end()), positive.end());
    const double decades = std::log10(axis.high / axis.low);
    if (axis.unit == AxisUnit::count && positive.size() <= kFewCounts)
        axis.ticks = positive;
    else if (decades < 1.0)
        add_even_ticks(axis);
    else
        add_decade_ticks(axis, decades < kDecadesForDecadeTicks);
}

// A tick below 1e-3: "2e-4", "1.5e-4".
std::string power_text(double value) {
    const std::string text = short_error(value);
    std::string digits = text.substr(0, text.find('e'));
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits + text.substr(text.find('e'));
}

}  // namespace

double LogAxis::place(double value) const {
    if (!(value > low)) return 0.0;
    return std::min(1.0, std::log(value / low) / std::log(high / low));
}

LogAxis log_axis(AxisUnit unit, std::span<const double> values, double least_ratio) {
    std::vector<double> positive;
    std::copy_if(values.begin(), values.end(), std::back_inserter(positive),
                 [](double value) { return value > 0.0 && std::isfinite(value); });
    LogAxis axis;
    axis.unit = unit;
    if (!positive.empty()) {
        const auto [least, largest] = std::minmax_element(positive.begin(), positive.end());
        const double spare = std::max(1.0, least_ratio / (*largest / *least));
        const double low = *least / std::sqrt(spare), high = *largest * std::sqrt(spare);
        const double air = std::pow(high / low, kAir);
        axis.low = low / air;
        axis.high = high * air;
    }
    add_ticks(axis, std::move(positive));
    return axis;
}

std::string tick_text(AxisUnit unit, double value) {
    switch (unit) {
        case AxisUnit::bytes:
            return decimal_bytes(value);
        case AxisUnit::fraction:
            return value >= 0.999e-3 ? fmt::format("{:.4g}", value) : power_text(value);
        case AxisUnit::nanoseconds:
        case AxisUnit::count:
            break;
    }
    return fmt::format("{:.4g}", value);
}

std::string decimal_bytes(double bytes) {
    if (bytes >= 999.95e6) return fmt::format("{:.4g} GB", bytes / 1e9);
    if (bytes >= 999.95e3) return fmt::format("{:.4g} MB", bytes / 1e6);
    if (bytes >= 999.95) return fmt::format("{:.4g} kB", bytes / 1e3);
    return fmt::format("{:.4g} B", bytes);
}

std::string length_text(double metres) {
    const double size = std::abs(metres);
    if (size >= 0.9995)
        return size >= 999.5 ? fmt::format("{:.0f} m", metres) : fmt::format("{:.3g} m", metres);
    if (size >= 0.9995e-3 || size == 0.0) return fmt::format("{:.3g} mm", metres * 1e3);
    return fmt::format("{:.3g} \u00b5m", metres * 1e6);
}

std::string short_error(double value) {
    if (value == 0.0) return "0";
    const std::string text = fmt::format("{:.2e}", value);  // "5.42e-02"
    const std::size_t e = text.find('e');
    return fmt::format("{}e{}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

}  // namespace posepack::output
