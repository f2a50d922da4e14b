// SPDX-License-Identifier: MIT
#include "measure/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace posepack::measure {

void Histogram::clear() {
    std::fill(counts_.begin(), counts_.end(), 0);
}

void Histogram::add(const Histogram& other, std::uint64_t times) {
    for (std::uint32_t bin = 0; bin < kBins; ++bin) counts_[bin] += times * other.counts_[bin];
}

std::uint64_t Histogram::count() const {
    return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

float Histogram::percentile(double share) const {
    const std::uint64_t total = count();
    if (total == 0) return 0.0f;
    const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(total)));
    std::uint64_t below = 0;
    for (std::uint32_t bin = 0; bin < kBins; ++bin) {
        below += counts_[bin];
        if (below < rank) continue;
        if (bin == 0) return 0.0f;  // zeros and subnormals
        return std::bit_cast<float>((bin + 1) << kShift);
    }
    return 0.0f;
}

}  // namespace posepack::measure
