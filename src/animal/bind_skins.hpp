// SPDX-License-Identifier: MIT
// From skins to bones: which joints of which skins can share a bone.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "animal/animal.hpp"

namespace posepack::animal {

inline constexpr std::size_t kMaxBones = 1'024;

// Gives bones to one skin after the other.
//
// Two skins share the bones of equal (joint, inverse bind) pairs. Where the inverse binds of all joints that
// a skin has in common with an earlier one differ by a single matrix X, B(j) = A(j) X within float rounding,
// it is *folded*: its vertices enter by X, and every common joint needs one bone only. Exporters write such
// skins when the parts of a character have nodes of their own: X is then the place of the part.
class SkinBinder {
 public:
    // Bones are added to `animal`, which must outlive the binder.
    explicit SkinBinder(Animal& animal) : animal_(animal) {}

    struct Bound {
        std::vector<std::uint16_t> bones;  // of each joint
        std::uint32_t fold = kNone;        // into Animal::folds
    };
    // The bones of a skin; nothing when they would be more than kMaxBones.
    //   nodes, inverse_binds  of each joint
    std::optional<Bound> bind(std::span<const std::uint32_t> nodes,
                              std::span<const glm::dmat4> inverse_binds);

 private:
    // A skin that later ones may be folded onto: (node, bone), by node, each node once.
    using Reference = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    struct Skin {
        std::span<const std::uint32_t> nodes;
        std::span<const glm::dmat4> inverse_binds;
    };
    struct CommonJoint {
        std::size_t joint;
        std::uint32_t bone;
    };
    std::vector<CommonJoint> common_joints(const Skin& skin, const Reference& reference) const;
    std::optional<glm::dmat4> matrix_between(const Skin& skin, std::span<const CommonJoint> common) const;
    bool is_between(const Skin& skin, std::span<const CommonJoint> common, const glm::dmat4& x) const;
    std::optional<Bound> share_equal(const Skin& skin);
    std::optional<Bound> fold_onto(const Skin& skin, std::span<const CommonJoint> common,
                                   const glm::dmat4& x);
    std::uint32_t bone_of(std::uint32_t node, const glm::dmat4& inverse_bind);
    void remember(const Skin& skin, const Bound& bound);

    Animal& animal_;
    std::multimap<std::uint32_t, std::uint32_t> bones_by_node_;
    std::vector<Reference> references_;
    std::size_t folded_joints_ = 0;
};

}  // namespace posepack::animal
