// SPDX-License-Identifier: MIT
// Affine maps in double precision: linear part and translation, without the constant last row.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "animal/animal.hpp"

namespace posepack::motion {

// p' = linear * p + translation, column vectors.
struct Affine {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};
};

inline Affine operator*(const Affine& a, const Affine& b) {
    return {a.linear * b.linear, a.linear * b.translation + a.translation};
}

inline glm::dvec3 operator*(const Affine& a, const glm::dvec3& point) {
    return a.linear * point + a.translation;
}

// The affine part of a matrix whose last row is 0 0 0 1.
inline Affine affine_of(const glm::dmat4& m) {
    return {glm::dmat3(m), glm::dvec3(m[3])};
}

// T * R * S (glTF 2.0 section 3.5.3). The rotation must be of unit length.
inline Affine affine_of(const animal::Transform& transform) {
    const auto& [x, y, z, w] =
        std::array{transform.rotation.x, transform.rotation.y, transform.rotation.z, transform.rotation.w};
    const glm::dvec3& s = transform.scale;
    Affine out;
    out.linear[0] = glm::dvec3(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)) * s.x;
    out.linear[1] = glm::dvec3(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)) * s.y;
    out.linear[2] = glm::dvec3(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)) * s.z;
    out.translation = transform.translation;
    return out;
}

// What takes the vertices of `mesh` to where its bones bind them: the identity, but where its skin is folded.
inline Affine bind_from_mesh(const animal::Animal& animal, const animal::Mesh& mesh) {
    return mesh.fold == animal::kNone ? Affine{} : affine_of(animal.folds[mesh.fold].bind_from_mesh);
}

}  // namespace posepack::motion
