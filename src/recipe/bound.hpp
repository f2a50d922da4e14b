// SPDX-License-Identifier: MIT
// Bound: how far the drawn pose may be from the source, as people write it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace posepack::recipe {

// One largest error: a fraction of R, or metres.
struct ErrorLimit {
    double value = 0.0;
    bool in_metres = false;

    // As a fraction of an animal's radius in metres, above zero.
    double fraction(double radius_m) const { return in_metres ? value / radius_m : value; }
    bool operator==(const ErrorLimit&) const = default;
};

// Limits of each clip; what is not given does not bind.
struct ErrorBound {
    ErrorLimit max;                  // no vertex at no time is off by more
    std::optional<ErrorLimit> p999;  // 99.9 % of all are not
    std::optional<ErrorLimit> rms;
    bool operator==(const ErrorBound&) const = default;
};

// A limit from its text:
//   "0.02"              a fraction of R, above 0 and at most 1
//   "5mm"               millimetres, above 0
//   "1px@20m,1080,60"   pixels, on a screen 1,080 pixels high with a vertical field of view of 60 degrees, of
//   an
//                       animal 20 m away
// Errors: nothing where the text is none of these.
std::optional<ErrorLimit> parse_error_limit(std::string_view text);

// A bound from the text of its largest error: a preset (hero 5e-3 and p99.9 1e-3; default 2e-2 and 5e-3; far
// 5e-2 and 2e-2), or a limit, whose quarter is then p99.9.
std::optional<ErrorBound> parse_error_bound(std::string_view text);

// As canonical JSON: {"max": {"unit": "R", "value": 0.02}, "p999": ..., "rms": null}.
std::string bound_json(const ErrorBound& bound);

inline constexpr std::string_view kErrorLimitForms =
    "hero, default, far, a fraction of the radius (0.02), millimetres (5mm) or pixels (1px@20m,1080,60)";

}  // namespace posepack::recipe
