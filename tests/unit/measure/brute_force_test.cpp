// SPDX-License-Identifier: MIT
// The whole measurement against a second one: naive loops over vertices and times in long double, with
// curves, skinning, time law and percentiles of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure/error_heat.hpp"
#include "measure/measure_error.hpp"
#include "posepack/loader.h"
#include "support/baked.hpp"
#include "support/naive_pose.hpp"
#include "support/sample_models.hpp"

namespace posepack::measure {
namespace {

using support::Matrix34;
using support::Point;
using support::Real;

struct Sample {
    double time_s;
    std::size_t vertex;
    double error;       // model units
    double normal_deg;  // angle; -1 for a zero normal
};

bool has_splines(const animal::Clip& clip) {
    return std::any_of(clip.channels.begin(), clip.channels.end(), [](const animal::Channel& channel) {
        return channel.interpolation == animal::Interpolation::cubic_spline;
    });
}

std::vector<double> naive_times(const animal::Animal& animal, const palette::PaletteClip& clip) {
    const animal::Clip& source = animal.clips[clip.source];
    std::vector<double> marks{clip.plan.duration_s};
    std::vector<double> beside_jumps;
    for (const animal::Channel& channel : source.channels) {
        for (std::uint32_t k = 0; k < channel.key_count; ++k) {
            const double key_s = animal.key_times[channel.first_time + k] - source.start_s;
            marks.push_back(key_s);
            // Every key of the one STEP channel has another value than the one before.
            if (channel.interpolation == animal::Interpolation::step && k > 0)
                for (const double t : {key_s - 1.5e-6, key_s + 1.5e-6})
                    if (t < clip.plan.duration_s) beside_jumps.push_back(t);
        }
    }
    const bool loop = clip.plan.wrap == recipe::Wrap::loop;
    for (std::uint32_t row = 0; row < clip.plan.row_count; ++row) {
        const double intervals = std::max(1u, loop ? clip.plan.row_count : clip.plan.row_count - 1);
        const double t = clip.plan.period_s / intervals * row;
        if (t <= clip.plan.duration_s) marks.push_back(t);
    }
    std::sort(marks.begin(), marks.end());
    std::vector<double> kept;
    for (const double t : marks)
        if (kept.empty() || t - kept.back() >= 1e-6) kept.push_back(t);
    std::vector<double> times;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (i > 0)
            for (const double part : {0.25, 0.5, 0.75})
                if (has_splines(source) || part == 0.5)
                    times.push_back(kept[i - 1] + (kept[i] - kept[i - 1]) * part);
        times.push_back(kept[i]);
    }
    times.insert(times.end(), beside_jumps.begin(), beside_jumps.end());
    return times;
}

// The matrices that a reader blends at one time, in float as a shader does.
std::vector<Matrix34> shown(const posepack_view& view, const palette::PaletteClip& clip, double time_s) {
    const motion::RowPlan& plan = clip.plan;
    const bool loop = plan.wrap == recipe::Wrap::loop;
    const double intervals = loop ? plan.row_count : plan.row_count - 1;
    const double position = plan.period_s > 0 ? time_s / plan.period_s * intervals : 0.0;
    double row0 = std::min(std::floor(position + 1e-9), static_cast<double>(plan.row_count - 1));
    auto factor = static_cast<float>(std::max(0.0, position - row0));
    if (position - row0 < 1e-9) factor = 0.0f;
    if (plan.step) factor = 0.0f;
    if (plan.step && loop && position >= intervals - 1e-9) row0 = 0;  // held poses: the next turn has begun
    double row1 = factor > 0 ? row0 + 1 : row0;
    if (row1 >= plan.row_count) row1 = loop ? 0 : plan.row_count - 1;
    std::vector<Matrix34> bones(view.header.bone_count);
    for (std::uint32_t b = 0; b < view.header.bone_count; ++b) {
        float m0[12], m1[12];
        EXPECT_EQ(posepack_decode_bone(&view, clip.first_row + static_cast<std::uint32_t>(row0), b, m0),
                  POSEPACK_OK);
        EXPECT_EQ(posepack_decode_bone(&view, clip.first_row + static_cast<std::uint32_t>(row1), b, m1),
                  POSEPACK_OK);
        for (std::size_t e = 0; e < 12; ++e) {
            const float blended = m0[e] * (1.0f - factor) + m1[e] * factor;
            bones[b][e] = static_cast<Real>(factor > 0 ? blended : m0[e]);
        }
    }
    return bones;
}

Real length(const Point& p) {
    return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

double angle_deg(const Point& a, const Point& b) {
    const Point cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const Real dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return static_cast<double>(std::atan2(length(cross), dot) * 180 / 3.14159265358979323846L);
}

std::vector<Sample> samples_at(const std::vector<double>& times_s, const animal::Animal& animal,
                               const posepack_view& view, const palette::PaletteClip& clip) {
    std::vector<Sample> samples;
    for (const double time_s : times_s) {
        const auto exact = support::naive_bones(animal, animal.clips[clip.source], time_s);
        const auto read = shown(view, clip, time_s);
        for (std::size_t v = 0; v < animal.vertices.positions.size(); ++v) {
            const Point a = support::naive_point(animal, v, exact);
            const Point b = support::naive_point(animal, v, read);
            const Point na = support::naive_normal(animal, v, exact);
            const Point nb = support::naive_normal(animal, v, read);
            samples.push_back({time_s, v,
                               static_cast<double>(length({a[0] - b[0], a[1] - b[1], a[2] - b[2]})),
                               length(na) == 0 ? -1.0 : angle_deg(na, nb)});
        }
    }
    return samples;
}

std::vector<Sample> naive_samples(const animal::Animal& animal, const posepack_view& view,
                                  const palette::PaletteClip& clip) {
    return samples_at(naive_times(animal, clip), animal, view, clip);
}

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1];
}

