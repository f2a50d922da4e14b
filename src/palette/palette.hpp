// SPDX-License-Identifier: MIT
// Palette: the baked rows of an animal and everything a container says about them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "animal/animal.hpp"
#include "motion/row_plan.hpp"
#include "palette/bounds.hpp"
#include "palette/layout.hpp"
#include "palette/runs.hpp"
#include "palette/spaces.hpp"
#include "recipe/catalog.hpp"

namespace posepack::palette {

struct PaletteClip {
    std::uint32_t source = 0;  // index into Animal::clips
    motion::RowPlan plan;
    std::uint32_t first_row = 0;
    bool closing_row = false;  // row 0 once more behind the last row, not counted in plan.row_count
    double speed_mps = 0.0;
    double stride_phase = 0.0;
    Box bounds;
    ClipRuns runs;  // empty under uniform rows

    // The stored rows, counted from the clip's first, that show clip time `time_s`: the plan's, but that a
    // closing row stands for row 0 at the end.
    motion::RowBlend rows_at(double time_s) const {
        motion::RowBlend blend = plan.rows_at(time_s);
        const bool wraps = blend.row0 + 1 == plan.row_count && blend.row1 == 0 && plan.row_count > 1;
        if (closing_row && wraps) blend.row1 = plan.row_count;
        return blend;
    }
    // Rows a second of the longest run, with slots on average; 0 where all bones are still.
    double runs_rate_hz() const { return runs.longest > 0 ? runs.longest / plan.period_s : 0.0; }
    std::uint32_t stored_rows() const {
        return runs.is_empty() ? plan.row_count + (closing_row ? 1 : 0) : runs.longest + 1;
    }
};

struct PaletteState {
    std::string name;
    std::uint32_t clip = 0;  // index into Palette::clips
};

struct Palette {
    Layout layout;
    std::vector<PaletteClip> clips;
    std::vector<PaletteState> states;             // sorted by name
    std::uint32_t default_state = animal::kNone;  // index into states
    recipe::ForwardAxis forward = recipe::ForwardAxis::plus_z;
    double metres_per_unit = 1.0;
    double radius = 0.0;  // R in model units
    Spaces spaces;
    float dualquat_length = 0.0f;  // L in units of palette space; zero under other encodings
    std::vector<std::uint8_t> pixels;

    bool has_runs() const { return layout.run_texels > 0; }
    bool has_slots() const {
        return std::any_of(clips.begin(), clips.end(),
                           [](const PaletteClip& clip) { return !clip.runs.slots.empty(); });
    }
    // R in units of palette space.
    double reach() const { return spaces.normalised ? 1.0 : radius; }
};

// Measured error of one clip, as the container stores it. Lengths as fractions of R, angles in degrees.
struct ClipError {
    float max = 0, p999 = 0, rms = 0, time_s = 0;
    std::uint32_t mesh = animal::kNone, vertex = animal::kNone, bone = animal::kNone;
    float normal_max_deg = 0, normal_p999_deg = 0, normal_rms_deg = 0, normal_time_s = 0;
    std::uint32_t normal_mesh = animal::kNone, normal_vertex = animal::kNone, normal_bone = animal::kNone;
};

}  // namespace posepack::palette
