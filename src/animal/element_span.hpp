// SPDX-License-Identifier: MIT
// ElementSpan: numbers proven to lie inside a buffer view. All arithmetic on counts, strides and offsets of
// accessors and sparse streams is done, and checked, here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/result.hpp"

namespace posepack::animal {

// glTF 2.0 component types (section 5.1.3).
inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                     kUnsignedInt = 5125, kFloat = 5126;

// Bytes of a component; 0 for a type that glTF does not have.
std::size_t component_bytes(int component);

struct ElementShape {
    std::size_t count = 0;         // of elements
    std::size_t components = 1;    // of an element: 1 to 16
    int component = kFloat;        // one of the types above
    std::size_t stride_bytes = 0;  // from element to element; 0: tightly packed

    std::size_t element_bytes() const { return components * component_bytes(component); }
};

class ElementSpan {
 public:
    // The elements of `shape` in `bytes`, from `offset_bytes` on. The span points into `bytes`.
    // Errors: E-GLB-ACCESSOR-RANGE where one leaves `bytes`, or where a stride is shorter than an element or
    // longer than 252 bytes (glTF 2.0 section 5.11.4). `where` is left empty for the caller to fill.
    static base::Result<ElementSpan> over(std::span<const std::uint8_t> bytes, std::size_t offset_bytes,
                                          ElementShape shape);

    std::size_t count() const { return shape_.count; }
    std::size_t components() const { return shape_.components; }

    // Writes element after element into `out`, which holds count() x components() numbers. Normalised integers
    // become -1..1 or 0..1 by glTF 2.0 section 3.11, others keep their value.
    void copy_floats(bool normalised, float* out) const;
    void copy_integers(std::uint32_t* out) const;  // unsigned component types alone

    // The same for one element, of components() numbers.
    void copy_element(std::size_t index, bool normalised, float* out) const;
    void copy_element(std::size_t index, std::uint32_t* out) const;

 private:
    ElementSpan(const std::uint8_t* data, ElementShape shape) : data_(data), shape_(shape) {}

    const std::uint8_t* data_;
    ElementShape shape_;  // stride_bytes filled in
};

}  // namespace posepack::animal
