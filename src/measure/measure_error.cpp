// SPDX-License-Identifier: MIT
#include "measure/measure_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/trig.hpp"
#include "measure/closer_times.hpp"
#include "measure/lane_poses.hpp"
#include "measure/skin_difference.hpp"
#include "measure/test_times.hpp"
#include "palette/moments.hpp"
#include "posepack/loader.h"

namespace posepack::measure {
namespace {

using animal::Animal;
using motion::SkinSet;
using palette::ClipError;

constexpr double kDegrees = 180.0 / base::kPi;
// Bends of dual quaternions that a second look at the quarters is worth: in R, and of the largest error found
// half way, where a bend shows nothing.
constexpr double kWorthLooking = 3e-4;
constexpr double kShareWorthLooking = 0.5;
// A span is looked at closer where its ends show these shares of the largest error. Bends and splines may
// have more in between than at either end, up to what is said above. Others are arcs: one that is zero at a
// mark, and half way to the next and there a and b of the largest, goes 1 % beyond both where b is 0.4 a, and
// an eighth where b is a.
struct CloserRule {
    double share, other_share;
};
constexpr CloserRule kForBends{kShareWorthLooking, 0.0};
constexpr CloserRule kForArcs{0.8, 0.4};
// The second time, for the top of what the first has found.
constexpr double kShareOfTheTop = 0.9;

// The largest value so far, the time it was seen and the set entry it was seen at.
struct Worst {
    float square = -1.0f;
    double time_s = 0.0;
    std::uint32_t entry = 0;

    void take(const LaneWorst& lanes, std::span<const double> times_s) {
        for (std::size_t l = 0; l < times_s.size(); ++l)
            if (lanes.value[l] > square) *this = {lanes.value[l], times_s[l], lanes.entry[l]};
    }
};

// What was seen of a clip at the times looked at.
struct Seen {
    Worst point, normal;
    std::vector<Moment> moments;  // of points

    void take(const LaneWorst& lanes, std::span<const double> times_s) {
        point.take(lanes, times_s);
        for (std::size_t l = 0; l < times_s.size(); ++l) moments.push_back({times_s[l], lanes.value[l]});
    }
};

// What one clip, or all of them, add up to.
struct Tally {
    Histogram distances, half_tangents;  // squared
    double sum = 0.0;                    // of squared distances
    std::uint64_t point_samples = 0, normal_samples = 0;
    unsigned weight = 1;  // in a sum of tallies: a clip that is looked at twice as finely counts half as much

    void clear() {
        distances.clear();
        half_tangents.clear();
        sum = 0.0;
        point_samples = normal_samples = 0;
    }
    void add(const Tally& other) {
        distances.add(other.distances, other.weight);
        half_tangents.add(other.half_tangents, other.weight);
        sum += other.weight * other.sum;
        point_samples += other.weight * other.point_samples;
        normal_samples += other.weight * other.normal_samples;
    }
};

// Of the square of the tangent of half the angle.
double degrees_of_half_tangent_square(double square) {
    if (square >= static_cast<double>(kStraightAngle)) return 180.0;
    return 2.0 * base::arc_tangent(std::sqrt(square)) * kDegrees;
}

struct Place {
    std::uint32_t mesh, vertex;
};

Place place_of(const Animal& animal, const SkinSet& set, std::uint32_t entry) {
    const std::uint32_t vertex = set.vertices[entry];
    std::uint32_t mesh = 0;
    while (vertex - animal.meshes[mesh].first_vertex >= animal.meshes[mesh].vertex_count ||
           vertex < animal.meshes[mesh].first_vertex)
        ++mesh;
    return {mesh, vertex - animal.meshes[mesh].first_vertex};
}

// Measures one clip after the other with buffers that are made once.
class ClipMeter {
 public:
    ClipMeter(const Animal& animal, const palette::Palette& palette, const posepack_view& view,
              const SkinSet& points, const SkinSet& normals)
        : animal_(animal),
          palette_(palette),
          inverse_radius_(palette.radius > 0.0 ? 1.0 / palette.radius : 1.0),
          moments_(palette::bone_moments(points, palette.spaces, animal.bones.size(), palette.reach())),
          poses_(animal, palette, view, inverse_radius_),
          points_(in_radii(poses_.bindings().bind(points), inverse_radius_)),
          normals_(poses_.bindings().bind(normals)) {}

