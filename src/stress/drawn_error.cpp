// SPDX-License-Identifier: MIT
#include "stress/drawn_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "format/bytes.h"
#include "motion/clip_sampler.hpp"
#include "motion/skin_set.hpp"
#include "posepack/loader.h"
#include "stress/row_law.hpp"

namespace posepack::stress {
namespace {

using motion::Affine;

constexpr double kEqualTimesS = 1e-6;                     // times closer than this are one
constexpr double kEdge = 1e-3;                            // of a span: how near to its ends it is looked at
constexpr std::size_t kFewestSteps = 3, kMostSteps = 16;  // in the span between two rows or keys
constexpr std::size_t kTimesAClip = 6000;                 // beyond it there are fewer steps
constexpr double kLargestError = 1e30;                    // what counts for anything that is not a number

struct Vec {
    float x = 0, y = 0, z = 0;
};

Vec transform(const float* m, const Vec& p) {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

// The vertices of an animal, drawn from a container.
class Drawing {
 public:
    Drawing(const animal::Animal& animal, const posepack_view& view, const motion::SkinSet& points)
        : view_(view), points_(points) {
        posepack_get_space(&view, &space_);
        for (std::size_t i = 0; i < points.size(); ++i) {
            posepack_mesh mesh{};
            posepack_get_mesh(&view, mesh_of(animal, points.vertices[i]), &mesh);
            const auto& p = points.vectors[i];
            entered_.push_back(transform(mesh.palette_from_mesh, {p[0], p[1], p[2]}));
        }
    }

    // Model-space places of all points under the matrices of all bones.
    const std::vector<Vec>& draw(const std::vector<float>& matrices) {
        drawn_.resize(points_.size());
        for (std::size_t n = 0; n + 1 < points_.first.size(); ++n)
            for (std::uint32_t i = points_.first[n]; i < points_.first[n + 1]; ++i) {
                Vec sum;
                for (std::size_t k = 0; k < n; ++k) {
                    const float w = points_.weights[i][k];
                    const Vec p = transform(&matrices[std::size_t{points_.bones[i][k]} * 12], entered_[i]);
                    sum = {sum.x + w * p.x, sum.y + w * p.y, sum.z + w * p.z};
                }
                drawn_[i] = transform(space_.model_from_palette, sum);
            }
        return drawn_;
    }

    double radius() const {
        return static_cast<double>(view_.header.radius_m) / static_cast<double>(space_.metres_per_unit);
    }

 private:
    static std::uint32_t mesh_of(const animal::Animal& animal, std::uint32_t vertex) {
        std::uint32_t mesh = 0;
        while (vertex - animal.meshes[mesh].first_vertex >= animal.meshes[mesh].vertex_count) ++mesh;
        return mesh;
    }

    const posepack_view& view_;
    const motion::SkinSet& points_;
    posepack_space space_{};
    std::vector<Vec> entered_, drawn_;
};

// Errors by and by, and what they amount to.
class Errors {
 public:
    void add(const std::vector<Vec>& drawn, std::span<const glm::dvec3> exact, double radius) {
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const glm::dvec3 found(drawn[i].x, drawn[i].y, drawn[i].z);
            const glm::dvec3 d = found - exact[i];
            const double error = std::sqrt(glm::dot(d, d)) / radius;
            all_.push_back(error <= kLargestError ? static_cast<float>(error)
                                                  : static_cast<float>(kLargestError));
        }
    }
    void add(const Errors& other) { all_.insert(all_.end(), other.all_.begin(), other.all_.end()); }

    // Reorders the errors.
    Amounts amounts() {
        if (all_.empty()) return {};
        double sum = 0.0;
        for (const float error : all_) sum += static_cast<double>(error) * static_cast<double>(error);
        const auto rank =
            static_cast<std::ptrdiff_t>(std::ceil(0.999 * static_cast<double>(all_.size()))) - 1;
        std::nth_element(all_.begin(), all_.begin() + rank, all_.end());
        return {static_cast<double>(*std::max_element(all_.begin(), all_.end())),
                static_cast<double>(all_[static_cast<std::size_t>(rank)]),
                std::sqrt(sum / static_cast<double>(all_.size()))};
    }

 private:
    std::vector<float> all_;
};

// Ends of the spans that are looked at: rows and keys, rising, up to the last key.
std::vector<double> marks_of(std::vector<double> marks, const std::vector<double>& key_times_s,
                             double duration_s) {
    marks.insert(marks.end(), key_times_s.begin(), key_times_s.end());
    std::erase_if(marks, [&](double time_s) { return time_s > duration_s; });
    marks.push_back(duration_s);
    std::sort(marks.begin(), marks.end());
    marks.erase(
        std::unique(marks.begin(), marks.end(), [](double a, double b) { return b - a < kEqualTimesS; }),
        marks.end());
    return marks;
}

// Zeros halves that some GPUs read as zero. The view stays valid: its checks are done, and values may change.
void flush_subnormals(const posepack_view& view, std::span<std::uint8_t> container) {
    if (view.header.texel_format != POSEPACK_TEXEL_RGBA16F) return;
    const posepack_section& pixels = view.sections[view.pixl_section];
    for (std::uint64_t at = pixels.offset; at + 2 <= pixels.offset + pixels.stored_bytes; at += 2) {
        const auto magnitude = static_cast<std::uint16_t>(posepack_read_u16(&container[at]) & 0x7FFFu);
        if (magnitude < 0x0400u) posepack_write_u16(&container[at], 0);
    }
}

class Meter {
 public:
    Meter(const animal::Animal& animal, const posepack_view& view, const Reader& reader)
        : animal_(animal),
          view_(view),
          reader_(reader),
          points_(motion::unique_points(animal)),
          drawing_(animal, view, points_),
          bones_(animal.bones.size()),
          exact_(points_.size()),
          matrices_(std::size_t{view.header.bone_count} * 12) {}

