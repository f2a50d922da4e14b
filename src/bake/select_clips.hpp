// SPDX-License-Identifier: MIT
// Which clips of an animal are baked, and which states play them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "animal/animal.hpp"
#include "base/result.hpp"
#include "motion/row_plan.hpp"
#include "palette/palette.hpp"
#include "recipe/catalog.hpp"

namespace posepack::bake {

struct ClipChoice {
    std::uint32_t source = 0;  // index into Animal::clips
    motion::RowWish wish;
    double speed_mps = 0.0;
    double stride_phase = 0.0;
    std::vector<std::string> states;
    std::optional<recipe::ErrorBound> bound;  // of this clip alone
};

// The clips that `entry` wishes for, in the order of its wishes; every clip in file order when it has none.
// Names are compared without case, with the clip's unique name, its name after the last '|', or its
// whole source name; a wish with * or ? may take several clips. A clip is taken once, by its first wish.
// Errors: E-CAT-CLIP-MISSING.
base::Result<std::vector<ClipChoice>> select_clips(const animal::Animal& animal,
                                                   const recipe::AnimalEntry& entry);

struct StateChoice {
    std::vector<palette::PaletteState> states;    // sorted by name; clips index `choices`
    std::uint32_t default_state = animal::kNone;  // index into states
};

// States from the wishes first, then from the keyword map: the first clip whose name holds the state's first
// matching keyword. Errors: E-CAT-STATE-MISSING.
base::Result<StateChoice> choose_states(const animal::Animal& animal, const recipe::AnimalEntry& entry,
                                        const std::vector<ClipChoice>& choices);

}  // namespace posepack::bake
