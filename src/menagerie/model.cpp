// SPDX-License-Identifier: MIT
#include "menagerie/model.hpp"

#include <utility>

namespace posepack::menagerie {

std::vector<Clip> perform(const std::vector<ClipScript>& scripts, int rate_hz, double unit_m,
                          const Poser& pose) {
    std::vector<Clip> clips;
    for (const ClipScript& script : scripts) {
        const int cycle = cycle_step_count(script, rate_hz);
        Clip clip{script.name, rate_hz, script.ending, 0.0, {}};
        for (int key = 0; key <= step_count(script, rate_hz); ++key) {
            const bool closing = script.ending == Ending::closed && key == cycle;
            clip.keys.push_back(pose(script, closing ? 0.0 : static_cast<double>(key) / cycle));
        }
        clip.ground_speed_mps = travel_per_cycle(script) * unit_m * rate_hz / cycle;
        clips.push_back(std::move(clip));
    }
    return clips;
}

}  // namespace posepack::menagerie
