// SPDX-License-Identifier: MIT
#include "animal/storage_facts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace posepack::animal {
namespace {

struct NamedType {
    std::string_view name;
    ElementType type;
    std::size_t components;
};

constexpr std::array<NamedType, 7> kTypes{{{"SCALAR", ElementType::scalar, 1},
                                           {"VEC2", ElementType::vec2, 2},
                                           {"VEC3", ElementType::vec3, 3},
                                           {"VEC4", ElementType::vec4, 4},
                                           {"MAT2", ElementType::mat2, 4},
                                           {"MAT3", ElementType::mat3, 9},
                                           {"MAT4", ElementType::mat4, 16}}};

constexpr std::uint64_t kMaxStrideBytes = 252;          // glTF 2.0 section 5.11.4
constexpr double kWholeLimit = 18446744073709551616.0;  // 2^64, below which no double is kMissing

}  // namespace

std::size_t components_of(ElementType type) {
    return kTypes[static_cast<std::size_t>(type)].components;
}

void StorageVisitor::begin(List list) {
    list_ = list;
    slot_ = {};
}

void StorageVisitor::blame(std::string detail) {
    if (!status_) return;
    const bool is_accessor = list_ == List::accessors;
    const std::size_t count = is_accessor ? accessors.size() : views.size();
    status_ = base::Issue{
        base::IssueCode::glb_schema,
        fmt::format("{}/{}", is_accessor ? "accessors" : "bufferViews", count == 0 ? 0 : count - 1),
        std::move(detail)};
}

base::Status StorageVisitor::status() const {
    return status_;
}

void StorageVisitor::key(std::size_t depth, std::string_view name) {
    if (slot_.is_set()) blame("expected a value, found null");
    slot_ = {};
    if (depth == 3) return item_key(name);
    if (depth == 4 && inside_[4] == Inside::sparse) return sparse_key(name);
    if (depth == 4 && inside_[4] == Inside::extensions) {
        const bool is_meshopt = name == "EXT_meshopt_compression" || name == "KHR_meshopt_compression";
        inside_[5] = is_meshopt ? Inside::meshopt : Inside::other;
        return;
    }
    if (depth != 5) return;
    if (inside_[5] == Inside::meshopt) return meshopt_key(name);
    if (inside_[5] != Inside::sparse_indices && inside_[5] != Inside::sparse_values) return;
    SparseFacts& sparse = *accessors.back().sparse;
    const bool is_index = inside_[5] == Inside::sparse_indices;
    if (name == "bufferView") slot_.whole = is_index ? &sparse.index_view : &sparse.value_view;
    if (name == "byteOffset")
        slot_.whole = is_index ? &sparse.index_offset_bytes : &sparse.value_offset_bytes;
    if (name == "componentType" && is_index) slot_.whole = &sparse.index_component;
}

void StorageVisitor::item_key(std::string_view name) {
    inside_[4] = Inside::other;
    if (list_ == List::accessors)
        accessor_key(name);
    else
        view_key(name);
}

void StorageVisitor::accessor_key(std::string_view name) {
    AccessorFacts& accessor = accessors.back();
    if (name == "bufferView")
        slot_.whole = &accessor.view;
    else if (name == "byteOffset")
        slot_.whole = &accessor.offset_bytes;
    else if (name == "componentType")
        slot_.whole = &accessor.component;
    else if (name == "count")
        slot_.whole = &accessor.count;
    else if (name == "type")
        slot_.text = &accessor.type_name;
    else if (name == "normalized")
        slot_.truth = &accessor.normalised;
    else if (name == "sparse")
        inside_[4] = Inside::sparse;
}

void StorageVisitor::view_key(std::string_view name) {
    ViewFacts& view = views.back();
    if (name == "buffer")
        slot_.whole = &view.buffer;
    else if (name == "byteOffset")
        slot_.whole = &view.offset_bytes;
    else if (name == "byteLength")
        slot_.whole = &view.length_bytes;
    else if (name == "byteStride")
        slot_.whole = &view.stride_bytes;
    else if (name == "extensions")
        inside_[4] = Inside::extensions;
}

void StorageVisitor::sparse_key(std::string_view name) {
    inside_[5] = name == "indices"  ? Inside::sparse_indices
                 : name == "values" ? Inside::sparse_values
                                    : Inside::other;
    if (name == "count") slot_.whole = &accessors.back().sparse->count;
}

