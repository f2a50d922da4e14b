// SPDX-License-Identifier: MIT
// What the program does with signals.
#pragma once

namespace posepack::cli {

// SIGINT and SIGTERM ask the work to stop (base/interrupt.hpp): it unwinds, removes its temporary files and
// ends with exit code 130; a second one ends the program at once. SIGPIPE and SIGXFSZ are ignored, so that a
// write into a closed pipe or over the limit of file sizes fails, and is told, like any other.
void install_signal_handlers();

}  // namespace posepack::cli
