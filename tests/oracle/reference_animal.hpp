// SPDX-License-Identifier: MIT
// ReferenceAnimal: an animated GLB as glTF 2.0 words it, read and posed in double precision.
//
// Written to be compared with the compiler, and therefore sharing no line with it: its own chunks,
// accessors, key search and interpolation (std::acos and std::sin), straight from the specification, slow and
// plain. Not read: sparse accessors, Draco, meshopt. Failures are std::runtime_error or nlohmann's
// exceptions.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace posepack::oracle {

// 3x4, row-major: position' = m[4 r .. 4 r + 2] . position + m[4 r + 3].
using Affine = std::array<double, 12>;
Affine operator*(const Affine& a, const Affine& b);

// A translation or scale (the fourth number is zero) or a rotation x y z w.
using Value = std::array<double, 4>;

// A channel of an animation: keys, and how to get from one to the next (glTF 2.0, appendix C).
struct ReferenceChannel {
    std::string interpolation;  // LINEAR, STEP or CUBICSPLINE
    std::vector<double> times_s;
    std::vector<double> values;  // three values a key where cubic: in-tangent, value, out-tangent
    std::size_t width = 3;       // components of a value; 4 are a rotation

    // The value at a glTF time; the first and the last hold outside the keys. Rotations have unit length.
    Value at(double time_s) const;
};

// An animation that moves nodes: its channels by node and path, and the glTF times of its first and last key.
struct ReferenceClip {
    std::string name;  // as in the file; `clip_<index>` where it has none
    std::map<std::pair<std::size_t, std::string>, ReferenceChannel> channels;
    double start_s = 0.0, end_s = 0.0;
};

struct Box {
    std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

// A skin: of every joint its node, its inverse bind matrix and the box, in bind space, of the vertices that
// it moves (any weight above zero), or of all vertices of the skin where it moves none.
struct ReferenceSkin {
    std::vector<std::size_t> nodes;
    std::vector<Affine> inverse_binds;
    std::vector<Box> boxes;
};

// A node that draws a mesh: the box of its vertices, in the space of the node.
struct ReferenceRigidMesh {
    std::size_t node;
    Box box;
};

class Glb;

class ReferenceAnimal {
 public:
    // Reads a GLB file.
    explicit ReferenceAnimal(const std::filesystem::path& path);

    // Global transforms of all nodes at a glTF time of a clip (glTF 2.0, section 3.5), node by node.
    std::vector<Affine> globals(const ReferenceClip& clip, double time_s) const;

    std::vector<ReferenceSkin> skins;
    std::vector<ReferenceRigidMesh> rigid_meshes;  // of nodes with a mesh and without a skin
    std::vector<ReferenceClip> clips;              // in the order of the file

 private:
    struct Node {
        std::size_t parent;
        bool has_matrix = false;
        Affine matrix{};
        Value translation{}, rotation{0, 0, 0, 1}, scale{1, 1, 1, 0};
    };

    void read_nodes(const Glb& glb);
    void read_skin(const Glb& glb, std::size_t index);
    void read_rigid_meshes(const Glb& glb);
    void read_clip(const Glb& glb, std::size_t index);
    Affine local(std::size_t node, const ReferenceClip& clip, double time_s) const;
    void resolve(std::size_t node, const ReferenceClip& clip, double time_s, std::vector<Affine>& out,
                 std::vector<bool>& done) const;

    std::vector<Node> nodes_;
};

}  // namespace posepack::oracle
