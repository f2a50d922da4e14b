// SPDX-License-Identifier: MIT
#include "choose/choose_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fit/polyline.hpp"
#include "fit/tracks.hpp"
#include "format/texels.h"
#include "measure/measure_error.hpp"
#include "motion/clip_sampler.hpp"
#include "palette/container_writer.hpp"
#include "posepack/format.h"

namespace posepack::choose {
namespace {

using fit::BoneRows;
using fit::Limits;
using palette::ClipError;
using palette::PaletteClip;

constexpr int kMostTries = 8;          // of one fineness
constexpr double kCloseEnough = 0.98;  // of the bound: not worth another try
constexpr double kRounding = 3e-4;     // of R: what rounding adds to the largest error
constexpr double kShortestReal = 0.75;

struct Fineness {
    std::uint32_t samples_per_key, rows_per_key;
};
constexpr Fineness kFineness[] = {{8, 4}, {32, 16}};

// Largest share of the bound that a figure takes; above 1 it is broken.
struct Shares {
    double max, p999, rms;
    double largest() const { return std::max({max, p999, rms}); }
};
Shares shares_of(const ClipError& error, const Limits& bound) {
    const auto share = [](float value, double limit) {
        return std::isfinite(limit) ? static_cast<double>(value) / limit : 0.0;
    };
    return {share(error.max, bound.max), share(error.p999, bound.p999), share(error.rms, bound.rms)};
}

// What single bones tell differs from what vertices between them show, by factors that hardly change from try
// to try: the next limits take them out.
Limits corrected(const Limits& bound, const Limits& expected, const ClipError& found) {
    const auto turn = [](double limit, double told, float seen) {
        const double factor = std::clamp(told / std::max(static_cast<double>(seen), 1e-9), 0.1, 4.0);
        return std::isfinite(limit) ? limit * factor : limit;
    };
    return {turn(bound.max, expected.max, found.max), turn(bound.p999, expected.p999, found.p999),
            turn(bound.rms, expected.rms, found.rms)};
}

// Looks for the widest limits whose rows keep the bound, as multiples of the same: between the widest that
// kept it and the narrowest that did not.
class Search {
 public:
    double scale() const { return scale_; }
    // Another multiple, after one whose errors take `share` of the bound. False: it is not worth one.
    bool step(double share) {
        (share <= 1.0 ? kept_ : broken_) = scale_;
        if (kept_ > 0.0 && broken_ < HUGE_VAL) {
            scale_ = std::sqrt(kept_ * broken_);
            return broken_ / kept_ > 1.01 && share < kCloseEnough + (share > 1.0 ? HUGE_VAL : 0.0);
        }
        const double back =
            0.99 / share;  // further than it seems: what is narrower helps less than in proportion
        scale_ *= share > 1.0 ? back * std::sqrt(std::sqrt(back)) : std::min(1.3, 0.995 / share);
        return share > 1.0 || share < kCloseEnough;
    }

 private:
    double scale_ = 1.0, kept_ = 0.0, broken_ = HUGE_VAL;
};

Limits scaled(const Limits& limits, double scale) {
    return {limits.max * scale, limits.p999 * scale, limits.rms * scale};
}

palette::Similarity similarity_of(const double* n) {
    palette::Similarity out;
    const glm::dvec4 q(n[0], n[1], n[2], n[3]);
    const glm::dvec4 d(n[4], n[5], n[6], n[7]);
    const double square = glm::dot(q, q);
    const double h = 2.0 / square;
    out.translation = h * glm::dvec3(q.w * d.x - d.w * q.x + (q.y * d.z - q.z * d.y),
                                     q.w * d.y - d.w * q.y + (q.z * d.x - q.x * d.z),
                                     q.w * d.z - d.w * q.z + (q.x * d.y - q.y * d.x));
    // A fitted row inside a turn is shorter than those beside it, and blends best so.
    const double length = std::sqrt(square);
    out.rotation = q * (std::clamp(length, kShortestReal, 1.0) / length);
    out.scale = n[8];
    return out;
}

motion::Affine affine_of(const double* n) {
    motion::Affine out;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) out.linear[c][r] = n[4 * r + c];
        out.translation[r] = n[4 * r + 3];
    }
    return out;
}

std::uint64_t bytes_of(const palette::ClipRuns& runs) {
    return runs.texels.size() + runs.entries.size() * std::uint64_t{POSEPACK_RUN_BYTES};
}

}  // namespace

RowChooser::RowChooser(const animal::Animal& animal, const palette::Palette& palette,
                       const palette::RoundingAids& aids, const motion::SkinSet& points)
    : animal_(animal),
      palette_(palette),
      aids_(aids),
      points_(points),
      bone_points_(fit::bone_points(points, palette.spaces, animal.bones.size())),
      boxes_(animal, palette.spaces),
      hemispheres_(animal.bones.size()) {}

