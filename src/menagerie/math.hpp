// SPDX-License-Identifier: MIT
// The little geometry the generator needs, on GLM's double vectors, without one call of the C library's
// trigonometry: its results differ from host to host, and these reach the bytes of a model.
// Right-handed, +Y up, +Z forward, metres; angles are in degrees where a name says so.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace posepack::menagerie {

using Vec3 = glm::dvec3;
using Quat = glm::dquat;

inline constexpr Vec3 kAxisX{1.0, 0.0, 0.0};  // to the animal's left
inline constexpr Vec3 kAxisY{0.0, 1.0, 0.0};
inline constexpr Vec3 kAxisZ{0.0, 0.0, 1.0};
inline constexpr Quat kNoTurn{1.0, 0.0, 0.0, 0.0};

// The rotation by `degrees` about the unit vector `axis`, counter-clockwise seen from its tip.
Quat turn_about(const Vec3& axis, double degrees);

// Nose down for positive degrees (about +X), nose to the left (about +Y), left side up (about +Z).
Quat pitch(double degrees);
Quat yaw(double degrees);
Quat roll(double degrees);

// The shortest rotation that takes the direction of `from` to that of `to`; neither may be zero.
Quat turn_between(const Vec3& from, const Vec3& to);

// The rotation that takes the frame (direction, side) at rest to the posed one. `side` need not be square to
// `direction`, only not parallel to it.
Quat turn_of_frames(const Vec3& rest_direction, const Vec3& rest_side, const Vec3& direction,
                    const Vec3& side);

// 0 below 0, 1 above 1, between them a cubic with zero slope at both ends.
double smooth_step(double x);

// x - floor(x): the phase of a cycle, in [0, 1).
double wrapped(double x);

// sin(2 pi turns) and cos(2 pi turns).
double sine_of_turns(double turns);
double cosine_of_turns(double turns);

// The cubic through `from` and `to` with slopes (change over the whole span) `from_slope`, `to_slope`; u in
// [0, 1].
template <typename T>
T hermite(const T& from, const T& from_slope, const T& to, const T& to_slope, double u) {
    const double u2 = u * u;
    const double u3 = u2 * u;
    return from * (2.0 * u3 - 3.0 * u2 + 1.0) + from_slope * (u3 - 2.0 * u2 + u) +
           to * (3.0 * u2 - 2.0 * u3) + to_slope * (u3 - u2);
}

// The mirror image on the animal's other side, of a place or way and of a rotation.
inline Vec3 mirrored(const Vec3& v) {
    return {-v.x, v.y, v.z};
}
inline Quat mirrored(const Quat& q) {
    return {q.w, q.x, -q.y, -q.z};
}

// The rotation `share` of the way from `from` to `to`, by the shorter arc.
Quat blended(const Quat& from, const Quat& to, double share);

}  // namespace posepack::menagerie
