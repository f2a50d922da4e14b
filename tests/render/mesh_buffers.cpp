// SPDX-License-Identifier: MIT
#include "render/mesh_buffers.hpp"

#include <cstddef>

namespace posepack::render {

MeshBuffers upload_mesh(const SkinnedMesh& mesh) {
    constexpr std::size_t kStride = sizeof(MeshVertex);
    MeshBuffers out;
    out.vertex_array = make_vertex_array();
    out.vertices = make_buffer(GL_ARRAY_BUFFER, mesh.vertices.data(), mesh.vertices.size() * kStride);
    use_float_attribute(0, 3, kStride, offsetof(MeshVertex, position));
    use_float_attribute(1, 3, kStride, offsetof(MeshVertex, normal));
    use_float_attribute(2, 3, kStride, offsetof(MeshVertex, colour));
    use_float_attribute(3, 4, kStride, offsetof(MeshVertex, joints));
    use_float_attribute(4, 4, kStride, offsetof(MeshVertex, weights));
    out.indices = make_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.data(),
                              mesh.indices.size() * sizeof mesh.indices[0]);
    out.index_count = static_cast<int>(mesh.indices.size());
    out.vertex_count = static_cast<int>(mesh.vertices.size());
    return out;
}

}  // namespace posepack::render
