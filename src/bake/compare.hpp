// SPDX-License-Identifier: MIT
// Texture memory of every form, animal by animal, at the rows that a bake would make.
#pragma once

#include <string>
#include <vector>

#include "bake/bake_catalog.hpp"

namespace posepack::bake {

struct CompareRow {
    std::string id;
    std::uint32_t bone_count = 0, row_count = 0, vertex_count = 0;
    recipe::VramRecord vram;
};

struct Comparison {
    std::vector<CompareRow> rows;  // sorted by id
    CompareRow total;              // id "total"; counts and bytes summed
};

// Reads and plans every animal of the catalog, `copies` instances of each in memory of their own.
// Errors: those of open_catalog, read_model and bake_animal.
base::Result<Comparison> compare_catalog(const CatalogSource& source, std::uint32_t copies);

}  // namespace posepack::bake
