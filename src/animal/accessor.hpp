// SPDX-License-Identifier: MIT
// Accessors: the only way from glTF data to numbers. All arithmetic on counts and offsets is checked here.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "animal/load_gltf.hpp"

namespace posepack::animal {

// What a use of an accessor asks for.
struct AccessorUse {
    std::string where;                // for messages: "meshes/0/primitives/1/POSITION"
    int type = TINYGLTF_TYPE_SCALAR;  // TINYGLTF_TYPE_*
    std::initializer_list<int>
        components;                 // accepted component types; integers must be normalised for floats
    bool allow_not_finite = false;  // weights: repaired later
};

// Reads accessors of one model, and counts what they decode to against a limit that grows with the file.
class AccessorReader {
 public:
    explicit AccessorReader(const LoadedGltf& gltf);

    // Every element as floats, element by element, component by component; matrices column by column.
    // Normalised integers are converted by glTF 2.0 section 3.11. Errors: E-GLB-REFERENCE,
    // E-GLB-ACCESSOR-*, E-GLB-VIEW-RANGE, E-GLB-SPARSE, E-GLB-NUMBER, E-LIM-DECODED.
    base::Result<std::vector<float>> read_floats(int index, const AccessorUse& use);

    // Every element as unsigned integers. Errors as above.
    base::Result<std::vector<std::uint32_t>> read_integers(int index, const AccessorUse& use);

    const tinygltf::Model& model() const { return model_; }

 private:
    struct Source;
    base::Result<Source> open(int index, const AccessorUse& use);
    base::Result<Source> open_view(int view_index, std::size_t byte_offset, std::size_t count, int type,
                                   int component, bool tight, const std::string& where) const;
    template <class T, class Convert>
    base::Result<std::vector<T>> read(int index, const AccessorUse& use, Convert convert);

    const tinygltf::Model& model_;
    std::uint64_t decoded_bytes_ = 0;
    std::uint64_t decoded_limit_bytes_ = 0;
};

}  // namespace posepack::animal
