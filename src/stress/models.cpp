// SPDX-License-Identifier: MIT
#include "stress/models.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/trig.hpp"

namespace posepack::stress {
namespace {

constexpr int kSides = 6;

void add_vertex(RawModel& model, const Vec3& place, const Vec3& normal, int joint, double share_of_next) {
    for (int axis = 0; axis < 3; ++axis) {
        model.positions.push_back(static_cast<float>(place[axis]));
        model.normals.push_back(static_cast<float>(normal[axis]));
    }
    const auto own = static_cast<std::uint16_t>(joint);
    const auto next = static_cast<std::uint16_t>(share_of_next > 0.0 ? joint + 1 : joint);
    model.joints.insert(model.joints.end(), {own, next, 0, 0});
    // A weight that a float holds exactly, so that both sum to one.
    const auto share = static_cast<float>(std::floor(share_of_next * 256.0) / 256.0);
    model.weights.insert(model.weights.end(), {1.0f - share, share, 0.0f, 0.0f});
}

void add_ring(RawModel& model, const Reed& shape, int first_joint, double along) {
    // Counted in parts of the chain from the middle of the first: between two middles the ring is shared.
    const double part = along * shape.joints - 0.5;
    const int lower = std::clamp(static_cast<int>(std::floor(part)), 0, shape.joints - 1);
    const bool is_shared = part > 0.0 && lower + 1 < shape.joints;
    const double share = is_shared ? menagerie::smooth_step(part - lower) : 0.0;
    for (int side = 0; side < kSides; ++side) {
        const double turns = static_cast<double>(side) / kSides;
        const Vec3 normal(cosine_of_turns(turns), 0.0, sine_of_turns(turns));
        add_vertex(model, shape.foot + shape.thickness * normal + Vec3(0.0, along * shape.length, 0.0),
                   normal, first_joint + lower, share);
    }
}

void add_reed(RawModel& model, const Reed& shape, int parent) {
    const int first_joint = static_cast<int>(model.nodes.size());
    const Vec3 step(0.0, shape.length / shape.joints, 0.0);
    for (int joint = 0; joint < shape.joints; ++joint)
        model.nodes.push_back({"joint " + std::to_string(joint),
                               joint == 0 ? parent : first_joint + joint - 1,
                               joint == 0 ? shape.foot : step});
    for (int ring = 0; ring < shape.rings; ++ring)
        add_ring(model, shape, first_joint, static_cast<double>(ring) / (shape.rings - 1));
}

template <class Put>
RawChannel channel(int node, RawPath path, const std::vector<float>& times_s, const Put& put) {
    RawChannel out{node, path, Interpolation::linear, times_s, {}};
    for (const float time_s : times_s)
        put(static_cast<double>(time_s) - static_cast<double>(times_s.front()), out.values);
    return out;
}

RawChannel channel_of(int node, RawPath path, const std::vector<float>& times_s,
                      const std::function<Vec3(double)>& value) {
    return channel(node, path, times_s, [&value](double time_s, std::vector<float>& values) {
        const Vec3 v = value(time_s);
        for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(v[axis]));
    });
}

}  // namespace

RawModel reed(const Reed& shape) {
    RawModel model;
    model.name = "Reed";
    add_reed(model, shape, -1);
    bind_at_rest(model);
    return model;
}

RawModel carried_reed(const Reed& shape) {
    RawModel model;
    model.name = "Reed";
    model.nodes.push_back({"carrier"});
    add_reed(model, shape, 0);
    bind_at_rest(model);
    return model;
}

std::vector<float> grid(std::size_t count, double rate_hz, double first_s) {
    std::vector<float> times_s;
    for (std::size_t key = 0; key < count; ++key)
        times_s.push_back(static_cast<float>(first_s + static_cast<double>(key) / rate_hz));
    return times_s;
}

RawChannel turning(int node, const std::vector<float>& times_s, const std::function<Quat(double)>& turn) {
    return channel(node, RawPath::rotation, times_s, [&turn](double time_s, std::vector<float>& values) {
        const Quat q = turn(time_s);
        for (const double part : {q.x, q.y, q.z, q.w}) values.push_back(static_cast<float>(part));
    });
}

RawChannel moving(int node, const std::vector<float>& times_s, const std::function<Vec3(double)>& place) {
    return channel_of(node, RawPath::translation, times_s, place);
}

RawChannel scaling(int node, const std::vector<float>& times_s, const std::function<Vec3(double)>& scale) {
    return channel_of(node, RawPath::scale, times_s, scale);
}

double decayed(double x) {
    // exp(-x) = 1 / exp(x / 1024)^1024: the series is exact to a double for small x, and ten squarings
    // follow.
    const double y = x / 1024.0;
    double power = 1.0;
    for (int term = 12; term > 0; --term) power = 1.0 + power * y / term;
    for (int i = 0; i < 10; ++i) power *= power;
    return 1.0 / power;
}

std::vector<RawChannel> swaying(const RawModel& model, const std::vector<float>& times_s, double degrees,
                                double period_s) {
    std::vector<RawChannel> channels;
    for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
        const Vec3 axis = glm::normalize(Vec3(1.0, 0.2, 0.3 * (node % 3)));
        channels.push_back(turning(node, times_s, [&](double time_s) {
            return turn_about(axis, degrees * sine_of_turns(time_s / period_s - 0.1 * node));
        }));
    }
    return channels;
}

RawModel with_clip(RawModel model, std::vector<RawChannel> channels) {
    model.clips.push_back({"Move", std::move(channels)});
    return model;
}

}  // namespace posepack::stress
