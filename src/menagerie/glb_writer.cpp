// SPDX-License-Identifier: MIT
#include "menagerie/glb_writer.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "menagerie/glb_animation.hpp"
#include "menagerie/glb_buffer.hpp"
#include "menagerie/glb_values.hpp"

namespace posepack::menagerie {
namespace {

constexpr int kVertexTarget = 34962;
constexpr int kIndexTarget = 34963;

// The node of the skinned mesh; an empty one where every joint has a mesh of its own.
Json body_node(const Model& model) {
    if (model.style.rigid) return {{"name", model.name}};
    return {{"name", model.name}, {"mesh", 0}, {"skin", 0}};
}

// Nodes: the armature, the skinned mesh, the joints.
Json nodes_of(const Model& model) {
    const std::vector<RigJoint>& joints = model.rig.joints;
    std::vector<Json> children(joints.size() + 1, Json::array());
    for (std::size_t index = 0; index < joints.size(); ++index) {
        children[static_cast<std::size_t>(joints[index].parent + 1)].push_back(kFirstJointNode +
                                                                               static_cast<int>(index));
    }
    Json armature{{"name", model.style.armature}, {"children", std::move(children[0])}};
    if (model.style.z_up_armature) armature["rotation"] = quaternion_json(armature_turn(model.style));
    if (model.style.armature_scale != 1.0) armature["scale"] = vector_json(Vec3(model.style.armature_scale));
    Json nodes = Json::array({std::move(armature), body_node(model)});
    for (std::size_t index = 0; index < joints.size(); ++index) {
        const Local local = local_of(model, index, kNoTurn, Vec3(0.0));
        Json node{{"name", joints[index].name},
                  {"translation", vector_json(local.translation)},
                  {"rotation", quaternion_json(local.rotation)}};
        if (!children[index + 1].empty()) node["children"] = std::move(children[index + 1]);
        nodes.push_back(std::move(node));
    }
    return nodes;
}

int add_positions(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    Vec3 low = mesh.vertices.front().position;
    Vec3 high = low;
    for (const Vertex& vertex : mesh.vertices) {
        put_vector(payload, vertex.position);
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    const int accessor =
        buffer.add_accessor(payload, ComponentType::f32, "VEC3", mesh.vertices.size(), kVertexTarget);
    buffer.accessor(accessor)["min"] = vector_json(low);
    buffer.accessor(accessor)["max"] = vector_json(high);
    return accessor;
}

int add_normals(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) put_vector(payload, vertex.normal);
    return buffer.add_accessor(payload, ComponentType::f32, "VEC3", mesh.vertices.size(), kVertexTarget);
}

int add_colours(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) {
        for (const double value : {vertex.colour.x, vertex.colour.y, vertex.colour.z, 1.0}) {
            payload.put_u8(static_cast<std::uint32_t>(std::floor(value * 255.0 + 0.5)));
        }
    }
    return buffer.add_accessor(payload, ComponentType::u8, "VEC4", mesh.vertices.size(), kVertexTarget, true);
}

int add_joints(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) {
        for (const int joint : vertex.influences.joints) payload.put_u8(static_cast<std::uint32_t>(joint));
    }
    return buffer.add_accessor(payload, ComponentType::u8, "VEC4", mesh.vertices.size(), kVertexTarget);
}

int add_weights(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) {
        for (const double weight : vertex.influences.weights) payload.put_f32(static_cast<float>(weight));
    }
    return buffer.add_accessor(payload, ComponentType::f32, "VEC4", mesh.vertices.size(), kVertexTarget);
}

Json mesh_json(GlbBuffer& buffer, const Mesh& mesh, const std::string& name, bool with_skin) {
    Payload indices;
    for (const std::uint16_t index : mesh.indices) indices.put_u16(index);
    Json attributes{{"POSITION", add_positions(buffer, mesh)},
                    {"NORMAL", add_normals(buffer, mesh)},
                    {"COLOR_0", add_colours(buffer, mesh)}};
    if (with_skin) {
        attributes["JOINTS_0"] = add_joints(buffer, mesh);
        attributes["WEIGHTS_0"] = add_weights(buffer, mesh);
    }
    Json primitive{{"attributes", std::move(attributes)},
                   {"indices", buffer.add_accessor(indices, ComponentType::u16, "SCALAR", mesh.indices.size(),
                                                   kIndexTarget)},
                   {"material", 0}};
    return {{"name", name}, {"primitives", Json::array({std::move(primitive)})}};
}

// Inverse of T(head) R(bone) S(armature scale), column by column.
void put_inverse_bind(Payload& payload, const RigJoint& joint, double scale) {
    const Quat inverse = glm::conjugate(joint.bone);
    const double shrink = 1.0 / scale;
    for (const Vec3& axis : {kAxisX, kAxisY, kAxisZ}) {
        put_vector(payload, inverse * axis * shrink);
        payload.put_f32(0.0f);
    }
    put_vector(payload, inverse * -joint.head * shrink);
    payload.put_f32(1.0f);
}

Json skin_json(GlbBuffer& buffer, const Model& model) {
    Payload matrices;
    Json joints = Json::array();
    for (std::size_t index = 0; index < model.rig.joints.size(); ++index) {
        put_inverse_bind(matrices, model.rig.joints[index], model.style.armature_scale);
        joints.push_back(kFirstJointNode + static_cast<int>(index));
    }
    const int accessor =
        buffer.add_accessor(matrices, ComponentType::f32, "MAT4", model.rig.joints.size(), 0);
    return {{"name", model.style.armature},
            {"inverseBindMatrices", accessor},
            {"skeleton", kArmatureNode},
            {"joints", std::move(joints)}};
}

// A mesh for each joint that any triangle follows, in the joint's own axes.
void add_rigid_meshes(GlbBuffer& buffer, const Model& model, Json& document) {
    document["meshes"] = Json::array();
    for (std::size_t joint = 0; joint < model.rig.joints.size(); ++joint) {
        const Mesh part = rigid_part(model.mesh, model.rig, static_cast<int>(joint));
        if (part.indices.empty()) continue;
        const RigJoint& owner = model.rig.joints[joint];
        document["nodes"][kFirstJointNode + joint]["mesh"] = document["meshes"].size();
        document["meshes"].push_back(mesh_json(buffer, part, owner.name, false));
    }
}

}  // namespace

std::vector<std::uint8_t> write_glb(const Model& model) {
    GlbBuffer buffer;
    Json document{{"asset", {{"version", "2.0"}, {"generator", "posepack menagerie"}}},
                  {"scene", 0},
                  {"scenes", Json::array({{{"nodes", {kArmatureNode, kMeshNode}}}})},
                  {"nodes", nodes_of(model)}};
    document["materials"] =
        Json::array({{{"name", "Hide"},
                      {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", number(0.8)}}}}});
    if (model.style.rigid) {
        add_rigid_meshes(buffer, model, document);
    } else {
        document["meshes"] = Json::array({mesh_json(buffer, model.mesh, model.name, true)});
        document["skins"] = Json::array({skin_json(buffer, model)});
    }
    Json animations = Json::array();
    for (const Clip& clip : model.clips) animations.push_back(animation_json(buffer, model, clip));
    document["animations"] = std::move(animations);
    const std::string bytes = buffer.finish(document);
    return pack_glb(document.dump(), bytes);
}

}  // namespace posepack::menagerie
