// SPDX-License-Identifier: MIT
#include "measure/bindings.hpp"

#include <glm/matrix.hpp>

namespace posepack::measure {
namespace {

using motion::Affine;

Affine inverse(const Affine& map) {
    const glm::dmat3 linear = glm::inverse(map.linear);
    return {linear, -(linear * map.translation)};
}

}  // namespace

Bindings::Bindings(const animal::Animal& animal, const palette::Spaces& spaces)
    : animal_(animal),
      spaces_(spaces),
      bone_count_(animal.bones.size()),
      binding_of_bone_(animal.folds.size()) {
    for (std::size_t m = 0; m < animal.meshes.size(); ++m) {
        const animal::Mesh& mesh = animal.meshes[m];
        // Several meshes may use one skin.
        if (mesh.fold == animal::kNone || !binding_of_bone_[mesh.fold].empty()) continue;
        std::vector<std::uint32_t>& bindings = binding_of_bone_[mesh.fold];
        bindings.assign(bone_count_, animal::kNone);
        const Affine back = inverse(motion::bind_from_mesh(animal, mesh));
        for (std::uint32_t j = 0; j < mesh.joint_count; ++j) {
            const std::uint16_t bone = animal.joint_map[mesh.first_joint + j];
            if (bone == animal::kNoBone) continue;
            bindings[bone] = static_cast<std::uint32_t>(size());
            folded_.push_back({bone, animal.bones[bone].node,
                               motion::affine_of(animal.folds[mesh.fold].inverse_binds[j]) * back,
                               spaces.mesh_entry(m) * back});
        }
    }
}

motion::SkinSet Bindings::bind(motion::SkinSet set) const {
    if (folded_.empty()) return set;
    std::size_t mesh = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const std::uint32_t vertex = set.vertices[i];
        const auto holds = [&](const animal::Mesh& m) {
            return vertex >= m.first_vertex && vertex - m.first_vertex < m.vertex_count;
        };
        // Entries mostly follow each other.
        while (!holds(animal_.meshes[mesh])) mesh = (mesh + 1) % animal_.meshes.size();
        const std::uint32_t fold = animal_.meshes[mesh].fold;
        if (fold == animal::kNone) continue;
        for (std::size_t k = 0; k < set.weights[i].size() && set.weights[i][k] > 0.0f; ++k)
            set.bones[i][k] = static_cast<std::uint16_t>(binding_of_bone_[fold][set.bones[i][k]]);
    }
    return set;
}

Affine Bindings::source(std::uint32_t binding, std::span<const Affine> bones,
                        const motion::ClipSampler& sampler) const {
    if (binding < bone_count_) return bones[binding];
    const Folded& folded = folded_[binding - bone_count_];
    return sampler.node_global(folded.node) * folded.inverse_bind;
}

Affine Bindings::found(std::uint32_t binding, const Affine& stored) const {
    if (binding < bone_count_) return spaces_.leave(binding, stored);
    const Affine entered = stored * folded_[binding - bone_count_].entry;
    return spaces_.normalised ? spaces_.model_from_palette * entered : entered;
}

}  // namespace posepack::measure
