// SPDX-License-Identifier: MIT
#include "palette/spaces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "palette/bounds.hpp"
#include "palette/similarity.hpp"

namespace posepack::palette {
namespace {

using animal::Animal;
using motion::Affine;

constexpr std::uint32_t kRowsLookedAt = 10;  // of a clip: enough for a centre and a median
// Beyond these a scale is a limb that was hidden by shrinking it, not the unit of a mesh.
constexpr double kSmallestScale = 1e-9;
constexpr double kLargestScale = 1e9;

// Meshes that share a bone are in one group: the smallest index of a mesh among them.
std::vector<std::uint32_t> group_meshes(const Animal& animal, std::vector<std::uint32_t>& group_of_bone) {
    std::vector<std::uint32_t> group(animal.meshes.size());
    std::iota(group.begin(), group.end(), 0u);
    group_of_bone.assign(animal.bones.size(), animal::kNone);
    for (std::uint32_t m = 0; m < group.size(); ++m) {
        const animal::Mesh& mesh = animal.meshes[m];
        for (std::uint32_t j = 0; j < mesh.joint_count; ++j) {
            const std::uint16_t bone = animal.joint_map[mesh.first_joint + j];
            if (bone == animal::kNoBone) continue;
            const std::uint32_t other = group_of_bone[bone];
            if (other == animal::kNone) {
                group_of_bone[bone] = group[m];
            } else if (other != group[m]) {
                const std::uint32_t low = std::min(other, group[m]);
                const std::uint32_t high = std::max(other, group[m]);
                std::replace(group.begin(), group.end(), high, low);
                std::replace(group_of_bone.begin(), group_of_bone.end(), high, low);
            }
        }
    }
    return group;
}

// What the clips show of an animal: the box of its vertices, and the scales of every bone.
struct Survey {
    Box box;                                  // model space
    std::vector<std::vector<double>> scales;  // signed, of each bone
};

Survey survey_clips(const Animal& animal, std::span<const PlannedClip> clips) {
    Survey survey;
    survey.scales.resize(animal.bones.size());
    const BoneBoxes boxes(animal);
    std::vector<Affine> bones(animal.bones.size());
    for (const PlannedClip& planned : clips) {
        motion::ClipSampler sampler(animal, *planned.clip);
        const std::uint32_t step = (planned.plan->row_count + kRowsLookedAt - 1) / kRowsLookedAt;
        for (std::uint32_t row = 0; row < planned.plan->row_count; row += step) {
            motion::sample_row(sampler, *planned.plan, row, bones);
            boxes.add(bones, survey.box);
            for (std::size_t b = 0; b < bones.size(); ++b)
                survey.scales[b].push_back(signed_scale(bones[b].linear));
        }
    }
    return survey;
}

bool is_usable(double scale) {
    return std::abs(scale) > kSmallestScale && std::abs(scale) < kLargestScale;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// The bone of `members` whose rotation at rest is nearest to all others'.
std::uint32_t most_agreed(const std::vector<std::uint32_t>& members, std::span<const Similarity> rest) {
    std::uint32_t best = members.front();
    double largest = -1.0;
    for (const std::uint32_t a : members) {
        double sum = 0.0;
        for (const std::uint32_t b : members) sum += std::abs(glm::dot(rest[a].rotation, rest[b].rotation));
        if (sum > largest * (1.0 + 1e-9)) {
            largest = sum;
            best = a;
        }
    }
    return best;
}

// The middle of the box of the vertices that a bone moves, as it binds them.
glm::dvec3 middle_of(const Animal& animal, std::uint32_t bone) {
    glm::dvec3 low(HUGE_VAL);
    glm::dvec3 high(-HUGE_VAL);
    for (const animal::Mesh& mesh : animal.meshes) {
        const Affine entry = motion::bind_from_mesh(animal, mesh);
        for (std::uint32_t v = mesh.first_vertex; v < mesh.first_vertex + mesh.vertex_count; ++v)
            for (std::size_t i = 0; i < animal::kMaxInfluences; ++i) {
                if (animal.vertices.bones[v][i] != bone || animal.vertices.weights[v][i] <= 0.0f) continue;
                const auto& p = animal.vertices.positions[v];
                const glm::dvec3 bound = entry * glm::dvec3(p[0], p[1], p[2]);
                low = glm::min(low, bound);
                high = glm::max(high, bound);
            }
    }
    return low.x > high.x ? glm::dvec3(0.0) : 0.5 * (low + high);
}

// B of the bones of a group: model from mesh, a similarity.
Affine bind_of_group(const Animal& animal, std::uint32_t group, std::span<const std::uint32_t> group_of_bone,
                     std::span<const Affine> rest, const Survey& survey) {
    std::vector<Similarity> similarities(rest.size());
    std::vector<std::uint32_t> members;
    std::vector<double> scales;
    for (std::uint32_t b = 0; b < rest.size(); ++b) {
        if (group_of_bone[b] != group || !animal.bones[b].weighted) continue;
        similarities[b] = nearest_similarity(rest[b], glm::dvec4(0.0, 0.0, 0.0, 1.0));
        if (!is_usable(similarities[b].scale)) continue;
        members.push_back(b);
        for (const double scale : survey.scales[b])
            if (is_usable(scale)) scales.push_back(scale);
    }
    if (members.empty()) return {};
    const std::uint32_t chosen = most_agreed(members, similarities);
    Similarity bind = similarities[chosen];
    if (!scales.empty()) bind.scale = median(std::move(scales));
    Affine out{bind.scale * rotation_matrix(bind.rotation), glm::dvec3(0.0)};
    const glm::dvec3 middle = middle_of(animal, chosen);
    out.translation = rest[chosen] * middle - out * middle;
    return out;
}

double rounded(double value) {
    return static_cast<double>(static_cast<float>(value));
}

Affine rounded(const Affine& map) {
    Affine out;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) out.linear[c][r] = rounded(map.linear[c][r]);
        out.translation[c] = rounded(map.translation[c]);
    }
    return out;
}

Affine inverse(const Affine& map) {
    const glm::dmat3 linear = glm::inverse(map.linear);
    return {linear, -(linear * map.translation)};
}

glm::dvec3 center_of(const Box& box) {
    glm::dvec3 center(0.0);
    for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(c);
        center[c] = 0.5 * (box.low[i] + box.high[i]);
    }
    // What floats cannot hold is refused where it is stored; here it only must not spread.
    for (int c = 0; c < 3; ++c)
        if (!(std::abs(center[c]) < 1e30)) return glm::dvec3(0.0);
    return center;
}

}  // namespace