double root_mean_square(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v * v;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// What `samples` say at the place that the measurement names.
const Sample& at(const std::vector<Sample>& samples, float time_s, std::uint32_t vertex) {
    for (const Sample& s : samples)
        if (s.vertex == vertex && static_cast<float>(s.time_s) == time_s) return s;
    throw std::runtime_error("no sample at the reported place");
}

// How far each bone moves the vertex of `sample` from its place, weights taken into account.
std::vector<double> naive_moves(const animal::Animal& animal, const posepack_view& view,
                                const palette::PaletteClip& clip, const Sample& sample) {
    const auto exact = support::naive_bones(animal, animal.clips[clip.source], sample.time_s);
    const auto read = shown(view, clip, sample.time_s);
    const auto& p = animal.vertices.positions[sample.vertex];
    std::vector<double> moves(animal.bones.size(), -1.0);
    for (std::size_t i = 0; i < animal::kMaxInfluences; ++i) {
        const std::uint32_t bone = animal.vertices.bones[sample.vertex][i];
        const float weight = animal.vertices.weights[sample.vertex][i];
        const Point a = support::transform(exact[bone], {p[0], p[1], p[2]});
        const Point b = support::transform(read[bone], {p[0], p[1], p[2]});
        if (weight > 0)
            moves[bone] = static_cast<double>(weight * length({a[0] - b[0], a[1] - b[1], a[2] - b[2]}));
    }
    return moves;
}

std::uint32_t naive_blame(const animal::Animal& animal, const posepack_view& view,
                          const palette::PaletteClip& clip, const Sample& worst) {
    const std::vector<double> moves = naive_moves(animal, view, clip, worst);
    return static_cast<std::uint32_t>(std::max_element(moves.begin(), moves.end()) - moves.begin());
}

void expect_close(double found, double expected, double relative, const std::string& what) {
    EXPECT_NEAR(found, expected, expected * relative + 1e-12) << what;
}

struct Case {
    const char* what;
    recipe::OutputOptions output;
    std::optional<double> rate_hz;
    double tolerance;  // relative, of the maximum
};

TEST(BruteForce, AgreesInEveryFigureAndPlace) {
    recipe::OutputOptions half, half_mat4, floats = support::in_floats();
    half_mat4.encoding = recipe::Encoding::mat4;
    half_mat4.texel_order = recipe::TexelOrder::planar;
    const Case cases[] = {{"affine half", half, {}, 2e-6},
                          {"mat4 half planar", half_mat4, {}, 2e-6},
                          {"affine float at a low rate", floats, 8.0, 1e-6},
                          {"affine float off the grid", floats, 17.0, 1e-6}};
    const animal::Animal animal = support::animal_of(support::tail());
    const motion::SkinSet points = motion::unique_points(animal);
    const motion::SkinSet normals = motion::unique_normals(animal);
    std::size_t closer_count = 0;
    for (const Case& test : cases) {
        const std::vector<motion::RowWish> wishes(
            3, {test.rate_hz, recipe::Wrap::automatic, recipe::Seam::automatic});
        const support::Baked baked = support::bake_all(animal, test.output, wishes);
        const auto stats = measure_error(animal, baked.palette, baked.container, points, normals);
        ASSERT_TRUE(stats);
        posepack_view view;
        ASSERT_EQ(posepack_open(&view, baked.container.data(), baked.container.size()), POSEPACK_OK);
        const double radius = baked.palette.radius;
        std::vector<double> all_errors, all_angles;
        std::size_t sample_count = 0, normal_count = 0;
        double pooled_max = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string what = std::string(test.what) + ", " + animal.clips[c].name;
            const palette::PaletteClip& clip = baked.palette.clips[c];
            const palette::ClipError& error = stats.value().clips[c];
            const std::vector<Sample> samples = naive_samples(animal, view, clip);
            std::vector<double> errors, angles;
            for (const Sample& s : samples) errors.push_back(s.error / radius);
            for (const Sample& s : samples)
                if (s.normal_deg >= 0) angles.push_back(s.normal_deg);
            const std::vector<Sample> closer =
                samples_at(stats.value().looks[c].closer_s, animal, view, clip);
            closer_count += closer.size();
            std::vector<Sample> everywhere = samples;
            everywhere.insert(everywhere.end(), closer.begin(), closer.end());
            double max = 0;
            for (const Sample& s : everywhere) max = std::max(max, s.error / radius);
            const double normal_max = *std::max_element(angles.begin(), angles.end());
            expect_close(error.max, max, test.tolerance, what + " max");
            expect_close(error.rms, root_mean_square(errors), 1e-5, what + " rms");
            EXPECT_GE(error.p999, percentile(errors, 0.999) * (1 - 1e-5)) << what;
            EXPECT_LE(error.p999, percentile(errors, 0.999) * 1.016) << what;
            EXPECT_LE(error.p999, error.max) << what;
            const Sample& worst = at(everywhere, error.time_s, error.vertex);
            expect_close(worst.error / radius, max, 1e-5, what + " place");
            EXPECT_EQ(error.bone, naive_blame(animal, view, clip, worst)) << what;
            EXPECT_EQ(error.mesh, 0u);
            expect_close(error.normal_max_deg, normal_max, 1e-4, what + " normal max");
            expect_close(error.normal_rms_deg, root_mean_square(angles), 0.009, what + " normal rms");
            EXPECT_GE(error.normal_p999_deg, percentile(angles, 0.999) * (1 - 1e-4) - 1e-9) << what;
            EXPECT_LE(error.normal_p999_deg, percentile(angles, 0.999) * 1.016 + 1e-9) << what;
            expect_close(at(samples, error.normal_time_s, error.normal_vertex).normal_deg, normal_max, 1e-4,
                         what);
            sample_count += errors.size();
            normal_count += angles.size();
            // A clip of splines is looked at twice as finely, and counts no more for it.
            for (int times = has_splines(animal.clips[clip.source]) ? 1 : 2; times > 0; --times) {
                all_errors.insert(all_errors.end(), errors.begin(), errors.end());
                all_angles.insert(all_angles.end(), angles.begin(), angles.end());
            }
            pooled_max = std::max(pooled_max, max);
        }
        const palette::ClipError& pooled = stats.value().pooled;
        expect_close(pooled.max, pooled_max, test.tolerance, "pooled max");
        EXPECT_EQ(pooled.max, stats.value().clips[stats.value().worst_clip].max);
        EXPECT_EQ(pooled.vertex, stats.value().clips[stats.value().worst_clip].vertex);
        expect_close(pooled.rms, root_mean_square(all_errors), 1e-5, "pooled rms");
        EXPECT_GE(pooled.p999, percentile(all_errors, 0.999) * (1 - 1e-5));
        EXPECT_LE(pooled.p999, percentile(all_errors, 0.999) * 1.016);
        expect_close(pooled.normal_rms_deg, root_mean_square(all_angles), 0.009, "pooled normal rms");
        EXPECT_EQ(stats.value().point_samples, sample_count);
        EXPECT_EQ(stats.value().normal_samples, normal_count);
    }
    EXPECT_GT(closer_count, 1000u);
}

