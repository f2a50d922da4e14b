// SPDX-License-Identifier: MIT
#include "animal/element_span.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::size_t kMaxStrideBytes = 252;

template <class T>
T load(const std::uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

// Calls `copy` with a function object that reads one component of this type as a float.
template <class Copy>
void with_float_reader(int component, bool normalised, Copy copy) {
    switch (component) {
        case kByte:
            if (normalised)
                copy([](const std::uint8_t* p) { return std::max(load<std::int8_t>(p) / 127.0f, -1.0f); });
            else
                copy([](const std::uint8_t* p) { return static_cast<float>(load<std::int8_t>(p)); });
            break;
        case kUnsignedByte:
            if (normalised)
                copy([](const std::uint8_t* p) { return *p / 255.0f; });
            else
                copy([](const std::uint8_t* p) { return static_cast<float>(*p); });
            break;
        case kShort:
            if (normalised)
                copy([](const std::uint8_t* p) { return std::max(load<std::int16_t>(p) / 32767.0f, -1.0f); });
            else
                copy([](const std::uint8_t* p) { return static_cast<float>(load<std::int16_t>(p)); });
            break;
        case kUnsignedShort:
            if (normalised)
                copy([](const std::uint8_t* p) { return load<std::uint16_t>(p) / 65535.0f; });
            else
                copy([](const std::uint8_t* p) { return static_cast<float>(load<std::uint16_t>(p)); });
            break;
        case kUnsignedInt:
            copy([](const std::uint8_t* p) { return static_cast<float>(load<std::uint32_t>(p)); });
            break;
        default:
            copy([](const std::uint8_t* p) { return load<float>(p); });
    }
}

template <class Copy>
void with_integer_reader(int component, Copy copy) {
    switch (component) {
        case kUnsignedByte:
            copy([](const std::uint8_t* p) -> std::uint32_t { return *p; });
            break;
        case kUnsignedShort:
            copy([](const std::uint8_t* p) -> std::uint32_t { return load<std::uint16_t>(p); });
            break;
        default:
            copy([](const std::uint8_t* p) { return load<std::uint32_t>(p); });
    }
}

template <class T, class Read>
void copy_all(const std::uint8_t* data, const ElementShape& shape, T* out, Read read) {
    const std::size_t step = component_bytes(shape.component);
    for (std::size_t i = 0; i < shape.count; ++i) {
        const std::uint8_t* at = data + i * shape.stride_bytes;
        for (std::size_t c = 0; c < shape.components; ++c) *out++ = read(at + c * step);
    }
}

}  // namespace

std::size_t component_bytes(int component) {
    switch (component) {
        case kByte:
        case kUnsignedByte:
            return 1;
        case kShort:
        case kUnsignedShort:
            return 2;
        case kUnsignedInt:
        case kFloat:
            return 4;
        default:
            return 0;
    }
}

base::Result<ElementSpan> ElementSpan::over(std::span<const std::uint8_t> bytes, std::size_t offset_bytes,
                                            ElementShape shape) {
    const std::size_t element_bytes = shape.element_bytes();
    if (shape.stride_bytes == 0) shape.stride_bytes = element_bytes;
    if (shape.stride_bytes < element_bytes || shape.stride_bytes > std::max(kMaxStrideBytes, element_bytes))
        return Issue{
            IssueCode::glb_accessor_range, "",
            fmt::format("a stride of {} bytes does not fit elements of {}", shape.stride_bytes, element_bytes)};
    const auto outside = [&](const std::string& end) {
        return Issue{IssueCode::glb_accessor_range, "",
                     fmt::format("{} elements from byte {} on end {}, the buffer view has {} bytes", shape.count,
                                 offset_bytes, end, bytes.size())};
    };
    if (shape.count == 0) return ElementSpan(bytes.data(), shape);
    if (shape.count - 1 > (std::numeric_limits<std::size_t>::max() - element_bytes) / shape.stride_bytes)
        return outside("beyond every buffer");
    const std::size_t needed = (shape.count - 1) * shape.stride_bytes + element_bytes;
    if (offset_bytes > bytes.size()) return outside("behind it");
    if (needed > bytes.size() - offset_bytes) return outside(fmt::format("{} bytes later", needed));
    return ElementSpan(bytes.data() + offset_bytes, shape);
}

void ElementSpan::copy_floats(bool normalised, float* out) const {
    if (shape_.component == kFloat && shape_.stride_bytes == shape_.element_bytes()) {
        if (shape_.count > 0) std::memcpy(out, data_, shape_.count * shape_.stride_bytes);
        return;
    }
    with_float_reader(shape_.component, normalised, [&](auto read) { copy_all(data_, shape_, out, read); });
}

void ElementSpan::copy_integers(std::uint32_t* out) const {
    with_integer_reader(shape_.component, [&](auto read) { copy_all(data_, shape_, out, read); });
}

void ElementSpan::copy_element(std::size_t index, bool normalised, float* out) const {
    ElementShape one = shape_;
    one.count = 1;
    ElementSpan(data_ + index * shape_.stride_bytes, one).copy_floats(normalised, out);
}

void ElementSpan::copy_element(std::size_t index, std::uint32_t* out) const {
    ElementShape one = shape_;
    one.count = 1;
    ElementSpan(data_ + index * shape_.stride_bytes, one).copy_integers(out);
}

}  // namespace posepack::animal
