// SPDX-License-Identifier: MIT
#include "posed_model.hpp"

#include <stdexcept>

#include "animal/read_animal.hpp"
#include "bake/bake_animal.hpp"

namespace posepack::derived {
namespace {

template <class T>
T good(base::Result<T> result) {
    if (!result) throw std::runtime_error(base::format_issue(result.issue()));
    return std::move(result).value();
}

recipe::AnimalEntry entry_of(const std::filesystem::path& path, std::optional<double> rate_hz) {
    recipe::AnimalEntry entry;
    entry.id = path.stem().string();
    entry.model = path.filename().string();
    entry.canonical_json = "{}";
    entry.output.texel_format = recipe::TexelFormat::rgba32f;
    entry.output.space = recipe::Space::model;
    entry.output.caps = recipe::Caps::desktop;
    // Played once: every key has a row, whatever the seam of a changed clip looks like.
    recipe::ClipWish every;
    every.name = "*";
    every.rate_hz = rate_hz;
    every.wrap = recipe::Wrap::once;
    entry.clips = {every};
    return entry;
}

glm::dmat4 matrix_of(const float* m) {
    glm::dmat4 out(1.0);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) out[c][r] = static_cast<double>(m[r * 4 + c]);
    return out;
}

}  // namespace

PosedModel pose_model(const std::filesystem::path& path, std::optional<double> rate_hz) {
    PosedModel model;
    const base::Bytes glb = good(base::read_file(path, animal::kMaxGlbBytes));
    model.animal = good(animal::read_animal(glb));
    bake::AnimalOptions options;
    options.measure = false;
    bake::BakedAnimal baked = good(bake::bake_animal(entry_of(path, rate_hz), glb, options));
    model.container = std::move(baked.container);
    model.record = std::move(baked.record);
    if (posepack_open(&model.view, model.container.data(), model.container.size()) != POSEPACK_OK)
        throw std::runtime_error(path.string() + ": the loader refuses the container");
    return model;
}

std::vector<float> decoded_row(const PosedModel& model, std::uint32_t row) {
    std::vector<float> matrices(std::size_t{model.view.header.bone_count} * 12);
    if (posepack_decode_row(&model.view, row, matrices.data()) != POSEPACK_OK)
        throw std::runtime_error("the loader cannot decode a row");
    return matrices;
}

std::vector<glm::dvec3> posed_vertices(const PosedModel& model, const std::vector<float>& row,
                                       const std::vector<glm::dmat4>& before) {
    std::vector<glm::dmat4> bones;
    for (std::size_t b = 0; b * 12 < row.size(); ++b) {
        bones.push_back(matrix_of(&row[b * 12]));
        if (!before.empty()) bones.back() *= before[b];
    }
    const animal::Vertices& vertices = model.animal.vertices;
    std::vector<glm::dvec3> out;
    out.reserve(vertices.positions.size());
    for (std::uint32_t m = 0; m < model.animal.meshes.size(); ++m) {
        posepack_mesh mesh;
        if (posepack_get_mesh(&model.view, m, &mesh) != POSEPACK_OK)
            throw std::runtime_error("the container lacks a mesh");
        const glm::dmat4 palette_from_mesh = matrix_of(mesh.palette_from_mesh);
        const animal::Mesh& source = model.animal.meshes[m];
        for (std::uint32_t v = source.first_vertex; v < source.first_vertex + source.vertex_count; ++v) {
            const auto& [x, y, z] = vertices.positions[v];
            const glm::dvec4 point = palette_from_mesh * glm::dvec4(x, y, z, 1.0);
            glm::dvec4 sum(0.0);
            for (std::size_t i = 0; i < animal::kMaxInfluences; ++i)
                sum += static_cast<double>(vertices.weights[v][i]) * (bones[vertices.bones[v][i]] * point);
            out.emplace_back(sum);
        }
    }
    return out;
}

}  // namespace posepack::derived
