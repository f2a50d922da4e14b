// SPDX-License-Identifier: MIT
// Accessors: the only way from glTF data to numbers.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "animal/buffer_views.hpp"
#include "animal/draco_mesh.hpp"
#include "animal/element_span.hpp"

namespace posepack::animal {

// A place in the glTF, put into words only when a message needs it: "meshes/0/primitives/1/POSITION".
struct Place {
    std::string_view list;
    std::size_t index = 0;
    std::string_view inner_list = {};  // empty: none
    std::size_t inner_index = 0;
    std::string_view leaf = {};  // empty: none

    std::string text() const;
};

// What a use of an accessor asks for.
struct AccessorUse {
    Place place;
    ElementType type = ElementType::scalar;
    std::initializer_list<int> components;  // accepted component types
    bool allow_not_finite = false;          // weights: repaired later
    // An attribute of a Draco primitive: its values come from there instead of a buffer view.
    const DracoMesh* draco = nullptr;
    std::uint32_t draco_id = 0;
};

// Reads accessors of one model, and counts what they decode to against a limit that grows with the file.
class AccessorReader {
 public:
    explicit AccessorReader(const LoadedGltf& gltf);

    // Every element as floats, element by element, component by component; matrices column by column.
    // Normalised integers are converted by glTF 2.0 section 3.11, others keep their value
    // (KHR_mesh_quantization). Errors: E-GLB-REFERENCE, E-GLB-ACCESSOR-*, E-GLB-VIEW-RANGE, E-GLB-URI,
    // E-GLB-SPARSE, E-GLB-NUMBER, E-GLB-MESHOPT, E-GLB-DRACO, E-GLB-EXTENSION, E-LIM-DECODED.
    base::Result<std::vector<float>> read_floats(int index, const AccessorUse& use);

    // The same, behind what `out` holds already. Returns the numbers added.
    base::Result<std::size_t> append_floats(int index, const AccessorUse& use, std::vector<float>& out);

    // Every element as unsigned integers. Errors as above.
    base::Result<std::vector<std::uint32_t>> read_integers(int index, const AccessorUse& use);

    // Elements that an accessor declares; 0 when it does not exist.
    std::uint64_t declared_count(int index) const;

    // Bytes of the BIN chunk.
    std::size_t stored_bytes() const { return gltf_.bin.size(); }

    // Counts `count` elements of `element_bytes` that are made of what was read. Errors: E-LIM-DECODED.
    base::Status take(std::uint64_t count, std::uint64_t element_bytes) {
        return budget_.take(count, element_bytes);
    }

    // Decodes the primitive of KHR_draco_mesh_compression in a buffer view. Errors: as above.
    base::Result<DracoMesh> read_draco(int view_index, const DracoLimits& limits);

    const tinygltf::Model& model() const { return gltf_.model_ref(); }
    const GltfFacts& facts() const { return gltf_.facts; }

 private:
    struct Source;
    base::Result<Source> open(int index, const AccessorUse& use);
    base::Result<ElementSpan> open_view(std::uint64_t view_index, std::uint64_t offset_bytes,
                                        const ElementShape& shape, bool is_tight);
    base::Status open_draco(const AccessorUse& use, Source& source);
    template <class T>
    base::Status read_sparse(const Source& source, T* out);

    const LoadedGltf& gltf_;
    DecodeBudget budget_;
    BufferViews views_;
};

}  // namespace posepack::animal
