// SPDX-License-Identifier: MIT
// How a program reads a palette while it runs, where readers differ.
#pragma once

namespace posepack::stress {

struct Reader {
    // Seconds that the program has been running when the clip is looked at.
    double running_s = 0.0;
    // The phase of a clip comes from all those seconds in one float. A careful reader keeps time in double
    // precision and hands the shader the phase.
    bool has_raw_clock = false;
    // The phase travels in a half, as in a half-float vertex attribute.
    bool has_half_phase = false;
};

}  // namespace posepack::stress
