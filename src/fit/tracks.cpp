// SPDX-License-Identifier: MIT
#include "fit/tracks.hpp"

#include <algorithm>

#include "motion/clip_sampler.hpp"
#include "palette/rounding.hpp"

namespace posepack::fit {
namespace {

using motion::Affine;

constexpr std::uint32_t kFewestIntervals = 32;

void write_matrix(const Affine& map, float* out) {
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) *out++ = static_cast<float>(map.linear[c][r]);
        *out++ = static_cast<float>(map.translation[r]);
    }
}

void write_dualquat(const palette::Similarity& target, float* out) {
    palette::Similarity rigid = target;
    rigid.scale = 1.0;  // leaves the dual part at right angles to the real one
    std::array<double, 8> numbers{};
    palette::dualquat_numbers(rigid, 1.0, numbers);
    for (std::size_t i = 0; i < 8; ++i) out[i] = static_cast<float>(numbers[i]);
    out[8] = static_cast<float>(target.scale);
}

// Of an open loop nothing is known between the last key and row 0, nor at the end of any loop, where row 0
// stands: there the numbers go straight from the last known sample to sample 0.
void close_loop(Tracks& tracks) {
    const std::size_t width = numbers_of(tracks.form);
    const std::size_t last = tracks.known_count - 1;
    const double gap = static_cast<double>(tracks.interval_count - last);
    for (std::size_t bone = 0; bone < tracks.bone_count; ++bone) {
        float* base = &tracks.numbers[bone * tracks.sample_count() * width];
        double along = 0.0;
        for (std::size_t c = 0; c < 4; ++c)
            along += static_cast<double>(base[c]) * static_cast<double>(base[last * width + c]);
        tracks.turned[bone] = tracks.form == Form::dualquat && along < 0.0;
        for (std::size_t k = last + 1; k <= tracks.interval_count; ++k) {
            const auto factor = static_cast<float>(static_cast<double>(k - last) / gap);
            for (std::size_t c = 0; c < width; ++c) {
                const float sign = tracks.turned[bone] && c < 8 ? -1.0f : 1.0f;
                base[k * width + c] = base[last * width + c] * (1.0f - factor) + sign * base[c] * factor;
            }
        }
    }
}

}  // namespace

Tracks sample_tracks(const animal::Animal& animal, const animal::Clip& clip, const motion::RowPlan& plan,
                     const palette::Spaces& spaces, Form form, std::uint32_t per_key,
                     palette::Hemispheres& hemispheres) {
    Tracks tracks;
    tracks.form = form;
    tracks.loop = plan.wrap == recipe::Wrap::loop;
    tracks.step = plan.step;
    tracks.bone_count = static_cast<std::uint32_t>(animal.bones.size());
    if (plan.period_s > 0.0) {
        tracks.key_intervals = tracks.loop ? plan.row_count : std::max<std::uint32_t>(1, plan.row_count - 1);
        const std::uint32_t least = (kFewestIntervals + tracks.key_intervals - 1) / tracks.key_intervals;
        tracks.interval_count = tracks.key_intervals * std::max(per_key, least);
    }
    const std::size_t width = numbers_of(form);
    tracks.numbers.resize(tracks.bone_count * tracks.sample_count() * width);
    tracks.exact.resize(tracks.bone_count * tracks.sample_count() * 12);
    tracks.turned.resize(tracks.bone_count);
    motion::ClipSampler sampler(animal, clip);
    std::vector<Affine> bones(tracks.bone_count);
    hemispheres.begin_clip();
    const bool loop = tracks.loop && tracks.interval_count > 0;
    constexpr double kHairS = 1e-9;
    for (std::size_t k = 0; k < tracks.sample_count() - (loop ? 1 : 0); ++k) {
        const double time_s = tracks.time_phase(k) * plan.period_s;
        if (time_s > plan.duration_s + kHairS) break;
        sampler.sample(time_s, bones);
        spaces.enter(bones);
        for (std::size_t b = 0; b < bones.size(); ++b) {
            write_matrix(bones[b], &tracks.exact[(b * tracks.sample_count() + k) * 12]);
            float* numbers = &tracks.numbers[(b * tracks.sample_count() + k) * width];
            if (form == Form::affine)
                write_matrix(bones[b], numbers);
            else
                write_dualquat(hemispheres.next(b, bones[b]), numbers);
        }
        tracks.known_count = static_cast<std::uint32_t>(k + 1);
    }
    if (loop) close_loop(tracks);
    return tracks;
}

}  // namespace posepack::fit
