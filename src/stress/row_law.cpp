// SPDX-License-Identifier: MIT
#include "stress/row_law.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

ReaderClip read_clip(const posepack_view& view, std::uint32_t index) {
    ReaderClip clip;
    posepack_get_clip(&view, index, &clip.facts);
    clip.cuts.resize(clip.facts.cut_count);
    for (std::uint32_t i = 0; i < clip.facts.cut_count; ++i) posepack_get_cut(&view, index, i, &clip.cuts[i]);
    return clip;
}

RowPair rows_at(const ReaderClip& clip, double time_s, const Reader& reader) {
    const posepack_clip& facts = clip.facts;
    if (facts.row_count == 1) return {facts.first_row, facts.first_row, 0.0f};
    const bool is_loop = facts.wrap == POSEPACK_WRAP_LOOP;
    const float phase = is_loop ? loop_phase(facts, time_s, reader) : once_phase(facts, time_s, reader);
    const float position = phase * static_cast<float>(is_loop ? facts.row_count : facts.row_count - 1);
    const std::uint32_t row = std::min(static_cast<std::uint32_t>(position), facts.row_count - 1);
    const bool is_held = facts.interpolation == POSEPACK_INTERPOLATION_STEP ||
                         std::binary_search(clip.cuts.begin(), clip.cuts.end(), row);
    if (is_held) return {facts.first_row + row, facts.first_row + row, 0.0f};
    std::uint32_t next = row + 1;
    if (next == facts.row_count) next = !is_loop ? row : facts.closing_row != 0 ? facts.row_count : 0;
    return {facts.first_row + row, facts.first_row + next, position - static_cast<float>(row)};
}

double row_time_s(const ReaderClip& clip, std::uint32_t row) {
    if (clip.facts.row_count == 1) return 0.0;
    const double intervals =
        clip.facts.wrap == POSEPACK_WRAP_LOOP ? clip.facts.row_count : clip.facts.row_count - 1;
    return static_cast<double>(clip.facts.period_s) * row / intervals;
}

}  // namespace posepack::stress
