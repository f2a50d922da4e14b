// SPDX-License-Identifier: MIT
// The steps of read_animal, in the order they run. Each adds its part to the animal.
#pragma once

#include "animal/accessor.hpp"
#include "animal/animal.hpp"
#include "animal/read_animal.hpp"
#include "animal/weights.hpp"

namespace posepack::animal {

struct ReadContext {
    AccessorReader& accessors;
    const ReadOptions& options;
    Animal& animal;
    std::uint64_t neighbour_tests_left = kMaxNeighbourTests;

    const tinygltf::Model& model() const { return accessors.model(); }
    // Notes a repair, or refuses it under --strict with `refusal`.
    base::Status repair(base::IssueCode warning, base::IssueCode refusal, std::string where,
                        std::string detail);
    void note(base::IssueCode code, std::string where, std::string detail);
};

// Nodes, their parents and an order from parents to children.
// Errors: E-GLB-REFERENCE, E-GLB-NODE-LOOP, E-GLB-QUAT, E-GLB-IBM, E-LIM-COUNT, E-LIM-NODE-DEPTH.
base::Status read_nodes(ReadContext& context);

// Bones, joint map and meshes (without vertices) of every node that has a mesh and a skin, and of those that
// move a mesh rigidly. Errors: E-GLB-REFERENCE, E-GLB-SKIN-JOINT, E-GLB-IBM, E-GLB-IBM-COUNT,
// E-LIM-BONES.
base::Status read_skins(ReadContext& context);

// Vertices of every skinned mesh; names what is left out.
// Errors: E-GLB-REFERENCE, E-GLB-ACCESSOR-*, E-GLB-JOINT-INDEX, E-GLB-WEIGHTS.
base::Status read_meshes(ReadContext& context);

// Clips. Errors: E-GLB-CHANNEL, E-GLB-TIMES, E-GLB-QUAT, E-LIM-COUNT, E-LIM-DURATION.
base::Status read_clips(ReadContext& context);

}  // namespace posepack::animal