    DrawnError measure() {
        Errors rows;
        Errors between;
        for (std::uint32_t c = 0; c < view_.header.clip_count; ++c) {
            posepack_clip clip;
            posepack_get_clip(&view_, c, &clip);
            motion::ClipSampler sampler(animal_, animal_.clips[c]);
            const double duration_s = animal_.clips[c].duration_s;
            const std::vector<double> times_s = row_times_s(view_, c);
            if (view_.header.row_scheme == POSEPACK_ROWS_UNIFORM)
                look_at_rows(clip, times_s, duration_s, sampler, rows);
            look_between(c, clip, marks_of(times_s, sampler.key_times_s(), duration_s), sampler, between);
        }
        between.add(rows);
        return {rows.amounts(), between.amounts()};
    }

 private:
    // At the matrices that were read.
    void look(motion::ClipSampler& sampler, double time_s, Errors& errors) {
        sampler.sample(time_s, bones_);
        motion::skin(points_, bones_, exact_);
        errors.add(drawing_.draw(matrices_), exact_, drawing_.radius());
    }

    void look_at_rows(const posepack_clip& clip, const std::vector<double>& times_s, double duration_s,
                      motion::ClipSampler& sampler, Errors& errors) {
        for (std::uint32_t row = 0; row < clip.row_count; ++row) {
            if (times_s[row] > duration_s + kEqualTimesS) break;
            posepack_decode_row(&view_, clip.first_row + row, matrices_.data());
            look(sampler, times_s[row], errors);
        }
    }

    void look_between(std::uint32_t index, const posepack_clip& clip, const std::vector<double>& marks,
                      motion::ClipSampler& sampler, Errors& errors) {
        const auto steps = static_cast<unsigned>(
            std::clamp<std::size_t>(kTimesAClip / marks.size(), kFewestSteps, kMostSteps));
        for (std::size_t i = 1; i < marks.size(); ++i)
            for (unsigned step = 0; step <= steps; ++step) {
                const double part = std::clamp(static_cast<double>(step) / steps, kEdge, 1.0 - kEdge);
                const double time_s = marks[i - 1] + part * (marks[i] - marks[i - 1]);
                posepack_sample_pose(&view_, index, phase_at(clip, time_s, reader_), matrices_.data());
                look(sampler, time_s, errors);
            }
    }

    const animal::Animal& animal_;
    const posepack_view& view_;
    const Reader& reader_;
    motion::SkinSet points_;
    Drawing drawing_;
    std::vector<Affine> bones_;
    std::vector<glm::dvec3> exact_;
    std::vector<float> matrices_;
};

}  // namespace

base::Result<DrawnError> measure_drawn(const animal::Animal& animal, std::span<const std::uint8_t> container,
                                       const Reader& reader) {
    base::Bytes bytes(container.begin(), container.end());
    posepack_view view;
    if (const posepack_result result = posepack_open(&view, bytes.data(), bytes.size());
        result != POSEPACK_OK)
        return base::Issue{
            base::IssueCode::internal, "",
            fmt::format("expected a container that the loader opens, it answers {} to the one just made",
                        posepack_result_name(result))};
    flush_subnormals(view, bytes);
    return Meter(animal, view, reader).measure();
}

}  // namespace posepack::stress
