// SPDX-License-Identifier: MIT
// The vertices of one primitive, from plain accessors or out of a Draco stream.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "animal/read_parts.hpp"

namespace posepack::animal {

struct Primitive {
    std::vector<std::array<float, 3>> positions, normals;  // normals: zeros where the primitive has none
    std::vector<std::uint16_t> bones;                      // vertex by vertex, `influences` each
    std::vector<float> weights;                            // in step with `bones`; as stored, NaN included
    std::size_t influences = 0;
};

// Reads primitive `index` of a mesh; it has positions, and joints where the mesh has a skin.
// Errors: those of AccessorReader; E-GLB-ACCESSOR-COUNT where attributes differ in their number of elements;
// E-GLB-JOINT-INDEX.
base::Result<Primitive> read_primitive(ReadContext& context, const Mesh& mesh, std::size_t index);

}  // namespace posepack::animal
