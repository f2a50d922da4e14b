// SPDX-License-Identifier: MIT
// Meshes without a skin, which move as a whole with their nodes.
#pragma once

#include "animal/bind_skins.hpp"
#include "animal/read_parts.hpp"

namespace posepack::animal {

// Bones, joint map and meshes (without vertices) of the nodes that draw a mesh without a skin, behind those
// of the skins: one bone a node, whose matrix is the global transform of the node, because the vertices are
// in the space of the node. In a model with skins those alone that a joint carries or a channel moves; the
// others stand still, and are named as left out. Errors: E-GLB-REFERENCE, E-LIM-BONES, E-LIM-STRING.
base::Status read_rigid_meshes(ReadContext& context, SkinBinder& binder);

}  // namespace posepack::animal
