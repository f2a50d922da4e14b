// SPDX-License-Identifier: MIT
// Bones that move nothing: control and helper joints, and limbs without vertices.
#pragma once

#include "animal/animal.hpp"

namespace posepack::animal {

// Takes the bones out on which no vertex of the file has a weight: those left move up, keep their order, and
// hang from the nearest ancestor that is left. Joints of bones that are gone become kNoBone in the joint map.
void drop_unused_bones(Animal& animal);

}  // namespace posepack::animal
