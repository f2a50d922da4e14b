// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "animal/read_parts.hpp"
#include "animal/weights.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

struct Primitive {
    std::vector<float> positions, normals;
    std::vector<std::uint16_t> bones;  // vertex_count x influences
    std::vector<float> weights;
    std::size_t influences = 0;
    std::size_t vertex_count = 0;
};

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

// A compressed primitive whose plain accessors are empty would be read as zeros.
base::Status refuse_draco(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                          const std::string& where) {
    constexpr const char* kDraco = "KHR_draco_mesh_compression";
    const int positions = attribute(primitive, "POSITION");
    const bool is_stored = positions >= 0 && static_cast<std::size_t>(positions) < model.accessors.size() &&
                           model.accessors[static_cast<std::size_t>(positions)].bufferView >= 0;
    if (!primitive.extensions.contains(kDraco) || is_stored) return {};
    return Issue{IssueCode::glb_extension, where,
                 fmt::format("expected plain accessors, found geometry behind {}", kDraco)};
}

base::Status read_geometry(ReadContext& context, const tinygltf::Primitive& source, const std::string& where,
                           Primitive& out) {
    const std::initializer_list<int> kinds{
        TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
        TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
    auto positions = context.accessors.read_floats(attribute(source, "POSITION"),
                                                   {where + "/POSITION", TINYGLTF_TYPE_VEC3, kinds});
    if (!positions) return positions.issue();
    out.positions = std::move(positions).value();
    out.vertex_count = out.positions.size() / 3;
    out.normals.assign(out.positions.size(), 0.0f);
    if (attribute(source, "NORMAL") < 0) return {};
    auto normals = context.accessors.read_floats(attribute(source, "NORMAL"),
                                                 {where + "/NORMAL", TINYGLTF_TYPE_VEC3, kinds});
    if (!normals) return normals.issue();
    if (normals.value().size() != out.positions.size())
        return Issue{
            IssueCode::glb_accessor_count, where + "/NORMAL",
            fmt::format("expected {} elements, found {}", out.vertex_count, normals.value().size() / 3)};
    out.normals = std::move(normals).value();
    return {};
}

base::Status read_influence_set(ReadContext& context, const tinygltf::Primitive& source, const Mesh& mesh,
                                int set, std::size_t sets, const std::string& where, Primitive& out) {
    const std::string joints_name = fmt::format("JOINTS_{}", set);
    const std::string weights_name = fmt::format("WEIGHTS_{}", set);
    const auto joints = context.accessors.read_integers(
        attribute(source, joints_name),
        {where + "/" + joints_name,
         TINYGLTF_TYPE_VEC4,
         {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT}});
    if (!joints) return joints.issue();
    const auto weights =
        context.accessors.read_floats(attribute(source, weights_name),
                                      {where + "/" + weights_name,
                                       TINYGLTF_TYPE_VEC4,
                                       {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                        TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
                                       true});
    if (!weights) return weights.issue();
    if (joints.value().size() != out.vertex_count * 4 || weights.value().size() != out.vertex_count * 4)
        return Issue{IssueCode::glb_accessor_count, where + "/" + joints_name,
                     fmt::format("expected {} elements, found {} joints and {} weights", out.vertex_count,
                                 joints.value().size() / 4, weights.value().size() / 4)};
    for (std::size_t v = 0; v < out.vertex_count; ++v)
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t joint = joints.value()[v * 4 + i];
            const float weight = weights.value()[v * 4 + i];
            // An unused influence may hold anything (the weight says it is unused).
            if (joint >= mesh.joint_count && weight != 0.0f)
                return Issue{IssueCode::glb_joint_index, where + "/" + joints_name,
                             fmt::format("expected joints below {}, found {} at vertex {}", mesh.joint_count,
                                         joint, v)};
            const std::size_t slot = v * sets * 4 + static_cast<std::size_t>(set) * 4 + i;
            out.bones[slot] = joint < mesh.joint_count ? context.animal.joint_map[mesh.first_joint + joint]
                                                       : std::uint16_t{0};
            out.weights[slot] = weight;
        }
    return {};
}

// Every vertex of a rigid mesh follows the one bone of its node.
void bind_rigidly(const Animal& animal, const Mesh& mesh, Primitive& out) {
    out.influences = 1;
    out.bones.assign(out.vertex_count, animal.joint_map[mesh.first_joint]);
    out.weights.assign(out.vertex_count, 1.0f);
}

base::Status read_influences(ReadContext& context, const tinygltf::Primitive& source, const Mesh& mesh,
                             const std::string& where, Primitive& out) {
    if (mesh.skin == kNone) return bind_rigidly(context.animal, mesh, out), base::Status{};
    std::size_t sets = 1;
    while (sets < 4 && attribute(source, fmt::format("JOINTS_{}", sets)) >= 0) ++sets;
    out.influences = sets * 4;
    out.bones.resize(out.vertex_count * out.influences);
    out.weights.resize(out.vertex_count * out.influences);
    for (std::size_t set = 0; set < sets; ++set)
        if (auto status = read_influence_set(context, source, mesh, static_cast<int>(set), sets, where, out);
            !status)
            return status;
    return {};
}

base::Status report_repairs(ReadContext& context, const WeightRepairs& repairs, const std::string& where) {
    const auto repair = [&](std::uint32_t count, const std::string& what) -> base::Status {
        if (count == 0) return {};
        return context.repair(IssueCode::warn_weights, IssueCode::glb_weights, where,
                              fmt::format("expected weights of 0 or more that sum to 1, found {} {}",
                                          base::counted(count, "vertex", "vertices"), what));
    };
    if (repairs.hopeless)
        return Issue{IssueCode::glb_weights, where,
                     "expected weights on nearly all vertices, found most without any that can be used"};
    if (auto s = repair(repairs.bad, "with NaN, infinite or negative weights: zeroed"); !s) return s;
    if (auto s = repair(repairs.none_left, "with no weight: took those of the nearest good vertex"); !s)
        return s;
    if (auto s = repair(repairs.sum_not_one, "with another sum: renormalised"); !s) return s;
    if (repairs.truncated == 0) return {};
    return context.repair(
        IssueCode::warn_influences, IssueCode::glb_weights, where,
        fmt::format(
            "expected at most 4 influences, found {} with more: up to {:.3g} of a vertex's weight dropped",
            base::counted(repairs.truncated, "vertex", "vertices"), repairs.truncated_weight_max));
}

base::Status append(ReadContext& context, const Primitive& primitive, const std::string& where) {
    Vertices& vertices = context.animal.vertices;
    const std::size_t first = vertices.positions.size();
    for (std::size_t v = 0; v < primitive.vertex_count; ++v) {
        const float* p = &primitive.positions[v * 3];
        const float* n = &primitive.normals[v * 3];
        vertices.positions.push_back({p[0], p[1], p[2]});
        vertices.normals.push_back({n[0], n[1], n[2]});
    }
    const auto repairs = reduce_weights(primitive.bones, primitive.weights, primitive.influences,
                                        std::span(vertices.positions).subspan(first), vertices);
    return report_repairs(context, repairs, where);
}

// Primitives without joints under a skinned node, and everything else a palette cannot move.
void note_left_out(ReadContext& context) {
    const auto& model = context.model();
    std::uint32_t rigid_meshes = 0;
    for (const auto& node : model.nodes) rigid_meshes += node.mesh >= 0 && node.skin < 0 ? 1 : 0;
    const bool is_rigid = !context.animal.meshes.empty() && context.animal.meshes.front().skin == kNone;
    if (rigid_meshes > 0 && !is_rigid)
        context.note(IssueCode::warn_left_out, "nodes",
                     fmt::format("{} without a skin: not in the palette",
                                 base::counted(rigid_meshes, "rigid mesh", "rigid meshes")));
    std::uint32_t morphed = 0;
    for (const auto& mesh : model.meshes)
        for (const auto& primitive : mesh.primitives) morphed += primitive.targets.empty() ? 0 : 1;
    if (morphed > 0)
        context.note(
            IssueCode::warn_left_out, "meshes",
            fmt::format("morph targets of {}: not in the palette", base::counted(morphed, "primitive")));
}

base::Status read_mesh(ReadContext& context, Mesh& mesh) {
    mesh.first_vertex = static_cast<std::uint32_t>(context.animal.vertices.positions.size());
    const auto& primitives = context.model().meshes[mesh.mesh].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
        const std::string where = fmt::format("meshes/{}/primitives/{}", mesh.mesh, p);
        const bool needs_joints = mesh.skin != kNone;
        if (attribute(primitives[p], "POSITION") < 0 ||
            (needs_joints && attribute(primitives[p], "JOINTS_0") < 0)) {
            context.note(IssueCode::warn_left_out, where,
                         "has no positions or no joints: not in the palette");
            continue;
        }
        if (auto s = refuse_draco(context.model(), primitives[p], where); !s) return s;
        Primitive primitive;
        if (auto s = read_geometry(context, primitives[p], where, primitive); !s) return s;
        if (auto s = read_influences(context, primitives[p], mesh, where, primitive); !s) return s;
        if (auto s = append(context, primitive, where); !s) return s;
    }
    mesh.vertex_count =
        static_cast<std::uint32_t>(context.animal.vertices.positions.size()) - mesh.first_vertex;
    return {};
}

}  // namespace

base::Status read_meshes(ReadContext& context) {
    for (Mesh& mesh : context.animal.meshes)
        if (auto status = read_mesh(context, mesh); !status) return status;
    const Vertices& vertices = context.animal.vertices;
    for (std::size_t v = 0; v < vertices.bones.size(); ++v)
        for (std::size_t i = 0; i < kMaxInfluences; ++i)
            if (vertices.weights[v][i] > 0.0f) context.animal.bones[vertices.bones[v][i]].weighted = true;
    note_left_out(context);
    return {};
}

}  // namespace posepack::animal
