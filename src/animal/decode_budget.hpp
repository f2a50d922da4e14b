// SPDX-License-Identifier: MIT
// DecodeBudget: how many bytes a file may make of itself. Asked before anything is allocated.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/result.hpp"

namespace posepack::animal {

// Grows with the file: 16 bytes a byte of it and 16 MiB more, at most 2 GiB. Compression of animals stays
// under 16 : 1, and accessors without data (zeros by rule) need the rest.
class DecodeBudget {
 public:
    explicit DecodeBudget(std::uint64_t file_bytes)
        : limit_bytes_(std::min<std::uint64_t>(2ull << 30, 16 * file_bytes + (16u << 20))) {}

    // Takes `count` elements of `element_bytes` each. Errors: E-LIM-DECODED, with an empty `where`.
    base::Status take(std::uint64_t count, std::uint64_t element_bytes);

 private:
    std::uint64_t limit_bytes_;
    std::uint64_t used_bytes_ = 0;
};

}  // namespace posepack::animal
