// SPDX-License-Identifier: MIT
// Animal: our model of one skinned, animated GLB. Plain arrays, checked once by the reader, then const.
//
// Every index in it is in range, every float is finite, key times rise, hierarchies end. Later rooms rely
// on that and check nothing again.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/issue.hpp"

namespace posepack::animal {

inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;
inline constexpr std::uint16_t kNoBone = 0xFFFFu;  // in a joint map: nothing moves by this joint
// Of a vertex, at most; ReadOptions says how many of them are kept.
inline constexpr std::size_t kMaxInfluences = 8;
using InfluenceBones = std::array<std::uint16_t, kMaxInfluences>;
using InfluenceWeights = std::array<float, kMaxInfluences>;

// Translation, rotation (unit quaternion x, y, z, w) and scale of a node, relative to its parent.
struct Transform {
    glm::dvec3 translation{0.0, 0.0, 0.0};
    glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0};
    glm::dvec3 scale{1.0, 1.0, 1.0};
};

struct Node {
    std::string name;
    std::uint32_t parent = kNone;
    Transform rest;           // meaningless when has_matrix
    bool has_matrix = false;  // glTF 2.0 section 3.5.3: such a node is not animated
    glm::dmat4 matrix{1.0};
};

enum class Interpolation : std::uint8_t { linear, step, cubic_spline };
enum class Path : std::uint8_t { translation, rotation, scale };

// The keys of one animated property. Values: 3 floats a key (4 for rotation, x y z w), three times as many
// for cubic splines (in-tangent, value, out-tangent), as in glTF 2.0 appendix C.
struct Channel {
    std::uint32_t node = 0;
    Path path = Path::translation;
    Interpolation interpolation = Interpolation::linear;
    std::uint32_t first_time = 0;   // index into Animal::key_times
    std::uint32_t key_count = 0;    // at least 1
    std::uint32_t first_value = 0;  // index into Animal::key_values
};

struct Clip {
    std::string source_name;  // glTF animation name, verbatim
    std::string name;         // text after the last '|', made unique among the clips
    std::vector<Channel> channels;
    double start_s = 0.0;     // time of the first key
    double duration_s = 0.0;  // from the first key to the last
};

// A palette column: the matrix node_global x inverse_bind (x the X of the skin where that is folded).
struct Bone {
    std::string name;
    std::uint32_t node = 0;
    std::uint32_t parent = kNone;  // bone of the nearest ancestor node that has one
    glm::dmat4 inverse_bind{1.0};
    bool weighted = false;  // some vertex of the file has a weight on it, kept or left out
};

// A skin whose inverse binds are those of other bones times one matrix X, within the rounding of floats: its
// vertices enter by X and share the bones.
struct Fold {
    glm::dmat4 bind_from_mesh{1.0};         // X: mesh space to the space that the bones bind; floats
    std::vector<glm::dmat4> inverse_binds;  // of each joint, as the file has them
};

// A node that draws a mesh: with a skin, and then its own transform is ignored (glTF 2.0 section 3.7.3.3);
// or rigidly, with one bone of its own, or that of a joint if it is one.
struct Mesh {
    std::string name;
    std::uint32_t node = 0, mesh = 0;                // glTF indices
    std::uint32_t skin = kNone;                      // glTF index; kNone for a rigid mesh
    std::uint32_t first_joint = 0, joint_count = 0;  // into Animal::joint_map
    std::uint32_t first_vertex = 0, vertex_count = 0;
    std::uint32_t fold = kNone;  // into Animal::folds; kNone: bones bind the mesh as it is
};

// The vertices of all meshes, primitive by primitive; arrays run in step.
struct Vertices {
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 3>> normals;  // zero where the primitive has none
    std::vector<InfluenceBones> bones;
    std::vector<InfluenceWeights> weights;  // falling, sum 1; unused ones zero
};

// All influences of the vertices that have more than were kept, to measure what leaving some out costs.
struct ReducedVertices {
    std::vector<std::uint32_t> vertices;  // rising
    std::vector<std::uint32_t> first;     // of each, where its influences begin
    std::vector<std::uint16_t> bones;
    std::vector<float> weights;  // of each vertex falling, sum 1

    std::uint32_t end_of(std::size_t index) const {
        return index + 1 < first.size() ? first[index + 1] : static_cast<std::uint32_t>(bones.size());
    }
};

struct Animal {
    std::vector<Node> nodes;                // in glTF order
    std::vector<std::uint32_t> node_order;  // parents before children
    std::vector<Bone> bones;                // of the skins' joints in their order, then of rigid meshes
    std::vector<std::uint16_t> joint_map;   // bone of each (mesh's skin, joint), or kNoBone
    std::vector<Mesh> meshes;
    std::vector<Fold> folds;
    Vertices vertices;
    ReducedVertices reduced;
    std::vector<Clip> clips;
    std::vector<float> key_times;  // seconds, of all channels
    std::vector<float> key_values;
    std::vector<base::Issue> findings;  // what was repaired or left out
};

}  // namespace posepack::animal
