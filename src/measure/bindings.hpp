// SPDX-License-Identifier: MIT
// Bindings: the different ways in which vertices hang on bones, each with what the source says of it.
//
// A vertex of a folded skin reads the bone of another skin, behind a matrix that is rounded to floats; its
// source has an inverse bind of its own. So what is compared is not one pair of matrices a bone, but one a
// binding: first the bones themselves, one each, then one a joint of every folded skin.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "animal/animal.hpp"
#include "motion/clip_sampler.hpp"
#include "motion/skin_set.hpp"
#include "palette/spaces.hpp"

namespace posepack::measure {

class Bindings {
 public:
    Bindings(const animal::Animal& animal, const palette::Spaces& spaces);

    std::size_t size() const { return bone_count_ + folded_.size(); }
    std::uint32_t bone_of(std::uint32_t binding) const {
        return binding < bone_count_ ? binding : folded_[binding - bone_count_].bone;
    }

    // The set with a binding in the place of every bone.
    motion::SkinSet bind(motion::SkinSet set) const;

    // What the source says, from where bones bind to model space.
    //   bones    skinning matrices at the time of the sampler's last sample
    motion::Affine source(std::uint32_t binding, std::span<const motion::Affine> bones,
                          const motion::ClipSampler& sampler) const;
    // What a reader makes of the stored matrix of the binding's bone, between the same spaces.
    motion::Affine found(std::uint32_t binding, const motion::Affine& stored) const;

 private:
    struct Folded {
        std::uint32_t bone, node;
        motion::Affine inverse_bind,
            entry;  // the source's, and the reader's palette_from_mesh; both behind 1 / X
    };
    const animal::Animal& animal_;
    const palette::Spaces& spaces_;
    std::size_t bone_count_;
    std::vector<Folded> folded_;
    std::vector<std::vector<std::uint32_t>> binding_of_bone_;  // of each fold; kNone where it lacks the bone
};

}  // namespace posepack::measure
