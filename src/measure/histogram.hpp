// SPDX-License-Identifier: MIT
// A histogram of non-negative floats with bins of equal relative width: percentiles without sorting.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace posepack::measure {

// The bin of a value is its exponent and the upper six bits of its mantissa: 1.6 % wide.
class Histogram {
 public:
    Histogram() : counts_(kBins) {}

    // Infinity and NaN count as the largest floats.
    void add(float value) { ++counts_[std::min(std::bit_cast<std::uint32_t>(value) >> kShift, kBins - 1)]; }
    void clear();
    // As if every value of `other` had been added `times` times.
    void add(const Histogram& other, std::uint64_t times = 1);

    // The upper edge of the bin that the `share` smallest values end in: at most 1.6 % above the true value.
    // 0 when nothing was added.
    float percentile(double share) const;

    std::uint64_t count() const;

    // The mean of f(x) over all values, each taken at the middle of its bin.
    template <class F>
    double mean(F f) const {
        double sum = 0.0;
        std::uint64_t total = 0;
        for (std::uint32_t bin = 0; bin < kBins; ++bin) {
            if (counts_[bin] == 0) continue;
            sum += static_cast<double>(counts_[bin]) * f(0.5 * (lower_edge(bin) + lower_edge(bin + 1)));
            total += counts_[bin];
        }
        return total == 0 ? 0.0 : sum / static_cast<double>(total);
    }

 private:
    static constexpr std::uint32_t kShift = 17;
    static constexpr std::uint32_t kBins = 0x7F800000u >> kShift;  // every finite float
    static double lower_edge(std::uint32_t bin) {
        return static_cast<double>(std::bit_cast<float>(bin << kShift));
    }

    std::vector<std::uint64_t> counts_;
};

}  // namespace posepack::measure
