// SPDX-License-Identifier: MIT
#include "palette/dualquat_fit.hpp"

#include <cmath>

namespace posepack::palette {
namespace {

// Half the difference of the largest and the smallest singular value is at most this: one glance at the
// matrix that spares most bones the eigenvalues.
double stretch_bound(const glm::dmat3& linear) {
    const glm::dmat3 square = glm::transpose(linear) * linear;
    const double mean = (square[0][0] + square[1][1] + square[2][2]) / 3.0;
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            const double d = square[c][r] - (c == r ? mean : 0.0);
            sum += d * d;
        }
    // Eigenvalues differ by at most sqrt(2) times the norm, singular values by that over their sum.
    return mean > 0.0 ? std::sqrt(2.0 * sum) / std::sqrt(mean) : 0.0;
}

// The bone's vertices, moved by the nearest similarity instead, are off by more than the tolerance.
bool is_unfit(const glm::dmat3& linear, double radius, double reach) {
    const double allowed = kStretchTolerance * reach;
    if (stretch_bound(linear) * radius <= allowed) return false;
    const Stretch stretch = stretch_of(linear);
    return (stretch.largest - stretch.smallest) * radius > allowed;
}

}  // namespace

void Hemispheres::begin_clip() {
    if (!reference_.empty()) previous_ = reference_;
    is_fresh_.assign(previous_.size(), true);
    clip_first_.resize(previous_.size());
}

Similarity Hemispheres::next(std::size_t bone, const motion::Affine& matrix) {
    Similarity out = nearest_similarity(matrix, previous_[bone]);
    if (glm::dot(out.rotation, previous_[bone]) < 0.0) out.rotation = -out.rotation;
    previous_[bone] = out.rotation;
    if (is_fresh_[bone]) {
        is_fresh_[bone] = false;
        clip_first_[bone] = out.rotation;
        if (bone + 1 == previous_.size() && reference_.empty()) reference_ = previous_;
    }
    return out;
}

DualquatFit fit_dualquat(motion::ClipSampler& sampler, const motion::RowPlan& plan, const Spaces& spaces,
                         std::span<const BoneMoment> moments, double reach) {
    DualquatFit fit;
    Hemispheres hemispheres(moments.size());
    hemispheres.begin_clip();
    std::vector<motion::Affine> bones(moments.size());
    for (std::uint32_t row = 0; row < plan.row_count; ++row) {
        motion::sample_row(sampler, plan, row, bones);
        spaces.enter(bones);
        // Behind the last key of an open loop rows are mixed from matrices, and nothing there is the source.
        const bool is_source = plan.row_time_s(row) <= plan.duration_s;
        for (std::uint32_t b = 0; b < bones.size(); ++b) {
            if (is_source && !fit.unfit && is_unfit(bones[b].linear, moments[b].radius, reach))
                fit.unfit = Unfit{row, b, stretch_of(bones[b].linear).ratio()};
            const double scale = hemispheres.next(b, bones[b]).scale;
            fit.largest_change = std::max(fit.largest_change, std::abs(scale - 1.0));
        }
    }
    if (plan.wrap == recipe::Wrap::loop && !plan.step && plan.row_count > 1)
        for (std::size_t b = 0; b < bones.size(); ++b)
            fit.closing_row = fit.closing_row || hemispheres.is_turned(b);
    return fit;
}

}  // namespace posepack::palette
