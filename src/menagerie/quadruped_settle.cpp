// SPDX-License-Identifier: MIT
// How far a neck bows and a body sinks until they meet the ground, found by halving.
#include <algorithm>

#include "menagerie/quadruped.hpp"

namespace posepack::menagerie {
namespace {

const ClipScript& script_of(const std::vector<ClipScript>& scripts, const char* name) {
    return *std::find_if(scripts.begin(), scripts.end(),
                         [name](const ClipScript& script) { return script.name == name; });
}

// Height of the lowest point of the head over the ground in a clip's first key, by its joints and the
// thickness of what lies around them.
double head_clearance(const QuadrupedShape& shape, const char* clip) {
    const Quadruped animal = quadruped_of(shape);
    const std::vector<ClipScript> scripts = quadruped_scripts(shape);
    const Placement placed = place(animal.rig, quadruped_pose(animal, script_of(scripts, clip), 0.0));
    const auto height = [&](int joint) { return placed.heads[static_cast<std::size_t>(joint)].y; };
    const int nose = animal.joints.head + 1;  // Head_end
    const double muzzle = height(nose) - shape.muzzle_depth;
    const double cheek = height(animal.joints.jaw) - shape.head_depth * 0.5;
    const double neck = height(animal.joints.head) - shape.neck_radius * 1.05;
    return std::min({muzzle, cheek, neck});
}

// The largest angle up to `most` that keeps the head above the ground; `most` where it cannot reach it.
double largest_bow(const QuadrupedShape& given, double QuadrupedShape::*angle, const char* clip, double least,
                   double most) {
    QuadrupedShape shape = given;
    shape.*angle = most;
    if (head_clearance(shape, clip) >= 0.0) return most;
    for (int step = 0; step < 24; ++step) {
        shape.*angle = (least + most) / 2;
        (head_clearance(shape, clip) >= 0.0 ? least : most) = shape.*angle;
    }
    return least;
}

}  // namespace

QuadrupedShape settled(QuadrupedShape shape) {
    shape.settles = true;
    shape.side_drop =
        0.985 - std::max({shape.belly_radius, shape.chest_radius, shape.rump_radius}) / shape.hip_height;
    shape.eat_pitch_degrees = largest_bow(shape, &QuadrupedShape::eat_pitch_degrees, "Eat", -30.0, 125.0);
    shape.sleep_pitch_degrees =
        largest_bow(shape, &QuadrupedShape::sleep_pitch_degrees, "Sleep", -60.0, 70.0);
    return shape;
}

}  // namespace posepack::menagerie
