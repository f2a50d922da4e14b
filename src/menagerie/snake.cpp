// SPDX-License-Identifier: MIT
#include "menagerie/snake.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>

#include "base/trig.hpp"

namespace posepack::menagerie {
namespace {

namespace channel = snake_channel;
using Values = std::vector<double>;

double value(const Values& values, int index) {
    return values[static_cast<std::size_t>(index)];
}

double front_step(const SnakeShape& s) {
    return s.length * 0.46 / s.front_joints;
}

double back_step(const SnakeShape& s) {
    return s.length * 0.54 / s.back_joints;
}

void add_head(Snake& animal, int parent, const Vec3& neck) {
    const SnakeShape& s = animal.shape;
    SnakeJoints& j = animal.joints;
    Rig& rig = animal.rig;
    const double l = s.head_length;
    j.head = add_joint(rig, "Head", parent, neck, neck + kAxisZ * l);
    add_joint(rig, "Head_end", j.head, neck + kAxisZ * l, neck + kAxisZ * (l * 1.2));
    const Vec3 hinge = neck + Vec3(0.0, -s.head_depth * 0.25, l * 0.16);
    j.jaw = add_joint(rig, "Jaw", j.head, hinge, hinge + kAxisZ * (l * 0.8));
    const Vec3 eye = neck + Vec3(s.head_radius * 0.66, s.head_depth * 0.42, l * 0.58);
    j.eye = add_joint_pair(rig, "Eye", j.head, eye, eye + kAxisX * 0.005);
    const Vec3 fang = neck + Vec3(s.head_radius * 0.34, -s.head_depth * 0.10, l * 0.84);
    j.fang = add_joint_pair(rig, "Fang", j.head, fang, fang - kAxisY * 0.012);
    const Vec3 tongue = neck + Vec3(0.0, -s.head_depth * 0.22, l * 0.80);
    const Vec3 half = kAxisZ * (s.tongue_length * 0.5);
    j.tongue.push_back(add_joint(rig, "Tongue1", j.head, tongue, tongue + half));
    j.tongue.push_back(add_joint(rig, "Tongue2", j.tongue.front(), tongue + half, tongue + half * 2.0));
}

// Heading of the serpentine, degrees, at a distance counted in waves (Hirose, Biologically Inspired Robots,
// 1993: the serpenoid curve).
double serpentine_heading(double swing_degrees, double waves) {
    return swing_degrees * sine_of_turns(waves);
}

// Way along the serpentine from 0 to `waves`, in wave lengths: x to the left, z ahead. The midpoint rule with
// 48 intervals a wave is exact to nine digits on whole waves of so smooth a curve.
Vec3 serpentine_point(double swing_degrees, double waves) {
    constexpr int kIntervals = 48;
    const double whole = std::floor(waves);
    const auto integrate = [swing_degrees](double end) {
        Vec3 sum(0.0);
        for (int index = 0; index < kIntervals; ++index) {
            const double at = end * (index + 0.5) / kIntervals;
            const double heading = serpentine_heading(swing_degrees, at) * (base::kPi / 180.0);
            sum += Vec3(base::sine(heading), 0.0, base::cosine(heading));
        }
        return sum * (end / kIntervals);
    };
    Vec3 point = integrate(waves - whole);
    if (whole != 0.0) point.z += whole * serpentine_advance(swing_degrees);
    return point;
}

// Directions of the chain's segments for one set of values, from the middle on: those of the chords of the
// serpentine, turned by what the body coils.
struct Curve {
    double swing = 0.0;
    double waves_per_metre = 0.0;
    double shift = 0.0;  // in waves

