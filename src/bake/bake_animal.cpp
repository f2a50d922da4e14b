// SPDX-License-Identifier: MIT
#include "bake/bake_animal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "animal/read_animal.hpp"
#include "animal/unused_bones.hpp"
#include "bake/influences.hpp"
#include "bake/records.hpp"
#include "bake/select_clips.hpp"
#include "base/sha256.hpp"
#include "choose/choose_rows.hpp"
#include "measure/measure_error.hpp"
#include "motion/skin_set.hpp"
#include "palette/container_writer.hpp"
#include "palette/dualquat_fit.hpp"
#include "palette/encode.hpp"
#include "posepack/loader.h"

namespace posepack::bake {
namespace {

using animal::Animal;
using base::Issue;
using base::IssueCode;
using palette::Box;
using palette::Palette;

class Stopwatch {
 public:
    double elapsed_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

// What determines the bytes of a container, as canonical JSON: stored in it, and digested in its header.
std::string recipe_text(const recipe::AnimalEntry& entry, const base::Sha256& glb_digest, bool measure) {
    const nlohmann::json recipe{{"bake_abi", POSEPACK_BAKE_ABI},
                                {"entry", nlohmann::json::parse(entry.canonical_json)},
                                {"glb_sha256", base::hexadecimal(glb_digest)},
                                {"measure", measure}};
    return recipe.dump();
}

double rest_radius(const Animal& animal, const motion::SkinSet& points) {
    std::vector<glm::dvec3> posed(points.size());
    motion::skin(points, motion::rest_pose(animal), posed);
    return motion::sphere_around(posed).radius;
}

Issue too_many_rows(const std::string& clip, std::uint64_t rows) {
    return {IssueCode::lim_rows, clip,
            fmt::format("expected at most {} rows, found {} in the clips up to this one", POSEPACK_MAX_ROWS,
                        rows)};
}

// What a seam that counts as closed may miss by: a share of the largest error allowed.
constexpr double kSeamShare = 0.25;

// The bound of each clip as fractions of R: its own, else the animal's.
std::vector<fit::Limits> clip_limits(const recipe::AnimalEntry& entry, const std::vector<ClipChoice>& choices,
                                     const Palette& palette) {
    const double radius_m = palette.radius * palette.metres_per_unit;
    const auto fraction = [&](const std::optional<recipe::ErrorLimit>& limit) {
        return limit ? limit->fraction(radius_m) : HUGE_VAL;
    };
    std::vector<fit::Limits> limits;
    for (const ClipChoice& choice : choices) {
        const recipe::ErrorBound& bound = choice.bound ? *choice.bound : *entry.output.bound;
        limits.push_back({fraction(bound.max), fraction(bound.p999), fraction(bound.rms)});
    }
    return limits;
}

base::Status plan_clips(const Animal& animal, const std::vector<ClipChoice>& choices,
                        const std::vector<fit::Limits>& bounds, const motion::SkinSet& points,
                        Palette& palette, std::vector<Issue>& findings) {
    std::uint64_t rows = 0;
    for (std::size_t c = 0; c < choices.size(); ++c) {
        const ClipChoice& choice = choices[c];
        const animal::Clip& clip = animal.clips[choice.source];
        motion::ClipSampler sampler(animal, clip);
        motion::RowWish wish = choice.wish;
        if (!bounds.empty()) wish.largest_gap = kSeamShare * bounds[c].max;
        palette::PaletteClip out;
        out.source = choice.source;
        out.plan = motion::plan_rows(animal, clip, sampler, points, palette.radius, wish);
        out.speed_mps = choice.speed_mps;
        out.stride_phase = choice.stride_phase;
        rows += out.plan.row_count;
        if (rows > POSEPACK_MAX_ROWS) return too_many_rows(clip.name, rows);
        findings.insert(findings.end(), out.plan.remarks.begin(), out.plan.remarks.end());
        palette.clips.push_back(std::move(out));
    }
    return {};
}

palette::Spaces choose_spaces(const Animal& animal, const Palette& palette) {
    std::vector<palette::PlannedClip> clips;
    for (const palette::PaletteClip& clip : palette.clips)
        clips.push_back({&animal.clips[clip.source], &clip.plan});
    return palette::normalise(animal, clips, palette.radius);
}

// Refuses what dual quaternions cannot hold, finds the clips that need a closing row, and chooses L.
base::Status fit_dualquats(const Animal& animal, std::span<const palette::BoneMoment> moments,
                           Palette& palette) {
    double largest_change = 0.0;
    for (palette::PaletteClip& clip : palette.clips) {
        motion::ClipSampler sampler(animal, animal.clips[clip.source]);
        const palette::DualquatFit fit =
            palette::fit_dualquat(sampler, clip.plan, palette.spaces, moments, palette.reach());
        if (const auto& unfit = fit.unfit)
            return Issue{
                IssueCode::lim_similarity, animal.clips[clip.source].name,
                fmt::format("expected bone '{}' to turn and scale evenly, found a stretch of {:.4g} to 1 "
                            "at row {} ({:.4g} s)",
                            animal.bones[unfit->bone].name, unfit->ratio, unfit->row,
                            clip.plan.row_time_s(unfit->row))};
        clip.closing_row = fit.closing_row;
        largest_change = std::max(largest_change, fit.largest_change);
    }
    palette.dualquat_length = static_cast<float>(palette::scale_length(palette.reach(), largest_change));
    return {};
}

// Rows follow each other, closing rows included. Returns how many there are.
base::Result<std::uint32_t> number_rows(const Animal& animal, Palette& palette) {
    std::uint32_t rows = 0;
    for (palette::PaletteClip& clip : palette.clips) {
        clip.first_row = rows;
        rows += clip.stored_rows();
        if (rows > POSEPACK_MAX_ROWS) return too_many_rows(animal.clips[clip.source].name, rows);
    }
    return rows;
}

base::Status sample_clips(const Animal& animal, const palette::RoundingAids& aids, Palette& palette) {
    palette::RowEncoder encoder(palette.layout, aids);
    const palette::BoneBoxes boxes(animal, palette.spaces);
    std::vector<motion::Affine> bones(animal.bones.size());
    std::vector<float> stored(animal.bones.size() * 12);
    const auto grow_by_arcs = [&](Box& bounds) {
        std::array<std::vector<float>, 5> quarters;
        for (std::size_t i = 0; i < quarters.size(); ++i) {
            quarters[i].resize(stored.size());
            encoder.between(0.25f * static_cast<float>(i), quarters[i]);
        }
        boxes.add_arcs(quarters, bounds);
    };
    const bool has_arcs = palette.layout.encoding == POSEPACK_ENCODING_DUALQUAT;
    for (palette::PaletteClip& clip : palette.clips) {
        motion::ClipSampler sampler(animal, animal.clips[clip.source]);
        encoder.begin_clip();
        for (std::uint32_t row = 0; row < clip.plan.row_count; ++row) {
            motion::sample_row(sampler, clip.plan, row, bones);
            palette.spaces.enter(bones);
            const std::uint32_t bad = encoder.encode(clip.first_row + row, bones, stored);
            if (bad < bones.size()) {
                const bool half = palette.layout.texel_format == POSEPACK_TEXEL_RGBA16F;
                return Issue{
                    half ? IssueCode::lim_half_range : IssueCode::lim_float_range,
                    animal.clips[clip.source].name,
                    fmt::format("expected values up to {:.6g}, found bone '{}' beyond at row {} ({:.4g} s)",
                                half ? 65504.0 : 3.4e38, animal.bones[bad].name, row,
                                clip.plan.row_time_s(row))};
            }
            boxes.add(stored, clip.bounds);
            if (has_arcs && row > 0) grow_by_arcs(clip.bounds);
        }
        if (has_arcs && clip.plan.wrap == recipe::Wrap::loop) {
            encoder.close_clip(clip.closing_row ? clip.first_row + clip.plan.row_count : animal::kNone);
            grow_by_arcs(clip.bounds);
        }
        if (!clip.bounds.fits_floats())
            return Issue{
                IssueCode::lim_float_range, animal.clips[clip.source].name,
                "expected bounds that fit 32-bit floats, found a skinned mesh that leaves their range"};
    }
    palette.pixels = encoder.finish();
    return {};
}

// A gap is stored as a fraction of the radius, and a motion may be beyond all measure of a tiny model.
base::Status check_seam_gaps(const Animal& animal, const Palette& palette) {
    for (const palette::PaletteClip& clip : palette.clips)
        if (!std::isfinite(static_cast<float>(clip.plan.seam_gap)))
            return Issue{
                IssueCode::glb_no_extent, animal.clips[clip.source].name,
                fmt::format("expected ends of the clip at most 3.4e38 radii apart, found {:.3g} radii "
                            "of {:.3g}",
                            clip.plan.seam_gap, palette.radius)};
    return {};
}

// Rows by a bound, in floats where halves do not keep it: far from an animal's centre halves are too coarse
// for narrow bounds.
base::Status choose_rows(const recipe::AnimalEntry& entry, const Animal& animal,
                         const motion::SkinSet& points, const std::vector<fit::Limits>& bounds,
                         const choose::Means& means, palette::RoundingAids& aids, Palette& palette,
                         std::vector<Issue>& findings, std::vector<std::vector<choose::Attempt>>& attempts) {
    if (entry.output.texel_format == recipe::TexelFormat::rgba32f)
        return choose::choose_rows(animal, points, bounds, POSEPACK_TEXEL_RGBA32F, aids, palette, attempts,
                                   means);
    auto halves =
        choose::choose_rows(animal, points, bounds, POSEPACK_TEXEL_RGBA16F, aids, palette, attempts, means);
    if (halves || halves.issue().code != IssueCode::lim_bound) return halves;
    auto floats =
        choose::choose_rows(animal, points, bounds, POSEPACK_TEXEL_RGBA32F, aids, palette, attempts, means);
    if (!floats) return floats;
    findings.push_back({IssueCode::warn_floats, halves.issue().where, halves.issue().detail});
    return {};
}

base::Result<Palette> make_palette(const recipe::AnimalEntry& entry, const Animal& animal,
                                   const motion::SkinSet& points, const choose::Means& means,
                                   std::vector<Issue>& findings,
                                   std::vector<std::vector<choose::Attempt>>& attempts) {
    auto choices = select_clips(animal, entry);
    if (!choices) return choices.issue();
    auto states = choose_states(animal, entry, choices.value());
    if (!states) return states.issue();
    Palette palette;
    palette.states = std::move(states.value().states);
    palette.default_state = states.value().default_state;
    palette.forward = entry.forward;
    palette.metres_per_unit = entry.metres_per_unit;
    palette.radius = rest_radius(animal, points);
    if (const auto radius_m = static_cast<float>(palette.radius * palette.metres_per_unit);
        !(radius_m > 0.0f) || !std::isfinite(radius_m))
        return Issue{IssueCode::glb_no_extent, "",
                     fmt::format("expected a rest pose with a size, found a radius of {:.3g} m", radius_m)};
    const std::vector<fit::Limits> bounds =
        entry.output.bound ? clip_limits(entry, choices.value(), palette) : std::vector<fit::Limits>{};
    if (auto status = plan_clips(animal, choices.value(), bounds, points, palette, findings); !status)
        return status.issue();
    palette.spaces =
        entry.output.is_normalised() ? choose_spaces(animal, palette) : palette::model_space(animal);
    palette::RoundingAids aids;
    aids.halves = palette.spaces.normalised ? palette::Halves::normal : palette::Halves::all;
    aids.moments = palette::bone_moments(points, palette.spaces, animal.bones.size(), palette.reach());
    if (entry.output.bound) {
        if (auto status =
                choose_rows(entry, animal, points, bounds, means, aids, palette, findings, attempts);
            !status)
            return status.issue();
        if (auto status = check_seam_gaps(animal, palette); !status) return status.issue();
        return palette;
    }
    if (entry.output.encoding == recipe::Encoding::dualquat) {
        if (auto status = fit_dualquats(animal, aids.moments, palette); !status) return status.issue();
        aids.dualquat_length = palette.dualquat_length;
    }
    const auto row_count = number_rows(animal, palette);
    if (!row_count) return row_count.issue();
    auto layout = palette::choose_layout(entry.output, static_cast<std::uint32_t>(animal.bones.size()),
                                         row_count.value());
    if (!layout) return layout.issue();
    palette.layout = layout.value();
    if (auto status = sample_clips(animal, aids, palette); !status) return status.issue();
    if (auto status = check_seam_gaps(animal, palette); !status) return status.issue();
    return palette;
}

animal::ReadOptions read_options(const recipe::AnimalEntry& entry, const AnimalOptions& options) {
    return {options.strict, options.allow_data_uris, entry.output.influences};
}

// Bins of equal width over all clips, `columns` of them in all.
base::Result<measure::ErrorHeat> heat_of(const Animal& animal, const Palette& palette,
                                         std::span<const std::uint8_t> container,
                                         const motion::SkinSet& points, std::span<const measure::Look> looks,
                                         std::uint32_t columns) {
    double total_s = 0.0;
    for (const palette::PaletteClip& clip : palette.clips) total_s += clip.plan.duration_s;
    return measure::measure_heat(animal, palette, container, points, looks,
                                 total_s > 0.0 ? total_s / columns : 1.0);
}

}  // namespace

base::Status check_own_bytes(std::span<const std::uint8_t> container) {
    posepack_view view;
    const posepack_result result = posepack_open(&view, container.data(), container.size());
    if (result == POSEPACK_OK) return {};
    return Issue{IssueCode::internal, "",
                 fmt::format("expected a container that the loader opens, it answers {} to the one just made",
                             posepack_result_name(result))};
}

base::Result<BakedAnimal> bake_animal(const recipe::AnimalEntry& entry, std::span<const std::uint8_t> glb,
                                      const AnimalOptions& options) {
    const Stopwatch bake_watch;
    BakedAnimal baked;
    const base::Sha256 glb_digest = base::sha256(glb);
    auto animal = animal::read_animal(glb, read_options(entry, options));
    if (!animal) return base::at(entry.model, animal.issue());
    if (entry.output.drops_unused_bones()) animal::drop_unused_bones(animal.value());
    for (const Issue& finding : animal.value().findings)
        baked.findings.push_back(base::at(entry.model, finding));
    const motion::SkinSet points = motion::unique_points(animal.value());
    std::vector<Issue> remarks;
    std::vector<std::vector<choose::Attempt>> attempts;
    auto palette = make_palette(entry, animal.value(), points, options.means, remarks, attempts);
    if (!palette) return base::at(entry.id, palette.issue());
    for (const Issue& remark : remarks) baked.findings.push_back(base::at(entry.id, remark));

    const std::string recipe = recipe_text(entry, glb_digest, options.measure);
    baked.container = palette::write_container(animal.value(), palette.value(), recipe);
    palette.value().pixels = {};  // the container has them now
    baked.bake_s = bake_watch.elapsed_s();

    const Stopwatch measure_watch;
    if (options.measure) {
        const motion::SkinSet normals = motion::unique_normals(animal.value());
        auto stats =
            measure::measure_error(animal.value(), palette.value(), baked.container, points, normals);
        if (!stats) return base::at(entry.id, stats.issue());
        if (options.heat_columns > 0) {
            auto heat = heat_of(animal.value(), palette.value(), baked.container, points, stats.value().looks,
                                options.heat_columns);
            if (!heat) return base::at(entry.id, heat.issue());
            baked.heat = std::move(heat).value();
        }
        palette::store_errors(baked.container, stats.value().clips);
        baked.record = describe(entry, animal.value(), palette.value(), &stats.value());
        if (auto status = measure_influences(animal.value(), palette.value(), baked); !status)
            return base::at(entry.id, status.issue());
    } else {
        baked.record = describe(entry, animal.value(), palette.value(), nullptr);
    }
    if (auto status = check_own_bytes(baked.container); !status) return base::at(entry.id, status.issue());
    baked.measure_s = measure_watch.elapsed_s();

    recipe::BakeRecord& record = baked.record;
    for (std::size_t c = 0; c < attempts.size(); ++c) record.clips[c].tried = tried(attempts[c]);
    record.container_bytes = baked.container.size();
    record.container_sha256 = base::hexadecimal(base::sha256(baked.container));
    record.model_bytes = glb.size();
    record.model_sha256 = base::hexadecimal(glb_digest);
    record.recipe_sha256 = base::hexadecimal(
        base::sha256({reinterpret_cast<const std::uint8_t*>(recipe.data()), recipe.size()}));
    for (const Issue& finding : baked.findings) record.remarks.push_back(base::format_issue(finding));
    if (options.compare_vat && !palette.value().has_runs()) {
        record.has_vram = true;
        record.vram = vram_of(record.row_count, record.bone_count, record.vertex_count);
    }
    return baked;
}

}  // namespace posepack::bake
