// SPDX-License-Identifier: MIT
// Models at the edges of what animals are, made in code: many joints, long chains, mirrors, shear, long
// clips. Keys lie at 30 Hz from 0 s on; every joint has a vertex or two of its own.
#pragma once

#include "support/model_spec.hpp"

namespace posepack::support {

inline constexpr double kExtremeRateHz = 30.0;

// `count` joints in a tree, each the parent of up to four; all turn for half a second, each about its own
// axis.
ModelSpec many_joints(int count);

// `count` joints in one chain, each an arm's length from the last, curling up together.
ModelSpec long_chain(int count);

// Three joints of which the middle one is mirrored (scale -1, 1, 1) and turns, as does the one below it.
ModelSpec mirrored_joint();

// A joint whose scale goes from 1 through 0 to -1, with a child that turns.
ModelSpec scale_through_zero();

// A joint that turns under a parent stretched by 1, 3 and 0.5, with a child that turns too: shear.
ModelSpec shear_under_rotation();

// Two skins of one skeleton: joints 0, 1, 2 and joints 2, 0. Mesh 1 is bound to the second.
ModelSpec shared_joint();

// `count` clips of two to six keys, each of its own motion, named "clip 0" and on.
ModelSpec many_clips(int count);

// One clip of `duration_s` seconds with a key every thirtieth of a second.
ModelSpec long_clip(double duration_s);

// A root that walks `radius` units around a circle, looking ahead, two times round in four seconds, while the
// joint below it swings.
ModelSpec walking_in_circles(double radius);

}  // namespace posepack::support