// The largest error of each bin and bone, from samples one by one. Errors within a hair of another bone's are
// put down to both: doubles and floats may blame another one.
struct NaiveCell {
    double least = 0, most = 0;
};

std::vector<NaiveCell> naive_cells(const animal::Animal& animal, const posepack_view& view,
                                   const palette::PaletteClip& clip, const Look& look, const ClipHeat& heat) {
    const std::size_t bones = animal.bones.size();
    std::vector<NaiveCell> cells(heat.errors.size());
    std::vector<double> times_s = naive_times(animal, clip);
    times_s.insert(times_s.end(), look.closer_s.begin(), look.closer_s.end());
    for (const Sample& sample : samples_at(times_s, animal, view, clip)) {
        std::size_t bin = 0;
        while (bin + 2 < heat.edges_s.size() && sample.time_s > heat.edges_s[bin + 1]) ++bin;
        const std::vector<double> moved = naive_moves(animal, view, clip, sample);
        const double largest = *std::max_element(moved.begin(), moved.end());
        std::size_t candidates = 0;
        for (const double m : moved) candidates += m >= largest * (1 - 1e-4) ? 1 : 0;
        for (std::size_t b = 0; b < bones; ++b) {
            if (moved[b] < largest * (1 - 1e-4)) continue;
            NaiveCell& cell = cells[bin * bones + b];
            cell.most = std::max(cell.most, sample.error);
            if (candidates == 1) cell.least = std::max(cell.least, sample.error);
        }
    }
    return cells;
}

