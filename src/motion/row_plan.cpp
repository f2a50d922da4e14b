// SPDX-License-Identifier: MIT
#include "motion/row_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/key_grid.hpp"
#include "motion/seam.hpp"

namespace posepack::motion {
namespace {

using base::IssueCode;
using recipe::Seam;
using recipe::Wrap;

constexpr double kFallbackRateHz = 30.0;
constexpr double kClosedGap = 1e-3;     // of R
constexpr double kClosedSteps = 0.3;    // of a key step: a pop, but no missing pose
constexpr double kOpenSteps = 1.5;      // beyond it the ends have nothing to do with each other
constexpr double kRowTolerance = 1e-9;  // rows; a time that is meant to hit a row does

void decide_wrap(RowPlan& plan, const RowWish& wish, const SeamMeasure& seam, double radius,
                 const std::string& clip_name) {
    const double steps = seam.step > 0.0 ? seam.gap / seam.step : 0.0;
    plan.seam_gap = radius > 0.0 ? seam.gap / radius : 0.0;
    const bool meets = plan.seam_gap < std::min(kClosedGap, wish.largest_gap.value_or(kClosedGap));
    const double closed_steps = wish.largest_gap ? 0.0 : kClosedSteps;
    Wrap wrap = wish.wrap;
    if (wrap == Wrap::automatic) wrap = meets || steps <= kOpenSteps ? Wrap::loop : Wrap::once;
    plan.wrap = wrap;
    plan.seam = Seam::closed;
    if (wrap != Wrap::loop) return;
    plan.seam = wish.seam;
    if (plan.seam == Seam::automatic) plan.seam = meets || steps < closed_steps ? Seam::closed : Seam::open;
    if (plan.seam == Seam::closed && !meets)
        plan.remarks.push_back(
            {IssueCode::warn_seam, clip_name,
             fmt::format("the last pose misses the first by {:.2g} R ({:.2g} of a key step)", plan.seam_gap,
                         steps)});
}

std::uint32_t at_least_one(double rows) {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(rows)));
}

}  // namespace

double RowPlan::row_time_s(std::uint32_t row) const {
    if (row_count == 1) return 0.0;
    const double intervals = wrap == Wrap::loop ? row_count : row_count - 1;
    return period_s * row / intervals;
}

RowBlend RowPlan::rows_at(double time_s) const {
    if (row_count == 1 || period_s <= 0.0) return {};
    const bool loop = wrap == Wrap::loop;
    const double intervals = loop ? row_count : row_count - 1;
    const double position = std::clamp(time_s / period_s * intervals, 0.0, intervals);
    double row0 = std::floor(position + kRowTolerance);
    if (row0 >= intervals) row0 = intervals - 1.0;  // the end belongs to the last interval
    RowBlend blend;
    blend.row0 = static_cast<std::uint32_t>(row0);
    blend.row1 = loop && blend.row0 + 1 == row_count ? 0 : blend.row0 + 1;
    blend.factor = std::clamp(position - row0, 0.0, 1.0);
    if (blend.factor < kRowTolerance) blend.factor = 0.0;
    if (step) {
        if (blend.factor > 1.0 - kRowTolerance) blend.row0 = blend.row1;  // the very end, or the next turn
        blend.row1 = blend.row0;
        blend.factor = 0.0;
    }
    return blend;
}

RowPlan plan_rows(const animal::Animal& animal, const animal::Clip& clip, ClipSampler& sampler,
                  const SkinSet& points, double radius, const RowWish& wish) {
    RowPlan plan;
    plan.duration_s = clip.duration_s;
    plan.period_s = clip.duration_s;
    if (clip.duration_s <= 0.0) return plan;
    const std::vector<double> key_times_s = sampler.key_times_s();
    const std::optional<double> key_step = key_step_s(key_times_s);
    double step_s = key_step.value_or(1.0 / kFallbackRateHz);
    const double seam_step_s = step_s;
    if (wish.rate_hz)
        step_s = 1.0 / *wish.rate_hz;
    else if (!key_step && sampler.moves())
        plan.remarks.push_back({IssueCode::warn_rate, clip.name,
                                fmt::format("{} key times lie on no uniform grid", key_times_s.size())});
    plan.step = sampler.all_steps();
    decide_wrap(plan, wish, measure_seam(sampler, points, animal.bones.size(), clip.duration_s, seam_step_s),
                radius, clip.name);
    if (plan.wrap == Wrap::loop) {
        if (plan.seam == Seam::open) plan.period_s += seam_step_s;
        plan.row_count = at_least_one(plan.period_s / step_s);
        plan.rate_hz = plan.row_count / plan.period_s;
    } else {
        const std::uint32_t intervals = at_least_one(plan.period_s / step_s);
        plan.row_count = intervals + 1;
        plan.rate_hz = intervals / plan.period_s;
    }
    if (plan.row_count == 1) plan.rate_hz = 0.0;
    plan.on_key_grid = key_step.has_value() && std::abs(step_s - *key_step) < 1e-9;
    return plan;
}

void sample_row(ClipSampler& sampler, const RowPlan& plan, std::uint32_t row, std::span<Affine> bones) {
    const double time_s = plan.row_time_s(row);
    const double beyond_s = time_s - plan.duration_s;
    if (beyond_s <= kRowTolerance) {
        sampler.sample(time_s, bones);
        return;
    }
    // Rows at another rate than the keys' may fall between the last key of an open loop and row 0.
    const double factor = beyond_s / (plan.period_s - plan.duration_s);
    std::vector<Affine> last(bones.size());
    sampler.sample(plan.duration_s, last);
    sampler.sample(0.0, bones);
    for (std::size_t b = 0; b < bones.size(); ++b) {
        bones[b].linear = last[b].linear * (1.0 - factor) + bones[b].linear * factor;
        bones[b].translation = last[b].translation * (1.0 - factor) + bones[b].translation * factor;
    }
}

}  // namespace posepack::motion
