// SPDX-License-Identifier: MIT
// One flag that a signal sets and long work looks at between its steps, so that it unwinds and cleans up.
#pragma once

#include "base/result.hpp"

namespace posepack::base {

// Asks all work of the process to stop soon. Async-signal-safe; may be called from any thread.
void request_interrupt() noexcept;

// Whether that was asked for.
bool interrupt_requested() noexcept;

// OK, or E-INTERRUPTED once an interrupt was asked for.
Status check_interrupt();

// Forgets it. For tests: a program that was interrupted ends.
void clear_interrupt() noexcept;

}  // namespace posepack::base
