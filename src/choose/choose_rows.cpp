// SPDX-License-Identifier: MIT
#include "choose/choose_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fit/polyline.hpp"
#include "fit/slots.hpp"
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
constexpr double kRounding = 3e-4;     // of R: what rounding to halves adds to the largest error
constexpr double kShortestReal = 0.75;
constexpr int kMostSlotTries = 6;
constexpr int kMostWidenings = 100;
constexpr double kWidening = 1.25;
constexpr double kClearlySmaller = 0.95;  // slots cost a reader a step more than runs
// Of the tightest limit: how far the lines that slots begin with may lie from the tracks. Least squares
// halves that, and most places are nearer.
constexpr double kFirstChord = 3.0;
constexpr double kRmsToChord = 4.0;
constexpr double kFarOff = 1.5;  // the share of the bound of rows that single bones do not keep it with

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

// For messages; those that `bound` does not bound are left out.
std::string figures(const Limits& bound, double max, double p999, double rms) {
    std::string out = fmt::format("max {:.3g}", max);
    if (std::isfinite(bound.p999)) out += fmt::format(", p99.9 {:.3g}", p999);
    if (std::isfinite(bound.rms)) out += fmt::format(", rms {:.3g}", rms);
    return out;
}

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
    return runs.texels.size() + runs.entries.size() * std::uint64_t{POSEPACK_RUN_BYTES} +
           runs.slots.size() * std::uint64_t{POSEPACK_SLOT_BYTES};
}

// The mean square of a bone's distances, squared units of palette space, that rounding may leave: a third of
// the tightest limit.
double enough_of(const Limits& bound, double reach) {
    const double limit = std::min({0.5 * bound.max, bound.p999, bound.rms}) * reach / 3.0;
    return limit * limit;
}

// Whether a bone has more than one row. Samples may all miss a motion.
bool any_moves(const fit::Selection& selection) {
    return std::any_of(selection.rows.begin(), selection.rows.end(),
                       [](const BoneRows& rows) { return rows.interval_count > 0; });
}

// Errors of single bones below this are summed, but not counted.
double floor_of(const Limits& bound) {
    return 0.25 * std::min(bound.max, std::isfinite(bound.p999) ? bound.p999 : bound.max);
}

}  // namespace

