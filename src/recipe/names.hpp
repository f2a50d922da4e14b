// SPDX-License-Identifier: MIT
// The words that catalogs, manifests and the command line use for the choices of catalog.hpp.
#pragma once

#include <span>
#include <string_view>

#include "recipe/catalog.hpp"

namespace posepack::recipe {

// Every name of an enumeration, in the order of its values.
template <class Choice>
std::span<const std::string_view> all_names();

}  // namespace posepack::recipe