    // `look` receives when the clip was looked at in the end.
    // Errors: E-LIM-WORK, before the work is done.
    base::Result<ClipError> measure(const palette::PaletteClip& clip, Tally& tally, Look& look) {
        motion::ClipSampler sampler(animal_, animal_.clips[clip.source]);
        look.parts = sampler.has_splines() ? Parts::quarters : Parts::halves;
        auto seen = measure(clip, sampler, look.parts, tally);
        if (!seen) return seen.issue();
        if (look.parts == Parts::halves && hides_bends(clip, sampler, seen.value())) {
            tally.clear();
            look.parts = Parts::quarters;
            seen = measure(clip, sampler, look.parts, tally);
            if (!seen) return seen.issue();
        }
        const CloserRule rule = may_bend(clip) || sampler.has_splines() ? kForBends : kForArcs;
        for (const double share : {rule.share, kShareOfTheTop})
            if (auto status = look_closer(clip, sampler, {share, rule.other_share}, seen.value(), look);
                !status)
                return status.issue();
        ClipError error = figures(tally);
        locate(sampler, clip, seen.value(), error);
        return error;
    }

    // The figures of a tally; places are left out.
    ClipError figures(const Tally& tally) const {
        ClipError error;
        error.p999 = static_cast<float>(std::sqrt(static_cast<double>(tally.distances.percentile(0.999))));
        if (tally.point_samples > 0)
            error.rms = static_cast<float>(std::sqrt(tally.sum / static_cast<double>(tally.point_samples)));
        error.normal_p999_deg = static_cast<float>(
            degrees_of_half_tangent_square(static_cast<double>(tally.half_tangents.percentile(0.999))));
        error.normal_rms_deg = static_cast<float>(std::sqrt(tally.half_tangents.mean([](double square) {
            const double degrees = degrees_of_half_tangent_square(square);
            return degrees * degrees;
        })));
        return error;
    }

 private:
    base::Result<Seen> measure(const palette::PaletteClip& clip, motion::ClipSampler& sampler, Parts parts,
                               Tally& tally) {
        const std::vector<double> times_s =
            test_times_s(clip, sampler.key_times_s(), sampler.jump_times_s(), parts);
        if (auto status = take_samples(times_s.size() * (points_.size() + normals_.size()), clip); !status)
            return status.issue();
        tally.weight = parts == Parts::halves ? 2 : 1;
        Seen seen;
        for (std::size_t first = 0; first < times_s.size(); first += kLanes) {
            const auto batch = std::span(times_s).subspan(first, std::min(kLanes, times_s.size() - first));
            for (std::size_t l = 0; l < batch.size(); ++l) poses_.fill(sampler, clip, batch[l], l);
            const LaneWorst lanes =
                measure_points(points_, poses_.difference(), batch.size(), tally.distances, tally.sum);
            seen.take(lanes, batch);
            seen.normal.take(measure_normals(normals_, poses_.difference(), poses_.exact(), batch.size(),
                                             tally.half_tangents),
                             batch);
            tally.point_samples += batch.size() * points_.size();
            tally.normal_samples += batch.size() * normals_.size();
        }
        return seen;
    }

    // Measures the points alone where they may be further off than all that was seen. Only the
    // largest error comes of it: times that were chosen for their errors have no say in the others.
    base::Status look_closer(const palette::PaletteClip& clip, motion::ClipSampler& sampler, CloserRule rule,
                             Seen& seen, Look& look) {
        const std::vector<double> times_s = closer_times_s(seen.moments, rule.share, rule.other_share);
        if (auto status = take_samples(times_s.size() * points_.size(), clip); !status) return status;
        for (std::size_t first = 0; first < times_s.size(); first += kLanes) {
            const auto batch = std::span(times_s).subspan(first, std::min(kLanes, times_s.size() - first));
            for (std::size_t l = 0; l < batch.size(); ++l) poses_.fill(sampler, clip, batch[l], l);
            seen.take(largest_points(points_, poses_.difference()), batch);
        }
        std::sort(seen.moments.begin(), seen.moments.end(),
                  [](const Moment& a, const Moment& b) { return a.time_s < b.time_s; });
        look.closer_s.insert(look.closer_s.end(), times_s.begin(), times_s.end());
        std::sort(look.closer_s.begin(), look.closer_s.end());
        return {};
    }

    // Whether blends between rows may leave the arc of an even turn.
    bool may_bend(const palette::PaletteClip& clip) const {
        const std::uint8_t encoding = clip.runs.is_empty() ? palette_.layout.encoding : clip.runs.encoding;
        return encoding == POSEPACK_ENCODING_DUALQUAT && !clip.plan.step && clip.plan.row_count > 1;
    }

