// SPDX-License-Identifier: MIT
// What must be known of a glTF before a parser that opens files or needs extensions may see it.
#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"

namespace posepack::animal {

// Checks, in one streaming pass over JSON that check_json accepted, that no buffer lies outside the GLB and
// that every required extension is one that posepack reads or that does not change geometry.
// Errors: E-GLB-URI, E-GLB-EXTENSION, E-GLB-JSON when the root is no object.
base::Status check_gltf_facts(std::string_view json);

}  // namespace posepack::animal
