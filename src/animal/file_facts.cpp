// SPDX-License-Identifier: MIT
#include "animal/file_facts.hpp"

#include <algorithm>

#include "animal/load_gltf.hpp"

namespace posepack::animal {
namespace {

std::uint32_t count_of(std::size_t count) {
    return static_cast<std::uint32_t>(count);  // bounded by the JSON chunk's 64 MiB
}

template <class T>
const T* at_or_null(const std::vector<T>& list, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size()
               ? &list[static_cast<std::size_t>(index)]
               : nullptr;
}

// `indices` is the accessor of the primitive's indices, or -1.
std::uint64_t triangles_of(const GltfFacts& gltf, const tinygltf::Primitive& primitive, int indices) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) return 0;
    const auto position = primitive.attributes.find("POSITION");
    const int source = indices >= 0                             ? indices
                       : position != primitive.attributes.end() ? position->second
                                                                : -1;
    const AccessorFacts* accessor = at_or_null(gltf.accessors, source);
    return accessor == nullptr ? 0 : accessor->count / 3;
}

void count_primitive(const GltfFacts& gltf, const tinygltf::Primitive& primitive, int indices,
                     FileFacts& facts) {
    ++facts.primitive_count;
    facts.triangle_count += triangles_of(gltf, primitive, indices);
    facts.compressed_primitive_count += count_of(primitive.extensions.count("KHR_draco_mesh_compression"));
    const auto position = primitive.attributes.find("POSITION");
    const AccessorFacts* accessor =
        position == primitive.attributes.end() ? nullptr : at_or_null(gltf.accessors, position->second);
    if (accessor != nullptr && accessor->component != TINYGLTF_COMPONENT_TYPE_FLOAT)
        ++facts.quantised_primitive_count;
    std::uint32_t sets = 0;
    while (primitive.attributes.contains("JOINTS_" + std::to_string(sets))) ++sets;
    facts.influence_set_count = std::max(facts.influence_set_count, sets);
    facts.morph_target_count += count_of(primitive.targets.size());
}

void count_meshes(const LoadedGltf& gltf, FileFacts& facts) {
    const std::vector<tinygltf::Mesh>& meshes = gltf.model->meshes;
    facts.mesh_count = count_of(meshes.size());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const tinygltf::Mesh& mesh = meshes[m];
        const std::uint32_t targets_before = facts.morph_target_count;
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
            count_primitive(gltf.facts, mesh.primitives[p], gltf.facts.indices_of(m, p), facts);
        if (facts.morph_target_count > targets_before) facts.morphed_meshes.push_back(mesh.name);
    }
}

void count_nodes(const tinygltf::Model& model, FileFacts& facts) {
    facts.node_count = count_of(model.nodes.size());
    for (const tinygltf::Skin& skin : model.skins)
        facts.skins.push_back({skin.name, count_of(skin.joints.size()), 0, skin.inverseBindMatrices >= 0});
    for (const tinygltf::Node& node : model.nodes) {
        if (node.mesh < 0) continue;
        if (node.skin < 0) {
            facts.rigid_nodes.push_back(node.name);
            continue;
        }
        ++facts.skinned_node_count;
        if (static_cast<std::size_t>(node.skin) < facts.skins.size())
            ++facts.skins[static_cast<std::size_t>(node.skin)].user_count;
    }
}

void count_channels(const tinygltf::Model& model, FileFacts& facts) {
    for (const tinygltf::Animation& animation : model.animations) {
        AnimationFacts out;
        out.name = animation.name;
        for (const tinygltf::AnimationChannel& channel : animation.channels) {
            const std::string& path = channel.target_path;
            const bool is_node = path == "translation" || path == "rotation" || path == "scale";
            if (path == "weights")
                ++out.morph_channels;
            else if (path == "pointer")
                ++out.pointer_channels;
            else if (is_node && channel.target_node >= 0)
                ++out.node_channels;
            else
                ++out.unknown_channels;
        }
        facts.animations.push_back(std::move(out));
    }
}

}  // namespace

base::Result<FileFacts> read_file_facts(std::span<const std::uint8_t> bytes) {
    const auto gltf = load_gltf(bytes);
    if (!gltf) return gltf.issue();
    const tinygltf::Model& model = *gltf.value().model;
    FileFacts facts;
    facts.file_bytes = bytes.size();
    facts.generator = model.asset.generator;
    facts.gltf_version = model.asset.version;
    facts.extensions_used = model.extensionsUsed;
    facts.extensions_required = model.extensionsRequired;
    facts.scene_count = count_of(model.scenes.size());
    facts.image_count = gltf.value().facts.image_count;
    facts.outside_image_count = gltf.value().facts.outside_image_count;
    for (const AccessorFacts& accessor : gltf.value().facts.accessors)
        if (accessor.sparse) ++facts.sparse_accessor_count;
    count_meshes(gltf.value(), facts);
    count_nodes(model, facts);
    count_channels(model, facts);
    return facts;
}

}  // namespace posepack::animal