void Spaces::enter(std::span<Affine> bones) const {
    if (!normalised) return;
    for (std::size_t b = 0; b < bones.size(); ++b)
        bones[b] = palette_from_model * bones[b] * bound_from_palette[b];
}

Affine Spaces::leave(std::size_t bone, const Affine& stored) const {
    return normalised ? model_from_palette * stored * palette_from_bound[bone] : stored;
}

Spaces model_space(const Animal& animal) {
    Spaces spaces;
    for (const animal::Mesh& mesh : animal.meshes)
        spaces.palette_from_mesh.push_back(motion::bind_from_mesh(animal, mesh));
    return spaces;
}

Spaces normalise(const Animal& animal, std::span<const PlannedClip> clips, double radius) {
    const Survey survey = survey_clips(animal, clips);
    const std::vector<Affine> rest = motion::rest_pose(animal);
    Spaces spaces;
    spaces.normalised = true;
    spaces.model_from_palette = rounded(Affine{glm::dmat3(radius), center_of(survey.box)});
    // The numbers that are stored decide; what is computed from them is exact to a double.
    spaces.palette_from_model = inverse(spaces.model_from_palette);
    std::vector<std::uint32_t> group_of_bone;
    const std::vector<std::uint32_t> group_of_mesh = group_meshes(animal, group_of_bone);
    std::vector<Affine> entry_of_group(animal.meshes.size());
    for (std::uint32_t m = 0; m < animal.meshes.size(); ++m) {
        const std::uint32_t group = group_of_mesh[m];
        if (group == m)
            entry_of_group[m] = rounded(spaces.palette_from_model *
                                        bind_of_group(animal, group, group_of_bone, rest, survey));
        const Affine& entry = entry_of_group[group];
        const bool is_folded = animal.meshes[m].fold != animal::kNone;
        spaces.palette_from_mesh.push_back(
            is_folded ? rounded(entry * motion::bind_from_mesh(animal, animal.meshes[m])) : entry);
    }
    for (const std::uint32_t group : group_of_bone) {
        const bool is_used = group != animal::kNone;
        spaces.palette_from_bound.push_back(is_used ? entry_of_group[group] : Affine{});
        spaces.bound_from_palette.push_back(inverse(spaces.palette_from_bound.back()));
    }
    return spaces;
}

}  // namespace posepack::palette
