// SPDX-License-Identifier: MIT
// How a glTF stores its numbers: accessors and buffer views as the JSON declares them, gathered in the pass
// that checks it. Half of the JSON of an animal is these two lists, and no tree is built of them.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace posepack::animal {

inline constexpr std::uint64_t kMissing = std::numeric_limits<std::uint64_t>::max();

// EXT_meshopt_compression or KHR_meshopt_compression of a buffer view, as declared.
struct CompressionFacts {
    std::uint64_t buffer = kMissing, offset_bytes = 0, length_bytes = kMissing;
    std::uint64_t stride_bytes = kMissing, count = kMissing;
    std::string mode, filter = "NONE";
};

struct ViewFacts {
    std::uint64_t buffer = kMissing;  // an index, perhaps of nothing
    std::uint64_t offset_bytes = 0, length_bytes = kMissing;
    std::uint64_t stride_bytes = 0;  // 0: tightly packed; else a multiple of 4 up to 252
    std::optional<CompressionFacts> compression;
};

struct SparseFacts {
    std::uint64_t count = kMissing;
    std::uint64_t index_view = kMissing, index_offset_bytes = 0, index_component = kMissing;
    std::uint64_t value_view = kMissing, value_offset_bytes = 0;
};

enum class ElementType : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };

// Numbers of an element.
std::size_t components_of(ElementType type);

struct AccessorFacts {
    std::uint64_t view = kMissing;  // an index, perhaps of nothing; kMissing: none
    std::uint64_t offset_bytes = 0;
    std::uint64_t component = kMissing;  // a glTF component type (element_span.hpp)
    std::uint64_t count = kMissing;
    bool normalised = false;
    std::string type_name;
    ElementType type = ElementType::scalar;
    std::optional<SparseFacts> sparse;
};

// Hears what stands inside the root object's "accessors" and "bufferViews". Depth counts open objects and
// arrays: items of the lists have their keys at depth 3.
class StorageVisitor {
 public:
    std::vector<AccessorFacts> accessors;
    std::vector<ViewFacts> views;

    enum class List : std::uint8_t { accessors, views };

    void begin(List list);
    void key(std::size_t depth, std::string_view name);
    void text(std::size_t depth, std::string_view value);
    void number(std::size_t depth, double value);
    void truth(std::size_t depth, bool value);
    void open(std::size_t depth, bool is_array);  // depth: before it opened
    void close(std::size_t depth);                // depth: after it closed

    // E-GLB-SCHEMA for the first item that lacks what it must have, or holds a value of another type.
    base::Status status() const;

 private:
    // What an open object at depth 4 or 5 is.
    enum class Inside : std::uint8_t { other, sparse, sparse_indices, sparse_values, extensions, meshopt };

    // Where the value of the key just heard goes. At most one is set.
    struct Slot {
        std::uint64_t* whole = nullptr;
        std::string* text = nullptr;
        bool* truth = nullptr;

        bool is_set() const { return whole != nullptr || text != nullptr || truth != nullptr; }
    };

    void item_key(std::string_view name);
    void accessor_key(std::string_view name);
    void view_key(std::string_view name);
    void sparse_key(std::string_view name);
    void meshopt_key(std::string_view name);
    void close_accessor();
    void close_view();
    void blame(std::string detail);

    List list_ = List::accessors;
    Slot slot_;
    std::array<Inside, 6> inside_{};  // by depth
    base::Status status_;
};

}  // namespace posepack::animal
