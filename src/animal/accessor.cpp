// SPDX-License-Identifier: MIT
#include "animal/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::uint64_t kMaxElements = 16u << 20;
constexpr std::uint64_t kMaxDecodedBytes = 2ull << 30;

std::size_t component_bytes(int component) {
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

std::size_t type_components(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        case TINYGLTF_TYPE_MAT4:
            return 16;
        default:
            return 0;
    }
}

// Names as glTF 2.0 gives them, in sections 3.6.2.2 and 3.6.2.4.
std::string type_name(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return "SCALAR";
        case TINYGLTF_TYPE_VEC2:
            return "VEC2";
        case TINYGLTF_TYPE_VEC3:
            return "VEC3";
        case TINYGLTF_TYPE_VEC4:
            return "VEC4";
        case TINYGLTF_TYPE_MAT2:
            return "MAT2";
        case TINYGLTF_TYPE_MAT3:
            return "MAT3";
        case TINYGLTF_TYPE_MAT4:
            return "MAT4";
        default:
            return "no type of glTF";
    }
}

std::string component_name(int component) {
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return "BYTE";
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return "UNSIGNED_BYTE";
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return "SHORT";
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return "UNSIGNED_SHORT";
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return "UNSIGNED_INT";
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return "FLOAT";
        default:
            return fmt::format("component type {}", component);
    }
}

std::string component_names(std::initializer_list<int> components) {
    std::string names;
    for (const int component : components) names += (names.empty() ? "" : " or ") + component_name(component);
    return names;
}

template <class Integer>
Integer load(const std::uint8_t* at) {
    Integer value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

// glTF 2.0 section 3.11, "Animations": the same formulas hold for every normalised accessor.
float to_float(const std::uint8_t* at, int component) {
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return load<float>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return static_cast<float>(*at) / 255.0f;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return static_cast<float>(load<std::uint16_t>(at)) / 65535.0f;
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return std::max(static_cast<float>(load<std::int8_t>(at)) / 127.0f, -1.0f);
        default:
            return std::max(static_cast<float>(load<std::int16_t>(at)) / 32767.0f, -1.0f);
    }
}

std::uint32_t to_integer(const std::uint8_t* at, int component) {
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return *at;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(at);
        default:
            return load<std::uint32_t>(at);
    }
}

// KHR_mesh_quantization lets positions and normals be plain integers.
float to_plain_float(const std::uint8_t* at, int component) {
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return load<float>(at);
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return static_cast<float>(load<std::int8_t>(at));
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return static_cast<float>(load<std::int16_t>(at));
        default:
            return static_cast<float>(to_integer(at, component));
    }
}

}  // namespace

// Bytes that were proven to lie inside a buffer; no data means zeros.
struct AccessorReader::Source {
    const tinygltf::Accessor* accessor = nullptr;
    const std::uint8_t* data = nullptr;
    std::size_t count = 0;
    std::size_t stride_bytes = 0;
    std::size_t components = 0;
    int component = 0;
};

AccessorReader::AccessorReader(const LoadedGltf& gltf)
    : model_(*gltf.model),
      decoded_limit_bytes_(std::min(kMaxDecodedBytes, 16 * gltf.file_bytes + (64u << 20))) {}

base::Result<AccessorReader::Source> AccessorReader::open_view(int view_index, std::size_t byte_offset,
                                                               std::size_t count, int type, int component,
                                                               bool tight, const std::string& where) const {
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size())
        return Issue{IssueCode::glb_reference, where,
                     fmt::format("expected one of {} buffer views, found index {}", model_.bufferViews.size(),
                                 view_index)};
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size())
        return Issue{
            IssueCode::glb_reference, fmt::format("bufferViews/{}", view_index),
            fmt::format("expected one of {} buffers, found index {}", model_.buffers.size(), view.buffer)};
    const std::size_t buffer_bytes = model_.buffers[static_cast<std::size_t>(view.buffer)].data.size();
    if (view.byteOffset > buffer_bytes || view.byteLength > buffer_bytes - view.byteOffset)
        return Issue{
            IssueCode::glb_view_range, fmt::format("bufferViews/{}", view_index),
            fmt::format("expected a range within the buffer's {} bytes, found {} bytes from byte {} on",
                        buffer_bytes, view.byteLength, view.byteOffset)};
    const std::size_t components = type_components(type);
    const std::size_t element_bytes = components * component_bytes(component);
    const std::size_t stride = tight || view.byteStride == 0 ? element_bytes : view.byteStride;
    if (stride < element_bytes || stride > 252 + element_bytes)
        return Issue{IssueCode::glb_accessor_range, where,
                     fmt::format("expected a stride of {} to {} bytes, found {}", element_bytes,
                                 252 + element_bytes, stride)};
    // count is below 2^32 and stride below 2^9: the product cannot overflow.
    const std::size_t needed = count == 0 ? 0 : (count - 1) * stride + element_bytes;
    if (byte_offset > view.byteLength || needed > view.byteLength - byte_offset)
        return Issue{
            IssueCode::glb_accessor_range, where,
            fmt::format("expected elements within the buffer view's {} bytes, found {} from byte {} on that "
                        "end at {}",
                        view.byteLength, count, byte_offset, byte_offset + needed)};
    Source source;
    source.data =
        model_.buffers[static_cast<std::size_t>(view.buffer)].data.data() + view.byteOffset + byte_offset;
    source.count = count;
    source.stride_bytes = stride;
    source.components = components;
    source.component = component;
    return source;
}

