// SPDX-License-Identifier: MIT
#include "animal/decode_budget.hpp"

#include <fmt/format.h>

namespace posepack::animal {
namespace {

constexpr std::uint64_t kMaxElements = 16u << 20;

}  // namespace

base::Status DecodeBudget::take(std::uint64_t count, std::uint64_t element_bytes) {
    const auto refuse = [&] {
        return base::Issue{base::IssueCode::lim_decoded, "",
                           fmt::format("{} elements of {} bytes go over {} bytes, what a file of this size may "
                                       "ask for ({} are taken), or over {} elements",
                                       count, element_bytes, limit_bytes_, used_bytes_, kMaxElements)};
    };
    if (count > kMaxElements) return refuse();
    if (element_bytes > 0 && count > (limit_bytes_ - used_bytes_) / element_bytes) return refuse();
    used_bytes_ += count * element_bytes;
    return {};
}

}  // namespace posepack::animal
