// SPDX-License-Identifier: MIT
#include "menagerie/math.hpp"

#include <glm/geometric.hpp>

#include <cmath>

#include "base/trig.hpp"

namespace posepack::menagerie {
namespace {

// Columns: direction, the part of side square to it, and their cross product.
glm::dmat3 frame_of(const Vec3& direction, const Vec3& side) {
    const Vec3 d = glm::normalize(direction);
    const Vec3 s = glm::normalize(side - d * glm::dot(side, d));
    return {d, s, glm::cross(d, s)};
}

}  // namespace

Quat turn_about(const Vec3& axis, double degrees) {
    const double half = degrees * (base::kPi / 360.0);
    const double s = base::sine(half);
    return {base::cosine(half), axis.x * s, axis.y * s, axis.z * s};
}

Quat pitch(double degrees) {
    return turn_about(kAxisX, degrees);
}

Quat yaw(double degrees) {
    return turn_about(kAxisY, degrees);
}

Quat roll(double degrees) {
    return turn_about(kAxisZ, degrees);
}

Quat turn_between(const Vec3& from, const Vec3& to) {
    const Vec3 a = glm::normalize(from);
    const Vec3 b = glm::normalize(to);
    const double w = 1.0 + glm::dot(a, b);
    if (w < 1e-9) {  // opposite: any axis square to them will do
        const Vec3 helper = std::abs(a.x) < 0.9 ? kAxisX : kAxisZ;
        const Vec3 axis = glm::normalize(glm::cross(a, helper));
        return {0.0, axis.x, axis.y, axis.z};
    }
    const Vec3 c = glm::cross(a, b);
    return glm::normalize(Quat(w, c.x, c.y, c.z));
}

Quat turn_of_frames(const Vec3& rest_direction, const Vec3& rest_side, const Vec3& direction,
                    const Vec3& side) {
    const glm::dmat3 rest = frame_of(rest_direction, rest_side);
    const glm::dmat3 posed = frame_of(direction, side);
    return glm::normalize(glm::quat_cast(posed * glm::transpose(rest)));
}

Quat blended(const Quat& from, const Quat& to, double share) {
    if (share <= 0.0) return from;
    const Quat near = glm::dot(from, to) < 0.0 ? -to : to;
    return glm::normalize(from * (1.0 - share) + near * share);
}

double smooth_step(double x) {
    if (x <= 0.0) return 0.0;
    if (x >= 1.0) return 1.0;
    return x * x * (3.0 - 2.0 * x);
}

double wrapped(double x) {
    return x - std::floor(x);
}

double sine_of_turns(double turns) {
    return base::sine(2.0 * base::kPi * wrapped(turns));
}

double cosine_of_turns(double turns) {
    return base::cosine(2.0 * base::kPi * wrapped(turns));
}

}  // namespace posepack::menagerie