void StorageVisitor::meshopt_key(std::string_view name) {
    CompressionFacts& compression = *views.back().compression;
    if (name == "buffer")
        slot_.whole = &compression.buffer;
    else if (name == "byteOffset")
        slot_.whole = &compression.offset_bytes;
    else if (name == "byteLength")
        slot_.whole = &compression.length_bytes;
    else if (name == "byteStride")
        slot_.whole = &compression.stride_bytes;
    else if (name == "count")
        slot_.whole = &compression.count;
    else if (name == "mode")
        slot_.text = &compression.mode;
    else if (name == "filter")
        slot_.text = &compression.filter;
}

void StorageVisitor::text(std::size_t depth, std::string_view value) {
    if (slot_.text != nullptr)
        slot_.text->assign(value);
    else if (slot_.is_set() || depth == 2)
        blame("expected another value, found a text");
    slot_ = {};
}

void StorageVisitor::number(std::size_t depth, double value) {
    if (slot_.whole != nullptr) {
        // Numbers beyond 64 bits lie beyond every range, as the largest of them do.
        if (value >= 0.0 && value == std::floor(value))
            *slot_.whole = value < kWholeLimit ? static_cast<std::uint64_t>(value) : kMissing - 1;
        else
            blame(fmt::format("expected a whole number, found {}", value));
    } else if (slot_.is_set() || depth == 2) {
        blame("expected another value, found a number");
    }
    slot_ = {};
}

void StorageVisitor::truth(std::size_t depth, bool value) {
    if (slot_.truth != nullptr)
        *slot_.truth = value;
    else if (slot_.is_set() || depth == 2)
        blame("expected another value, found true or false");
    slot_ = {};
}

void StorageVisitor::open(std::size_t depth, bool is_array) {
    if (slot_.is_set()) blame("expected a single value, found an object or an array");
    slot_ = {};
    if (depth == 2) {
        inside_ = {};
        if (list_ == List::accessors)
            accessors.emplace_back();
        else
            views.emplace_back();
        if (is_array) blame("expected an object, found an array");
        return;
    }
    if (depth < 3 || depth + 1 >= inside_.size()) return;
    // The key said what comes; only an object is that.
    if (is_array) inside_[depth + 1] = Inside::other;
    if (depth == 3 && inside_[4] == Inside::sparse) accessors.back().sparse.emplace();
    if (depth == 4 && inside_[5] == Inside::meshopt) views.back().compression.emplace();
}

void StorageVisitor::close(std::size_t depth) {
    if (slot_.is_set()) blame("expected a value, found null");
    slot_ = {};
    if (depth == 4) inside_[5] = Inside::other;
    if (depth == 3) inside_[4] = Inside::other;
    if (depth != 2) return;
    if (list_ == List::accessors)
        close_accessor();
    else
        close_view();
}

void StorageVisitor::close_accessor() {
    AccessorFacts& accessor = accessors.back();
    if (accessor.component == kMissing || accessor.count == kMissing || accessor.type_name.empty())
        return blame("expected componentType, count and type, found fewer");
    for (const NamedType& named : kTypes) {
        if (named.name != accessor.type_name) continue;
        accessor.type = named.type;
        if (!accessor.sparse) return;
        const SparseFacts& sparse = *accessor.sparse;
        if (sparse.count == kMissing || sparse.index_view == kMissing || sparse.value_view == kMissing ||
            sparse.index_component == kMissing)
            blame(
                "expected of its sparse object a count, indices with a componentType, and values, found "
                "fewer");
        return;
    }
    blame(fmt::format("expected a type from SCALAR to MAT4, found '{}'", accessor.type_name.substr(0, 32)));
}

void StorageVisitor::close_view() {
    const ViewFacts& view = views.back();
    if (view.buffer == kMissing || view.length_bytes == kMissing)
        return blame("expected buffer and byteLength, found fewer");
    if (view.stride_bytes > kMaxStrideBytes || view.stride_bytes % 4 != 0)
        blame(fmt::format("expected a byteStride of 4, 8, ... 252, found {}", view.stride_bytes));
}

}  // namespace posepack::animal