    Vec3 point(double way_m) const {
        return serpentine_point(swing, way_m * waves_per_metre + shift) / waves_per_metre;
    }
    Vec3 chord(double from_m, double to_m) const { return point(to_m) - point(from_m); }
};

// The turn that lays +Z along `way`, a level direction, then turns it left and raises it.
Quat segment_turn(const Vec3& way, double coil_degrees, double rise_degrees) {
    return yaw(coil_degrees) * turn_between(kAxisZ, way) * pitch(-rise_degrees);
}

void pose_chains(const Snake& animal, const Curve& curve, const Values& v, Pose& pose) {
    const SnakeShape& s = animal.shape;
    const SnakeJoints& j = animal.joints;
    const auto turn = [&pose](int joint) -> Quat& { return pose.turns[static_cast<std::size_t>(joint)]; };
    const double front = front_step(s);
    const Quat middle = segment_turn(curve.chord(0.0, front), 0.0, 0.0);
    turn(j.middle) = roll(value(v, channel::body_roll)) * middle;
    Quat previous = middle;
    for (int index = 0; index < s.front_joints; ++index) {
        const double along = (index + 1.0) / s.front_joints;
        const double begin = front * (index + 1);
        // The neck rises in the first part of the chain and levels out again in the last.
        const double rise = value(v, channel::rear) * smooth_step(along * 1.9) -
                            value(v, channel::crest) * smooth_step(along * 2.2 - 1.2);
        const Quat whole = segment_turn(curve.chord(begin, begin + front),
                                        value(v, channel::coil_front) * along * (0.6 + 0.4 * along), rise);
        turn(j.front[static_cast<std::size_t>(index)]) = glm::conjugate(previous) * whole;
        previous = whole;
    }
    turn(j.head) = glm::conjugate(previous) *
                   segment_turn(kAxisZ, value(v, channel::head_yaw), -value(v, channel::head_pitch)) *
                   roll(value(v, channel::head_roll));
    previous = middle;
    const double back = back_step(s);
    for (int index = 0; index < s.back_joints; ++index) {
        const double along = (index + 1.0) / s.back_joints;
        const double lift = value(v, channel::tail_lift) * smooth_step(along * 2.0 - 1.0);
        const Quat whole = segment_turn(curve.chord(-back * (index + 1), -back * index),
                                        value(v, channel::coil_back) * along * (0.5 + 0.5 * along), lift);
        turn(j.back[static_cast<std::size_t>(index)]) = glm::conjugate(previous) * whole;
        previous = whole;
    }
}

void pose_head(const Snake& animal, const Values& v, Pose& pose) {
    const SnakeJoints& j = animal.joints;
    const auto turn = [&pose](int joint) -> Quat& { return pose.turns[static_cast<std::size_t>(joint)]; };
    turn(j.jaw) = pitch(value(v, channel::jaw));
    for (int side = 0; side < 2; ++side) turn(j.fang + side) = pitch(70.0 - value(v, channel::fangs));
    // Drawn in, the tongue lies inside the mouth.
    const double out = value(v, channel::tongue);
    pose.shifts[static_cast<std::size_t>(j.tongue[0])] = kAxisZ * (animal.shape.tongue_length * (out - 1.0));
    turn(j.tongue[1]) = pitch(18.0 * (1.0 - out));
}

}  // namespace

double serpentine_advance(double swing_degrees) {
    constexpr int kIntervals = 48;
    double sum = 0.0;
    for (int index = 0; index < kIntervals; ++index) {
        const double heading = serpentine_heading(swing_degrees, (index + 0.5) / kIntervals);
        sum += base::cosine(heading * (base::kPi / 180.0));
    }
    return sum / kIntervals;
}

Snake snake_of(const SnakeShape& shape) {
    Snake animal;
    animal.shape = shape;
    SnakeJoints& j = animal.joints;
    const Vec3 centre(0.0, shape.body_radius, 0.0);
    j.root = add_joint(animal.rig, "Root", -1, Vec3(0.0), kAxisZ * 0.1);
    const Vec3 ahead = kAxisZ * front_step(shape);
    const Vec3 behind = -kAxisZ * back_step(shape);
    j.middle = add_joint(animal.rig, "Middle", j.root, centre, centre + ahead);
    int parent = j.middle;
    Vec3 head = centre + ahead;
    for (int index = 0; index < shape.front_joints; ++index) {
        parent = add_joint(animal.rig, fmt::format("Front{}", index + 1), parent, head, head + ahead);
        j.front.push_back(parent);
        head += ahead;
    }
    add_head(animal, parent, head);
    parent = j.middle;
    Vec3 tail = centre;
    for (int index = 0; index < shape.back_joints; ++index) {
        parent = add_joint(animal.rig, fmt::format("Back{}", index + 1), parent, tail, tail + behind);
        j.back.push_back(parent);
        tail += behind;
    }
    add_joint(animal.rig, fmt::format("Back{}_end", shape.back_joints), parent, tail, tail + behind * 0.3);
    return animal;
}

Pose snake_pose(const Snake& animal, const ClipScript& script, double phase) {
    const Values v = channel_values(script, channel::count, phase);
    const SnakeShape& s = animal.shape;
    Pose pose = rest_pose(animal.rig);
    Curve curve{value(v, channel::swing), s.bends / s.length, 0.125};
    Vec3 way(0.0);
    if (script.travel > 0.0) {
        // The middle slides along a curve that lies still on the ground, seen from a frame that goes ahead
        // evenly.
        curve.shift += phase;
        way = serpentine_point(curve.swing, curve.shift) / curve.waves_per_metre;
        way.z -= phase * serpentine_advance(curve.swing) / curve.waves_per_metre;
        way -= Curve{curve.swing, curve.waves_per_metre, 0.0}.point(0.125 / curve.waves_per_metre);
    }
    way += Vec3(value(v, channel::body_x), value(v, channel::body_y), value(v, channel::body_z)) * s.length;
    pose.shifts[static_cast<std::size_t>(animal.joints.middle)] = way;
    pose_chains(animal, curve, v, pose);
    pose_head(animal, v, pose);
    return pose;
}

Model snake_model(const SnakeShape& shape, const ExportStyle& style, int rate_hz) {
    const Snake animal = snake_of(shape);
    const auto pose = [&animal](const ClipScript& script, double phase) {
        return snake_pose(animal, script, phase);
    };
    std::vector<Clip> clips = perform(snake_scripts(), rate_hz, shape.length / shape.bends, pose);
    Model model{shape.name, animal.rig, snake_mesh(animal), std::move(clips), style};
    name_clips(model);
    return model;
}

}  // namespace posepack::menagerie
