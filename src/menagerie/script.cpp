// SPDX-License-Identifier: MIT
#include "menagerie/script.hpp"

#include <algorithm>

#include "menagerie/math.hpp"

namespace posepack::menagerie {
namespace {

double track_value(const Track& track, double phase) {
    const Stop* before = &track.stops.front();
    for (const Stop& stop : track.stops) {
        if (stop.at > phase) {
            if (stop.at <= before->at) return stop.value;
            const double u = (phase - before->at) / (stop.at - before->at);
            return before->value + (stop.value - before->value) * smooth_step(u);
        }
        before = &stop;
    }
    return before->value;
}

}  // namespace

std::vector<double> channel_values(const ClipScript& script, int channel_count, double phase) {
    std::vector<double> values(static_cast<std::size_t>(channel_count), 0.0);
    for (const Track& track : script.tracks) {
        values[static_cast<std::size_t>(track.channel)] += track_value(track, phase);
    }
    for (const Wave& wave : script.waves) {
        values[static_cast<std::size_t>(wave.channel)] +=
            wave.amplitude * sine_of_turns(wave.cycles * phase + wave.offset);
    }
    return values;
}

int step_count(const ClipScript& script, int rate_hz) {
    return std::max(1, (script.steps_at_30_hz * rate_hz + 15) / 30);
}

int cycle_step_count(const ClipScript& script, int rate_hz) {
    return step_count(script, rate_hz) + (script.ending == Ending::open ? 1 : 0);
}

FootStep foot_step(const Gait& gait, double phase) {
    const double cycle = wrapped(phase);
    if (cycle < gait.duty) return {0.5 - cycle / gait.duty, 0.0, 0.0};
    const double u = (cycle - gait.duty) / (1.0 - gait.duty);
    // The foot leaves and meets the ground at the ground's speed: half of it in the air looks less stiff.
    const double slope = -0.5 * (1.0 - gait.duty) / gait.duty;
    const double rise = 4.0 * u * (1.0 - u);
    return {hermite(-0.5, slope, 0.5, slope, u), rise * rise, u};
}

double travel_per_cycle(const ClipScript& script) {
    return script.gait ? script.gait->stroke / script.gait->duty : script.travel;
}

}  // namespace posepack::menagerie
