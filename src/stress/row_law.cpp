// SPDX-License-Identifier: MIT
#include "stress/row_law.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "format/half.h"

namespace posepack::stress {
namespace {

// Seconds since the clip began, in one float, of a shader that knows both moments only as floats.
float passed_in_floats(double began_s, double time_s) {
    return static_cast<float>(began_s + time_s) - static_cast<float>(began_s);
}

float loop_phase(const posepack_clip& clip, double time_s, const Reader& reader) {
    const double period_s = static_cast<double>(clip.period_s);
    const double now_s = std::floor(reader.running_s / period_s) * period_s + time_s;
    if (reader.has_raw_clock) {
        const float turns = static_cast<float>(now_s) / clip.period_s;
        return turns - std::floor(turns);
    }
    const double turns = now_s / period_s;
    return static_cast<float>(turns - std::floor(turns));
}

float once_phase(const posepack_clip& clip, double time_s, const Reader& reader) {
    const float passed_s =
        reader.has_raw_clock ? passed_in_floats(reader.running_s, time_s) : static_cast<float>(time_s);
    return std::clamp(passed_s / clip.period_s, 0.0f, 1.0f);
}

// Of slots that go through several rows the inner ones too.
void add_slot_times(const posepack_view& view, std::uint32_t index, const posepack_clip& clip,
                    std::vector<double>& times_s) {
    const double slot_s = static_cast<double>(clip.period_s) / clip.slot_count;
    for (std::uint32_t k = 0; k < clip.slot_count; ++k) {
        posepack_slot slot;
        posepack_get_slot(&view, index, k, &slot);
        const std::uint32_t rows = slot.span == 0 ? std::max(slot.offset, 1u) : 1u;
        for (std::uint32_t row = 0; row < rows; ++row)
            times_s.push_back(slot_s * (k + static_cast<double>(row) / rows));
    }
}

float through_half(float value) {
    return posepack_float_from_half(posepack_half_from_float(value));
}

}  // namespace

float phase_at(const posepack_clip& clip, double time_s, const Reader& reader) {
    if (!(clip.period_s > 0.0f)) return 0.0f;
    const float phase =
        clip.wrap == POSEPACK_WRAP_LOOP ? loop_phase(clip, time_s, reader) : once_phase(clip, time_s, reader);
    return reader.has_half_phase ? through_half(phase) : phase;
}

std::vector<double> row_times_s(const posepack_view& view, std::uint32_t index) {
    posepack_clip clip;
    posepack_get_clip(&view, index, &clip);
    std::vector<double> times_s;
    if (clip.slot_count > 0) {
        add_slot_times(view, index, clip, times_s);
        return times_s;
    }
    std::set<std::uint32_t> interval_counts;
    for (std::uint32_t bone = 0; bone < view.header.bone_count; ++bone) {
        posepack_run run;
        posepack_get_run(&view, index, bone, &run);
        interval_counts.insert(run.interval_count);
    }
    for (const std::uint32_t count : interval_counts)
        for (std::uint32_t row = 0; row <= count; ++row)
            times_s.push_back(static_cast<double>(clip.period_s) * row / std::max(count, 1u));
    return times_s;
}

}  // namespace posepack::stress
