// SPDX-License-Identifier: MIT
// Small still meshes: a tuft of grass, a flower, a tree. They use the vertices of skinned meshes, without
// bones.
#pragma once

#include "render/glb_mesh.hpp"

namespace posepack::render {

SkinnedMesh make_tuft();
SkinnedMesh make_flower();
SkinnedMesh make_tree();

}  // namespace posepack::render
