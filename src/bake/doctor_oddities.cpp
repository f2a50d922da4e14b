// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bake/doctor.hpp"
#include "base/text.hpp"
#include "motion/affine.hpp"

namespace posepack::bake {
namespace {

using animal::Animal;
using output::Diagnosis;

constexpr double kScaleTolerance = 1e-3;  // relative; exporters round
constexpr double kLargestAnimalM = 35.0;  // a blue whale, and a little
constexpr double kSmallestAnimalM = 0.002;

template <class... Arguments>
void add(Diagnosis& diagnosis, const char* id, fmt::format_string<Arguments...> text,
         Arguments&&... arguments) {
    diagnosis.oddities.push_back({id, fmt::format(text, std::forward<Arguments>(arguments)...)});
}

// "one clip", "3 clips".
std::string counted(std::size_t count, const char* noun) {
    return count == 1 ? fmt::format("one {}", noun) : fmt::format("{} {}s", count, noun);
}

void look_at_armature(Diagnosis& diagnosis) {
    const output::DiagnosedSkeleton& skeleton = *diagnosis.skeleton;
    const auto& [x, y, z] = skeleton.armature_scale;
    const bool is_uniform = std::abs(x - y) < kScaleTolerance * x && std::abs(x - z) < kScaleTolerance * x;
    if (is_uniform && std::abs(x - 1.0) > kScaleTolerance)
        add(diagnosis, "armature-scale",
            "The nodes above the skeleton scale it by {:.4g} (many exporters do this); it is part of every "
            "bone.",
            x);
    if (!is_uniform)
        add(diagnosis, "armature-stretch",
            "The nodes above the skeleton stretch it by {:.4g}, {:.4g} and {:.4g} along its axes; bones that "
            "turn below it get sheared.",
            x, y, z);
    if (skeleton.is_sheared)
        add(diagnosis, "armature-shear",
            "The nodes above the skeleton shear it: forms that store a rotation and a scale cannot hold "
            "that, "
            "mat4 and affine can.");
    if (skeleton.is_mirrored)
        add(diagnosis, "armature-mirror",
            "The nodes above the skeleton mirror it: triangles turn their back, so draw them with the other "
            "winding.");
}

void look_at_skins(const Animal& animal, const animal::FileFacts& facts, Diagnosis& diagnosis) {
    std::size_t unbound = 0;
    std::size_t unused = 0;
    for (const animal::SkinFacts& skin : facts.skins) {
        unbound += skin.user_count > 0 && !skin.has_inverse_binds ? 1 : 0;
        unused += skin.user_count == 0 ? 1 : 0;
    }
    if (unbound > 0)
        add(diagnosis, "no-bind-pose",
            "{} without a bind pose (inverse bind matrices): every joint is taken to have stood at the "
            "origin "
            "when the mesh was bound.",
            counted(unbound, "skin"));
    if (const std::size_t folded = animal.folds.size(); folded > 0)
        add(diagnosis, "folded-skins",
            "{} whose bind pose is that of another, moved as a whole: the two share their bones, so that the "
            "palette is smaller.",
            counted(folded, "skin"));
    if (unused > 0) add(diagnosis, "unused-skin", "{} that no mesh uses.", counted(unused, "skin"));
    const auto bones = diagnosis.skeleton->unused_bones.size();
    if (bones > 0)
        add(diagnosis, "unused-bones",
            "{} without a vertex (control and helper bones have none): part of the palette, which costs "
            "memory, unless --max-error or --unused-bones drop leaves such bones out.",
            counted(bones, "bone"));
}

bool is_identity(const motion::Affine& affine) {
    double difference = 0.0;
    for (int c = 0; c < 3; ++c) {
        difference = std::max(difference, std::abs(affine.translation[c]));
        for (int r = 0; r < 3; ++r)
            difference = std::max(difference, std::abs(affine.linear[c][r] - (c == r ? 1.0 : 0.0)));
    }
    return difference < 1e-6;
}

// A skinned mesh stands where its joints put it; what its own node says is ignored (glTF 2.0
// section 3.7.3.3).
void look_at_mesh_nodes(const Animal& animal, Diagnosis& diagnosis) {
    std::size_t moved = 0;
    for (const animal::Mesh& mesh : animal.meshes) {
        const animal::Node& node = animal.nodes[mesh.node];
        const bool is_still = node.has_matrix ? is_identity(motion::affine_of(node.matrix))
                                              : is_identity(motion::affine_of(node.rest));
        moved += mesh.skin != animal::kNone && !is_still ? 1 : 0;
    }
    if (moved > 0)
        add(diagnosis, "mesh-node-moved",
            "The node of {} is moved, turned or scaled: glTF ignores that, the joints alone place the mesh.",
            counted(moved, "skinned model part"));
}

void look_at_clips(Diagnosis& diagnosis) {
    std::size_t late = 0, empty = 0, ragged = 0, still = 0, steps = 0;
    std::set<std::string> names;
    std::size_t doubled = 0;
    for (const output::DiagnosedClip& clip : diagnosis.clips) {
        late += clip.start_s > 1e-6 ? 1 : 0;
        empty += clip.duration_s == 0.0 ? 1 : 0;
        ragged += clip.has_late_channel ? 1 : 0;
        still += clip.duration_s > 0.0 && !clip.moves ? 1 : 0;
        steps += clip.step_channels > 0 && clip.linear_channels + clip.cubic_channels > 0 ? 1 : 0;
        doubled += names.insert(base::lowered(clip.source_name)).second ? 0 : 1;
    }
    if (late > 0)
        add(diagnosis, "late-start", "{} whose first key is later than 0 s: baked from that key on.",
            counted(late, "clip"));
    if (empty > 0)
        add(diagnosis, "single-pose", "{} of one moment only (a pose): one row each.",
            counted(empty, "clip"));
    if (ragged > 0)
        add(diagnosis, "uneven-channels",
            "{} in which some bones have their first key later than others: until then they hold it.",
            counted(ragged, "clip"));
    if (still > 0) add(diagnosis, "still-clip", "{} in which no bone moves.", counted(still, "clip"));
    if (steps > 0)
        add(diagnosis, "mixed-steps",
            "{} with both smooth and stepped keys: stepped bones are blended over the last row before each "
            "jump.",
            counted(steps, "clip"));
    if (doubled > 0)
        add(diagnosis, "same-name",
            "{} with the name of an earlier one (letter case aside): a number is added to the name.",
            counted(doubled, "clip"));
}

void look_at_size(Diagnosis& diagnosis) {
    const double largest = *std::max_element(diagnosis.extent_m.begin(), diagnosis.extent_m.end());
    if (largest > kLargestAnimalM)
        add(diagnosis, "huge",
            "It is {:.4g} units long; if those are centimetres, write \"metres_per_unit\": 0.01 in the "
            "catalog.",
            largest);
    else if (largest < kSmallestAnimalM)
        add(diagnosis, "tiny",
            "It is {:.4g} units long; if a unit is more than a metre, write \"metres_per_unit\" in the "
            "catalog.",
            largest);
}

void look_at_file(const Animal& animal, const animal::FileFacts& facts, Diagnosis& diagnosis) {
    const auto rigid_parts = static_cast<std::size_t>(
        std::count_if(animal.meshes.begin(), animal.meshes.end(),
                      [](const animal::Mesh& mesh) { return mesh.skin == animal::kNone; }));
    if (facts.scene_count > 1)
        add(diagnosis, "several-scenes", "It has {} scenes; nodes of all of them are read.",
            facts.scene_count);
    if (facts.outside_image_count > 0)
        add(diagnosis, "outside-images",
            "{} outside the file: textures are never opened, so nothing is missing for a bake.",
            counted(facts.outside_image_count, "image"));
    if (facts.skinned_node_count > 0 && rigid_parts > 0)
        add(diagnosis, "rigid-parts",
            "{} beside the skinned ones (weapons, antlers): each moves with a bone of its own.",
            counted(rigid_parts, "rigid model part"));
    if (facts.skinned_node_count == 0 && !facts.rigid_nodes.empty())
        add(diagnosis, "no-skin", "It has no skin: every node with a mesh becomes a bone of its own.");
}

}  // namespace

void find_oddities(const Animal& animal, Diagnosis& diagnosis) {
    if (diagnosis.facts) {
        look_at_file(animal, *diagnosis.facts, diagnosis);
        look_at_skins(animal, *diagnosis.facts, diagnosis);
    }
    look_at_armature(diagnosis);
    look_at_mesh_nodes(animal, diagnosis);
    look_at_size(diagnosis);
    look_at_clips(diagnosis);
}

}  // namespace posepack::bake
