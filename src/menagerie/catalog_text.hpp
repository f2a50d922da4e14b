// SPDX-License-Identifier: MIT
// The catalog that belongs to generated animals: their clips with states, speeds, wraps and seams.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "menagerie/model.hpp"

namespace posepack::menagerie {

// What a catalog says of one animal.
struct CatalogAnimal {
    std::string id;
    std::string file_name;
    std::string clips;  // rows of JSON, ready to be joined
};

CatalogAnimal catalog_animal(std::string id, const Model& model);

// A whole catalog of schema 1, as text with one clip a line. `schema_path` is where editors find its schema;
// empty leaves that out.
std::string catalog_text(const std::vector<CatalogAnimal>& animals, const std::string& schema_path);

}  // namespace posepack::menagerie
