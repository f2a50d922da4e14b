// SPDX-License-Identifier: MIT
// How a derived model relates to its base, row by row and vertex by vertex.
#pragma once

#include <string>
#include <vector>

#include "posed_model.hpp"

namespace posepack::derived {

struct Relation {
    glm::dmat4 transform{1.0};         // derived model space from that of the base
    std::uint32_t clip_copies = 1;     // how often it has the clips of the base, one set after another
    bool bits_equal = false;           // matrices, bone by bone
    bool pairs_bones_by_name = false;  // else by index
    bool undoes_bind = false;          // the derived model has no inverse binds: those of the base are added
    bool second_half_only = false;     // the first half of a clip may differ
};

struct Found {
    std::size_t clips = 0, rows = 0, vertices = 0;
    double largest = 0.0;  // distance of a vertex, fraction of the derived model's R
    std::vector<std::string> faults;
};

// Compares every row of every clip. The derived model has the base's clips in order, `clip_copies` times
// over; their rows and rates must be equal.
Found compare(const PosedModel& base, const PosedModel& derived, const Relation& relation);

}  // namespace posepack::derived
