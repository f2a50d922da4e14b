// SPDX-License-Identifier: MIT
#include "output/choice_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"

namespace posepack::output {
namespace {

using recipe::TryRecord;

// The smallest try that keeps the bound among those that `is_meant`; null where none does.
template <typename Meant>
const TryRecord* smallest(const std::vector<TryRecord>& tried, const Meant& is_meant) {
    const TryRecord* best = nullptr;
    for (const TryRecord& one : tried)
        if (one.keeps_bound && is_meant(one) && (best == nullptr || one.bytes < best->bytes)) best = &one;
    return best;
}

// What became of the others: what they would need, or that they missed the bound.
template <typename Meant>
std::string others(const std::vector<TryRecord>& tried, const std::string& name, const Meant& is_meant) {
    if (std::none_of(tried.begin(), tried.end(), is_meant)) return "";
    const TryRecord* best = smallest(tried, is_meant);
    if (best != nullptr) return fmt::format("; {} need {}", name, base::grouped(best->bytes));
    return fmt::format("; {} miss it", name);
}

}  // namespace

std::string choice_sentence(const recipe::ClipRecord& clip) {
    const std::vector<TryRecord>& tried = clip.tried;
    const TryRecord* taken = smallest(tried, [](const TryRecord&) { return true; });
    if (taken == nullptr) return "as asked for";
    const auto kept =
        std::count_if(tried.begin(), tried.end(), [](const TryRecord& one) { return one.keeps_bound; });
    const std::string rank = kept == 1 ? std::string("the only one that keeps")
                                       : fmt::format("the smallest of {} that keep", kept);
    std::string out = fmt::format("{} of {}, {} bytes: {} the bound, of {} tried", taken->row_scheme,
                                  taken->encoding, base::grouped(taken->bytes), rank, tried.size());
    const std::string scheme = taken->row_scheme == "runs" ? "slots" : "runs";
    out += others(tried, scheme, [&](const TryRecord& one) {
        return one.row_scheme == scheme && one.encoding == taken->encoding;
    });
    const std::string encoding = taken->encoding == "affine" ? "dualquat" : "affine";
    out += others(tried, encoding, [&](const TryRecord& one) { return one.encoding == encoding; });
    return out;
}

}  // namespace posepack::output
