// SPDX-License-Identifier: MIT
// ModelSpec: a skinned, animated model in plain lists, and the GLB that says the same.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "support/glb_builder.hpp"

namespace posepack::support {

// One animated property. Values as in glTF: 3 numbers a key, 4 for rotations, three times as many for
// "CUBICSPLINE".
struct ChannelSpec {
    int node = 0;
    std::string path = "rotation";
    std::vector<float> times, values;
    std::string interpolation = "LINEAR";
};

struct ClipSpec {
    std::string name;
    std::vector<ChannelSpec> channels;
};

using Matrix16 = std::array<float, 16>;  // column by column

struct SkinSpec {
    std::vector<int> joints;
    std::vector<Matrix16> inverse_binds;  // empty: the skin has none
};

struct MeshSpec {
    std::string name;
    int skin = 0;
    std::vector<float> positions, normals;  // 3 a vertex; normals may be empty
    std::vector<std::uint16_t> joints;      // 4 a vertex
    std::vector<float> weights;             // 4 a vertex
};

struct ModelSpec {
    std::vector<Json> nodes;  // as in glTF; one more is added for each mesh
    std::vector<SkinSpec> skins;
    std::vector<MeshSpec> meshes;
    std::vector<ClipSpec> clips;
};

// The GLB of `spec`, still open for edits. Accessors come in the order positions, normals, joints, weights of
// each mesh; inverse binds of each skin; times and values of each channel.
GlbBuilder builder_of(const ModelSpec& spec);

// The same, closed.
Bytes glb_of(const ModelSpec& spec);

// The inverses of the rest-pose global transforms of `joints` (translation, rotation, scale or matrix).
std::vector<Matrix16> inverse_binds_of(const std::vector<Json>& nodes, const std::vector<int>& joints);

// A unit quaternion (x, y, z, w), rounded to float: `degrees` around an axis that need not be of unit length.
std::array<float, 4> turn(double degrees, double x, double y, double z);

// Quaternions one after the other, as a channel wants them.
std::vector<float> turns(const std::vector<std::array<float, 4>>& rotations);

// Times 0, 1 / rate, ... of `count` keys.
std::vector<float> grid(std::size_t count, double rate_hz, double first_s = 0.0);

}  // namespace posepack::support
