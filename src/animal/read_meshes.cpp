// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "animal/read_parts.hpp"
#include "animal/read_primitive.hpp"
#include "animal/weights.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

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
            "expected at most {} influences, found {} with more, up to {}: at most {:.3g} of a vertex's "
            "weight left out",
            context.options.influences, base::counted(repairs.truncated, "vertex", "vertices"),
            repairs.influences_most, repairs.truncated_weight_max));
}

base::Status append(ReadContext& context, const Primitive& primitive, const std::string& where) {
    constexpr std::size_t kInfluenceBytes = sizeof(InfluenceBones) + sizeof(InfluenceWeights);
    if (auto s = context.accessors.take(primitive.positions.size(), kInfluenceBytes); !s)
        return base::at(where, s.issue());
    Vertices& vertices = context.animal.vertices;
    const std::size_t first = vertices.positions.size();
    vertices.positions.insert(vertices.positions.end(), primitive.positions.begin(),
                              primitive.positions.end());
    vertices.normals.insert(vertices.normals.end(), primitive.normals.begin(), primitive.normals.end());
    const auto repairs =
        reduce_weights(primitive.bones, primitive.weights, primitive.influences, context.options.influences,
                       std::span(vertices.positions).subspan(first), context.neighbour_tests_left, vertices,
                       context.animal.reduced);
    return report_repairs(context, repairs, where);
}

// What a palette cannot move.
void note_left_out(ReadContext& context) {
    const auto& model = context.model();
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
        const auto& attributes = primitives[p].attributes;
        if (!attributes.contains("POSITION") || (mesh.skin != kNone && !attributes.contains("JOINTS_0"))) {
            context.note(IssueCode::warn_left_out, where,
                         "has no positions or no joints: not in the palette");
            continue;
        }
        const auto primitive = read_primitive(context, mesh, p);
        if (!primitive) return primitive.issue();
        if (auto s = append(context, primitive.value(), where); !s) return s;
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
    for (const std::uint16_t bone : context.animal.reduced.bones) context.animal.bones[bone].weighted = true;
    note_left_out(context);
    return {};
}

}  // namespace posepack::animal
