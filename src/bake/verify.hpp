// SPDX-License-Identifier: MIT
// Checks of what was baked: a container alone, or a folder against its manifest.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.hpp"

namespace posepack::bake {

struct VerifyOutcome {
    std::uint32_t container_count = 0;  // containers looked at
    std::uint64_t byte_count = 0;
    std::vector<base::Issue> findings;  // errors and warnings, in the order of names
};

// `path` is a container or a folder with a manifest. Every rule of the format is checked by the loader; a
// folder's containers are compared with the manifest by digest and by every field they can answer
// (bake/check_record.hpp).
//   strict  a container that is not listed is an error, not a warning
// Errors: E-IO-*, E-MAN-JSON, E-MAN-VERSION, E-INTERRUPTED; what is wrong with containers is in the outcome.
base::Result<VerifyOutcome> verify(const std::filesystem::path& path, bool strict);

}  // namespace posepack::bake
