// SPDX-License-Identifier: MIT
#include "animal/bind_skins.hpp"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

namespace posepack::animal {
namespace {

// Sixteen units in the last place of a float: exporters compose inverse binds from chains of float matrices.
constexpr double kRounding = 0x1p-20;
// Below this share of its own size a matrix cannot be turned back.
constexpr double kLeastDeterminant = 1e-9;
// What a hostile file may cost: skins that a skin is compared with, and joints of all folded skins.
constexpr std::size_t kMaxReferences = 32;
constexpr std::size_t kMaxFoldedJoints = 32'768;

double largest_of(const glm::dmat3& m) {
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
    return largest;
}

double largest_of(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool is_invertible(const glm::dmat3& m) {
    const double size = largest_of(m);
    return std::abs(glm::determinant(m)) > kLeastDeterminant * size * size * size;
}

// Containers hold it as floats; with those numbers the rest is computed, so that nothing is lost by storing.
glm::dmat4 as_floats(const glm::dmat4& m) {
    glm::dmat4 out(1.0);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r) out[c][r] = static_cast<double>(static_cast<float>(m[c][r]));
    return out;
}

glm::dmat4 inverse_of(const glm::dmat4& m) {
    const glm::dmat3 linear = glm::inverse(glm::dmat3(m));
    glm::dmat4 out(linear);
    out[3] = glm::dvec4(-(linear * glm::dvec3(m[3])), 1.0);
    return out;
}

}  // namespace

std::optional<SkinBinder::Bound> SkinBinder::bind(std::span<const std::uint32_t> nodes,
                                                  std::span<const glm::dmat4> inverse_binds) {
    const Skin skin{nodes, inverse_binds};
    std::vector<std::uint32_t> sorted(nodes.begin(), nodes.end());
    std::sort(sorted.begin(), sorted.end());
    const bool is_once_each = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (!is_once_each || folded_joints_ + nodes.size() > kMaxFoldedJoints) return share_equal(skin);
    for (const Reference& reference : references_) {
        const std::vector<CommonJoint> common = common_joints(skin, reference);
        const std::optional<glm::dmat4> x = matrix_between(skin, common);
        if (!x) continue;
        auto bound = fold_onto(skin, common, *x);
        if (bound && common.size() < nodes.size()) remember(skin, *bound);
        return bound;
    }
    auto bound = share_equal(skin);
    if (bound) remember(skin, *bound);
    return bound;
}

void SkinBinder::remember(const Skin& skin, const Bound& bound) {
    if (references_.size() >= kMaxReferences) return;
    Reference reference;
    for (std::size_t j = 0; j < skin.nodes.size(); ++j) reference.emplace_back(skin.nodes[j], bound.bones[j]);
    std::sort(reference.begin(), reference.end());
    references_.push_back(std::move(reference));
}

std::vector<SkinBinder::CommonJoint> SkinBinder::common_joints(const Skin& skin,
                                                               const Reference& reference) const {
    std::vector<CommonJoint> common;
    for (std::size_t j = 0; j < skin.nodes.size(); ++j) {
        const auto found = std::lower_bound(reference.begin(), reference.end(),
                                            std::pair<std::uint32_t, std::uint32_t>{skin.nodes[j], 0});
        if (found != reference.end() && found->first == skin.nodes[j]) common.push_back({j, found->second});
    }
    return common;
}

// The least squares of A(j) X - B(j), linear part and translation apart: (sum A'A) X = sum A'B.
std::optional<glm::dmat4> SkinBinder::matrix_between(const Skin& skin,
                                                     std::span<const CommonJoint> common) const {
    if (common.empty()) return std::nullopt;
    if (is_between(skin, common, glm::dmat4(1.0))) return glm::dmat4(1.0);
    glm::dmat3 square(0.0), linear(0.0);
    glm::dvec3 translation(0.0);
    for (const CommonJoint& c : common) {
        const glm::dmat4& a = animal_.bones[c.bone].inverse_bind;
        const glm::dmat4& b = skin.inverse_binds[c.joint];
        const glm::dmat3 transposed = glm::transpose(glm::dmat3(a));
        square += transposed * glm::dmat3(a);
        linear += transposed * glm::dmat3(b);
        translation += transposed * (glm::dvec3(b[3]) - glm::dvec3(a[3]));
    }
    if (!is_invertible(square)) return std::nullopt;
    const glm::dmat3 solved = glm::inverse(square);
    glm::dmat4 x(solved * linear);
    x[3] = glm::dvec4(solved * translation, 1.0);
    x = as_floats(x);
    // Not so for NaN, which values at the end of the floats' range can bring.
    const bool is_usable = is_invertible(glm::dmat3(x)) && largest_of(glm::dvec3(x[3])) < HUGE_VAL;
    if (!is_usable || !is_between(skin, common, x)) return std::nullopt;
    return x;
}

// B(j) = A(j) X for all, to the rounding of floats of the size that the skin has.
bool SkinBinder::is_between(const Skin& skin, std::span<const CommonJoint> common,
                            const glm::dmat4& x) const {
    double far = 0.0;  // the largest translation: what the others were rounded beside
    for (const CommonJoint& c : common)
        far = std::max({far, largest_of(glm::dvec3(skin.inverse_binds[c.joint][3])),
                        largest_of(glm::dvec3(animal_.bones[c.bone].inverse_bind[3]))});
    return std::all_of(common.begin(), common.end(), [&](const CommonJoint& c) {
        const glm::dmat4& b = skin.inverse_binds[c.joint];
        const glm::dmat4 off = animal_.bones[c.bone].inverse_bind * x - b;
        return largest_of(glm::dmat3(off)) <= kRounding * largest_of(glm::dmat3(b)) &&
               largest_of(glm::dvec3(off[3])) <= kRounding * far;
    });
}

std::optional<SkinBinder::Bound> SkinBinder::share_equal(const Skin& skin) {
    Bound bound;
    for (std::size_t j = 0; j < skin.nodes.size(); ++j) {
        const std::uint32_t bone = bone_of(skin.nodes[j], skin.inverse_binds[j]);
        if (bone == kNone) return std::nullopt;
        bound.bones.push_back(static_cast<std::uint16_t>(bone));
    }
    return bound;
}

std::optional<SkinBinder::Bound> SkinBinder::fold_onto(const Skin& skin, std::span<const CommonJoint> common,
                                                       const glm::dmat4& x) {
    std::vector<std::uint32_t> bones(skin.nodes.size(), kNone);
    for (const CommonJoint& c : common) bones[c.joint] = c.bone;
    const bool is_identity = x == glm::dmat4(1.0);
    const glm::dmat4 back = is_identity ? x : inverse_of(x);
    Bound bound;
    bool is_exact = is_identity;
    for (std::size_t j = 0; j < bones.size(); ++j) {
        const glm::dmat4& source = skin.inverse_binds[j];
        if (bones[j] == kNone) bones[j] = bone_of(skin.nodes[j], is_identity ? source : source * back);
        if (bones[j] == kNone) return std::nullopt;
        is_exact = is_exact && animal_.bones[bones[j]].inverse_bind == source;
        bound.bones.push_back(static_cast<std::uint16_t>(bones[j]));
    }
    if (is_exact) return bound;
    bound.fold = static_cast<std::uint32_t>(animal_.folds.size());
    animal_.folds.push_back({x, {skin.inverse_binds.begin(), skin.inverse_binds.end()}});
    folded_joints_ += skin.nodes.size();
    return bound;
}

// The bone of an equal (joint, inverse bind) pair, or a new one; kNone where there are too many.
std::uint32_t SkinBinder::bone_of(std::uint32_t node, const glm::dmat4& inverse_bind) {
    const auto [first, last] = bones_by_node_.equal_range(node);
    for (auto it = first; it != last; ++it)
        if (animal_.bones[it->second].inverse_bind == inverse_bind) return it->second;
    if (animal_.bones.size() >= kMaxBones) return kNone;
    Bone bone;
    bone.name = animal_.nodes[node].name;
    bone.node = node;
    bone.inverse_bind = inverse_bind;
    animal_.bones.push_back(std::move(bone));
    const auto index = static_cast<std::uint32_t>(animal_.bones.size() - 1);
    bones_by_node_.emplace(node, index);
    return index;
}

}  // namespace posepack::animal
