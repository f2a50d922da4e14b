// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "animal/bind_skins.hpp"
#include "animal/names.hpp"
#include "animal/read_parts.hpp"
#include "animal/read_rigid_meshes.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr double kAffineTolerance = 1e-5;

struct SkinBones {
    std::uint32_t first_joint = 0, joint_count = 0;
    std::uint32_t fold = kNone;
};

base::Result<std::vector<glm::dmat4>> read_inverse_binds(ReadContext& context, const tinygltf::Skin& skin,
                                                         std::size_t index, const std::string& where) {
    std::vector<glm::dmat4> matrices(skin.joints.size(), glm::dmat4(1.0));
    if (skin.inverseBindMatrices < 0) return matrices;
    const auto floats = context.accessors.read_floats(
        skin.inverseBindMatrices,
        {{"skins", index, {}, 0, "inverseBindMatrices"}, ElementType::mat4, {kFloat}});
    if (!floats) return floats.issue();
    if (floats.value().size() / 16 < matrices.size())
        return Issue{IssueCode::glb_ibm_count, where,
                     fmt::format("expected {} inverse bind matrices, found {}", matrices.size(),
                                 floats.value().size() / 16)};
    for (std::size_t j = 0; j < matrices.size(); ++j)
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) {
                const double value = floats.value()[j * 16 + static_cast<std::size_t>(c * 4 + r)];
                if (r == 3 && std::abs(value - (c == 3 ? 1.0 : 0.0)) > kAffineTolerance)
                    return Issue{IssueCode::glb_ibm, where,
                                 fmt::format("expected affine matrices (last row 0 0 0 1), found matrix {} "
                                             "with {:.6g} in that row",
                                             j, value)};
                matrices[j][c][r] = r == 3 ? (c == 3 ? 1.0 : 0.0) : value;
            }
    return matrices;
}

base::Result<SkinBones> read_skin(ReadContext& context, int index, SkinBinder& binder) {
    const std::string where = fmt::format("skins/{}", index);
    const tinygltf::Skin& skin = context.model().skins[static_cast<std::size_t>(index)];
    Animal& animal = context.animal;
    if (skin.joints.empty()) return Issue{IssueCode::glb_skin_joint, where, "expected joints, found none"};
    const auto inverse_binds = read_inverse_binds(context, skin, static_cast<std::size_t>(index), where);
    if (!inverse_binds) return inverse_binds.issue();
    std::vector<std::uint32_t> nodes;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        const int node = skin.joints[j];
        if (node < 0 || static_cast<std::size_t>(node) >= animal.nodes.size())
            return Issue{
                IssueCode::glb_skin_joint, where,
                fmt::format("expected joints below {}, the count of nodes, found node {} as joint {}",
                            animal.nodes.size(), node, j)};
        nodes.push_back(static_cast<std::uint32_t>(node));
    }
    const auto bound = binder.bind(nodes, inverse_binds.value());
    if (!bound)
        return Issue{
            IssueCode::lim_bones, where,
            fmt::format("expected at most {} bones together, found more with the {} joints of this skin",
                        kMaxBones, nodes.size())};
    const SkinBones bones{static_cast<std::uint32_t>(animal.joint_map.size()),
                          static_cast<std::uint32_t>(nodes.size()), bound->fold};
    animal.joint_map.insert(animal.joint_map.end(), bound->bones.begin(), bound->bones.end());
    return bones;
}

void link_parents(Animal& animal) {
    std::vector<std::uint32_t> bone_of_node(animal.nodes.size(), kNone);
    for (std::uint32_t b = 0; b < animal.bones.size(); ++b)
        if (std::uint32_t& slot = bone_of_node[animal.bones[b].node]; slot == kNone) slot = b;
    for (Bone& bone : animal.bones)
        for (std::uint32_t n = animal.nodes[bone.node].parent; n != kNone && bone.parent == kNone;
             n = animal.nodes[n].parent)
            bone.parent = bone_of_node[n];
}

base::Status read_skinned_meshes(ReadContext& context, SkinBinder& binder) {
    const auto& model = context.model();
    std::map<int, SkinBones> skins;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const tinygltf::Node& node = model.nodes[n];
        const std::string where = fmt::format("nodes/{}", n);
        if (node.mesh < 0 || node.skin < 0) continue;
        if (static_cast<std::size_t>(node.mesh) >= model.meshes.size())
            return Issue{
                IssueCode::glb_reference, where,
                fmt::format("expected one of {} meshes, found index {}", model.meshes.size(), node.mesh)};
        if (static_cast<std::size_t>(node.skin) >= model.skins.size())
            return Issue{
                IssueCode::glb_reference, where,
                fmt::format("expected one of {} skins, found index {}", model.skins.size(), node.skin)};
        if (!skins.contains(node.skin)) {
            const auto bones = read_skin(context, node.skin, binder);
            if (!bones) return bones.issue();
            skins.emplace(node.skin, bones.value());
        }
        const SkinBones& bones = skins.at(node.skin);
        Mesh mesh;
        auto name =
            usable_name(model.meshes[static_cast<std::size_t>(node.mesh)].name, context.animal.nodes[n].name);
        if (!name) return base::at(fmt::format("meshes/{}", node.mesh), name.issue());
        mesh.name = std::move(name).value();
        mesh.node = static_cast<std::uint32_t>(n);
        mesh.mesh = static_cast<std::uint32_t>(node.mesh);
        mesh.skin = static_cast<std::uint32_t>(node.skin);
        mesh.first_joint = bones.first_joint;
        mesh.joint_count = bones.joint_count;
        mesh.fold = bones.fold;
        context.animal.meshes.push_back(std::move(mesh));
    }
    return {};
}

}  // namespace

base::Status read_skins(ReadContext& context) {
    SkinBinder binder(context.animal);
    if (auto status = read_skinned_meshes(context, binder); !status) return status;
    if (auto status = read_rigid_meshes(context, binder); !status) return status;
    link_parents(context.animal);
    return {};
}

}  // namespace posepack::animal
