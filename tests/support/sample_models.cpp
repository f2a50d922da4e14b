// SPDX-License-Identifier: MIT
#include "support/sample_models.hpp"

#include <cmath>
#include <stdexcept>

#include "animal/read_animal.hpp"

namespace posepack::support {
namespace {

// Rings of four vertices along x at the joints' places, the normals pointing outwards.
MeshSpec tail_mesh() {
    MeshSpec mesh{"Skin", 0, {}, {}, {}, {}};
    const float influences[3][4] = {
        {1.0f, 0.0f, 0.0f, 0.0f}, {0.625f, 0.375f, 0.0f, 0.0f}, {0.25f, 0.25f, 0.5f, 0.0f}};
    for (std::size_t ring = 0; ring < 3; ++ring)
        for (int side = 0; side < 4; ++side) {
            const float y = side == 0 ? 1.0f : side == 2 ? -1.0f : 0.0f;
            const float z = side == 1 ? 1.0f : side == 3 ? -1.0f : 0.0f;
            const float x = 0.75f * static_cast<float>(ring);
            mesh.positions.insert(mesh.positions.end(), {x, 0.5f + 0.25f * y, 0.25f * z});
            mesh.normals.insert(mesh.normals.end(), {0.0f, y, z});
            mesh.joints.insert(mesh.joints.end(), {0, 1, 2, 0});
            mesh.weights.insert(mesh.weights.end(), std::begin(influences[ring]), std::end(influences[ring]));
        }
    // The last vertex has four influences, the last of them a joint named before: equal joints are joined.
    const float four[4] = {0.125f, 0.25f, 0.5f, 0.125f};
    std::copy(std::begin(four), std::end(four), mesh.weights.end() - 4);
    return mesh;
}

std::vector<float> swing(std::size_t key_count, double degrees, double phase, double x, double y, double z) {
    std::vector<std::array<float, 4>> rotations;
    for (std::size_t k = 0; k < key_count; ++k) {
        const std::size_t turn_of = k + 1 == key_count ? 0 : k;  // the last key is the first
        const double angle =
            2.0 * 3.14159265358979323846 * static_cast<double>(turn_of) / static_cast<double>(key_count - 1);
        rotations.push_back(turn(degrees * std::sin(angle + phase), x, y, z));
    }
    return turns(rotations);
}

// a x b, affine, column by column; summed in double.
Matrix16 product(const Matrix16& a, const Matrix16& b) {
    Matrix16 out{};
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r) {
            double sum = 0.0;
            for (std::size_t k = 0; k < 4; ++k)
                sum += static_cast<double>(a[4 * k + r]) * static_cast<double>(b[4 * c + k]);
            out[4 * c + r] = static_cast<float>(sum);
        }
    return out;
}

}  // namespace

ModelSpec one_bone(std::vector<float> positions) {
    ModelSpec spec;
    spec.nodes = {{{"name", "Bone"}}};
    spec.skins = {{{0}, {}}};
    MeshSpec mesh{"Skin", 0, std::move(positions), {}, {}, {}};
    for (std::size_t v = 0; v < mesh.positions.size() / 3; ++v) {
        mesh.joints.insert(mesh.joints.end(), {0, 0, 0, 0});
        mesh.weights.insert(mesh.weights.end(), {1, 0, 0, 0});
    }
    spec.meshes = {mesh};
    return spec;
}

ModelSpec tail() {
    ModelSpec spec;
    spec.nodes = {
        {{"name", "Root"}, {"rotation", turn(30, 0, 1, 0)}, {"translation", {0, 0.5, 0}}, {"children", {1}}},
        {{"name", "Hips"}, {"children", {2}}},
        {{"name", "Spacer"},
         {"rotation", turn(-20, 1, 0, 1)},
         {"scale", {0.5, 2, 1.25}},
         {"translation", {0.25, 0, 0}},
         {"children", {3}}},
        {{"name", "Tail"}, {"translation", {0.5, 0, 0}}, {"children", {4}}},
        {{"name", "Tip"}, {"translation", {0.75, 0, 0.125}}, {"rotation", turn(15, 0, 0, 1)}}};
    spec.skins = {{{1, 3, 4}, inverse_binds_of(spec.nodes, {1, 3, 4})}};
    spec.meshes = {tail_mesh()};
    const std::vector<float> wag_times = grid(13, 30);
    const std::vector<float> hop_times{0.5f, 0.6f, 0.9f};  // spans of unequal length, after a lead-in
    spec.clips = {{"Rig|Wag",
                   {{1, "rotation", wag_times, swing(13, 12, 0, 0, 0, 1)},
                    {3, "rotation", wag_times, swing(13, 25, 0.6, 0, 1, 0.25)}}},
                  {"Rig|Hop",
                   {{0,
                     "translation",
                     hop_times,
                     {0, 0, 0,  0, 0.5f, 0, 0, 4,    0,    0.5f, 1, 0, 0.1f, 0.9f,
                      0, 0, -2, 1, 0.2f, 0, 0, 0.1f, 0.6f, 0.3f, 0, 0, 0},
                     "CUBICSPLINE"},
                    {4, "scale", hop_times, {1, 1, 1, 1, 1.5f, 0.75f, 2, 1, 1}}}},
                  {"Rig|Blink",
                   {{3, "translation", {0, 0.25f, 0.5f}, {0.5f, 0, 0, 0.5f, 0.25f, 0, 0.6f, 0, 0}, "STEP"}}}};
    return spec;
}

Matrix16 fold_matrix() {
    // 40 times a quarter turn about y, then a move: its inverse is exact in floats.
    return {0, 0, -40, 0, 0, 40, 0, 0, 40, 0, 0, 0, 0.5f, -2, 1.25f, 1};
}

ModelSpec folded_twice(ModelSpec spec) {
    const Matrix16 x = fold_matrix();
    SkinSpec skin = spec.skins[0];
    for (Matrix16& bind : skin.inverse_binds) bind = product(bind, x);
    spec.skins.push_back(skin);
    MeshSpec mesh = spec.meshes[0];
    mesh.name = "Folded";
    mesh.skin = 1;
    for (std::size_t v = 0; v < mesh.positions.size(); v += 3) {
        const float p[3] = {mesh.positions[v] - x[12], mesh.positions[v + 1] - x[13],
                            mesh.positions[v + 2] - x[14]};
        const float n[3] = {mesh.normals[v], mesh.normals[v + 1], mesh.normals[v + 2]};
        for (std::size_t r = 0; r < 3; ++r) {
            const float* column = &x[4 * r];  // a turn times 40: its inverse is its transpose by 1600
            mesh.positions[v + r] = (column[0] * p[0] + column[1] * p[1] + column[2] * p[2]) / 1600;
            mesh.normals[v + r] = (column[0] * n[0] + column[1] * n[1] + column[2] * n[2]) / 40;
        }
    }
    spec.meshes.push_back(mesh);
    return spec;
}

animal::Animal read_good(const Bytes& glb) {
    auto animal = animal::read_animal(glb);
    if (!animal) throw std::runtime_error(base::format_issue(animal.issue()));
    return std::move(animal).value();
}

}  // namespace posepack::support