    // Whether a bend may be larger than what was seen half way, where bends show nothing.
    bool hides_bends(const palette::PaletteClip& clip, motion::ClipSampler& sampler, const Seen& seen) {
        if (!may_bend(clip)) return false;
        const double largest = std::sqrt(static_cast<double>(std::max(seen.point.square, 0.0f)));
        const double bend = largest_bend(animal_, palette_, clip, sampler, moments_);
        return bend >= std::max(kWorthLooking, kShareWorthLooking * largest);
    }

    base::Status take_samples(std::uint64_t wanted, const palette::PaletteClip& clip) {
        if (wanted > samples_left_)
            return base::Issue{
                base::IssueCode::lim_work, animal_.clips[clip.source].name,
                fmt::format(
                    "expected at most {} places (times x vertices and normals) left to measure, found {}",
                    samples_left_, wanted)};
        samples_left_ -= wanted;
        return {};
    }

    void locate(motion::ClipSampler& sampler, const palette::PaletteClip& clip, const Seen& seen,
                ClipError& error) {
        const auto& [point, normal, moments] = seen;
        if (points_.size() > 0) {
            const Place place = place_of(animal_, points_, point.entry);
            poses_.fill(sampler, clip, point.time_s, 0);
            error.max = static_cast<float>(std::sqrt(static_cast<double>(point.square)));
            error.p999 = std::min(error.p999, error.max);
            error.time_s = static_cast<float>(point.time_s);
            error.mesh = place.mesh;
            error.vertex = place.vertex;
            error.bone =
                poses_.bindings().bone_of(blamed_bone(points_, point.entry, poses_.difference(), 0, true));
        }
        if (normals_.size() > 0) {
            const Place place = place_of(animal_, normals_, normal.entry);
            poses_.fill(sampler, clip, normal.time_s, 0);
            error.normal_max_deg =
                static_cast<float>(degrees_of_half_tangent_square(static_cast<double>(normal.square)));
            error.normal_p999_deg = std::min(error.normal_p999_deg, error.normal_max_deg);
            error.normal_time_s = static_cast<float>(normal.time_s);
            error.normal_mesh = place.mesh;
            error.normal_vertex = place.vertex;
            error.normal_bone =
                poses_.bindings().bone_of(blamed_bone(normals_, normal.entry, poses_.difference(), 0, false));
        }
    }

    const Animal& animal_;
    const palette::Palette& palette_;
    double inverse_radius_;
    std::vector<palette::BoneMoment> moments_;
    LanePoses poses_;
    const SkinSet points_, normals_;  // with bindings in the place of bones; points in units of R
    std::uint64_t samples_left_ = kMaxSamples;
};

}  // namespace

base::Result<ErrorStats> measure_error(const Animal& animal, const palette::Palette& palette,
                                       std::span<const std::uint8_t> container, const SkinSet& points,
                                       const SkinSet& normals) {
    posepack_view view;
    if (const posepack_result result = posepack_open(&view, container.data(), container.size());
        result != POSEPACK_OK)
        return base::Issue{
            base::IssueCode::internal, "",
            fmt::format("expected a container that the loader opens, it answers {} to the one just made",
                        posepack_result_name(result))};
    ClipMeter meter(animal, palette, view, points, normals);
    ErrorStats stats;
    Tally all, one;
    for (std::uint32_t c = 0; c < palette.clips.size(); ++c) {
        one.clear();
        Look look;
        const auto measured = meter.measure(palette.clips[c], one, look);
        if (!measured) return measured.issue();
        const ClipError& error = measured.value();
        if (!std::isfinite(error.max) || !std::isfinite(error.rms))
            return base::Issue{base::IssueCode::lim_float_range, animal.clips[palette.clips[c].source].name,
                               "expected errors that fit a float, found a motion too large to be measured"};
        all.add(one);
        stats.point_samples += one.point_samples;
        stats.normal_samples += one.normal_samples;
        if (stats.clips.empty() || error.max > stats.clips[stats.worst_clip].max) stats.worst_clip = c;
        stats.clips.push_back(error);
        stats.looks.push_back(std::move(look));
    }
    stats.pooled = stats.clips.empty() ? ClipError{} : stats.clips[stats.worst_clip];
    const ClipError pooled = meter.figures(all);
    stats.pooled.p999 = std::min(pooled.p999, stats.pooled.max);
    stats.pooled.rms = pooled.rms;
    stats.pooled.normal_rms_deg = pooled.normal_rms_deg;
    for (const ClipError& clip : stats.clips)
        stats.pooled.normal_max_deg = std::max(stats.pooled.normal_max_deg, clip.normal_max_deg);
    stats.pooled.normal_p999_deg = std::min(pooled.normal_p999_deg, stats.pooled.normal_max_deg);
    return stats;
}

}  // namespace posepack::measure
