// SPDX-License-Identifier: MIT
// Tracks: the motion of every bone of a clip, finely sampled, as the numbers that a form blends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "animal/animal.hpp"
#include "motion/affine.hpp"
#include "motion/row_plan.hpp"
#include "palette/dualquat_fit.hpp"
#include "palette/spaces.hpp"

namespace posepack::fit {

// The numbers that are blended: of `affine` the twelve of a matrix, row by row; of `dualquat` real part, dual
// part (at right angles to it) and scale.
enum class Form { affine, dualquat };
inline constexpr std::size_t kAffineNumbers = 12;
inline constexpr std::size_t kDualquatNumbers = 9;
inline constexpr std::size_t numbers_of(Form form) {
    return form == Form::affine ? kAffineNumbers : kDualquatNumbers;
}

// A slot as the container has it: its share of the period goes from offset / span to (offset + 1) / span of
// the way from row `row` to the next, or, where the span is 0, through `offset` intervals.
struct Slot {
    std::uint32_t row = 0, offset = 0, span = 0;
    bool operator==(const Slot&) const = default;
};
struct SlotPlan {
    std::vector<Slot> slots;           // none: rows are even
    std::uint32_t interval_count = 0;  // between the rows of every moving bone
    bool is_rough = false;             // the samples were too few to cut an interval of keys as it needs
};

// Samples 0 to interval_count of a clip, evenly over its period, of every bone.
struct Tracks {
    Form form = Form::affine;
    bool loop = false;  // sample `interval_count` is sample 0 again
    bool step = false;  // poses are held
    std::uint32_t bone_count = 0;
    std::uint32_t interval_count = 0;  // K; 0 for a clip without length
    std::uint32_t key_intervals = 0;   // of the row plan: K is a multiple
    std::uint32_t known_count = 0;     // samples from here on are between an open loop's ends, or its end
    std::vector<float> numbers;        // [bone][sample][number]
    std::vector<float> exact;          // [bone][sample][12]: matrices of palette space, row by row
    std::vector<bool> turned;          // the loop ends in the other hemisphere: -q for q
    SlotPlan slots;                    // none: rows are even
    std::vector<double> bent;          // with slots: phase of rows of every sample

    std::size_t sample_count() const { return std::size_t{interval_count} + 1; }
    std::span<const float> numbers_at(std::size_t bone, std::size_t sample) const {
        const std::size_t width = numbers_of(form);
        return std::span(numbers).subspan((bone * sample_count() + sample) * width, width);
    }
    std::span<const float> exact_at(std::size_t bone, std::size_t sample) const {
        return std::span(exact).subspan((bone * sample_count() + sample) * 12, 12);
    }
    // Of time: the share of the period.
    double time_phase(std::size_t sample) const {
        return interval_count == 0 ? 0.0 : static_cast<double>(sample) / interval_count;
    }
    // Of rows: the share of the intervals of a run.
    double phase(std::size_t sample) const { return bent.empty() ? time_phase(sample) : bent[sample]; }
};

// Samples a clip `per_key` times in each interval of its plan (at least 32 times in all).
//   hemispheres  of the animal; clips are sampled in their order
Tracks sample_tracks(const animal::Animal& animal, const animal::Clip& clip, const motion::RowPlan& plan,
                     const palette::Spaces& spaces, Form form, std::uint32_t per_key,
                     palette::Hemispheres& hemispheres);

}  // namespace posepack::fit