RowChooser::RowChooser(const animal::Animal& animal, const palette::Palette& palette,
                       const palette::RoundingAids& aids, const motion::SkinSet& points, const Means& means)
    : animal_(animal),
      palette_(palette),
      aids_(aids),
      points_(points),
      means_(means),
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
                                             std::vector<BoneRows> rows, const Limits& bound) const {
    give_weightless_rows(rows);
    const bool dualquat = tracks.form == fit::Form::dualquat;
    const std::size_t width = fit::numbers_of(tracks.form);
    palette::RunEncoder encoder(dualquat ? POSEPACK_ENCODING_DUALQUAT : POSEPACK_ENCODING_AFFINE,
                                palette_.layout.texel_format, aids_, rows.size(),
                                enough_of(bound, palette_.reach()));
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
    for (const fit::Slot& slot : tracks.slots.slots)
        out.runs.slots.push_back(slot.row | slot.offset << 16 | slot.span << 24);
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

// What was tried for one clip under one bound, and what is the best of it.
class RowChooser::Contest {
 public:
    Contest(const PaletteClip& clip, const Limits& bound, double rounding)
        : clip(clip), bound(bound), wanted(bound) {
        wanted.max = std::max(0.5 * bound.max, bound.max - rounding);
    }

    void enter(ChosenRows rows, const Limits& expected, const ClipError& error) {
        const std::uint64_t bytes = bytes_of(rows.runs);
        share = shares_of(error, bound).largest();
        attempts.push_back({rows.runs.encoding, !rows.runs.slots.empty(), bytes, error.max, error.p999,
                            error.rms, share <= 1.0});
        correction = corrected(wanted, expected, error);
        if (share < nearest_share) {
            nearest_share = share;
            nearest = error;
        }
        if (share <= 1.0 && bytes < best_bytes()) best = std::move(rows);
    }
    // The share that the same rows took before.
    std::optional<double> known_share(const std::vector<BoneRows>& rows, const fit::SlotPlan& plan) const {
        for (const Known& known : known_)
            if (known.rows == rows && known.slots == plan.slots) return known.share;
        return std::nullopt;
    }
    void remember(std::vector<BoneRows> rows, const fit::SlotPlan& plan) {
        known_.push_back({std::move(rows), plan.slots, share});
    }
    // Rows of other samples are others.
    void forget() { known_.clear(); }

    bool has_best() const { return !best.runs.is_empty(); }
    std::uint64_t best_bytes() const { return has_best() ? bytes_of(best.runs) : UINT64_MAX; }

    const PaletteClip& clip;
    const Limits bound;
    Limits wanted;       // the bound, less what rounding adds
    Limits correction;   // limits for single bones that should take up the bound, by the last try
    double share = 0.0;  // of the bound, that the last try took
    ChosenRows best;
    std::vector<Attempt> attempts;
    ClipError nearest;
    double nearest_share = HUGE_VAL;

 private:
    struct Known {
        std::vector<BoneRows> rows;
        std::vector<fit::Slot> slots;
        double share;
    };
    std::vector<Known> known_;
};

base::Result<bool> RowChooser::enter(const fit::Tracks& tracks, fit::RowSelector& selector,
                                     const fit::Selection& selection, Contest& contest) const {
    if (const auto known = contest.known_share(selection.rows, tracks.slots)) {
        contest.share = *known;
        return true;
    }
    auto encoded = encode(tracks, selector, selection.rows, contest.bound);
    if (!encoded) return false;
    PaletteClip trial = contest.clip;
    trial.runs = encoded->runs;
    trial.bounds = encoded->bounds;
    const auto error = measure(std::move(trial));
    if (!error) return error.issue();
    contest.enter(std::move(*encoded), selection.expected, error.value());
    contest.remember(selection.rows, tracks.slots);
    return true;
}

base::Status RowChooser::try_runs(const fit::Tracks& tracks, fit::RowSelector& selector,
                                  Contest& contest) const {
    Limits limits = contest.wanted;
    Search search;
    Limits base = limits;
    for (int attempt = 0; attempt < kMostTries; ++attempt) {
        if (attempt > 0) limits = scaled(base, search.scale());
        const auto selection = selector.select(limits);
        if (!selection) break;
        const auto entered = enter(tracks, selector, *selection, contest);
        if (!entered) return entered.issue();
        if (!entered.value()) break;
        if (attempt == 0) {
            if (contest.share <= 1.0 && contest.share >= kCloseEnough) break;
            base = contest.correction;
        } else if (!search.step(contest.share)) {
            break;
        }
    }
    return {};
}

// What is reached where no rows keep the bound: rows under limits that are widened until there are some.
base::Status RowChooser::try_wider(const fit::Tracks& tracks, fit::RowSelector& selector,
                                   Contest& contest) const {
    Limits limits = contest.wanted;
    for (int times = 0; times < kMostWidenings; ++times) {
        limits = scaled(limits, kWidening);
        const auto selection = selector.select(limits);
        if (!selection) continue;
        const auto entered = enter(tracks, selector, *selection, contest);
        return entered ? base::Status{} : entered.issue();
    }
    return {};
}

// Rows at uneven times, where they take clearly fewer bytes than runs, or keep the bound where no runs do.
base::Result<bool> RowChooser::try_slots(fit::Tracks& tracks, Contest& contest) const {
    if (!means_.slots || tracks.interval_count == 0 || tracks.step) return false;
    bool is_rough = false;
    const animal::Clip& source = animal_.clips[contest.clip.source];
    motion::ClipSampler sampler(animal_, source);
    const std::vector<double> jumps_s = sampler.jump_times_s();
    const double enough = contest.has_best() ? kClearlySmaller * contest.best_bytes() : HUGE_VAL;
    const double first =
        kFirstChord * std::min({contest.bound.max, contest.bound.p999, kRmsToChord * contest.bound.rms});
    Search search;
    for (int attempt = 0; attempt < kMostSlotTries; ++attempt) {
        fit::SlotPlan plan = fit::plan_slots(tracks, bone_points_, first * search.scale(), palette_.reach(),
                                             contest.clip.plan.period_s, jumps_s);
        if (plan.slots.empty()) break;
        is_rough = plan.is_rough;
        fit::bend(tracks, std::move(plan));
        fit::RowSelector selector(tracks, bone_points_, points_.size(), row_bytes(tracks.form),
                                  palette_.reach(), floor_of(contest.bound), 1, means_.rows);
        const auto selection = selector.select(contest.wanted);
        double share = kFarOff;
        if (selection) {
            if (!any_moves(*selection)) break;  // slots lead to rows
            if (expected_bytes(*selection, tracks) >= enough) return false;
            const auto entered = enter(tracks, selector, *selection, contest);
            if (!entered) return entered.issue();
            if (!entered.value()) break;
            share = contest.share;
        }
        if (!search.step(share)) break;
    }
    return is_rough;
}

std::uint32_t RowChooser::row_bytes(fit::Form form) const {
    return (form == fit::Form::dualquat ? 2 : 3) * posepack_texel_bytes(palette_.layout.texel_format);
}

// Of the runs and slots that a selection makes.
double RowChooser::expected_bytes(const fit::Selection& selection, const fit::Tracks& tracks) const {
    double rows = 0.0;
    for (const BoneRows& bone : selection.rows)
        if (bone.like == animal::kNone) rows += bone.interval_count + 1.0;
    return rows * row_bytes(tracks.form) + selection.rows.size() * double{POSEPACK_RUN_BYTES} +
           tracks.slots.slots.size() * double{POSEPACK_SLOT_BYTES};
}

base::Result<ChosenRows> RowChooser::choose(std::uint32_t index, fit::Form form, const Limits& bound) {
    const PaletteClip& clip = palette_.clips[index];
    const animal::Clip& source = animal_.clips[clip.source];
    const bool is_half = palette_.layout.texel_format == POSEPACK_TEXEL_RGBA16F;
    Contest contest(clip, bound, is_half ? kRounding : 0.0);
    const palette::Hemispheres before = hemispheres_;
    bool is_rough = false;
    for (const Fineness& fineness : kFineness) {
        if (contest.has_best() && !is_rough) break;
        contest.forget();
        hemispheres_ = before;
        fit::Tracks tracks = fit::sample_tracks(animal_, source, clip.plan, palette_.spaces, form,
                                                fineness.samples_per_key, hemispheres_);
        fit::RowSelector selector(tracks, bone_points_, points_.size(), row_bytes(form), palette_.reach(),
                                  floor_of(bound), fineness.rows_per_key, means_.rows);
        if (!contest.has_best())
            if (auto status = try_runs(tracks, selector, contest); !status) return status.issue();
        if (contest.attempts.empty() && &fineness == std::end(kFineness) - 1)
            if (auto status = try_wider(tracks, selector, contest); !status) return status.issue();
        const auto rough = try_slots(tracks, contest);
        if (!rough) return rough.issue();
        is_rough = rough.value();
    }
    if (!contest.has_best())
        return base::Issue{
            base::IssueCode::lim_bound, source.name,
            contest.nearest_share < HUGE_VAL
                ? fmt::format(
                      "expected errors within {} of R, found {} at {:.4g} s, bone '{}', with {} rows a key",
                      figures(bound, bound.max, bound.p999, bound.rms),
                      figures(bound, contest.nearest.max, contest.nearest.p999, contest.nearest.rms),
                      contest.nearest.time_s,
                      contest.nearest.bone < animal_.bones.size() ? animal_.bones[contest.nearest.bone].name
                                                                  : "-",
                      kFineness[1].rows_per_key)
                : fmt::format("expected errors within max {:.3g} of R, found more with {} rows a key",
                              bound.max, kFineness[1].rows_per_key)};
    contest.best.attempts = std::move(contest.attempts);
    return std::move(contest.best);
}

base::Status choose_rows(const animal::Animal& animal, const motion::SkinSet& points,
                         const std::vector<Limits>& bounds, std::uint8_t texel_format,
                         palette::RoundingAids& aids, palette::Palette& palette,
                         std::vector<std::vector<Attempt>>& attempts, const Means& means) {
    std::vector<fit::Form> forms;
    double largest_change = 0.0;
    for (const PaletteClip& clip : palette.clips) {
        motion::ClipSampler sampler(animal, animal.clips[clip.source]);
        const palette::DualquatFit dualquats =
            palette::fit_dualquat(sampler, clip.plan, palette.spaces, aids.moments, palette.reach());
        const bool fits = means.dual_quaternions && !dualquats.unfit;
        forms.push_back(fits ? fit::Form::dualquat : fit::Form::affine);
        if (fits) largest_change = std::max(largest_change, dualquats.largest_change);
    }
    const bool any_dualquat = std::count(forms.begin(), forms.end(), fit::Form::dualquat) > 0;
    if (any_dualquat)
        palette.dualquat_length = static_cast<float>(palette::scale_length(palette.reach(), largest_change));
    aids.dualquat_length = palette.dualquat_length;
    palette.layout.texel_format = texel_format;

    RowChooser chooser(animal, palette, aids, points, means);
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
    if (encoding == POSEPACK_ENCODING_AFFINE) palette.dualquat_length = 0.0f;
    return {};
}

}  // namespace posepack::choose