// A bone without vertices moves with the nearest bone above it that has some, else with the first that has.
void RowChooser::give_weightless_rows(std::vector<BoneRows>& rows) const {
    const auto has_points = [&](std::uint32_t bone) { return !bone_points_[bone].is_empty(); };
    std::uint32_t first = 0;
    while (first < rows.size() && !has_points(first)) ++first;
    for (std::uint32_t bone = 0; bone < rows.size(); ++bone) {
        if (has_points(bone)) continue;
        std::uint32_t above = animal_.bones[bone].parent;
        while (above != animal::kNone && !has_points(above)) above = animal_.bones[above].parent;
        if (above == animal::kNone) above = first;
        if (above >= rows.size() || above == bone) continue;
        rows[bone].like = rows[above].like == animal::kNone ? above : rows[above].like;
    }
}

std::optional<ChosenRows> RowChooser::encode(const fit::Tracks& tracks, fit::RowSelector& selector,
                                             std::vector<BoneRows> rows) const {
    give_weightless_rows(rows);
    const bool dualquat = tracks.form == fit::Form::dualquat;
    const std::size_t width = fit::numbers_of(tracks.form);
    palette::RunEncoder encoder(dualquat ? POSEPACK_ENCODING_DUALQUAT : POSEPACK_ENCODING_AFFINE,
                                palette_.layout.texel_format, aids_, rows.size());
    for (std::size_t bone = 0; bone < rows.size(); ++bone) {
        if (rows[bone].like != animal::kNone) continue;
        const fit::Polyline& line = selector.line(bone, rows[bone].interval_count);
        const std::size_t row_count = line.interval_count + std::size_t{1};
        bool fits = false;
        if (dualquat) {
            std::vector<palette::Similarity> poses(row_count);
            for (std::size_t r = 0; r < row_count; ++r) poses[r] = similarity_of(&line.rows[r * width]);
            fits = encoder.add_dualquat(bone, poses, tracks.loop, tracks.turned[bone]);
        } else {
            std::vector<motion::Affine> poses(row_count);
            for (std::size_t r = 0; r < row_count; ++r) poses[r] = affine_of(&line.rows[r * width]);
            fits = encoder.add_affine(bone, poses, tracks.loop);
        }
        if (!fits) return std::nullopt;
    }
    for (std::size_t bone = 0; bone < rows.size(); ++bone)
        if (rows[bone].like != animal::kNone) encoder.share(bone, rows[bone].like);
    ChosenRows out;
    encoder.grow_bounds(boxes_, out.bounds);
    out.runs = encoder.finish();
    return out;
}

// In a container of this clip alone.
base::Result<ClipError> RowChooser::measure(PaletteClip clip) const {
    palette::Palette one;
    one.spaces = palette_.spaces;
    one.radius = palette_.radius;
    one.metres_per_unit = palette_.metres_per_unit;
    one.dualquat_length = clip.runs.encoding == POSEPACK_ENCODING_DUALQUAT ? palette_.dualquat_length : 0.0f;
    const std::uint32_t texels = clip.runs.encoding == POSEPACK_ENCODING_DUALQUAT ? 2 : 3;
    const auto layout = palette::runs_layout(
        clip.runs.encoding, palette_.layout.texel_format, static_cast<std::uint32_t>(animal_.bones.size()),
        clip.runs.longest + 1,
        clip.runs.texels.size() / (palette_.layout.texel_format == POSEPACK_TEXEL_RGBA16F ? 8 : 16), texels);
    if (!layout) return layout.issue();
    one.layout = layout.value();
    clip.first_row = 0;
    clip.closing_row = false;
    one.clips.push_back(std::move(clip));
    const auto container = palette::write_container(animal_, one, "{}");
    auto stats = measure::measure_error(animal_, one, container, points_, no_normals_);
    if (!stats) return stats.issue();
    return stats.value().clips.front();
}

