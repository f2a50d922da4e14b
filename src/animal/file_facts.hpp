// SPDX-License-Identifier: MIT
// FileFacts: what a GLB says of itself, also where no palette can be made of it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace posepack::animal {

struct SkinFacts {
    std::string name;  // as in the file; may be empty
    std::uint32_t joint_count = 0;
    std::uint32_t user_count = 0;  // nodes that draw a mesh with it
    bool has_inverse_binds = false;
};

// Channels of one glTF animation by what they move.
struct AnimationFacts {
    std::string name;                    // as in the file; may be empty
    std::uint32_t node_channels = 0;     // translation, rotation, scale
    std::uint32_t morph_channels = 0;    // weights of morph targets
    std::uint32_t pointer_channels = 0;  // aimed by KHR_animation_pointer, at anything
    std::uint32_t unknown_channels = 0;  // anything else, and channels without a target node
};

// Plain counts; nothing in it was checked beyond the schema of glTF. Names are the file's own, unescaped.
struct FileFacts {
    std::uint64_t file_bytes = 0;
    std::string generator, gltf_version;  // of the asset; may be empty
    std::vector<std::string> extensions_used, extensions_required;
    std::uint32_t scene_count = 0, node_count = 0, mesh_count = 0, primitive_count = 0;
    std::uint32_t image_count = 0, outside_image_count = 0;  // never opened
    std::uint32_t compressed_primitive_count = 0;            // Draco
    std::uint32_t quantised_primitive_count = 0;             // positions as integers
    std::uint32_t sparse_accessor_count = 0;
    std::uint32_t influence_set_count = 0;  // largest number of JOINTS_n of a primitive; 4 influences each
    std::uint64_t triangle_count = 0;       // of primitives that are lists of triangles
    std::uint32_t skinned_node_count = 0;   // nodes that draw a mesh with a skin
    std::vector<std::string> rigid_nodes;   // names of nodes that draw a mesh without a skin
    std::uint32_t morph_target_count = 0;
    std::vector<std::string> morphed_meshes;  // names of meshes with morph targets
    std::vector<SkinFacts> skins;
    std::vector<AnimationFacts> animations;
};

// Parses the GLB in `bytes` and counts. Errors: those of load_gltf (the shell, the JSON and its schema,
// required extensions); what read_animal refuses later is not looked at.
base::Result<FileFacts> read_file_facts(std::span<const std::uint8_t> bytes);

}  // namespace posepack::animal
