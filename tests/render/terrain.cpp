// SPDX-License-Identifier: MIT
#include "render/terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace posepack::render {
namespace {

constexpr int kAcross = 360;
constexpr int kAway = 420;
constexpr float kNearZ = 6.0f;    // the first line of the mesh, behind the camera
constexpr float kDepth = 900.0f;  // from there to the last line
constexpr float kPathHalfWidth = 1.5f;

// Where the herd walks, from the hills to the right foreground: (x, z).
constexpr std::array<glm::vec2, 8> kPath = {
    {{-62, -150}, {-34, -104}, {2, -74}, {12, -52}, {1, -36}, {-7, -25}, {-3, -15.5f}, {4.5f, -9.5f}}};

float hash(int x, int z) {
    auto h = static_cast<std::uint32_t>(x) * 0x8DA6B343u ^ static_cast<std::uint32_t>(z) * 0xD8163841u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

float smooth_step(float from, float to, float value) {
    const float t = std::clamp((value - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

float mix(float a, float b, float factor) {
    return a + (b - a) * factor;
}

float distance_to_path(glm::vec2 place) {
    constexpr int kSteps = 240;
    float best = 1e9f;
    glm::vec2 from = path_place(0.0f);
    for (int i = 1; i <= kSteps; ++i) {
        const glm::vec2 to = path_place(static_cast<float>(i) / kSteps);
        const glm::vec2 way = to - from;
        const float t = std::clamp(glm::dot(place - from, way) / glm::dot(way, way), 0.0f, 1.0f);
        best = std::min(best, glm::distance(place, from + t * way));
        from = to;
    }
    return best;
}

glm::vec3 normal_at(float x, float z) {
    const float e = 0.05f;
    return glm::normalize(glm::vec3(ground_height(x - e, z) - ground_height(x + e, z), 2.0f * e,
                                    ground_height(x, z - e) - ground_height(x, z + e)));
}

}  // namespace

float trodden_at(glm::vec2 place) {
    if (place.y < kPath.front().y - 10.0f || std::abs(place.x) > 80.0f) return 0.0f;
    const float ragged = distance_to_path(place) + 1.1f * (smooth_noise(place * 0.9f) - 0.5f);
    return 1.0f - smooth_step(kPathHalfWidth * 0.35f, kPathHalfWidth * 1.25f, ragged);
}

float smooth_noise(glm::vec2 place) {
    const glm::vec2 cell(std::floor(place.x), std::floor(place.y));
    const auto x = static_cast<int>(cell.x);
    const auto z = static_cast<int>(cell.y);
    const float u = smooth_step(0.0f, 1.0f, place.x - cell.x);
    const float v = smooth_step(0.0f, 1.0f, place.y - cell.y);
    return mix(mix(hash(x, z), hash(x + 1, z), u), mix(hash(x, z + 1), hash(x + 1, z + 1), u), v);
}

glm::vec2 path_place(float along) {
    // Catmull-Rom through the points, their ends doubled.
    constexpr int kSpans = static_cast<int>(kPath.size()) - 1;
    const float scaled = std::clamp(along, 0.0f, 1.0f) * kSpans;
    const int span = std::min(static_cast<int>(scaled), kSpans - 1);
    const float t = scaled - static_cast<float>(span);
    const auto point = [=](int i) { return kPath[static_cast<std::size_t>(std::clamp(i, 0, kSpans))]; };
    const glm::vec2 a = point(span - 1), b = point(span), c = point(span + 1), d = point(span + 2);
    return 0.5f * (2.0f * b + t * (c - a) + t * t * (2.0f * a - 5.0f * b + 4.0f * c - d) +
                   t * t * t * (3.0f * b - 3.0f * c + d - a));
}

float ground_height(float x, float z) {
    const float away = std::hypot(x, z);
    const float swell = 0.9f * (smooth_noise({x * 0.045f + 7.0f, z * 0.045f}) - 0.5f) +
                        0.30f * (smooth_noise({x * 0.13f, z * 0.13f + 3.0f}) - 0.5f);
    const float rise = smooth_step(16.0f, 130.0f, -z) * 4.2f;
    const float hills = 26.0f * smooth_noise({x * 0.0062f + 1.7f, z * 0.0075f + 9.2f}) +
                        9.0f * smooth_noise({x * 0.021f, z * 0.021f});
    return swell * smooth_step(4.0f, 22.0f, away) * 1.3f + rise + hills * smooth_step(110.0f, 420.0f, away);
}

GroundMesh make_ground() {
    GroundMesh mesh;
    for (int i = 0; i <= kAway; ++i) {
        const float t = static_cast<float>(i) / kAway;
        const float away = kDepth * t * t * t + 40.0f * t * (1.0f - t);
        const float half_width = 12.0f + away * 0.75f;
        for (int j = 0; j <= kAcross; ++j) {
            const float x = half_width * (2.0f * static_cast<float>(j) / kAcross - 1.0f);
            const float z = kNearZ - away;
            mesh.vertices.push_back({{x, ground_height(x, z), z}, normal_at(x, z), trodden_at({x, z})});
        }
    }
    constexpr std::uint32_t kLine = kAcross + 1;
    for (std::uint32_t i = 0; i < kAway; ++i)
        for (std::uint32_t j = 0; j < kAcross; ++j) {
            const std::uint32_t a = i * kLine + j;
            for (const std::uint32_t index : {a, a + 1, a + kLine + 1, a, a + kLine + 1, a + kLine})
                mesh.indices.push_back(index);
        }
    return mesh;
}

}  // namespace posepack::render
