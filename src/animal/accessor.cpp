// SPDX-License-Identifier: MIT
#include "animal/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

// Names as glTF 2.0 gives them, in sections 3.6.2.2 and 3.6.2.4.
std::string type_name(ElementType type) {
    switch (type) {
        case ElementType::scalar:
            return "SCALAR";
        case ElementType::vec3:
            return "VEC3";
        case ElementType::vec4:
            return "VEC4";
        default:
            return "MAT4";
    }
}

std::string component_name(int component) {
    switch (component) {
        case kByte:
            return "BYTE";
        case kUnsignedByte:
            return "UNSIGNED_BYTE";
        case kShort:
            return "SHORT";
        case kUnsignedShort:
            return "UNSIGNED_SHORT";
        case kUnsignedInt:
            return "UNSIGNED_INT";
        case kFloat:
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

Issue in_accessor(const AccessorUse& use, int index, Issue issue) {
    return base::at(fmt::format("{} (accessors/{})", use.place.text(), index), std::move(issue));
}

// Index of the first number that is NaN or infinite, or the size.
std::size_t first_not_finite(const float* values, std::size_t size) {
    // A sum of zeros stays zero unless a term is not: no branch for each number.
    float sum = 0.0f;
    for (std::size_t i = 0; i < size; ++i) sum += values[i] * 0.0f;
    if (sum == 0.0f) return size;
    return static_cast<std::size_t>(
        std::find_if(values, values + size, [](float v) { return !std::isfinite(v); }) - values);
}

}  // namespace

std::string Place::text() const {
    std::string text = fmt::format("{}/{}", list, index);
    if (!inner_list.empty()) text += fmt::format("/{}/{}", inner_list, inner_index);
    if (!leaf.empty()) (text += '/') += leaf;
    return text;
}

// An accessor that was found to fit its use.
struct AccessorReader::Source {
    const AccessorFacts* accessor = nullptr;
    ElementShape shape;
    std::optional<ElementSpan> elements;    // none: zeros
    std::vector<std::uint8_t> draco_bytes;  // what `elements` points into, for Draco

    void copy(float* out) const { elements->copy_floats(accessor->normalised, out); }
    void copy(std::uint32_t* out) const { elements->copy_integers(out); }
    void copy_one(const ElementSpan& span, std::size_t i, float* out) const {
        span.copy_element(i, accessor->normalised, out);
    }
    void copy_one(const ElementSpan& span, std::size_t i, std::uint32_t* out) const {
        span.copy_element(i, out);
    }
};

AccessorReader::AccessorReader(const LoadedGltf& gltf)
    : gltf_(gltf), budget_(gltf.file_bytes), views_(gltf, budget_) {}

base::Result<ElementSpan> AccessorReader::open_view(std::uint64_t view_index, std::uint64_t offset_bytes,
                                                    const ElementShape& shape, bool is_tight) {
    const auto bytes = views_.bytes(view_index);
    if (!bytes) return bytes.issue();
    ElementShape strided = shape;
    strided.stride_bytes = is_tight ? 0 : facts().views[view_index].stride_bytes;
    return ElementSpan::over(bytes.value(), offset_bytes, strided);
}

base::Status AccessorReader::open_draco(const AccessorUse& use, Source& source) {
    // Draco may have fewer points than declared, never more (DracoLimits).
    source.shape.count = use.draco->point_count();
    auto values = use.draco->values(use.draco_id, source.shape.component, source.shape.components);
    if (!values) return values.issue();
    source.draco_bytes = std::move(values).value();
    auto elements = ElementSpan::over(source.draco_bytes, 0, source.shape);
    if (!elements) return elements.issue();
    source.elements = elements.value();
    return {};
}

base::Result<AccessorReader::Source> AccessorReader::open(int index, const AccessorUse& use) {
    if (index < 0 || static_cast<std::size_t>(index) >= facts().accessors.size())
        return Issue{
            IssueCode::glb_reference, "",
            fmt::format("expected one of {} accessors, found index {}", facts().accessors.size(), index)};
    const AccessorFacts& accessor = facts().accessors[static_cast<std::size_t>(index)];
    const auto component = static_cast<int>(std::min<std::uint64_t>(accessor.component, 0xFFFF));
    if (accessor.type != use.type ||
        std::find(use.components.begin(), use.components.end(), component) == use.components.end())
        return Issue{
            IssueCode::glb_accessor_type, "",
            fmt::format("expected {} of {}, found {} of {}", type_name(use.type),
                        component_names(use.components), accessor.type_name, component_name(component))};
    if (accessor.count == 0)
        return Issue{IssueCode::glb_accessor_count, "", "expected at least one element, found 0"};
    Source source;
    source.accessor = &accessor;
    source.shape = {accessor.count, components_of(use.type), component, 0};
    if (use.draco == nullptr && accessor.view != kMissing) {
        auto elements = open_view(accessor.view, accessor.offset_bytes, source.shape, false);
        if (!elements) return elements.issue();
        source.elements = elements.value();
    }
    // Counted after the range check, so that a lie about the count is called one; before any allocation.
    if (auto status = budget_.take(accessor.count, source.shape.components * sizeof(float)); !status)
        return status.issue();
    if (use.draco != nullptr)
        if (auto status = open_draco(use, source); !status) return status.issue();
    return source;
}

template <class T>
base::Status AccessorReader::read_sparse(const Source& source, T* out) {
    if (!source.accessor->sparse) return {};
    const SparseFacts& sparse = *source.accessor->sparse;
    const auto refuse = [](std::string detail) {
        return Issue{IssueCode::glb_sparse, "", std::move(detail)};
    };
    if (sparse.count < 1 || sparse.count > source.shape.count)
        return refuse(fmt::format("expected 1 to {} values, found {}", source.shape.count, sparse.count));
    const auto index_type = static_cast<int>(std::min<std::uint64_t>(sparse.index_component, 0xFFFF));
    if (index_type != kUnsignedByte && index_type != kUnsignedShort && index_type != kUnsignedInt)
        return refuse(
            fmt::format("expected indices of UNSIGNED_BYTE, UNSIGNED_SHORT or UNSIGNED_INT, found {}",
                        component_name(index_type)));
    const std::size_t count = sparse.count;
    // Both streams are tightly packed whatever their views say (glTF 2.0 section 3.6.2.3).
    const auto indices =
        open_view(sparse.index_view, sparse.index_offset_bytes, {count, 1, index_type, 0}, true);
    if (!indices) return indices.issue();
    const auto values = open_view(sparse.value_view, sparse.value_offset_bytes,
                                  {count, source.shape.components, source.shape.component, 0}, true);
    if (!values) return values.issue();
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t target = 0;
        indices.value().copy_element(i, &target);
        if (target < next || target >= source.shape.count)
            return refuse(fmt::format("expected index {} from {} to {}, found {}", i, next,
                                      source.shape.count - 1, target));
        source.copy_one(values.value(), i, out + target * source.shape.components);
        next = std::size_t{target} + 1;
    }
    return {};
}

