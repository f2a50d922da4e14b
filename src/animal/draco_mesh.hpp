// SPDX-License-Identifier: MIT
// The only door to Draco: primitives of KHR_draco_mesh_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "animal/decode_budget.hpp"
#include "base/result.hpp"

namespace posepack::animal {

// What the accessors of a primitive declare; a stream that asks for more is not decoded.
struct DracoLimits {
    std::uint64_t point_count = 0;
    std::uint64_t face_count = 0;
};

// A decoded triangle mesh. Only what its attributes hold is of use here.
class DracoMesh {
 public:
    // Reads the stream's header, compares what it asks for with `limits` and `budget`, then decodes it.
    // Both methods of Draco (sequential and edgebreaker) are read, in bitstream 2.2, which glTF prescribes.
    // Errors, with an empty `where`: E-GLB-DRACO; E-LIM-DECODED before anything of that size is allocated.
    static base::Result<DracoMesh> decode(std::span<const std::uint8_t> bytes, const DracoLimits& limits,
                                          DecodeBudget& budget);

    DracoMesh(DracoMesh&&) noexcept;
    DracoMesh& operator=(DracoMesh&&) noexcept;
    ~DracoMesh();

    std::size_t point_count() const;

    // The values of the attribute with this unique id, point by point, as tightly packed numbers of a glTF
    // component type; a value that this type does not hold is refused, and so is another number of
    // components. Errors, with an empty `where`: E-GLB-DRACO.
    base::Result<std::vector<std::uint8_t>> values(std::uint32_t unique_id, int component,
                                                   std::size_t components) const;

 private:
    struct Body;
    explicit DracoMesh(std::unique_ptr<Body> body);
    std::unique_ptr<Body> body_;
};

}  // namespace posepack::animal
