// SPDX-License-Identifier: MIT
// A container's tables as JSON, for inspect and for the attributes of exports.
#pragma once

#include <cstdint>
#include <string>

#include "posepack/loader.h"

namespace posepack::output {

// Header, clips, states, bones, meshes and sections of an open container: canonical JSON, keys sorted.
//   indent  spaces a level; below 0: one line
std::string container_json(const posepack_view& view, int indent);

// The parts of it, each one line: what an export carries as attributes.
std::string clips_json(const posepack_view& view);
std::string states_json(const posepack_view& view);
std::string bones_json(const posepack_view& view);
std::string space_json(const posepack_view& view);

// Joints of skins that have no bone because no vertex moves by them.
std::uint32_t joints_without_bone(const posepack_view& view);

// Names of the format's numbers: "affine", "rgba16f", "bone-major", "runs", "loop".
std::string encoding_name(std::uint32_t encoding);
std::string texel_format_name(std::uint32_t format);
std::string texel_order_name(std::uint32_t order);
std::string row_scheme_name(std::uint32_t row_scheme);
std::string wrap_name(std::uint32_t wrap);
std::string seam_name(std::uint32_t seam);

}  // namespace posepack::output
