// SPDX-License-Identifier: MIT
#include "cli/signals.hpp"

#include <csignal>

#include "base/interrupt.hpp"

namespace posepack::cli {
namespace {

extern "C" void stop_soon(int) {
    base::request_interrupt();
}

}  // namespace

void install_signal_handlers() {
    struct sigaction stop {};
    stop.sa_handler = stop_soon;
    stop.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigemptyset(&stop.sa_mask);
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    sigemptyset(&ignore.sa_mask);
    for (const int signal : {SIGINT, SIGTERM}) {
        // Who starts a program in the background may have told it to ignore them.
        struct sigaction inherited {};
        if (::sigaction(signal, nullptr, &inherited) == 0 && inherited.sa_handler != SIG_IGN)
            ::sigaction(signal, &stop, nullptr);
    }
    for (const int signal : {SIGPIPE, SIGXFSZ}) ::sigaction(signal, &ignore, nullptr);
}

}  // namespace posepack::cli
