// SPDX-License-Identifier: MIT
#include "base/interrupt.hpp"

#include <atomic>

namespace posepack::base {
namespace {

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may set it (C++20, [support.signal])");

}  // namespace

void request_interrupt() noexcept {
    requested.store(true, std::memory_order_relaxed);
}

bool interrupt_requested() noexcept {
    return requested.load(std::memory_order_relaxed);
}

Status check_interrupt() {
    if (!interrupt_requested()) return {};
    return Issue{IssueCode::interrupted, "", "expected to run to the end, found a signal to stop"};
}

void clear_interrupt() noexcept {
    requested.store(false, std::memory_order_relaxed);
}

}  // namespace posepack::base
