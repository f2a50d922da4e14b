// SPDX-License-Identifier: MIT
#include "measure/error_heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure/lane_poses.hpp"
#include "measure/measure_error.hpp"
#include "measure/test_times.hpp"

namespace posepack::measure {
namespace {

using motion::SkinSet;

// The measured times of a clip in bins of whole times.
struct Bins {
    std::vector<double> times_s;
    std::size_t count = 1;

    std::size_t first_time(std::size_t bin) const { return bin * times_s.size() / count; }
    std::size_t bin_of(std::size_t time) const {
        std::size_t bin = time * count / times_s.size();
        while (first_time(bin + 1) <= time) ++bin;  // the two divisions round towards each other
        return bin;
    }
    std::vector<double> edges_s() const {
        std::vector<double> edges{times_s.front()};
        for (std::size_t bin = 1; bin < count; ++bin)
            edges.push_back(0.5 * (times_s[first_time(bin) - 1] + times_s[first_time(bin)]));
        edges.push_back(times_s.back());
        return edges;
    }
};

Bins bins_of(std::vector<double> times_s, double bin_width_s) {
    Bins bins{std::move(times_s)};
    const double wanted = std::ceil((bins.times_s.back() - bins.times_s.front()) / bin_width_s);
    bins.count = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(bins.times_s.size())));
    return bins;
}

// The bin of a time that is none of those the bins were made of.
std::size_t bin_between(std::span<const double> edges_s, double time_s) {
    const auto behind = std::lower_bound(edges_s.begin() + 1, edges_s.end() - 1, time_s);
    return static_cast<std::size_t>(behind - edges_s.begin()) - 1;
}

// Takes the squared distances of every point at the times of `batch` into `squares` [bin * bones + bone].
void take_points(const SkinSet& set, const LanePoses& poses, std::span<const std::size_t> batch_bins,
                 std::size_t bone_count, std::vector<float>& squares) {
    const LaneMatrices& difference = poses.difference();
    for (std::size_t influences = 1; influences + 1 < set.first.size(); ++influences)
        for (std::uint32_t i = set.first[influences]; i < set.first[influences + 1]; ++i) {
            const Lanes square = squared_distances(set, i, influences, difference);
            for (std::size_t l = 0; l < batch_bins.size(); ++l) {
                float* cells = &squares[batch_bins[l] * bone_count];
                // Finding the bone to blame costs more than the distance: only where some cell may grow.
                const auto may_grow = [&](std::uint16_t binding) {
                    return square[l] > cells[poses.bindings().bone_of(binding)];
                };
                const auto& bones = set.bones[i];
                if (std::none_of(bones.begin(), bones.begin() + static_cast<std::ptrdiff_t>(influences),
                                 may_grow))
                    continue;
                float& cell = cells[poses.bindings().bone_of(blamed_bone(set, i, difference, l, true))];
                cell = std::max(cell, square[l]);
            }
        }
}

ClipHeat clip_heat(LanePoses& poses, motion::ClipSampler& sampler, const palette::PaletteClip& clip,
                   const Bins& bins, std::span<const double> closer_s, const SkinSet& points,
                   std::size_t bone_count) {
    ClipHeat heat{bins.edges_s(), std::vector<float>(bins.count * bone_count)};
    std::array<std::size_t, kLanes> lane_bins{};
    const std::size_t even_count = bins.times_s.size(), count = even_count + closer_s.size();
    for (std::size_t first = 0; first < count; first += kLanes) {
        const std::size_t lanes = std::min(kLanes, count - first);
        for (std::size_t l = 0; l < lanes; ++l) {
            const std::size_t i = first + l;
            const double time_s = i < even_count ? bins.times_s[i] : closer_s[i - even_count];
            poses.fill(sampler, clip, time_s, l);
            lane_bins[l] = i < even_count ? bins.bin_of(i) : bin_between(heat.edges_s, time_s);
        }
        take_points(points, poses, std::span(lane_bins).first(lanes), bone_count, heat.errors);
    }
    for (float& value : heat.errors) value = static_cast<float>(std::sqrt(static_cast<double>(value)));
    return heat;
}

}  // namespace

base::Result<ErrorHeat> measure_heat(const animal::Animal& animal, const palette::Palette& palette,
                                     std::span<const std::uint8_t> container, const SkinSet& points,
                                     std::span<const Look> looks, double bin_width_s) {
    posepack_view view;
    if (const posepack_result result = posepack_open(&view, container.data(), container.size());
        result != POSEPACK_OK)
        return base::Issue{
            base::IssueCode::internal, "",
            fmt::format("expected a container that the loader opens, it answers {} to the one just made",
                        posepack_result_name(result))};
    const double inverse_radius = palette.radius > 0.0 ? 1.0 / palette.radius : 1.0;
    LanePoses poses(animal, palette, view, inverse_radius);
    const SkinSet bound = in_radii(poses.bindings().bind(points), inverse_radius);
    ErrorHeat heat{static_cast<std::uint32_t>(animal.bones.size()), {}};
    std::uint64_t samples = 0;
    for (const palette::PaletteClip& clip : palette.clips) {
        motion::ClipSampler sampler(animal, animal.clips[clip.source]);
        const Look& look = looks[heat.clips.size()];
        const Bins bins = bins_of(
            test_times_s(clip, sampler.key_times_s(), sampler.jump_times_s(), look.parts), bin_width_s);
        samples += std::uint64_t{bins.times_s.size() + look.closer_s.size()} * points.size();
        if (samples > kMaxSamples)
            return base::Issue{
                base::IssueCode::lim_work, animal.clips[clip.source].name,
                fmt::format("expected at most {} places (times x vertices) to measure, found {}", kMaxSamples,
                            samples)};
        heat.clips.push_back(
            clip_heat(poses, sampler, clip, bins, look.closer_s, bound, animal.bones.size()));
    }
    return heat;
}

}  // namespace posepack::measure
