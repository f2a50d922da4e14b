// SPDX-License-Identifier: MIT
#include "measure/closer_times.hpp"

#include <algorithm>
#include <cstddef>

namespace posepack::measure {
namespace {

constexpr int kPartCount = 4;
constexpr double kShortestSpanS = 1e-5;

}  // namespace

std::vector<double> closer_times_s(std::span<const Moment> moments, double share, double other_share) {
    float largest = 0.0f;
    for (const Moment& moment : moments) largest = std::max(largest, moment.square);
    std::vector<double> times_s;
    if (largest == 0.0f) return times_s;
    const double enough = share * share * static_cast<double>(largest);
    const double other_enough = other_share * other_share * static_cast<double>(largest);
    for (std::size_t i = 1; i < moments.size(); ++i) {
        const Moment& from = moments[i - 1];
        const Moment& to = moments[i];
        if (static_cast<double>(std::max(from.square, to.square)) < enough ||
            static_cast<double>(std::min(from.square, to.square)) < other_enough)
            continue;
        const double span_s = to.time_s - from.time_s;
        if (span_s < kShortestSpanS) continue;
        for (int part = 1; part < kPartCount; ++part)
            times_s.push_back(from.time_s + span_s * part / kPartCount);
    }
    return times_s;
}

}  // namespace posepack::measure
