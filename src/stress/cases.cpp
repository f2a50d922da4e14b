// SPDX-License-Identifier: MIT
#include <array>

#include "stress/stress_case.hpp"

namespace posepack::stress {

std::span<const CaseGroup> case_groups() {
    static const std::array kGroups{place_cases(), speed_cases(), shape_cases(), key_cases(),
                                    skin_cases(),  fault_cases(), reader_cases()};
    return kGroups;
}

recipe::AnimalEntry entry_of(const StressCase& stress_case) {
    recipe::AnimalEntry entry;
    entry.id = stress_case.name;
    entry.model = entry.id + ".glb";
    entry.canonical_json = "{}";
    entry.output.caps = recipe::Caps::desktop;
    recipe::ClipWish every;
    every.name = "*";
    every.rate_hz = stress_case.start.rate_hz;
    every.wrap = stress_case.start.wrap;
    every.seam = stress_case.start.seam;
    entry.clips = {every};
    return entry;
}

recipe::AnimalEntry under_bound(recipe::AnimalEntry entry, const Bound& bound) {
    entry.output.bound =
        recipe::ErrorBound{recipe::ErrorLimit{bound.max}, recipe::ErrorLimit{bound.p999}, {}};
    for (recipe::ClipWish& wish : entry.clips) wish.rate_hz.reset();
    return entry;
}

}  // namespace posepack::stress
