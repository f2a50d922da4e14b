// SPDX-License-Identifier: MIT
// GLBs put together by hand: a JSON document that a test may edit freely, and the bytes that it points into.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace posepack::support {

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

// glTF 2.0 component types.
inline constexpr int kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126;

// The component type of a C++ number.
template <class T>
constexpr int component_of() {
    if constexpr (std::is_same_v<T, std::int8_t>) return kI8;
    if constexpr (std::is_same_v<T, std::uint8_t>) return kU8;
    if constexpr (std::is_same_v<T, std::int16_t>) return kI16;
    if constexpr (std::is_same_v<T, std::uint16_t>) return kU16;
    if constexpr (std::is_same_v<T, std::uint32_t>) return kU32;
    return kF32;
}

// Numbers that "SCALAR", "VEC3", "MAT4" and so on hold.
std::size_t components_of(std::string_view type);

// A GLB with these two chunks, each filled to a multiple of four bytes; no BIN chunk when `bin` is empty.
Bytes pack_glb(std::string_view json, std::span<const std::uint8_t> bin);

class GlbBuilder {
 public:
    Json document{{"asset", {{"version", "2.0"}}}};
    Bytes bin;

    // Appends bytes at a multiple of four. Returns the index of their buffer view.
    int add_view(std::span<const std::uint8_t> bytes, int stride_bytes = 0);

    template <class T>
    int add_view_of(const std::vector<T>& values, int stride_bytes = 0) {
        return add_view({reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)},
                        stride_bytes);
    }

    // An accessor over a view; a view below 0: none, all zeros.
    int add_accessor(int view, std::size_t offset_bytes, int component, std::size_t count,
                     std::string_view type, bool normalised = false);

    // A view and an accessor of these values, element by element.
    template <class T>
    int add_values(const std::vector<T>& values, std::string_view type, bool normalised = false) {
        return add_accessor(add_view_of(values), 0, component_of<T>(), values.size() / components_of(type),
                            type, normalised);
    }

    // Appends to a list of the root object. Returns the index.
    int add(const std::string& list, Json item);

    // The accessor of an attribute of the first primitive of a mesh.
    Json& attribute(std::size_t mesh, const std::string& name);

    // The accessors of a channel's key times and values.
    Json& times(std::size_t animation, std::size_t channel) { return sampled(animation, channel, "input"); }
    Json& values(std::size_t animation, std::size_t channel) { return sampled(animation, channel, "output"); }

    // Overwrites number `index` of an accessor that has a tightly packed view of its own.
    template <class T>
    void set(const Json& accessor, std::size_t index, T value) {
        const Json& view = document.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
        std::memcpy(&bin.at(view.at("byteOffset").get<std::size_t>() + index * sizeof(T)), &value,
                    sizeof value);
    }

    // The file; the length of the buffer is filled in where the document has a buffer without one.
    Bytes build() const;

 private:
    Json& sampled(std::size_t animation, std::size_t channel, const char* end);
};

}  // namespace posepack::support
