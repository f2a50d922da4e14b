// SPDX-License-Identifier: MIT
#include "support/glb_builder.hpp"

#include <stdexcept>

namespace posepack::support {
namespace {

void append_u32(Bytes& out, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::size_t padded(std::size_t size) {
    return (size + 3) / 4 * 4;
}

}  // namespace

std::size_t components_of(std::string_view type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    if (type == "MAT4") return 16;
    throw std::invalid_argument(std::string(type));
}

Bytes pack_glb(std::string_view json, std::span<const std::uint8_t> bin) {
    Bytes out;
    append_u32(out, 0x46546C67);
    append_u32(out, 2);
    append_u32(out, 20 + padded(json.size()) + (bin.empty() ? 0 : 8 + padded(bin.size())));
    append_u32(out, padded(json.size()));
    append_u32(out, 0x4E4F534A);
    out.insert(out.end(), json.begin(), json.end());
    out.resize(20 + padded(json.size()), ' ');
    if (bin.empty()) return out;
    append_u32(out, padded(bin.size()));
    append_u32(out, 0x004E4942);
    out.insert(out.end(), bin.begin(), bin.end());
    out.resize(padded(out.size()), 0);
    return out;
}

int GlbBuilder::add_view(std::span<const std::uint8_t> bytes, int stride_bytes) {
    bin.resize(padded(bin.size()));
    Json view{{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
    if (stride_bytes > 0) view["byteStride"] = stride_bytes;
    bin.insert(bin.end(), bytes.begin(), bytes.end());
    if (!document.contains("buffers")) document["buffers"] = Json::array({Json::object()});
    return add("bufferViews", std::move(view));
}

int GlbBuilder::add_accessor(int view, std::size_t offset_bytes, int component, std::size_t count,
                             std::string_view type, bool normalised) {
    Json accessor{{"componentType", component}, {"count", count}, {"type", type}};
    if (view >= 0) accessor["bufferView"] = view;
    if (offset_bytes > 0) accessor["byteOffset"] = offset_bytes;
    if (normalised) accessor["normalized"] = true;
    return add("accessors", std::move(accessor));
}

int GlbBuilder::add(const std::string& list, Json item) {
    Json& items = document[list];
    items.push_back(std::move(item));
    return static_cast<int>(items.size()) - 1;
}

Json& GlbBuilder::attribute(std::size_t mesh, const std::string& name) {
    const Json& attributes = document.at("meshes").at(mesh).at("primitives").at(0).at("attributes");
    return document.at("accessors").at(attributes.at(name).get<std::size_t>());
}

Json& GlbBuilder::sampled(std::size_t animation, std::size_t channel, const char* end) {
    Json& source = document.at("animations").at(animation);
    const auto sampler = source.at("channels").at(channel).at("sampler").get<std::size_t>();
    return document.at("accessors").at(source.at("samplers").at(sampler).at(end).get<std::size_t>());
}

Bytes GlbBuilder::build() const {
    Json filled = document;
    if (filled.contains("buffers"))
        for (Json& buffer : filled.at("buffers"))
            if (!buffer.contains("byteLength")) buffer["byteLength"] = bin.size();
    return pack_glb(filled.dump(), bin);
}

}  // namespace posepack::support
