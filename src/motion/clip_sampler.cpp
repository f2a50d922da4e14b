// SPDX-License-Identifier: MIT
#include "motion/clip_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "base/trig.hpp"

namespace posepack::motion {
namespace {

using animal::Animal;
using animal::Channel;
using animal::Interpolation;
using animal::kNone;
using animal::Path;

// Keys and times closer than this are one: float32 times are coarser than that after some seconds.
constexpr double kEqualTimesS = 1e-6;

glm::dvec4 normalised(const glm::dvec4& q) {
    return q / std::sqrt(glm::dot(q, q));
}

// Spherical interpolation along the shorter arc. The angle comes from the chord (W. Kahan: stable for
// nearly equal and for opposite rotations): tan(angle / 2) = |b - a| / |a + b|.
glm::dvec4 slerp(const glm::dvec4& from, glm::dvec4 to, double u) {
    const glm::dvec4 a = normalised(from);
    to = normalised(to);
    const glm::dvec4 b = glm::dot(a, to) < 0.0 ? -to : to;
    const glm::dvec4 chord = b - a;
    const glm::dvec4 sum = a + b;
    const double tangent = std::sqrt(glm::dot(chord, chord) / glm::dot(sum, sum));
    if (tangent < 1e-12) return a;
    const double angle = 2.0 * base::arc_tangent_unit(std::min(tangent, 1.0));
    const double sine_of_angle = 2.0 * tangent / (1.0 + tangent * tangent);
    return a * (base::sine((1.0 - u) * angle) / sine_of_angle) + b * (base::sine(u * angle) / sine_of_angle);
}

template <class Vector>
Vector value_at(const float* values) {
    Vector v;
    for (int c = 0; c < Vector::length(); ++c) v[c] = static_cast<double>(values[c]);
    return v;
}

// Cubic Hermite spline (glTF 2.0 appendix C.5); each key is in-tangent, value, out-tangent.
template <class Vector>
Vector hermite(const float* key, const float* next, double u, double span_s) {
    const int n = Vector::length();
    const Vector v0 = value_at<Vector>(key + n);
    const Vector out0 = value_at<Vector>(key + 2 * n);
    const Vector in1 = value_at<Vector>(next);
    const Vector v1 = value_at<Vector>(next + n);
    const double u2 = u * u;
    const double u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * v0 + span_s * (u3 - 2 * u2 + u) * out0 + (-2 * u3 + 3 * u2) * v1 +
           span_s * (u3 - u2) * in1;
}

// The value of a channel in the span of keys that begins at `key`.
template <class Vector>
Vector interpolate(const Animal& animal, const Channel& channel, std::uint32_t key, double time_s) {
    const int n = Vector::length();
    const bool cubic = channel.interpolation == Interpolation::cubic_spline;
    const int stride = cubic ? 3 * n : n;
    const float* values =
        &animal.key_values[channel.first_value + std::size_t{key} * static_cast<unsigned>(stride)];
    const Vector held = value_at<Vector>(values + (cubic ? n : 0));
    const float* times = &animal.key_times[channel.first_time + key];
    const bool last = key + 1 == channel.key_count;
    if (last || channel.interpolation == Interpolation::step || time_s <= times[0]) return held;
    const double span_s = static_cast<double>(times[1]) - times[0];
    if (span_s < kEqualTimesS) return held;
    const double u = (time_s - times[0]) / span_s;
    if (cubic) return hermite<Vector>(values, values + stride, u, span_s);
    const Vector next = value_at<Vector>(values + n);
    if constexpr (Vector::length() == 4)
        return slerp(held, next, u);
    else
        return held + (next - held) * u;
}

bool is_constant(const Animal& animal, const Channel& channel) {
    const std::size_t n = channel.path == Path::rotation ? 4 : 3;
    const bool cubic = channel.interpolation == Interpolation::cubic_spline;
    const float* values = &animal.key_values[channel.first_value];
    const std::size_t stride = cubic ? 3 * n : n;
    for (std::size_t k = 0; k < channel.key_count; ++k)
        for (std::size_t c = 0; c < stride; ++c) {
            const bool tangent = cubic && (c < n || c >= 2 * n);
            if (tangent ? values[k * stride + c] != 0.0f : values[k * stride + c] != values[c]) return false;
        }
    return true;
}

// Whether two keys have the same value, tangents aside.
bool are_equal_keys(const Animal& animal, const Channel& channel, std::uint32_t a, std::uint32_t b) {
    const std::size_t n = channel.path == Path::rotation ? 4 : 3;
    const bool cubic = channel.interpolation == Interpolation::cubic_spline;
    const float* values = &animal.key_values[channel.first_value] + (cubic ? n : 0);
    const std::size_t stride = cubic ? 3 * n : n;
    return std::equal(values + a * stride, values + a * stride + n, values + b * stride);
}

std::vector<bool> nodes_above_bones(const Animal& animal) {
    std::vector<bool> above(animal.nodes.size(), false);
    for (const animal::Bone& bone : animal.bones)
        for (std::uint32_t n = bone.node; n != kNone && !above[n]; n = animal.nodes[n].parent)
            above[n] = true;
    return above;
}

Affine local_of(const animal::Node& node, const animal::Transform& transform) {
    return node.has_matrix ? affine_of(node.matrix) : affine_of(transform);
}

Affine global_of(const Animal& animal, std::span<const Affine> globals, std::uint32_t node,
                 const Affine& local) {
    const std::uint32_t parent = animal.nodes[node].parent;
    return parent == kNone ? local : globals[parent] * local;
}

}  // namespace

std::vector<Affine> rest_pose(const Animal& animal) {
    std::vector<Affine> globals(animal.nodes.size());
    for (const std::uint32_t n : animal.node_order)
        globals[n] = global_of(animal, globals, n, local_of(animal.nodes[n], animal.nodes[n].rest));
    std::vector<Affine> bones;
    for (const animal::Bone& bone : animal.bones)
        bones.push_back(globals[bone.node] * affine_of(bone.inverse_bind));
    return bones;
}

ClipSampler::ClipSampler(const Animal& animal, const animal::Clip& clip)
    : animal_(animal), clip_(clip), globals_(animal.nodes.size()) {
    const std::vector<bool> above = nodes_above_bones(animal);
    std::vector<bool> moving(animal.nodes.size(), false);
    for (const animal::Node& node : animal.nodes) locals_.push_back(node.rest);
    for (const Channel& channel : clip.channels) {
        if (!above[channel.node]) continue;
        Cursor cursor{&channel};
        apply(cursor, clip.start_s);
        if (is_constant(animal, channel)) continue;
        moving[channel.node] = true;
        moving_channels_.push_back(cursor);
    }
    for (const std::uint32_t n : animal.node_order) {
        if (!above[n]) continue;
        const std::uint32_t parent = animal.nodes[n].parent;
        moving[n] = moving[n] || (parent != kNone && moving[parent]);
        if (moving[n]) moving_nodes_.push_back(n);
        globals_[n] = global_of(animal, globals_, n, local_of(animal.nodes[n], locals_[n]));
    }
    for (std::uint32_t b = 0; b < animal.bones.size(); ++b) {
        inverse_binds_.push_back(affine_of(animal.bones[b].inverse_bind));
        still_bones_.push_back(globals_[animal.bones[b].node] * inverse_binds_[b]);
        if (moving[animal.bones[b].node]) moving_bones_.push_back(b);
    }
}

void ClipSampler::apply(Cursor& cursor, double absolute_s) {
    const Channel& channel = *cursor.channel;
    const float* times = &animal_.key_times[channel.first_time];
    std::uint32_t key = cursor.key;
    // A step at a time that float32 rounded up must not be missed by the row that was meant for it.
    const double reached_s =
        channel.interpolation == Interpolation::step ? absolute_s + kEqualTimesS : absolute_s;
    while (key > 0 && times[key] > reached_s) --key;
    while (key + 1 < channel.key_count && times[key + 1] <= reached_s) ++key;
    // Nor a jump between keys that are one moment.
    const auto is_jump = [&](std::uint32_t k) {
        return k + 1 < channel.key_count && static_cast<double>(times[k + 1]) - times[k] < kEqualTimesS;
    };
    while ((is_jump(key) || is_jump(key + 1)) && times[key + 1] <= absolute_s + kEqualTimesS) ++key;
    cursor.key = key;
    animal::Transform& local = locals_[channel.node];
    switch (channel.path) {
        case Path::translation:
            local.translation = interpolate<glm::dvec3>(animal_, channel, key, absolute_s);
            break;
        case Path::scale:
            local.scale = interpolate<glm::dvec3>(animal_, channel, key, absolute_s);
            break;
        case Path::rotation: {
            const glm::dvec4 q = interpolate<glm::dvec4>(animal_, channel, key, absolute_s);
            const double square = glm::dot(q, q);
            // A cubic spline may pass through zero: the rotation before it holds there.
            if (square > 1e-20) local.rotation = q / std::sqrt(square);
            break;
        }
    }
}

void ClipSampler::sample(double time_s, std::span<Affine> bones) {
    for (Cursor& cursor : moving_channels_) apply(cursor, clip_.start_s + time_s);
    for (const std::uint32_t n : moving_nodes_)
        globals_[n] = global_of(animal_, globals_, n, local_of(animal_.nodes[n], locals_[n]));
    std::copy(still_bones_.begin(), still_bones_.end(), bones.begin());
    for (const std::uint32_t b : moving_bones_)
        bones[b] = globals_[animal_.bones[b].node] * inverse_binds_[b];
}

bool ClipSampler::all_steps() const {
    return moves() && std::all_of(moving_channels_.begin(), moving_channels_.end(), [](const Cursor& cursor) {
               return cursor.channel->interpolation == Interpolation::step;
           });
}

bool ClipSampler::has_splines() const {
    return std::any_of(moving_channels_.begin(), moving_channels_.end(), [](const Cursor& cursor) {
        return cursor.channel->interpolation == Interpolation::cubic_spline;
    });
}

std::vector<double> ClipSampler::jump_times_s() const {
    std::vector<double> times;
    for (const Cursor& cursor : moving_channels_) {
        const Channel& channel = *cursor.channel;
        const float* key_times = &animal_.key_times[channel.first_time];
        for (std::uint32_t k = 1; k < channel.key_count; ++k) {
            const bool is_sudden = channel.interpolation == Interpolation::step ||
                                   static_cast<double>(key_times[k]) - key_times[k - 1] < kEqualTimesS;
            if (is_sudden && !are_equal_keys(animal_, channel, k - 1, k))
                times.push_back(key_times[k] - clip_.start_s);
        }
    }
    std::sort(times.begin(), times.end());
    return times;
}

std::vector<double> ClipSampler::key_times_s() const {
    std::vector<std::uint32_t> starts;  // exporters share one list of times between most channels
    std::vector<double> times;
    for (const Cursor& cursor : moving_channels_) {
        const Channel& channel = *cursor.channel;
        if (std::find(starts.begin(), starts.end(), channel.first_time) != starts.end()) continue;
        starts.push_back(channel.first_time);
        for (std::uint32_t k = 0; k < channel.key_count; ++k)
            times.push_back(animal_.key_times[channel.first_time + k] - clip_.start_s);
    }
    std::sort(times.begin(), times.end());
    const auto same = [](double a, double b) { return b - a < kEqualTimesS; };
    times.erase(std::unique(times.begin(), times.end(), same), times.end());
    return times;
}

}  // namespace posepack::motion
