// SPDX-License-Identifier: MIT
// A container read from disk and opened, for the commands that take one.
#pragma once

#include <filesystem>

#include "base/files.hpp"
#include "base/result.hpp"
#include "posepack/loader.h"

namespace posepack::cli {

struct ContainerFile {
    base::Bytes bytes;  // must outlive the view
    posepack_view view;
};

// Errors: E-IO-*, E-PACK-INVALID.
base::Result<ContainerFile> open_container(const std::filesystem::path& path);

}  // namespace posepack::cli
