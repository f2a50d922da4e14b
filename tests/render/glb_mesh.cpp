// SPDX-License-Identifier: MIT
#include "render/glb_mesh.hpp"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "render/error.hpp"

namespace posepack::render {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kChunkStart = 12;  // glTF 2.0, section 4.4: behind the file header
constexpr std::size_t kChunkHead = 8;

template <class T>
T read_as(const std::uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

struct GltfFile {
    Json json;
    std::span<const std::uint8_t> binary;
};

GltfFile open_glb(std::span<const std::uint8_t> glb) {
    require(glb.size() >= kChunkStart + kChunkHead && std::memcmp(glb.data(), "glTF", 4) == 0,
            "expected a binary glTF");
    const std::size_t json_bytes = read_as<std::uint32_t>(glb.data() + kChunkStart);
    const std::size_t json_start = kChunkStart + kChunkHead;
    const std::size_t binary_start = json_start + json_bytes + kChunkHead;
    require(binary_start <= glb.size(), "expected a JSON and a BIN chunk in the GLB");
    const auto text = glb.subspan(json_start, json_bytes);
    GltfFile file{Json::parse(text.begin(), text.end(), nullptr, false), glb.subspan(binary_start)};
    require(!file.json.is_discarded(), "expected JSON in the first chunk of the GLB");
    return file;
}

// One accessor, as numbers in row order: count x components.
struct Numbers {
    std::size_t count = 0;
    std::size_t components = 0;
    std::vector<float> values;
};

std::size_t component_count(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    return type == "VEC3" ? 3 : 4;
}

float read_component(const std::uint8_t* at, int type, bool is_normalized) {
    switch (type) {
        case 5121:
            return static_cast<float>(*at) / (is_normalized ? 255.0f : 1.0f);
        case 5123:
            return static_cast<float>(read_as<std::uint16_t>(at)) / (is_normalized ? 65535.0f : 1.0f);
        case 5126:
            return read_as<float>(at);
        default:
            throw RenderError(fmt::format("expected bytes, shorts or floats, found component type {}", type));
    }
}

Numbers read_accessor(const GltfFile& file, std::size_t index) {
    const Json& accessor = file.json.at("accessors").at(index);
    require(!accessor.contains("sparse"), fmt::format("accessors/{}: sparse is not read here", index));
    const Json& view = file.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const int type = accessor.at("componentType").get<int>();
    const std::size_t size = type == 5126 ? 4 : type == 5123 ? 2 : 1;
    Numbers out{accessor.at("count").get<std::size_t>(), component_count(accessor.at("type")), {}};
    const std::size_t stride = view.value("byteStride", size * out.components);
    const std::size_t start =
        view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    require(out.count > 0 && start + (out.count - 1) * stride + size * out.components <= file.binary.size(),
            fmt::format("accessors/{}: expected it inside the BIN chunk", index));
    out.values.reserve(out.count * out.components);
    for (std::size_t element = 0; element < out.count; ++element)
        for (std::size_t component = 0; component < out.components; ++component)
            out.values.push_back(
                read_component(file.binary.data() + start + element * stride + component * size, type,
                               accessor.value("normalized", false)));
    return out;
}

void append_primitive(SkinnedMesh& mesh, const GltfFile& file, const Json& primitive) {
    const Json& attributes = primitive.at("attributes");
    const auto attribute = [&](const char* name) { return read_accessor(file, attributes.at(name)); };
    const Numbers positions = attribute("POSITION"), normals = attribute("NORMAL"),
                  colours = attribute("COLOR_0"), joints = attribute("JOINTS_0"),
                  weights = attribute("WEIGHTS_0");
    const std::size_t first = mesh.vertices.size();
    for (std::size_t v = 0; v < positions.count; ++v) {
        const auto vec3_of = [v](const Numbers& n) {
            const float* at = &n.values.at(v * n.components);
            return glm::vec3(at[0], at[1], at[2]);
        };
        MeshVertex vertex{vec3_of(positions), vec3_of(normals), vec3_of(colours), {}, {}};
        for (std::size_t i = 0; i < 4; ++i) {
            vertex.joints[i] = joints.values.at(v * 4 + i);
            vertex.weights[i] = weights.values.at(v * 4 + i);
        }
        mesh.vertices.push_back(vertex);
    }
    for (const float index : read_accessor(file, primitive.at("indices")).values)
        mesh.indices.push_back(static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(index));
}

}  // namespace

SkinnedMesh read_skinned_mesh(std::span<const std::uint8_t> glb) {
    const GltfFile file = open_glb(glb);
    SkinnedMesh mesh;
    try {
        for (const Json& primitive : file.json.at("meshes").at(0).at("primitives"))
            append_primitive(mesh, file, primitive);
    } catch (const Json::exception& error) {
        throw RenderError(fmt::format("expected a skinned, coloured mesh in the GLB: {}", error.what()));
    } catch (const std::out_of_range&) {
        throw RenderError("expected as many normals, colours, joints and weights as positions");
    }
    return mesh;
}

}  // namespace posepack::render
