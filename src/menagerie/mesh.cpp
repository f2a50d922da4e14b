// SPDX-License-Identifier: MIT
#include "menagerie/mesh.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace posepack::menagerie {
namespace {

// sRGB to linear light by a cubic fit (Chilliant, "sRGB approximations for HLSL", 2012): no power function.
double linear_of_srgb(double x) {
    return x * (x * (x * 0.305306011 + 0.682171111) + 0.012522878);
}

double falloff(const Vec3& position, const Vec3& centre, double radius) {
    return smooth_step(1.0 - glm::length(position - centre) / radius);
}

// Takes `share` of every weight away and gives it to `joint`, in place of the smallest if all four are used.
void give_share(Influences& influences, int joint, double share) {
    for (double& weight : influences.weights) weight *= 1.0 - share;
    if (influences.weights[3] > 0.0 && influences.joints[3] != joint) {
        std::size_t smallest = 0;
        for (std::size_t slot = 1; slot < 4; ++slot) {
            if (influences.weights[slot] < influences.weights[smallest]) smallest = slot;
        }
        influences.joints[smallest] = influences.joints[3];
        influences.weights[smallest] = influences.weights[3];
        influences.weights[3] = 0.0;
    }
    add_share(influences, joint, share);
}

void normalise(Influences& influences) {
    constexpr double kUnit = 65536.0;
    constexpr double kLeast = 0.02;  // an exporter's limit: smaller shares are dropped
    double sum = 0.0;
    for (double& weight : influences.weights) {
        if (weight < kLeast) weight = 0.0;
        sum += weight;
    }
    double rest = kUnit;
    std::size_t largest = 0;
    for (std::size_t slot = 0; slot < 4; ++slot) {
        double& weight = influences.weights[slot];
        weight = std::floor(weight / sum * kUnit + 0.5);
        rest -= weight;
        if (weight > influences.weights[largest]) largest = slot;
        if (weight == 0.0) influences.joints[slot] = 0;
    }
    influences.weights[largest] += rest;
    for (double& weight : influences.weights) weight /= kUnit;
}

// The joint with the largest sum of weights over the corners of the triangle that begins at `index`.
int leading_joint(const Mesh& mesh, std::size_t index) {
    std::map<int, double> sums;
    for (std::size_t corner = index; corner < index + 3; ++corner) {
        const Influences& influences = mesh.vertices[mesh.indices[corner]].influences;
        for (std::size_t slot = 0; slot < 4; ++slot)
            sums[influences.joints[slot]] += influences.weights[slot];
    }
    return std::max_element(sums.begin(), sums.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

}  // namespace

Vec3 linear_colour(Colour colour) {
    const auto channel = [colour](int shift) {
        return linear_of_srgb(static_cast<double>((colour >> shift) & 255u) / 255.0);
    };
    return {channel(16), channel(8), channel(0)};
}

Vec3 mixed(const Vec3& a, const Vec3& b, double share) {
    return a + (b - a) * share;
}

Influences one_influence(int joint) {
    Influences influences;
    influences.joints[0] = joint;
    influences.weights[0] = 1.0;
    return influences;
}

void add_share(Influences& influences, int joint, double share) {
    if (share <= 0.0) return;
    std::size_t slot = 0;
    while (influences.weights[slot] > 0.0 && influences.joints[slot] != joint) ++slot;
    influences.joints[slot] = joint;
    influences.weights[slot] += share;
}

void add_triangle(Mesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t index : {a, b, c}) mesh.indices.push_back(static_cast<std::uint16_t>(index));
}

Mark mark(const Mesh& mesh) {
    return {mesh.vertices.size(), mesh.indices.size()};
}

void add_mirror_image(Mesh& mesh, const Rig& rig, const Mark& from) {
    const std::size_t vertex_end = mesh.vertices.size();
    const std::size_t index_end = mesh.indices.size();
    for (std::size_t index = from.vertex_count; index < vertex_end; ++index) {
        Vertex vertex = mesh.vertices[index];
        vertex.position = mirrored(vertex.position);
        for (int& joint : vertex.influences.joints)
            joint = rig.joints[static_cast<std::size_t>(joint)].mirror;
        mesh.vertices.push_back(vertex);
    }
    const std::size_t offset = vertex_end - from.vertex_count;
    for (std::size_t index = from.index_count; index < index_end; index += 3) {
        add_triangle(mesh, mesh.indices[index] + offset, mesh.indices[index + 2] + offset,
                     mesh.indices[index + 1] + offset);
    }
}

void attract(Mesh& mesh, const Mark& from, int joint, const Vec3& centre, double radius, double share) {
    for (std::size_t index = from.vertex_count; index < mesh.vertices.size(); ++index) {
        Vertex& vertex = mesh.vertices[index];
        const double part = share * falloff(vertex.position, centre, radius);
        if (part > 0.0) give_share(vertex.influences, joint, part);
    }
}

void tint(Mesh& mesh, const Mark& from, Colour colour, const Vec3& centre, double radius, double share) {
    for (std::size_t index = from.vertex_count; index < mesh.vertices.size(); ++index) {
        Vertex& vertex = mesh.vertices[index];
        const double part = share * falloff(vertex.position, centre, radius);
        vertex.colour = mixed(vertex.colour, linear_colour(colour), part);
    }
}

void finish(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices) vertex.normal = Vec3(0.0);
    for (std::size_t index = 0; index < mesh.indices.size(); index += 3) {
        Vertex& a = mesh.vertices[mesh.indices[index]];
        Vertex& b = mesh.vertices[mesh.indices[index + 1]];
        Vertex& c = mesh.vertices[mesh.indices[index + 2]];
        const Vec3 area = glm::cross(b.position - a.position, c.position - a.position);
        a.normal += area;
        b.normal += area;
        c.normal += area;
    }
    for (Vertex& vertex : mesh.vertices) {
        vertex.normal = glm::normalize(vertex.normal);
        normalise(vertex.influences);
    }
}

Mesh rigid_part(const Mesh& mesh, const Rig& rig, int joint) {
    const RigJoint& owner = rig.joints[static_cast<std::size_t>(joint)];
    const Quat axes = glm::conjugate(owner.bone);
    Mesh part;
    std::map<std::uint16_t, std::uint16_t> known;
    for (std::size_t index = 0; index < mesh.indices.size(); index += 3) {
        if (leading_joint(mesh, index) != joint) continue;
        for (std::size_t corner = index; corner < index + 3; ++corner) {
            const auto next = static_cast<std::uint16_t>(part.vertices.size());
            const auto [place, is_new] = known.try_emplace(mesh.indices[corner], next);
            part.indices.push_back(place->second);
            if (!is_new) continue;
            Vertex vertex = mesh.vertices[mesh.indices[corner]];
            vertex.position = axes * (vertex.position - owner.head);
            vertex.normal = axes * vertex.normal;
            part.vertices.push_back(vertex);
        }
    }
    return part;
}

}  // namespace posepack::menagerie
