// SPDX-License-Identifier: MIT
#include "measure/reduction_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace posepack::measure {
namespace {

using animal::Animal;
using motion::Affine;

// A vertex that lost influences, as its bones bind it.
struct Vertex {
    glm::dvec3 point;
    std::uint32_t mesh = 0;
};

std::vector<Vertex> reduced_vertices(const Animal& animal) {
    std::vector<Vertex> out;
    std::uint32_t mesh = 0;
    for (const std::uint32_t v : animal.reduced.vertices) {
        const auto holds = [&](const animal::Mesh& m) {
            return v >= m.first_vertex && v - m.first_vertex < m.vertex_count;
        };
        while (!holds(animal.meshes[mesh])) ++mesh;  // vertices rise, and so do meshes
        const auto& p = animal.vertices.positions[v];
        out.push_back(
            {motion::bind_from_mesh(animal, animal.meshes[mesh]) * glm::dvec3(p[0], p[1], p[2]), mesh});
    }
    return out;
}

// The square of the distance between the vertex with all influences and with those that it keeps.
double square_at(const Animal& animal, std::size_t index, const glm::dvec3& point,
                 std::span<const Affine> bones) {
    const animal::ReducedVertices& all = animal.reduced;
    const std::uint32_t v = all.vertices[index];
    glm::dvec3 off(0.0);
    for (std::uint32_t i = all.first[index]; i < all.end_of(index); ++i)
        off += static_cast<double>(all.weights[i]) * (bones[all.bones[i]] * point);
    for (std::size_t k = 0; k < animal::kMaxInfluences; ++k)
        if (const float weight = animal.vertices.weights[v][k]; weight > 0.0f)
            off -= static_cast<double>(weight) * (bones[animal.vertices.bones[v][k]] * point);
    return glm::dot(off, off);
}

base::Status check_work(const palette::Palette& palette, std::size_t vertex_count) {
    std::uint64_t rows = 0;
    for (const palette::PaletteClip& clip : palette.clips) rows += clip.plan.row_count;
    if (rows * vertex_count <= kMaxReductionSamples) return {};
    return base::Issue{
        base::IssueCode::lim_work, "",
        fmt::format("expected at most {} places (rows x vertices that lose influences), found {}",
                    kMaxReductionSamples, rows * vertex_count)};
}

}  // namespace

base::Result<ReductionError> measure_reduction(const Animal& animal, const palette::Palette& palette) {
    ReductionError error;
    const std::vector<Vertex> vertices = reduced_vertices(animal);
    if (vertices.empty()) return error;
    if (auto status = check_work(palette, vertices.size()); !status) return status.issue();
    error.vertex_count = static_cast<std::uint32_t>(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        error.influences_most =
            std::max(error.influences_most, animal.reduced.end_of(i) - animal.reduced.first[i]);
    std::vector<Affine> bones(animal.bones.size());
    double largest = -1.0, sum = 0.0;
    std::uint64_t count = 0;
    for (std::uint32_t c = 0; c < palette.clips.size(); ++c) {
        const palette::PaletteClip& clip = palette.clips[c];
        motion::ClipSampler sampler(animal, animal.clips[clip.source]);
        for (std::uint32_t row = 0; row < clip.plan.row_count; ++row) {
            motion::sample_row(sampler, clip.plan, row, bones);
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                const double square = square_at(animal, i, vertices[i].point, bones);
                sum += square;
                ++count;
                if (!(square > largest)) continue;
                largest = square;
                error.clip = c;
                error.time_s = clip.plan.row_time_s(row);
                error.mesh = vertices[i].mesh;
                error.vertex = animal.reduced.vertices[i] - animal.meshes[vertices[i].mesh].first_vertex;
            }
        }
    }
    const double radius = palette.radius > 0.0 ? palette.radius : 1.0;
    error.max = std::sqrt(std::max(largest, 0.0)) / radius;
    error.rms = count > 0 ? std::sqrt(sum / static_cast<double>(count)) / radius : 0.0;
    if (!std::isfinite(static_cast<float>(error.max)) || !std::isfinite(static_cast<float>(error.rms)))
        return base::Issue{base::IssueCode::lim_float_range, "",
                           "expected errors that fit a float, found a motion too large to be measured"};
    return error;
}

}  // namespace posepack::measure
