// SPDX-License-Identifier: MIT
#include "recipe/bound.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/trig.hpp"

namespace posepack::recipe {
namespace {

// A number above zero at the front of `text`, which loses it.
std::optional<double> take_number(std::string_view& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !(value > 0.0) || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

// "@20m,1080,60": metres in a pixel.
std::optional<double> take_metres_per_pixel(std::string_view& text) {
    if (!take(text, "@")) return std::nullopt;
    const auto distance_m = take_number(text);
    if (!distance_m || !take(text, "m,")) return std::nullopt;
    const auto height_px = take_number(text);
    if (!height_px || !take(text, ",")) return std::nullopt;
    const auto field_deg = take_number(text);
    if (!field_deg || *field_deg >= 180.0) return std::nullopt;
    const double half = *field_deg * base::kPi / 360.0;
    return 2.0 * *distance_m * base::sine(half) / base::cosine(half) / *height_px;
}

}  // namespace

std::optional<ErrorLimit> parse_error_limit(std::string_view text) {
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    ErrorLimit limit{*number, false};
    if (take(text, "mm")) {
        limit = {*number * 1e-3, true};
    } else if (take(text, "px")) {
        const auto metres = take_metres_per_pixel(text);
        if (!metres) return std::nullopt;
        limit = {*number * *metres, true};
    } else if (*number > 1.0) {
        return std::nullopt;
    }
    return text.empty() ? std::optional(limit) : std::nullopt;
}

std::optional<ErrorBound> parse_error_bound(std::string_view text) {
    if (text == "hero") return ErrorBound{{5e-3}, ErrorLimit{1e-3}, {}};
    if (text == "default") return ErrorBound{{2e-2}, ErrorLimit{5e-3}, {}};
    if (text == "far") return ErrorBound{{5e-2}, ErrorLimit{2e-2}, {}};
    const auto limit = parse_error_limit(text);
    if (!limit) return std::nullopt;
    return ErrorBound{*limit, ErrorLimit{0.25 * limit->value, limit->in_metres}, {}};
}

std::string bound_json(const ErrorBound& bound) {
    const auto limit = [](const std::optional<ErrorLimit>& one) -> nlohmann::json {
        if (!one) return nullptr;
        return {{"unit", one->in_metres ? "m" : "R"}, {"value", one->value}};
    };
    return nlohmann::json{{"max", limit(bound.max)}, {"p999", limit(bound.p999)}, {"rms", limit(bound.rms)}}
        .dump();
}

}  // namespace posepack::recipe
