// SPDX-License-Identifier: MIT
// Names that mean the same file on every system: rules for animal ids and model paths, from text alone.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace posepack::recipe {

inline constexpr std::size_t kMaxIdBytes = 64;
inline constexpr std::size_t kMaxPathBytes = 1024;

// Why `id` cannot be an animal id ("expected ..., found ..."); empty when it can. An id is 1 to 64 letters,
// digits, '_' and '-', begins with no '-', and is no device name of Windows (CON, NUL, COM1, ...).
std::string id_fault(std::string_view id);

// Why `path` cannot be a model path; empty when it can. A path is relative, has '/' between its parts, at
// most 1,024 bytes, no backslash, ':' or control character, and no part that is empty, ".", "..", a device
// name, or ends in a dot or a space, which Windows would drop.
std::string path_fault(std::string_view path);

}  // namespace posepack::recipe
