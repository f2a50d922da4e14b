// SPDX-License-Identifier: MIT
#include "animal/read_rigid_meshes.hpp"

#include <fmt/format.h>

#include "animal/animation_target.hpp"
#include "animal/names.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::size_t kMostNames = 8;  // of a finding

base::Status add_rigid_mesh(ReadContext& context, std::uint32_t node, SkinBinder& binder) {
    const auto& meshes = context.model().meshes;
    Animal& animal = context.animal;
    const auto mesh_index = static_cast<std::size_t>(context.model().nodes[node].mesh);
    if (mesh_index >= meshes.size())
        return Issue{IssueCode::glb_reference, fmt::format("nodes/{}", node),
                     fmt::format("expected one of {} meshes, found index {}", meshes.size(), mesh_index)};
    const glm::dmat4 identity(1.0);
    const auto bound = binder.bind({&node, 1}, {&identity, 1});
    if (!bound)
        return Issue{IssueCode::lim_bones, fmt::format("nodes/{}", node),
                     fmt::format("expected at most {} bones together, those of nodes with a rigid mesh among "
                                 "them, found more",
                                 kMaxBones)};
    auto name = usable_name(meshes[mesh_index].name, animal.nodes[node].name);
    if (!name) return base::at(fmt::format("meshes/{}", mesh_index), name.issue());
    Mesh mesh;
    mesh.name = std::move(name).value();
    mesh.node = node;
    mesh.mesh = static_cast<std::uint32_t>(mesh_index);
    mesh.first_joint = static_cast<std::uint32_t>(animal.joint_map.size());
    mesh.joint_count = 1;
    mesh.fold = bound->fold;
    animal.joint_map.push_back(bound->bones.front());
    animal.meshes.push_back(std::move(mesh));
    return {};
}

// What moves: joints of skins, targets of channels, and all that is below them.
std::vector<bool> moving_nodes(const ReadContext& context) {
    std::vector<bool> moving = animated_nodes(context.model(), context.accessors.facts());
    for (const Bone& bone : context.animal.bones) moving[bone.node] = true;
    for (const std::uint32_t node : context.animal.node_order) {
        const std::uint32_t parent = context.animal.nodes[node].parent;
        if (parent != kNone && moving[parent]) moving[node] = true;
    }
    return moving;
}

void note_still(ReadContext& context, const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size() && i < kMostNames; ++i)
        list += (i > 0 ? ", " : "") + base::shortened(names[i], 40);
    if (names.size() > kMostNames) list += fmt::format(" and {} more", names.size() - kMostNames);
    context.note(IssueCode::warn_left_out, "nodes",
                 fmt::format("{} that nothing moves: not in the palette ({})",
                             base::counted(names.size(), "rigid mesh", "rigid meshes"), list));
}

}  // namespace

base::Status read_rigid_meshes(ReadContext& context, SkinBinder& binder) {
    const auto& nodes = context.model().nodes;
    const bool has_skins = !context.animal.meshes.empty();
    const std::vector<bool> moving = has_skins ? moving_nodes(context) : std::vector<bool>();
    std::vector<std::string> still;
    for (std::uint32_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].mesh < 0 || nodes[n].skin >= 0) continue;
        if (has_skins && !moving[n])
            still.push_back(context.animal.nodes[n].name);
        else if (auto status = add_rigid_mesh(context, n, binder); !status)
            return status;
    }
    if (!still.empty()) note_still(context, still);
    return {};
}

}  // namespace posepack::animal
