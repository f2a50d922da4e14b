// SPDX-License-Identifier: MIT
#include "support/compression.hpp"

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include <stdexcept>

namespace posepack::support {
namespace {

using FilterEncoder = void (*)(void*, std::size_t, std::size_t, int, const float*);

Bytes filtered(const std::vector<float>& values, std::size_t floats, std::size_t stride_bytes, int bits,
               FilterEncoder encode) {
    Bytes out(values.size() / floats * stride_bytes);
    encode(out.data(), values.size() / floats, stride_bytes, bits, values.data());
    return out;
}

draco::DataType draco_type(int component) {
    switch (component) {
        case kU8:
            return draco::DT_UINT8;
        case kU16:
            return draco::DT_UINT16;
        case kI16:
            return draco::DT_INT16;
        default:
            return draco::DT_FLOAT32;
    }
}

draco::GeometryAttribute::Type draco_use(const std::string& name) {
    if (name == "POSITION") return draco::GeometryAttribute::POSITION;
    if (name == "NORMAL") return draco::GeometryAttribute::NORMAL;
    return draco::GeometryAttribute::GENERIC;
}

// Adds the values of an accessor with a tightly packed view of its own.
void add_attribute(draco::Mesh& mesh, GlbBuilder& glb, const std::string& name, const Json& accessor,
                   std::uint32_t unique_id) {
    const draco::DataType type = draco_type(accessor.at("componentType").get<int>());
    const std::size_t components = components_of(accessor.at("type").get<std::string>());
    const auto bytes = static_cast<std::int64_t>(components) * draco::DataTypeLength(type);
    draco::GeometryAttribute attribute;
    attribute.Init(draco_use(name), nullptr, static_cast<std::int8_t>(components), type, false, bytes, 0);
    const int id = mesh.AddAttribute(attribute, true, mesh.num_points());
    mesh.attribute(id)->set_unique_id(unique_id);
    const std::uint8_t* data = view_data(glb, accessor.at("bufferView").get<int>());
    for (std::uint32_t v = 0; v < mesh.num_points(); ++v)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), data + v * bytes);
}

Bytes encode(const draco::Mesh& mesh, bool edgebreaker) {
    draco::Encoder encoder;
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING
                                          : draco::MESH_SEQUENTIAL_ENCODING);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(mesh, &buffer).ok()) throw std::runtime_error("Draco could not encode");
    return Bytes(buffer.data(), buffer.data() + buffer.size());
}

}  // namespace

std::uint8_t* view_data(GlbBuilder& glb, int view) {
    const Json& item = glb.document.at("bufferViews").at(static_cast<std::size_t>(view));
    return glb.bin.data() + item.at("byteOffset").get<std::size_t>();
}

Bytes meshopt_attributes(std::span<const std::uint8_t> elements, std::size_t stride_bytes) {
    const std::size_t count = elements.size() / stride_bytes;
    Bytes out(meshopt_encodeVertexBufferBound(count, stride_bytes));
    out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), elements.data(), count, stride_bytes));
    return out;
}

Bytes meshopt_triangles(const std::vector<std::uint32_t>& indices) {
    Bytes out(meshopt_encodeIndexBufferBound(indices.size(), 1u << 16));
    out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size()));
    return out;
}

Bytes meshopt_indices(const std::vector<std::uint32_t>& indices) {
    Bytes out(meshopt_encodeIndexSequenceBound(indices.size(), 1u << 16));
    out.resize(meshopt_encodeIndexSequence(out.data(), out.size(), indices.data(), indices.size()));
    return out;
}

Bytes filter_quaternions(const std::vector<float>& values, int bits) {
    return filtered(values, 4, 8, bits, meshopt_encodeFilterQuat);
}

Bytes filter_normals(const std::vector<float>& values, int bits) {
    return filtered(values, 4, 8, bits, meshopt_encodeFilterOct);
}

Bytes filter_exponential(const std::vector<float>& values, int bits) {
    return filtered(values, 3, 12, bits, meshopt_encodeFilterExp);
}

int add_meshopt_view(GlbBuilder& glb, std::span<const std::uint8_t> stream, std::size_t count,
                     std::size_t stride_bytes, const std::string& mode, const std::string& filter) {
    const int raw = glb.add_view(stream);
    Json& buffers = glb.document["buffers"];
    if (buffers.size() < 2)
        buffers.push_back(
            {{"byteLength", 0}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    const auto begin = buffers[1]["byteLength"].get<std::size_t>();
    buffers[1]["byteLength"] = begin + count * stride_bytes;
    Json& view = glb.document["bufferViews"][static_cast<std::size_t>(raw)];
    Json extension{{"buffer", 0},
                   {"byteOffset", view["byteOffset"]},
                   {"byteLength", stream.size()},
                   {"byteStride", stride_bytes},
                   {"count", count},
                   {"mode", mode}};
    if (filter != "NONE") extension["filter"] = filter;
    view = {{"buffer", 1},
            {"byteOffset", begin},
            {"byteLength", count * stride_bytes},
            {"extensions", {{"EXT_meshopt_compression", std::move(extension)}}}};
    return raw;
}

void compress_accessor(GlbBuilder& glb, std::size_t accessor) {
    Json& item = glb.document["accessors"][accessor];
    const auto view = item["bufferView"].get<int>();
    const auto count = item["count"].get<std::size_t>();
    const auto size =
        glb.document["bufferViews"][static_cast<std::size_t>(view)]["byteLength"].get<std::size_t>();
    const std::uint8_t* data = view_data(glb, view);
    const Bytes stream = meshopt_attributes({data, size}, size / count);
    std::fill_n(view_data(glb, view), size, std::uint8_t{0xA5});  // the plain bytes are no longer there
    item["bufferView"] = add_meshopt_view(glb, stream, count, size / count, "ATTRIBUTES");
}

void compress_primitive(GlbBuilder& glb, std::size_t mesh_index, const DracoOptions& options) {
    Json& primitive = glb.document["meshes"][mesh_index]["primitives"][0];
    const auto points = glb.attribute(mesh_index, "POSITION").at("count").get<std::uint32_t>();
    draco::Mesh mesh;
    mesh.set_num_points(points);
    mesh.SetNumFaces(points / 3);
    for (std::uint32_t f = 0; f < points / 3; ++f)
        mesh.SetFace(draco::FaceIndex(f),
                     {draco::PointIndex(3 * f), draco::PointIndex(3 * f + 1), draco::PointIndex(3 * f + 2)});
    Json ids = Json::object();
    std::uint32_t next_id = 10;
    for (const auto& [name, accessor] : primitive.at("attributes").items()) {
        const auto stored = options.stored_instead.find(name);
        const auto index = static_cast<std::size_t>(
            stored != options.stored_instead.end() ? stored->second : accessor.get<int>());
        add_attribute(mesh, glb, name, glb.document["accessors"][index], next_id);
        ids[name] = next_id++;
    }
    for (const auto& [name, accessor] : primitive.at("attributes").items())
        glb.document["accessors"][accessor.get<std::size_t>()].erase("bufferView");
    primitive["indices"] = glb.add_accessor(-1, 0, kU16, points / 3 * 3, "SCALAR");
    const int view = glb.add_view(encode(mesh, options.edgebreaker));
    glb.document["meshes"][mesh_index]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", ids}};
    glb.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
}

}  // namespace posepack::support
