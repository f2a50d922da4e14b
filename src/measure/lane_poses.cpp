// SPDX-License-Identifier: MIT
#include "measure/lane_poses.hpp"

#include <cassert>

namespace posepack::measure {
namespace {

using motion::Affine;

Affine affine_of(const float* matrix) {
    Affine out;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) out.linear[c][r] = static_cast<double>(matrix[r * 4 + c]);
        out.translation[r] = static_cast<double>(matrix[r * 4 + 3]);
    }
    return out;
}

}  // namespace

motion::SkinSet in_radii(motion::SkinSet points, double inverse_radius) {
    for (auto& vector : points.vectors)
        for (float& c : vector) c = static_cast<float>(c * inverse_radius);
    return points;
}

LanePoses::LanePoses(const animal::Animal& animal, const palette::Palette& palette, const posepack_view& view,
                     double inverse_radius)
    : palette_(palette),
      bindings_(animal, palette.spaces),
      view_(view),
      inverse_radius_(inverse_radius),
      bones_(animal.bones.size()),
      blended_(animal.bones.size() * 12) {
    difference_.values.resize(bindings_.size() * 12 * kLanes);
    exact_.values.resize(bindings_.size() * 9 * kLanes);
}

void LanePoses::read_pose(const palette::PaletteClip& clip, double time_s) {
    posepack_result result = POSEPACK_OK;
    if (clip.runs.is_empty()) {
        const motion::RowBlend blend = clip.rows_at(time_s);
        result = posepack_blend_row(&view_, clip.first_row + blend.row0, clip.first_row + blend.row1,
                                    static_cast<float>(blend.factor), blended_.data());
    } else {
        // A held pose begins with its key, as the sampler has it, and not a rounding of the phase later.
        constexpr double kEarlyS = 1e-6;
        const double shown_s = clip.plan.step ? time_s + kEarlyS : time_s;
        const double phase = clip.plan.period_s > 0.0 ? shown_s / clip.plan.period_s : 0.0;
        const auto index = static_cast<std::uint32_t>(&clip - palette_.clips.data());
        result = posepack_sample_pose(&view_, index, static_cast<float>(phase), blended_.data());
    }
    assert(result == POSEPACK_OK);
    static_cast<void>(result);
}

void LanePoses::fill(motion::ClipSampler& sampler, const palette::PaletteClip& clip, double time_s,
                     std::size_t lane) {
    sampler.sample(time_s, bones_);
    read_pose(clip, time_s);
    for (std::uint32_t b = 0; b < bindings_.size(); ++b) {
        const Affine source = bindings_.source(b, bones_, sampler);
        const Affine found = bindings_.found(b, affine_of(&blended_[std::size_t{bindings_.bone_of(b)} * 12]));
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 4; ++c) {
                const double difference =
                    c < 3 ? found.linear[c][r] - source.linear[c][r]
                          : (found.translation[r] - source.translation[r]) * inverse_radius_;
                const std::size_t e = std::size_t{b} * 12 + static_cast<std::size_t>(r * 4 + c);
                difference_.values[e * kLanes + lane] = static_cast<float>(difference);
            }
            for (int c = 0; c < 3; ++c)
                exact_.values[(std::size_t{b} * 9 + static_cast<std::size_t>(r * 3 + c)) * kLanes + lane] =
                    static_cast<float>(source.linear[c][r]);
        }
    }
}

std::uint32_t blamed_bone(const motion::SkinSet& set, std::uint32_t entry, const LaneMatrices& difference,
                          std::size_t lane, bool is_point) {
    std::uint32_t worst = set.bones[entry][0];
    double largest = -1.0;
    const auto& v = set.vectors[entry];
    for (std::size_t k = 0; k < animal::kMaxInfluences; ++k) {
        if (set.weights[entry][k] <= 0.0f) break;
        double square = 0.0;
        for (std::size_t r = 0; r < 3; ++r) {
            const float* m =
                &difference.values[(std::size_t{set.bones[entry][k]} * 12 + r * 4) * kLanes + lane];
            double sum = is_point ? static_cast<double>(m[3 * kLanes]) : 0.0;
            for (std::size_t c = 0; c < 3; ++c) sum += static_cast<double>(m[c * kLanes]) * v[c];
            square += sum * sum * set.weights[entry][k] * set.weights[entry][k];
        }
        if (square > largest) {
            largest = square;
            worst = set.bones[entry][k];
        }
    }
    return worst;
}

}  // namespace posepack::measure
