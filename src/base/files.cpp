// SPDX-License-Identifier: MIT
// POSIX: openat and renameat keep to the folder that was opened, whatever its path comes to mean.
#include "base/files.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <map>
#include <mutex>
#include <random>
#include <system_error>
#include <thread>
#include <utility>

#include "base/interrupt.hpp"
#include "base/text.hpp"

namespace posepack::base {
namespace {

namespace fs = std::filesystem;

constexpr char kLockName[] = ".posepack.lock";
constexpr std::string_view kTemporaryPrefix = ".posepack-tmp-";
constexpr std::size_t kMaxIoBytes = std::size_t{1} << 30;  // Linux transfers no more than 2 GiB at once

// An open file, closed when it goes.
class Descriptor {
 public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    int get() const { return fd_; }
    bool is_open() const { return fd_ >= 0; }
    // Closes now; false when the system reports a late write error (network file systems do).
    bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
    int fd_;
};

std::string error_text(int error) {
    return std::generic_category().message(error);
}

Issue write_issue(const fs::path& path, std::string_view expected, int error) {
    const bool is_full = error == ENOSPC || error == EDQUOT;
    return {is_full ? IssueCode::io_space : IssueCode::io_write, path.string(),
            fmt::format("expected {}, found: {}", expected, error_text(error))};
}

// Reads to the end of the file, but at most `limit` + 1 bytes. Returns errno, or 0.
int read_all(int fd, std::uint64_t expected_bytes, std::uint64_t limit, Bytes* bytes) {
    std::size_t used = 0;
    bytes->resize(static_cast<std::size_t>(std::min(expected_bytes, limit)) + 1);
    for (;;) {
        const ssize_t got = ::read(fd, bytes->data() + used, std::min(bytes->size() - used, kMaxIoBytes));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno;
        used += static_cast<std::size_t>(got);
        if (got == 0 || used > limit) break;
        // The file has grown since its size was asked for.
        if (used == bytes->size()) bytes->resize(std::min<std::uint64_t>(2 * used, limit + 1));
    }
    bytes->resize(used);
    return 0;
}

// Writes all of `bytes`. Returns errno, or 0.
int write_all(int fd, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(fd, bytes.data(), std::min(bytes.size(), kMaxIoBytes));
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return 0;
}

std::string temporary_name() {
    thread_local std::random_device random;
    return fmt::format("{}{}-{:08x}{:08x}", kTemporaryPrefix, ::getpid(), random(), random());
}

// Creates a file of a new temporary name in `folder`. On failure the descriptor is closed and errno says why.
Descriptor create_temporary(int folder, std::string* name) {
    for (;;) {
        *name = temporary_name();
        Descriptor file(::openat(folder, name->c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (file.is_open() || (errno != EEXIST && errno != EINTR)) return file;
    }
}

// Fills a created temporary file and closes it. Returns errno, or 0.
int fill(Descriptor* file, std::span<const std::uint8_t> bytes, bool sync_to_disk) {
    if (const int error = write_all(file->get(), bytes); error != 0) return error;
    if (sync_to_disk && ::fsync(file->get()) != 0) return errno;
    return 0;
}

// Whether no process works on the temporary file any more: write_file() holds a lock on its own, and those
// of an OutputFolder lie under the folder's lock, which the caller holds.
bool is_stale(int folder, const char* name) {
    const Descriptor file(::openat(folder, name, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}

void remove_stale_temporaries(int folder) {
    const int copy = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* list = copy >= 0 ? ::fdopendir(copy) : nullptr;
    if (list == nullptr) {
        if (copy >= 0) ::close(copy);
        return;
    }
    std::vector<std::string> names;
    while (const dirent* entry = ::readdir(list)) {
        if (std::string_view(entry->d_name).starts_with(kTemporaryPrefix)) names.emplace_back(entry->d_name);
    }
    ::closedir(list);
    for (const std::string& name : names) {
        if (is_stale(folder, name.c_str())) ::unlinkat(folder, name.c_str(), 0);
    }
}

// Makes the folder where it is missing, and opens it.
Result<Descriptor> open_folder(const fs::path& folder) {
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (fs::exists(status) && !fs::is_directory(status)) {
        return Issue{IssueCode::io_write, folder.string(), "expected a folder, found a file of that name"};
    }
    fs::create_directories(folder, error);
    if (error) return write_issue(folder, "a folder that can be made", error.value());
    Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!opened.is_open()) return write_issue(folder, "a folder that can be opened", errno);
    return opened;
}

// Creates a file in the folder and removes it: a folder that cannot be written to is found before any work.
Status probe(int folder, const fs::path& path) {
    std::string name;
    const Descriptor file = create_temporary(folder, &name);
    if (!file.is_open()) return write_issue(path, "a writable folder", errno);
    ::unlinkat(folder, name.c_str(), 0);
    return {};
}

Result<Descriptor> lock_folder(int folder, const fs::path& path, double timeout_s) {
    using Clock = std::chrono::steady_clock;
    Descriptor lock(::openat(folder, kLockName, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!lock.is_open()) return write_issue(path, "a writable folder", errno);
    const Clock::time_point start = Clock::now();
    while (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
        const int error = errno;
        if (Status status = check_interrupt(); !status) return status.issue();
        if (error == EINTR) continue;
        if (error != EWOULDBLOCK) return write_issue(path / kLockName, "a file that can be locked", error);
        const double waited_s = std::chrono::duration<double>(Clock::now() - start).count();
        if (!(waited_s < timeout_s)) {
            return Issue{IssueCode::io_locked, path.string(),
                         fmt::format("expected the folder to be free within {} s, found another run in it",
                                     shortest(static_cast<float>(std::max(timeout_s, 0.0))))};
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return lock;
}

// Where write_file() really writes: behind symbolic links, so that it replaces the file and not the link.
Result<fs::path> write_target(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) return path;
    if (!fs::is_regular_file(status)) {
        return Issue{IssueCode::io_write, path.string(),
                     "expected a regular file or nothing of that name, found a folder or device"};
    }
    fs::path target = fs::canonical(path, error);
    if (error) return write_issue(path, "a path that can be followed", error.value());
    return target;
}

}  // namespace

Result<Bytes> read_file(const fs::path& path, std::uint64_t limit_bytes) {
    // Without O_NONBLOCK, opening a pipe would wait for a writer.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.is_open()) {
        return Issue{IssueCode::io_open, path.string(),
                     fmt::format("expected a readable file, found: {}", error_text(errno))};
    }
    struct stat status {};
    if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
        return Issue{IssueCode::io_open, path.string(), "expected a regular file, found a folder or device"};
    }
    const auto size_bytes = static_cast<std::uint64_t>(status.st_size);
    Bytes bytes;
    const int error = size_bytes > limit_bytes ? 0 : read_all(file.get(), size_bytes, limit_bytes, &bytes);
    if (error != 0) {
        return Issue{IssueCode::io_read, path.string(),
                     fmt::format("expected {} bytes, found: {}", grouped(size_bytes), error_text(error))};
    }
    if (std::max<std::uint64_t>(size_bytes, bytes.size()) > limit_bytes) {
        return Issue{IssueCode::lim_file, path.string(),
                     fmt::format("expected at most {} bytes, found {}", grouped(limit_bytes),
                                 grouped(std::max<std::uint64_t>(size_bytes, bytes.size())))};
    }
    return bytes;
}

Result<fs::path> resolve_below(const fs::path& root, std::string_view relative) {
    const std::string name(relative);
    std::error_code error;
    const fs::path base = fs::canonical(root, error);
    if (error) {
        return Issue{IssueCode::io_open, root.string(),
                     fmt::format("expected a folder, found: {}", error.message())};
    }
    const fs::path path = fs::weakly_canonical(base / name, error);
    if (error) {
        return Issue{IssueCode::io_open, name, fmt::format("expected a file, found: {}", error.message())};
    }
    const auto [root_end, rest] = std::mismatch(base.begin(), base.end(), path.begin(), path.end());
    if (root_end != base.end() || fs::path(name).is_absolute()) {
        return Issue{IssueCode::cat_path, name,
                     fmt::format("expected a path inside {}, found one that leads out of it", root.string())};
    }
    if (!fs::exists(path, error)) {
        return Issue{IssueCode::io_open, name,
                     fmt::format("expected a file in {}, found none", root.string())};
    }
    return path;
}

struct OutputFolder::State {
    fs::path path;
    Descriptor folder;
    Descriptor lock;
    bool sync_to_disk = false;
    std::mutex mutex;
    std::map<std::string, std::string> staged;  // final name -> temporary name

    // Gives the staged file its final name. Returns errno, or 0.
    int rename(std::map<std::string, std::string>::iterator file) {
        if (::renameat(folder.get(), file->second.c_str(), folder.get(), file->first.c_str()) != 0) {
            return errno;
        }
        staged.erase(file);
        return 0;
    }

    // Whether rename() can give the staged file its name: it replaces files and links, never a folder, and
    // should not replace a device or pipe. What a name came to mean since is found by rename().
    Status check_replaceable(const std::string& name) const {
        struct stat status {};
        if (::fstatat(folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
            return errno == ENOENT ? Status()
                                   : write_issue(path / name, "a name that can be replaced", errno);
        }
        if (S_ISREG(status.st_mode) || S_ISLNK(status.st_mode)) return {};
        return Issue{IssueCode::io_write, (path / name).string(),
                     fmt::format("expected a regular file or nothing of that name, found a {}",
                                 S_ISDIR(status.st_mode) ? "folder" : "device or pipe")};
    }

    Status sync() const {
        if (!sync_to_disk || ::fsync(folder.get()) == 0) return {};
        return write_issue(path, "a folder whose entries can be written to disk", errno);
    }
};

Result<OutputFolder> OutputFolder::open(const fs::path& folder, double lock_timeout_s, bool sync_to_disk) {
    Result<Descriptor> opened = open_folder(folder);
    if (!opened) return opened.issue();
    const int fd = opened.value().get();
    Result<Descriptor> lock = lock_folder(fd, folder, lock_timeout_s);
    if (!lock) return lock.issue();
    remove_stale_temporaries(fd);
    if (const Status writable = probe(fd, folder); !writable) return writable.issue();
    auto* state = new State;
    state->path = folder;
    state->folder = std::move(opened).value();
    state->lock = std::move(lock).value();
    state->sync_to_disk = sync_to_disk;
    return OutputFolder(state);
}

OutputFolder::OutputFolder(OutputFolder&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}

OutputFolder::~OutputFolder() {
    if (state_ == nullptr) return;
    for (const auto& [name, temporary] : state_->staged) {
        ::unlinkat(state_->folder.get(), temporary.c_str(), 0);
    }
    delete state_;
}

Status OutputFolder::stage(const std::string& name, std::span<const std::uint8_t> bytes) {
    if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos) {
        return Issue{IssueCode::io_write, name, "expected a plain file name, found a path"};
    }
    std::string temporary;
    Descriptor file = create_temporary(state_->folder.get(), &temporary);
    if (!file.is_open()) return write_issue(state_->path / name, "a writable folder", errno);
    int error = fill(&file, bytes, state_->sync_to_disk);
    if (!file.close() && error == 0) error = errno;
    if (error != 0) {
        ::unlinkat(state_->folder.get(), temporary.c_str(), 0);
        return write_issue(state_->path / name, fmt::format("room for {} bytes", grouped(bytes.size())),
                           error);
    }
    const std::lock_guard guard(state_->mutex);
    std::string& entry = state_->staged[name];
    if (!entry.empty()) ::unlinkat(state_->folder.get(), entry.c_str(), 0);
    entry = std::move(temporary);
    return {};
}

Status OutputFolder::publish(const std::string& last) {
    const std::lock_guard guard(state_->mutex);
    const auto fail = [&](const std::string& name, int error) {
        return write_issue(state_->path / name, "a name that can be replaced", error);
    };
    if (!state_->staged.contains(last)) return fail(last, ENOENT);
    for (const auto& [name, temporary] : state_->staged)
        if (Status status = state_->check_replaceable(name); !status) return status;
    if (Status status = check_interrupt(); !status) return status;  // from here on it is all or nothing
    for (auto file = state_->staged.begin(); file != state_->staged.end();) {
        const auto current = file++;
        if (current->first == last) continue;
        const std::string name = current->first;
        if (const int error = state_->rename(current); error != 0) return fail(name, error);
    }
    if (Status synced = state_->sync(); !synced) return synced;
    if (const int error = state_->rename(state_->staged.find(last)); error != 0) return fail(last, error);
    return state_->sync();
}

Status write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const Result<fs::path> target = write_target(path);
    if (!target) return target.issue();
    const fs::path parent = target.value().has_parent_path() ? target.value().parent_path() : fs::path(".");
    const Descriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.is_open()) return write_issue(path, "a folder that exists", errno);
    std::string temporary;
    const std::string name = target.value().filename();
    Descriptor file = create_temporary(folder.get(), &temporary);
    if (!file.is_open()) return write_issue(path, "a writable folder", errno);
    ::flock(file.get(), LOCK_EX);  // tells remove_stale_temporaries() that somebody is at work
    int error = fill(&file, bytes, true);
    if (error == 0 && ::renameat(folder.get(), temporary.c_str(), folder.get(), name.c_str()) != 0)
        error = errno;
    if (error != 0) {
        ::unlinkat(folder.get(), temporary.c_str(), 0);
        return write_issue(path, fmt::format("room for {} bytes", grouped(bytes.size())), error);
    }
    if (::fsync(folder.get()) != 0) return write_issue(path, "a folder that can be written to disk", errno);
    return {};
}

}  // namespace posepack::base
