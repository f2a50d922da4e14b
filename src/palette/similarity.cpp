// SPDX-License-Identifier: MIT
#include "palette/similarity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace posepack::palette {
namespace {

using glm::dmat3;
using glm::dvec3;
using glm::dvec4;

double square_sum(const dmat3& m) {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) sum += m[c][r] * m[c][r];
    return sum;
}

// The quaternion of a rotation matrix, by its largest component (S. W. Shepperd, "Quaternion from rotation
// matrix", Journal of Guidance and Control 1 (3), 1978). m[c][r]: column c.
dvec4 quaternion_of(const dmat3& m) {
    const double trace = m[0][0] + m[1][1] + m[2][2];
    int largest = 3;
    double most = trace;
    for (int i = 0; i < 3; ++i)
        if (m[i][i] > most) {
            most = m[i][i];
            largest = i;
        }
    dvec4 q;
    if (largest == 3) {
        q = dvec4(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0], 1.0 + trace);
    } else {
        const int j = (largest + 1) % 3;
        const int k = (largest + 2) % 3;
        q[largest] = 1.0 + m[largest][largest] - m[j][j] - m[k][k];
        q[j] = m[largest][j] + m[j][largest];
        q[k] = m[largest][k] + m[k][largest];
        q[3] = m[j][k] - m[k][j];
    }
    return q / std::sqrt(glm::dot(q, q));
}

// The orthogonal part of the polar decomposition, by Newton's iteration (N. J. Higham, "Computing the polar
// decomposition", SIAM J. Sci. Stat. Comput. 7 (4), 1986). `m` has a determinant of about 1.
dmat3 orthogonal_part(dmat3 m) {
    for (int i = 0; i < 40; ++i) {
        const dmat3 next = 0.5 * (m + glm::transpose(glm::inverse(m)));
        const double change = square_sum(next - m);
        m = next;
        if (change < 1e-28) break;
    }
    return m;
}

}  // namespace

double signed_scale(const dmat3& linear) {
    const double scale = std::sqrt(square_sum(linear) / 3.0);
    return glm::determinant(linear) < 0.0 ? -scale : scale;
}

Similarity nearest_similarity(const motion::Affine& map, const dvec4& fallback) {
    constexpr double kFlat = 1e-9;  // of the cube of the scale
    Similarity out{fallback, signed_scale(map.linear), map.translation};
    if (out.scale == 0.0) return out;
    const dmat3 unit = map.linear / out.scale;
    if (!(glm::determinant(unit) > kFlat)) return out;
    out.rotation = quaternion_of(orthogonal_part(unit));
    return out;
}

dmat3 rotation_matrix(const dvec4& q) {
    const double h = 2.0 / glm::dot(q, q);
    dmat3 m;
    m[0] = dvec3(1 - h * (q.y * q.y + q.z * q.z), h * (q.x * q.y + q.w * q.z), h * (q.x * q.z - q.w * q.y));
    m[1] = dvec3(h * (q.x * q.y - q.w * q.z), 1 - h * (q.x * q.x + q.z * q.z), h * (q.y * q.z + q.w * q.x));
    m[2] = dvec3(h * (q.x * q.z + q.w * q.y), h * (q.y * q.z - q.w * q.x), 1 - h * (q.x * q.x + q.y * q.y));
    return m;
}

Stretch stretch_of(const dmat3& linear) {
    // Jacobi's eigenvalue iteration on the square of the matrix (Golub and Van Loan, Matrix
    // Computations, 8.5).
    dmat3 a = glm::transpose(linear) * linear;
    for (int sweep = 0; sweep < 12; ++sweep)
        for (const auto& [p, q] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
            if (a[p][q] == 0.0) continue;
            const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
            const double c = 1.0 / std::sqrt(t * t + 1.0);
            dmat3 rotation(1.0);
            rotation[p][p] = rotation[q][q] = c;
            rotation[q][p] = t * c;
            rotation[p][q] = -t * c;
            a = glm::transpose(rotation) * a * rotation;
        }
    Stretch stretch;
    stretch.largest = std::sqrt(std::max({a[0][0], a[1][1], a[2][2], 0.0}));
    stretch.smallest = std::sqrt(std::max(std::min({a[0][0], a[1][1], a[2][2]}), 0.0));
    return stretch;
}

}  // namespace posepack::palette
