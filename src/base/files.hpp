// SPDX-License-Identifier: MIT
// Files: whole reads, writes that appear whole or not at all, and the lock of an output folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace posepack::base {

using Bytes = std::vector<std::uint8_t>;

// Reads a regular file of at most `limit_bytes`. Errors: E-IO-OPEN, E-IO-READ, E-LIM-FILE.
Result<Bytes> read_file(const std::filesystem::path& path, std::uint64_t limit_bytes);

// The file `relative` below `root`, refused with E-CAT-PATH when a symbolic link leads out of `root`.
Result<std::filesystem::path> resolve_below(const std::filesystem::path& root, std::string_view relative);

// Folder that several files are published into together. Locks the folder, writes each file to a temporary
// name beside its final one, and renames all of them on publish(); what was not published is removed.
// Temporary files of dead runs are removed once the lock is held.
class OutputFolder {
 public:
    // Makes the folder when it is missing. Waits at most `lock_timeout_s` for another run.
    // Errors: E-IO-WRITE, E-IO-LOCKED, E-INTERRUPTED.
    static Result<OutputFolder> open(const std::filesystem::path& folder, double lock_timeout_s,
                                     bool sync_to_disk);

    OutputFolder(OutputFolder&& other) noexcept;
    OutputFolder& operator=(OutputFolder&&) = delete;
    ~OutputFolder();

    // Writes `bytes` under a temporary name. May be called from several threads.
    // Errors: E-IO-WRITE, E-IO-SPACE.
    Status stage(const std::string& name, std::span<const std::uint8_t> bytes);

    // Renames every staged file to its name, in the order of names, then `last` (the commit point). Before
    // the first rename every name is looked at: one that a folder or device holds changes nothing. Each name
    // holds a whole old or a whole new file at any instant; a crash between two renames leaves new files
    // under the old `last`. Errors: E-IO-WRITE, E-INTERRUPTED (before the first rename).
    Status publish(const std::string& last);

 private:
    struct State;
    explicit OutputFolder(State* state) : state_(state) {}
    State* state_;
};

// Writes one file so that its name holds the whole old or the whole new content at any instant.
// Errors: E-IO-WRITE, E-IO-SPACE.
Status write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace posepack::base