base::Result<std::size_t> AccessorReader::append_floats(int index, const AccessorUse& use,
                                                        std::vector<float>& out) {
    const auto opened = open(index, use);
    if (!opened) return in_accessor(use, index, opened.issue());
    const Source& source = opened.value();
    const std::size_t first = out.size();
    const std::size_t size = source.shape.count * source.shape.components;
    out.resize(first + size);
    if (source.elements) source.copy(out.data() + first);
    if (auto status = read_sparse(source, out.data() + first); !status)
        return in_accessor(use, index, base::at("sparse", status.issue()));
    if (use.allow_not_finite) return size;
    const std::size_t bad = first_not_finite(out.data() + first, size);
    if (bad == size) return size;
    return in_accessor(use, index,
                       {IssueCode::glb_number, "",
                        fmt::format("expected finite numbers, found element {} with {}",
                                    bad / source.shape.components, out[first + bad])});
}

base::Result<std::vector<float>> AccessorReader::read_floats(int index, const AccessorUse& use) {
    std::vector<float> out;
    const auto added = append_floats(index, use, out);
    if (!added) return added.issue();
    return out;
}

base::Result<std::vector<std::uint32_t>> AccessorReader::read_integers(int index, const AccessorUse& use) {
    const auto opened = open(index, use);
    if (!opened) return in_accessor(use, index, opened.issue());
    const Source& source = opened.value();
    std::vector<std::uint32_t> out(source.shape.count * source.shape.components);
    if (source.elements) source.copy(out.data());
    if (auto status = read_sparse(source, out.data()); !status)
        return in_accessor(use, index, base::at("sparse", status.issue()));
    return out;
}

std::uint64_t AccessorReader::declared_count(int index) const {
    if (index < 0 || static_cast<std::size_t>(index) >= facts().accessors.size()) return 0;
    return facts().accessors[static_cast<std::size_t>(index)].count;
}

base::Result<DracoMesh> AccessorReader::read_draco(int view_index, const DracoLimits& limits) {
    const auto bytes = views_.bytes(view_index < 0 ? kMissing : static_cast<std::uint64_t>(view_index));
    if (!bytes) return bytes.issue();
    return DracoMesh::decode(bytes.value(), limits, budget_);
}

}  // namespace posepack::animal
