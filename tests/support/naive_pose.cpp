// SPDX-License-Identifier: MIT
#include "support/naive_pose.hpp"

#include <cmath>

namespace posepack::support {
namespace {

using animal::Animal;
using animal::Channel;
using animal::Interpolation;
using animal::Path;

std::array<Real, 4> unit(std::array<Real, 4> q) {
    Real square = 0;
    for (const Real c : q) square += c * c;
    for (Real& c : q) c /= std::sqrt(square);
    return q;
}

// Components of one channel at an absolute time.
std::array<Real, 4> value_of(const Animal& animal, const Channel& channel, Real time_s) {
    const std::size_t n = channel.path == Path::rotation ? 4 : 3;
    const bool cubic = channel.interpolation == Interpolation::cubic_spline;
    const auto time_at = [&](std::size_t k) {
        return static_cast<Real>(animal.key_times[channel.first_time + k]);
    };
    const auto number = [&](std::size_t k, std::size_t part, std::size_t c) {
        const std::size_t place = cubic ? (k * 3 + part) * n + c : k * n + c;
        return static_cast<Real>(animal.key_values[channel.first_value + place]);
    };
    const Real slack = channel.interpolation == Interpolation::step ? 1e-6L : 0.0L;
    std::size_t key = 0;
    for (std::size_t k = 0; k < channel.key_count; ++k)
        if (time_at(k) <= time_s + slack) key = k;
    std::array<Real, 4> a{}, b{}, out{};
    for (std::size_t c = 0; c < n; ++c) out[c] = a[c] = number(key, 1, c);
    const bool before = time_s <= time_at(key);
    if (key + 1 == channel.key_count || before || channel.interpolation == Interpolation::step) return out;
    for (std::size_t c = 0; c < n; ++c) b[c] = number(key + 1, 1, c);
    const Real d = time_at(key + 1) - time_at(key);
    const Real u = (time_s - time_at(key)) / d;
    if (!cubic && n == 4) return naive_slerp(a, b, u);
    for (std::size_t c = 0; c < n; ++c) {
        if (!cubic) {
            out[c] = (1 - u) * a[c] + u * b[c];
            continue;
        }
        const Real out_tangent = d * number(key, 2, c);
        const Real in_tangent = d * number(key + 1, 0, c);
        // The Hermite polynomial in Bezier form, by de Casteljau: the same curve, another formula.
        const Real p[4] = {a[c], a[c] + out_tangent / 3, b[c] - in_tangent / 3, b[c]};
        const Real q[3] = {p[0] + (p[1] - p[0]) * u, p[1] + (p[2] - p[1]) * u, p[2] + (p[3] - p[2]) * u};
        const Real r[2] = {q[0] + (q[1] - q[0]) * u, q[1] + (q[2] - q[1]) * u};
        out[c] = r[0] + (r[1] - r[0]) * u;
    }
    return out;
}

Matrix34 affine_part(const glm::dmat4& m) {
    Matrix34 out;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) out[static_cast<std::size_t>(r * 4 + c)] = m[c][r];
    return out;
}

Matrix34 local_at(const Animal& animal, const animal::Clip& clip, std::uint32_t node, Real time_s) {
    const animal::Node& source = animal.nodes[node];
    if (source.has_matrix) return affine_part(source.matrix);
    const animal::Transform& rest = source.rest;
    Point t{rest.translation.x, rest.translation.y, rest.translation.z};
    Point s{rest.scale.x, rest.scale.y, rest.scale.z};
    std::array<Real, 4> q{rest.rotation.x, rest.rotation.y, rest.rotation.z, rest.rotation.w};
    for (const Channel& channel : clip.channels) {
        if (channel.node != node) continue;
        const std::array<Real, 4> value = value_of(animal, channel, clip.start_s + time_s);
        if (channel.path == Path::translation) t = {value[0], value[1], value[2]};
        if (channel.path == Path::scale) s = {value[0], value[1], value[2]};
        if (channel.path == Path::rotation) q = value;
    }
    return matrix_of(t, unit(q), s);
}

}  // namespace

Matrix34 multiply(const Matrix34& a, const Matrix34& b) {
    Matrix34 out{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            out[r * 4 + c] = c == 3 ? a[r * 4 + 3] : 0;
            for (std::size_t k = 0; k < 3; ++k) out[r * 4 + c] += a[r * 4 + k] * b[k * 4 + c];
        }
    return out;
}

Point transform(const Matrix34& m, const Point& p) {
    Point out;
    for (std::size_t r = 0; r < 3; ++r)
        out[r] = m[r * 4] * p[0] + m[r * 4 + 1] * p[1] + m[r * 4 + 2] * p[2] + m[r * 4 + 3];
    return out;
}

Matrix34 matrix_of(const Point& t, const std::array<Real, 4>& q, const Point& s) {
    const auto [x, y, z, w] = q;
    const Real rotation[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                 {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                                 {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    Matrix34 out;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) out[r * 4 + c] = rotation[r][c] * s[c];
        out[r * 4 + 3] = t[r];
    }
    return out;
}

std::array<Real, 4> naive_slerp(std::array<Real, 4> a, std::array<Real, 4> b, Real u) {
    a = unit(a);
    b = unit(b);
    Real dot = 0;
    for (std::size_t c = 0; c < 4; ++c) dot += a[c] * b[c];
    const Real sign = dot < 0 ? -1 : 1;
    dot = std::fabs(dot);
    Real wa = 1 - u;
    Real wb = u;
    if (dot < 1) {
        const Real angle = std::acos(dot);
        wa = std::sin((1 - u) * angle) / std::sin(angle);
        wb = std::sin(u * angle) / std::sin(angle);
    }
    std::array<Real, 4> out;
    for (std::size_t c = 0; c < 4; ++c) out[c] = wa * a[c] + sign * wb * b[c];
    return out;
}

std::vector<Matrix34> naive_bones(const Animal& animal, const animal::Clip& clip, Real time_s) {
    std::vector<Matrix34> bones;
    for (const animal::Bone& bone : animal.bones) {
        Matrix34 m = affine_part(bone.inverse_bind);
        for (std::uint32_t n = bone.node; n != animal::kNone; n = animal.nodes[n].parent)
            m = multiply(local_at(animal, clip, n, time_s), m);
        bones.push_back(m);
    }
    return bones;
}

namespace {

Point weighted(const Animal& animal, std::size_t vertex, const std::array<float, 3>& v,
               const std::vector<Matrix34>& bones, bool is_point) {
    Point sum{};
    for (std::size_t i = 0; i < animal::kMaxInfluences; ++i) {
        Matrix34 m = bones[animal.vertices.bones[vertex][i]];
        if (!is_point) m[3] = m[7] = m[11] = 0;
        const Point image = transform(m, {v[0], v[1], v[2]});
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += static_cast<Real>(animal.vertices.weights[vertex][i]) * image[c];
    }
    return sum;
}

}  // namespace

Point naive_point(const Animal& animal, std::size_t vertex, const std::vector<Matrix34>& bones) {
    return weighted(animal, vertex, animal.vertices.positions[vertex], bones, true);
}

Point naive_normal(const Animal& animal, std::size_t vertex, const std::vector<Matrix34>& bones) {
    return weighted(animal, vertex, animal.vertices.normals[vertex], bones, false);
}

}  // namespace posepack::support