TEST(BruteForce, AgreesInEveryCellOfTheHeat) {
    const animal::Animal animal = support::animal_of(support::tail());
    const motion::SkinSet points = motion::unique_points(animal), normals = motion::unique_normals(animal);
    std::size_t compared = 0;
    for (const double rate_hz : {8.0, 17.0}) {
        const std::vector<motion::RowWish> wishes(
            3, {rate_hz, recipe::Wrap::automatic, recipe::Seam::automatic});
        const support::Baked baked = support::bake_all(animal, support::in_floats(), wishes);
        posepack_view view;
        ASSERT_EQ(posepack_open(&view, baked.container.data(), baked.container.size()), POSEPACK_OK);
        const auto stats = measure_error(animal, baked.palette, baked.container, points, normals);
        ASSERT_TRUE(stats);
        for (const double width_s : {1e-4, 0.07, 0.4, 1e6}) {
            const auto heat =
                measure_heat(animal, baked.palette, baked.container, points, stats.value().looks, width_s);
            ASSERT_TRUE(heat);
            ASSERT_EQ(heat.value().clips.size(), 3u);
            for (std::size_t c = 0; c < 3; ++c) {
                const ClipHeat& found = heat.value().clips[c];
                const palette::PaletteClip& clip = baked.palette.clips[c];
                const std::vector<NaiveCell> expected =
                    naive_cells(animal, view, clip, stats.value().looks[c], found);
                ASSERT_EQ(found.errors.size(), (found.edges_s.size() - 1) * animal.bones.size());
                EXPECT_TRUE(std::is_sorted(found.edges_s.begin(), found.edges_s.end()));
                EXPECT_EQ(found.edges_s.front(), 0.0);
                EXPECT_EQ(found.edges_s.back(), clip.plan.duration_s);
                for (std::size_t cell = 0; cell < expected.size(); ++cell) {
                    const double error = found.errors[cell] * baked.palette.radius;
                    EXPECT_GE(error, expected[cell].least * (1 - 1e-5) - 1e-12) << width_s << " " << cell;
                    EXPECT_LE(error, expected[cell].most * (1 + 1e-5) + 1e-7) << width_s << " " << cell;
                    compared += expected[cell].least > 1e-6 ? 1 : 0;
                }
                EXPECT_EQ(*std::max_element(found.errors.begin(), found.errors.end()),
                          stats.value().clips[c].max);
            }
        }
    }
    EXPECT_GT(compared, 100u);
}

TEST(BruteForce, HeatNamesTheBoneAndTheTimeOfTheWorstPlace) {
    const animal::Animal animal = support::animal_of(support::tail());
    const motion::SkinSet points = motion::unique_points(animal), normals = motion::unique_normals(animal);
    const support::Baked baked = support::bake_all(animal, {});
    const auto stats = measure_error(animal, baked.palette, baked.container, points, normals);
    const auto heat = measure_heat(animal, baked.palette, baked.container, points, stats.value().looks, 0.05);
    ASSERT_TRUE(stats && heat);
    for (std::size_t c = 0; c < 3; ++c) {
        const palette::ClipError& error = stats.value().clips[c];
        const ClipHeat& clip = heat.value().clips[c];
        const auto worst = std::max_element(clip.errors.begin(), clip.errors.end()) - clip.errors.begin();
        const std::size_t bin = static_cast<std::size_t>(worst) / animal.bones.size();
        EXPECT_EQ(static_cast<std::size_t>(worst) % animal.bones.size(), error.bone);
        EXPECT_LE(clip.edges_s[bin], error.time_s + 1e-6f);
        EXPECT_GE(clip.edges_s[bin + 1], error.time_s - 1e-6f);
    }
}

TEST(BruteForce, HeatOfNoContainerIsRefused) {
    const animal::Animal animal = support::animal_of(support::tail());
    support::Baked baked = support::bake_all(animal, {});
    baked.container[0] ^= 1;
    const auto heat = measure_heat(animal, baked.palette, baked.container, motion::unique_points(animal),
                                   std::vector<Look>(3), 0.05);
    ASSERT_FALSE(heat);
    EXPECT_EQ(heat.issue().code, base::IssueCode::internal);
}

}  // namespace
}  // namespace posepack::measure
