// SPDX-License-Identifier: MIT
#include "render/prop_meshes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace posepack::render {
namespace {

constexpr float kTwoPi = 2.0f * glm::pi<float>();

void add_triangle(SkinnedMesh& mesh, const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    for (const MeshVertex& vertex : {a, b, c}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(vertex);
    }
}

// A blade of three triangles that bends outwards. Normals point up, so that grass is lit like the ground
// below it.
void add_blade(SkinnedMesh& mesh, float turn, float height, float lean, float start) {
    const glm::vec3 out(std::cos(turn), 0.0f, std::sin(turn));
    const glm::vec3 side(-out.z * 0.011f, 0.0f, out.x * 0.011f);
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    const glm::vec3 root = out * start;
    const glm::vec3 middle = root + out * (lean * 0.3f) + up * (height * 0.6f);
    const glm::vec3 tip = root + out * lean + up * height;
    const glm::vec3 dark(0.055f, 0.095f, 0.024f), half(0.095f, 0.145f, 0.034f),
        bright(0.175f, 0.215f, 0.062f);
    const MeshVertex a{root - side, up, dark, {}, {}}, b{root + side, up, dark, {}, {}};
    const MeshVertex c{middle - 0.7f * side, up, half, {}, {}}, d{middle + 0.7f * side, up, half, {}, {}};
    add_triangle(mesh, a, b, d);
    add_triangle(mesh, a, d, c);
    add_triangle(mesh, c, d, {tip, up, bright, {}, {}});
}

void add_cone(SkinnedMesh& mesh, float base, float top, float radius, glm::vec3 low, glm::vec3 high) {
    constexpr int kSides = 9;
    const float slope = radius / (top - base);
    const auto rim = [&](int i) {
        const float turn = kTwoPi * static_cast<float>(i) / kSides;
        const glm::vec3 out(std::cos(turn), 0.0f, std::sin(turn));
        return MeshVertex{
            out * radius + glm::vec3(0, base, 0), glm::normalize(out + glm::vec3(0, slope, 0)), low, {}, {}};
    };
    for (int i = 0; i < kSides; ++i) {
        MeshVertex apex{{0, top, 0}, glm::normalize(rim(i).normal + rim(i + 1).normal), high, {}, {}};
        add_triangle(mesh, rim(i + 1), rim(i), apex);
    }
}

}  // namespace

SkinnedMesh make_tuft() {
    SkinnedMesh mesh;
    constexpr int kBlades = 9;
    for (int i = 0; i < kBlades; ++i) {
        const float turn = kTwoPi * static_cast<float>(i) * 0.618034f;
        const float vary = std::fmod(static_cast<float>(i) * 0.37f, 1.0f);
        add_blade(mesh, turn, 0.10f + 0.10f * vary, 0.04f + 0.07f * (1.0f - vary), 0.035f * vary);
    }
    return mesh;
}

SkinnedMesh make_flower() {
    SkinnedMesh mesh;
    add_blade(mesh, 0.0f, 0.17f, 0.01f, 0.0f);
    constexpr int kPetals = 6;
    const glm::vec3 centre(0.01f, 0.17f, 0.0f), up(0.0f, 1.0f, 0.0f), petal(0.9f, 0.9f, 0.9f);
    for (int i = 0; i < kPetals; ++i) {
        const auto corner = [&](float turn, float radius, float rise) {
            return MeshVertex{centre + glm::vec3(radius * std::cos(turn), rise, radius * std::sin(turn)),
                              up,
                              petal,
                              {},
                              {}};
        };
        const float turn = kTwoPi * static_cast<float>(i) / kPetals;
        add_triangle(mesh, {centre, up, {0.8f, 0.5f, 0.1f}, {}, {}}, corner(turn + 0.45f, 0.028f, 0.016f),
                     corner(turn - 0.45f, 0.028f, 0.016f));
    }
    return mesh;
}

SkinnedMesh make_tree() {
    SkinnedMesh mesh;
    const glm::vec3 dark(0.022f, 0.055f, 0.024f), light(0.06f, 0.125f, 0.045f);
    add_cone(mesh, 0.0f, 3.0f, 0.28f, {0.06f, 0.04f, 0.025f}, {0.06f, 0.04f, 0.025f});
    add_cone(mesh, 1.0f, 5.0f, 1.9f, dark, light);
    add_cone(mesh, 3.0f, 6.8f, 1.5f, dark, light);
    add_cone(mesh, 5.0f, 8.6f, 1.0f, dark, light);
    return mesh;
}

}  // namespace posepack::render