base::Result<AccessorReader::Source> AccessorReader::open(int index, const AccessorUse& use) {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size())
        return Issue{
            IssueCode::glb_reference, use.where,
            fmt::format("expected one of {} accessors, found index {}", model_.accessors.size(), index)};
    const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    const std::string where = fmt::format("{} (accessors/{})", use.where, index);
    if (accessor.type != use.type || std::find(use.components.begin(), use.components.end(),
                                               accessor.componentType) == use.components.end())
        return Issue{IssueCode::glb_accessor_type, where,
                     fmt::format("expected {} of {}, found {} of {}", type_name(use.type),
                                 component_names(use.components), type_name(accessor.type),
                                 component_name(accessor.componentType))};
    if (accessor.count == 0)
        return Issue{IssueCode::glb_accessor_count, where, "expected at least one element, found 0"};
    if (accessor.count > std::numeric_limits<std::uint32_t>::max())
        return Issue{IssueCode::glb_accessor_range, where,
                     fmt::format("expected at most {} elements, found {}",
                                 std::numeric_limits<std::uint32_t>::max(), accessor.count)};
    Source source;
    source.components = type_components(use.type);
    source.component = accessor.componentType;
    source.count = accessor.count;
    if (accessor.bufferView >= 0) {
        auto opened = open_view(accessor.bufferView, accessor.byteOffset, accessor.count, accessor.type,
                                accessor.componentType, false, where);
        if (!opened) return opened.issue();
        source = opened.value();
    }
    // Counted after the range check, so that a lie about the count is called one; before any allocation.
    decoded_bytes_ += accessor.count * source.components * sizeof(float);
    if (accessor.count > kMaxElements || decoded_bytes_ > decoded_limit_bytes_)
        return Issue{
            IssueCode::lim_decoded, where,
            fmt::format(
                "expected at most {} bytes of decoded data, found {} with the {} elements of this one",
                decoded_limit_bytes_, decoded_bytes_, accessor.count)};
    source.accessor = &accessor;
    return source;
}

template <class T, class Convert>
base::Result<std::vector<T>> AccessorReader::read(int index, const AccessorUse& use, Convert convert) {
    auto opened = open(index, use);
    if (!opened) return opened.issue();
    const Source source = opened.value();
    std::vector<T> out(source.count * source.components);
    const auto copy = [&](const Source& from, std::size_t element, std::size_t to) {
        const std::uint8_t* at = from.data + element * from.stride_bytes;
        for (std::size_t c = 0; c < from.components; ++c)
            out[to * from.components + c] = convert(at + c * component_bytes(from.component), from.component);
    };
    if (source.data != nullptr)
        for (std::size_t i = 0; i < source.count; ++i) copy(source, i, i);

    const auto& sparse = source.accessor->sparse;
    if (!sparse.isSparse) return out;
    const std::string where = fmt::format("{} (accessors/{}/sparse)", use.where, index);
    if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > source.count)
        return Issue{IssueCode::glb_sparse, where,
                     fmt::format("expected 1 to {} values, found {}", source.count, sparse.count)};
    const int index_type = sparse.indices.componentType;
    if (index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
        index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
        return Issue{
            IssueCode::glb_sparse, where,
            fmt::format("expected indices of UNSIGNED_BYTE, UNSIGNED_SHORT or UNSIGNED_INT, found {}",
                        component_name(index_type))};
    const auto count = static_cast<std::size_t>(sparse.count);
    // Both streams are tightly packed whatever their views say (glTF 2.0 section 3.6.2.3).
    auto indices = open_view(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                             count, TINYGLTF_TYPE_SCALAR, index_type, true, where);
    if (!indices) return indices.issue();
    auto values = open_view(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                            count, use.type, source.component, true, where);
    if (!values) return values.issue();
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* at = indices.value().data + i * indices.value().stride_bytes;
        const std::size_t target = to_integer(at, index_type);
        if (target < next || target >= source.count)
            return Issue{
                IssueCode::glb_sparse, where,
                fmt::format("expected index {} from {} to {}, found {}", i, next, source.count - 1, target)};
        copy(values.value(), i, target);
        next = target + 1;
    }
    return out;
}

base::Result<std::vector<float>> AccessorReader::read_floats(int index, const AccessorUse& use) {
    const bool exists = index >= 0 && static_cast<std::size_t>(index) < model_.accessors.size();
    const bool plain = exists && !model_.accessors[static_cast<std::size_t>(index)].normalized;
    auto floats = read<float>(index, use, plain ? to_plain_float : to_float);
    if (!floats || use.allow_not_finite) return floats;
    const auto& values = floats.value();
    const auto bad = std::find_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
    if (bad == values.end()) return floats;
    return Issue{IssueCode::glb_number, fmt::format("{} (accessors/{})", use.where, index),
                 fmt::format("expected finite numbers, found element {} with {}",
                             (bad - values.begin()) / static_cast<long>(type_components(use.type)), *bad)};
}

base::Result<std::vector<std::uint32_t>> AccessorReader::read_integers(int index, const AccessorUse& use) {
    return read<std::uint32_t>(index, use, to_integer);
}

}  // namespace posepack::animal
