// SPDX-License-Identifier: MIT
#include "motion/skin_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace posepack::motion {
namespace {

using animal::kMaxInfluences;

// What makes two vertices equal, as plain bytes.
struct Key {
    std::array<float, 3> vector;
    animal::InfluenceWeights weights;
    animal::InfluenceBones bones;
    std::uint32_t fold;
};
static_assert(sizeof(Key) == 64, "compared and hashed as bytes: no padding");

std::uint64_t hash_of(const Key& key) {
    std::array<std::uint32_t, sizeof(Key) / 4> words;
    std::memcpy(words.data(), &key, sizeof key);
    std::uint64_t hash = 0x9E3779B97F4A7C15ull;
    for (const std::uint32_t word : words) {
        hash = (hash ^ word) * 0xFF51AFD7ED558CCDull;
        hash ^= hash >> 32;
    }
    return hash;
}

// The vertices with different keys, in order of first appearance. Open addressing: a third of the time of
// a node-based map on meshes of some thousand vertices.
std::vector<std::uint32_t> first_of_each(std::span<const Key> keys) {
    std::size_t capacity = 16;
    while (capacity < keys.size() * 2) capacity *= 2;
    std::vector<std::uint32_t> table(capacity, animal::kNone);
    std::vector<std::uint32_t> firsts;
    for (std::uint32_t v = 0; v < keys.size(); ++v) {
        std::size_t slot = hash_of(keys[v]) & (capacity - 1);
        // Bitwise on purpose: equal bits skin equally.
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
        while (table[slot] != animal::kNone && std::memcmp(&keys[table[slot]], &keys[v], sizeof(Key)) != 0)
            slot = (slot + 1) & (capacity - 1);
        if (table[slot] != animal::kNone) continue;
        table[slot] = v;
        firsts.push_back(v);
    }
    return firsts;
}

std::size_t influence_count(const animal::InfluenceWeights& weights) {
    std::size_t count = 0;
    while (count < kMaxInfluences && weights[count] > 0.0f) ++count;
    return count;
}

enum class Kind { point, direction };

// Vectors of all vertices as the bones bind them, mesh by mesh.
std::vector<std::array<float, 3>> bound_vectors(const animal::Animal& animal, Kind kind) {
    std::vector<std::array<float, 3>> out =
        kind == Kind::point ? animal.vertices.positions : animal.vertices.normals;
    for (const animal::Mesh& mesh : animal.meshes) {
        if (mesh.fold == animal::kNone) continue;
        Affine entry = bind_from_mesh(animal, mesh);
        if (kind == Kind::direction) entry.translation = glm::dvec3(0.0);
        for (std::uint32_t v = mesh.first_vertex; v < mesh.first_vertex + mesh.vertex_count; ++v) {
            const glm::dvec3 moved = entry * glm::dvec3(out[v][0], out[v][1], out[v][2]);
            for (std::size_t c = 0; c < 3; ++c) out[v][c] = static_cast<float>(moved[static_cast<int>(c)]);
        }
    }
    return out;
}

SkinSet unique_set(const animal::Animal& animal, Kind kind) {
    const animal::Vertices& vertices = animal.vertices;
    const std::vector<std::array<float, 3>> vectors = bound_vectors(animal, kind);
    std::vector<Key> keys(vectors.size());
    for (const animal::Mesh& mesh : animal.meshes)
        for (std::uint32_t v = mesh.first_vertex; v < mesh.first_vertex + mesh.vertex_count; ++v) {
            keys[v] = {vectors[v], vertices.weights[v], vertices.bones[v], mesh.fold};
            for (float& c : keys[v].vector) c += 0.0f;  // -0 and 0 are one
        }
    std::vector<std::uint32_t> firsts = first_of_each(keys);
    const auto influences = [&](std::uint32_t v) { return influence_count(vertices.weights[v]); };
    std::stable_sort(firsts.begin(), firsts.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return influences(a) < influences(b); });
    SkinSet set;
    for (const std::uint32_t v : firsts) {
        set.vectors.push_back(vectors[v]);
        set.bones.push_back(vertices.bones[v]);
        set.weights.push_back(vertices.weights[v]);
        set.vertices.push_back(v);
        for (std::size_t n = influences(v) + 1; n < set.first.size(); ++n) ++set.first[n];
    }
    return set;
}

}  // namespace

SkinSet unique_points(const animal::Animal& animal) {
    return unique_set(animal, Kind::point);
}

SkinSet unique_normals(const animal::Animal& animal) {
    SkinSet all = unique_set(animal, Kind::direction);
    SkinSet set;
    for (std::size_t n = 0; n + 1 < all.first.size(); ++n) {
        for (std::uint32_t i = all.first[n]; i < all.first[n + 1]; ++i) {
            if (all.vectors[i] == std::array{0.0f, 0.0f, 0.0f}) continue;
            set.vectors.push_back(all.vectors[i]);
            set.bones.push_back(all.bones[i]);
            set.weights.push_back(all.weights[i]);
            set.vertices.push_back(all.vertices[i]);
        }
        set.first[n + 1] = static_cast<std::uint32_t>(set.size());
    }
    return set;
}

void skin(const SkinSet& set, std::span<const Affine> bones, std::span<glm::dvec3> out) {
    for (std::size_t n = 0; n + 1 < set.first.size(); ++n)
        for (std::uint32_t i = set.first[n]; i < set.first[n + 1]; ++i) {
            const glm::dvec3 point(set.vectors[i][0], set.vectors[i][1], set.vectors[i][2]);
            out[i] = glm::dvec3(0.0);
            for (std::size_t k = 0; k < n; ++k)
                out[i] += static_cast<double>(set.weights[i][k]) * (bones[set.bones[i][k]] * point);
        }
}

Sphere sphere_around(std::span<const glm::dvec3> points) {
    if (points.empty()) return {};
    glm::dvec3 low = points[0];
    glm::dvec3 high = points[0];
    for (const glm::dvec3& p : points)
        for (int c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    Sphere sphere{(low + high) * 0.5, 0.0};
    double square = 0.0;
    for (const glm::dvec3& p : points)
        square = std::max(square, glm::dot(p - sphere.center, p - sphere.center));
    sphere.radius = std::sqrt(square);
    return sphere;
}

}  // namespace posepack::motion
