// SPDX-License-Identifier: MIT
#include "measure/test_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>

#include "posepack/format.h"

namespace posepack::measure {
namespace {

using motion::Affine;

constexpr double kEqualTimesS = 1e-6;
// Beside a jump: the sampler takes a step up to 1e-6 s early, for the row that was meant for it.
constexpr double kBesideJumpS = 1.5e-6;

// Times of the rows of a clip with slots.
void add_slot_times(const palette::PaletteClip& clip, std::vector<double>& times_s) {
    const double slot_s = clip.plan.period_s / static_cast<double>(clip.runs.slots.size());
    for (std::size_t i = 0; i < clip.runs.slots.size(); ++i) {
        const std::uint32_t word = clip.runs.slots[i];
        const std::uint32_t offset = word >> 16 & 0xFF;
        const bool is_whole = word >> 24 == 0;
        if (!is_whole && offset > 0) continue;  // between two rows
        const std::uint32_t rows = is_whole ? std::max(offset, 1u) : 1;
        for (std::uint32_t row = 0; row < rows; ++row)
            times_s.push_back(slot_s * (static_cast<double>(i) + static_cast<double>(row) / rows));
    }
}

// Rows and keys up to the last key.
std::vector<double> marks_of(const palette::PaletteClip& clip, std::span<const double> key_times_s) {
    const motion::RowPlan& plan = clip.plan;
    std::vector<double> marks(key_times_s.begin(), key_times_s.end());
    std::set<std::uint32_t> interval_counts;
    for (const std::uint32_t run : clip.runs.entries) interval_counts.insert(run >> POSEPACK_RUN_OFFSET_BITS);
    std::vector<double> rows;
    if (!clip.runs.slots.empty())
        add_slot_times(clip, rows);
    else
        for (const std::uint32_t count : interval_counts)
            for (std::uint32_t row = 0; row < count; ++row) rows.push_back(plan.period_s * row / count);
    for (std::uint32_t row = 0; row < plan.row_count && clip.runs.is_empty(); ++row)
        rows.push_back(plan.row_time_s(row));
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(marks),
                 [&](double time_s) { return time_s <= plan.duration_s; });
    marks.push_back(plan.duration_s);
    std::sort(marks.begin(), marks.end());
    // A key that float32 moved by a hair is the row that was meant for it.
    marks.erase(
        std::unique(marks.begin(), marks.end(), [](double a, double b) { return b - a < kEqualTimesS; }),
        marks.end());
    return marks;
}

double square_sum(const glm::dmat3& m) {
    return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
}

}  // namespace

std::vector<double> test_times_s(const palette::PaletteClip& clip, std::span<const double> key_times_s,
                                 std::span<const double> jump_times_s, Parts parts) {
    const std::vector<double> marks = marks_of(clip, key_times_s);
    const int count = static_cast<int>(parts);
    std::vector<double> times_s{marks.front()};
    for (std::size_t i = 1; i < marks.size(); ++i) {
        for (int part = 1; part < count; ++part)
            times_s.push_back(marks[i - 1] + (marks[i] - marks[i - 1]) * part / count);
        times_s.push_back(marks[i]);
    }
    for (const double jump_s : jump_times_s)
        for (const double time_s : {jump_s - kBesideJumpS, jump_s + kBesideJumpS})
            if (time_s > 0.0 && time_s < clip.plan.duration_s) times_s.push_back(time_s);
    std::sort(times_s.begin(), times_s.end());
    return times_s;
}

double bend_between(const Affine& from, const Affine& to, const palette::BoneMoment& moment) {
    const double norms = std::sqrt(square_sum(from.linear) * square_sum(to.linear));
    if (norms == 0.0) return 0.0;
    double product = 0.0;
    for (int c = 0; c < 3; ++c) product += glm::dot(from.linear[c], to.linear[c]);
    // 4 sin^2(theta / 2): nearly the square of the angle between the two.
    const double square_angle = 3.0 - 3.0 * product / norms;
    const Affine change{to.linear - from.linear, to.translation - from.translation};
    const glm::dvec3 shift = change * moment.centroid;
    const double way =
        std::sqrt(glm::dot(shift, shift)) + std::sqrt(square_sum(change.linear)) * moment.radius;
    // A blend of two quaternions runs ahead of an even turn, or behind it, by theta^3 / 24 u (1 - u) (1 - 2
    // u) at the share u: by nothing half way, and by theta^2 / 256 of the way at a quarter.
    return std::max(square_angle, 0.0) * way / 256.0;
}

double largest_bend(const animal::Animal& animal, const palette::Palette& palette,
                    const palette::PaletteClip& clip, motion::ClipSampler& sampler,
                    std::span<const palette::BoneMoment> moments) {
    std::vector<Affine> from(animal.bones.size());
    std::vector<Affine> to(animal.bones.size());
    double largest = 0.0;
    bool is_first = true;
    for (const double time_s : marks_of(clip, sampler.key_times_s())) {
        std::swap(from, to);
        sampler.sample(time_s, to);
        palette.spaces.enter(to);
        for (std::size_t b = 0; b < to.size() && !is_first; ++b)
            if (animal.bones[b].weighted)
                largest = std::max(largest, bend_between(from[b], to[b], moments[b]));
        is_first = false;
    }
    return largest / palette.reach();
}

}  // namespace posepack::measure