base::Result<ChosenRows> RowChooser::choose(std::uint32_t index, fit::Form form, const Limits& bound) {
    const PaletteClip& clip = palette_.clips[index];
    const animal::Clip& source = animal_.clips[clip.source];
    const std::uint32_t row_bytes = (form == fit::Form::dualquat ? 2 : 3) *
                                    (palette_.layout.texel_format == POSEPACK_TEXEL_RGBA16F ? 8 : 16);
    const double floor = 0.25 * std::min(bound.max, std::isfinite(bound.p999) ? bound.p999 : bound.max);
    ChosenRows best;
    std::vector<Attempt> attempts;
    ClipError nearest;
    double nearest_share = HUGE_VAL;
    const palette::Hemispheres before = hemispheres_;
    for (const Fineness& fineness : kFineness) {
        hemispheres_ = before;
        const fit::Tracks tracks = fit::sample_tracks(animal_, source, clip.plan, palette_.spaces, form,
                                                      fineness.samples_per_key, hemispheres_);
        fit::RowSelector selector(tracks, bone_points_, points_.size(), row_bytes, palette_.reach(), floor,
                                  fineness.rows_per_key);
        Limits limits = bound;
        limits.max = std::max(0.5 * bound.max, bound.max - kRounding);
        Limits base = limits;
        Search search;
        for (int attempt = 0; attempt < kMostTries; ++attempt) {
            if (attempt > 0) limits = scaled(base, search.scale());
            const auto selection = selector.select(limits);
            if (!selection) break;
            auto encoded = encode(tracks, selector, selection->rows);
            if (!encoded) break;
            PaletteClip trial = clip;
            trial.runs = encoded->runs;
            trial.bounds = encoded->bounds;
            const auto error = measure(std::move(trial));
            if (!error) return error.issue();
            const Shares shares = shares_of(error.value(), bound);
            const bool keeps = shares.largest() <= 1.0;
            attempts.push_back({encoded->runs.encoding, bytes_of(encoded->runs), error.value().max,
                                error.value().p999, error.value().rms, keeps});
            if (shares.largest() < nearest_share) {
                nearest_share = shares.largest();
                nearest = error.value();
            }
            if (keeps && (best.runs.is_empty() || bytes_of(encoded->runs) < bytes_of(best.runs)))
                best = std::move(*encoded);
            if (attempt == 0) {
                if (keeps && shares.largest() >= kCloseEnough) break;
                base = corrected(bound, selection->expected, error.value());
            } else if (!search.step(shares.largest())) {
                break;
            }
        }
        if (!best.runs.is_empty()) break;
    }
    if (best.runs.is_empty())
        return base::Issue{
            base::IssueCode::lim_bound, source.name,
            nearest_share < HUGE_VAL
                ? fmt::format("expected errors within max {:.3g}, p99.9 {:.3g} of R, found max {:.3g}, p99.9 "
                              "{:.3g} at {:.4g} s, bone '{}', with {} rows a key",
                              bound.max, bound.p999, nearest.max, nearest.p999, nearest.time_s,
                              nearest.bone < animal_.bones.size() ? animal_.bones[nearest.bone].name : "-",
                              kFineness[1].rows_per_key)
                : fmt::format("expected errors within max {:.3g} of R, found more with {} rows a key",
                              bound.max, kFineness[1].rows_per_key)};
    best.attempts = std::move(attempts);
    return best;
}

base::Status choose_rows(const animal::Animal& animal, const motion::SkinSet& points,
                         const std::vector<Limits>& bounds, std::uint8_t texel_format,
                         palette::RoundingAids& aids, palette::Palette& palette,
                         std::vector<std::vector<Attempt>>& attempts) {
    std::vector<fit::Form> forms;
    double largest_change = 0.0;
    for (const PaletteClip& clip : palette.clips) {
        motion::ClipSampler sampler(animal, animal.clips[clip.source]);
        const palette::DualquatFit dualquats =
            palette::fit_dualquat(sampler, clip.plan, palette.spaces, aids.moments, palette.reach());
        forms.push_back(dualquats.unfit ? fit::Form::affine : fit::Form::dualquat);
        if (!dualquats.unfit) largest_change = std::max(largest_change, dualquats.largest_change);
    }
    const bool any_dualquat = std::count(forms.begin(), forms.end(), fit::Form::dualquat) > 0;
    if (any_dualquat)
        palette.dualquat_length = static_cast<float>(palette::scale_length(palette.reach(), largest_change));
    aids.dualquat_length = palette.dualquat_length;
    palette.layout.texel_format = texel_format;

    RowChooser chooser(animal, palette, aids, points);
    std::vector<ChosenRows> chosen;
    for (std::uint32_t c = 0; c < palette.clips.size(); ++c) {
        auto rows = chooser.choose(c, forms[c], bounds[c]);
        // Matrices hold what dual quaternions of halves do not: far from the centre they round better.
        if (!rows && rows.issue().code == base::IssueCode::lim_bound && forms[c] == fit::Form::dualquat) {
            auto matrices = chooser.choose(c, fit::Form::affine, bounds[c]);
            if (matrices) rows = std::move(matrices);
        }
        if (!rows) return rows.issue();
        chosen.push_back(std::move(rows).value());
    }
    std::uint32_t next_row = 0;
    std::uint64_t texels = 0;
    std::uint8_t encoding = chosen.front().runs.encoding;
    const std::uint32_t texel_bytes = posepack_texel_bytes(texel_format);
    for (std::uint32_t c = 0; c < palette.clips.size(); ++c) {
        PaletteClip& clip = palette.clips[c];
        clip.runs = std::move(chosen[c].runs);
        attempts.push_back(std::move(chosen[c].attempts));
        clip.bounds = chosen[c].bounds;
        clip.closing_row = false;
        clip.first_row = next_row;
        next_row += clip.stored_rows();
        if (next_row > POSEPACK_MAX_ROWS)
            return base::Issue{base::IssueCode::lim_rows, animal.clips[clip.source].name,
                               fmt::format("expected at most {} rows, found {} in the clips up to this one",
                                           POSEPACK_MAX_ROWS, next_row)};
        texels += clip.runs.texels.size() / texel_bytes;
        if (clip.runs.encoding != encoding) encoding = POSEPACK_MIXED;
    }
    const auto layout =
        palette::runs_layout(encoding, texel_format, static_cast<std::uint32_t>(animal.bones.size()),
                             next_row, texels, posepack_encoding_texels(palette.clips.back().runs.encoding));
    if (!layout) return layout.issue();
    palette.layout = layout.value();
    return {};
}

}  // namespace posepack::choose
