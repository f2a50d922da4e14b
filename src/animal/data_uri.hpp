// SPDX-License-Identifier: MIT
// Buffers inside the JSON: "data:application/octet-stream;base64,..." (RFC 2397).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "animal/decode_budget.hpp"
#include "base/result.hpp"

namespace posepack::animal {

// The bytes of a data URI of base64 (RFC 4648 section 4; padding may be missing), whatever its media type.
// Errors, with an empty `where`: E-GLB-URI for another coding or a letter that is none; E-LIM-DECODED.
base::Result<std::vector<std::uint8_t>> decode_data_uri(std::string_view uri, DecodeBudget& budget);

}  // namespace posepack::animal
