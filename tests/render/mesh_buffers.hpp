// SPDX-License-Identifier: MIT
// A skinned mesh in GPU buffers: attributes 0 position, 1 normal, 2 colour, 3 bones, 4 weights.
#pragma once

#include "render/gl_objects.hpp"
#include "render/glb_mesh.hpp"

namespace posepack::render {

struct MeshBuffers {
    VertexArray vertex_array;
    Buffer vertices;
    Buffer indices;
    int index_count = 0;
    int vertex_count = 0;
};

// Leaves the vertex array bound, so that attributes of instances can join it.
MeshBuffers upload_mesh(const SkinnedMesh& mesh);

}  // namespace posepack::render
