// SPDX-License-Identifier: MIT
#include "cli/container_file.hpp"

#include <fmt/format.h>

namespace posepack::cli {

base::Result<ContainerFile> open_container(const std::filesystem::path& path) {
    auto bytes = base::read_file(path, POSEPACK_MAX_FILE_BYTES);
    if (!bytes) return bytes.issue();
    ContainerFile file{std::move(bytes).value(), {}};
    const posepack_result result = posepack_open(&file.view, file.bytes.data(), file.bytes.size());
    if (result == POSEPACK_OK) return file;
    return base::Issue{
        base::IssueCode::pack_invalid, path.filename().string(),
        fmt::format("expected a container of format {}.{}, found that the loader answers {}",
                    POSEPACK_FORMAT_MAJOR, POSEPACK_FORMAT_MINOR, posepack_result_name(result))};
}

}  // namespace posepack::cli
