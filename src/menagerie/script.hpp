// SPDX-License-Identifier: MIT
// Clips as rows of data. A body plan has numbered channels (how far the neck bows, how high a foot is
// lifted); a script moves them by tracks and waves; the plan turns one set of values into a pose.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace posepack::menagerie {

// amplitude * sin(2 pi (cycles * phase + offset)).
struct Wave {
    int channel = 0;
    double amplitude = 0.0;
    int cycles = 1;
    double offset = 0.0;
};

struct Stop {
    double at = 0.0;  // phase of the clip, 0..1
    double value = 0.0;
};

// From stop to stop with zero slope at each; held before the first and after the last.
struct Track {
    int channel = 0;
    std::vector<Stop> stops;
};

// How a clip ends: on a copy of its first key, one key before it, or somewhere else.
enum class Ending { closed, open, once };

// A foot's cycle: on the ground for `duty` of it, moving backwards at the ground's speed in the body's frame.
struct Gait {
    double duty = 0.6;
    double stroke = 0.5;          // way of a foot on the ground, in units of the plan's leg height
    double lift = 0.1;            // height of the swing, in the same units
    std::vector<double> offsets;  // phase by which each foot is ahead
};

struct ClipScript {
    std::string name;
    int steps_at_30_hz = 30;  // key steps from the first to the last key
    Ending ending = Ending::closed;
    std::vector<Track> tracks;
    std::vector<Wave> waves;
    std::optional<Gait> gait;
    double travel = 0.0;  // without a gait: way over the ground in one cycle, in the plan's unit of length
};

// The values of all channels at a phase; channels that no track or wave names are zero.
std::vector<double> channel_values(const ClipScript& script, int channel_count, double phase);

// Key steps at another rate: scaled and rounded, at least one.
int step_count(const ClipScript& script, int rate_hz);

// Steps in one cycle: one more than there are where the loop is open.
int cycle_step_count(const ClipScript& script, int rate_hz);

// Where a foot is: `forward` from +0.5 to -0.5 of the stroke on the ground, back again in the air; `height` 0
// on the ground, 1 at the top of the swing; `swing` the part of the swing that is done, 0 on the ground.
struct FootStep {
    double forward = 0.0;
    double height = 0.0;
    double swing = 0.0;
};

FootStep foot_step(const Gait& gait, double phase);

// Way over the ground in one cycle, in the plan's unit of length: what a foot goes while it stands, and as
// much again for the time that it does not; or the script's own travel.
double travel_per_cycle(const ClipScript& script);

}  // namespace posepack::menagerie
