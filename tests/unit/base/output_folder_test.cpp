// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "scratch_folder.hpp"

namespace posepack::base {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

Bytes bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

OutputFolder opened(const fs::path& folder) {
    Result<OutputFolder> result = OutputFolder::open(folder, 0.0, false);
    if (!result) throw std::runtime_error(format_issue(result.issue()));
    return std::move(result).value();
}

TEST(OutputFolder, PublishesWholeFilesTogether) {
    const ScratchFolder scratch;
    const fs::path folder = scratch.path() / "made/on/demand";
    OutputFolder output = opened(folder);
    ASSERT_TRUE(output.stage("deer.posepack", bytes_of("deer")));
    ASSERT_TRUE(output.stage("manifest.json", bytes_of("{}")));
    EXPECT_FALSE(names_in(folder).contains("deer.posepack"));
    ASSERT_TRUE(output.publish("manifest.json"));
    EXPECT_EQ(names_in(folder), (Names{"deer.posepack", "manifest.json"}));
    EXPECT_EQ(read_text(folder / "deer.posepack"), "deer");
    EXPECT_EQ(read_text(folder / "manifest.json"), "{}");
}

TEST(OutputFolder, LooksAtEveryNameBeforeItRenamesOne) {
    const ScratchFolder scratch;
    write_text(scratch.path() / "a", "old");
    fs::create_directory(scratch.path() / "b");
    ASSERT_EQ(::mkfifo((scratch.path() / "pipe").c_str(), 0600), 0);
    for (const char* in_the_way : {"b", "pipe"}) {
        OutputFolder output = opened(scratch.path());
        for (const char* name : {"a", in_the_way, "z"}) ASSERT_TRUE(output.stage(name, bytes_of("new")));
        for (const char* last : {"z", in_the_way}) {
            const Status status = output.publish(last);
            ASSERT_FALSE(status);
            EXPECT_EQ(status.issue().code, IssueCode::io_write);
            EXPECT_NE(status.issue().where.find(in_the_way), std::string::npos);
            EXPECT_EQ(read_text(scratch.path() / "a"), "old");
        }
    }
    EXPECT_EQ(names_in(scratch.path()), (Names{"a", "b", "pipe"}));
}

TEST(OutputFolder, ReplacesALinkAndNotWhatItNames) {
    const ScratchFolder scratch;
    write_text(scratch.path() / "elsewhere", "old");
    fs::create_symlink("elsewhere", scratch.path() / "a");
    OutputFolder output = opened(scratch.path());
    ASSERT_TRUE(output.stage("a", bytes_of("new")));
    ASSERT_TRUE(output.publish("a"));
    EXPECT_EQ(read_text(scratch.path() / "elsewhere"), "old");
    EXPECT_EQ(read_text(scratch.path() / "a"), "new");
}

TEST(OutputFolder, AnInterruptComesBeforeTheFirstRename) {
    const ScratchFolder scratch;
    write_text(scratch.path() / "a", "old");
    {
        OutputFolder output = opened(scratch.path());
        ASSERT_TRUE(output.stage("a", bytes_of("new")));
        request_interrupt();
        const Status status = output.publish("a");
        clear_interrupt();
        ASSERT_FALSE(status);
        EXPECT_EQ(status.issue().code, IssueCode::interrupted);
    }
    EXPECT_EQ(read_text(scratch.path() / "a"), "old");
    EXPECT_EQ(names_in(scratch.path()), Names{"a"});
}

TEST(OutputFolder, SyncsToDiskWhenAsked) {
    const ScratchFolder scratch;
    Result<OutputFolder> output = OutputFolder::open(scratch.path(), 0.0, true);
    ASSERT_TRUE(output);
    ASSERT_TRUE(output.value().stage("a", bytes_of("a")));
    ASSERT_TRUE(output.value().publish("a"));
    EXPECT_EQ(read_text(scratch.path() / "a"), "a");
}

TEST(OutputFolder, LeavesNothingWhenAbandoned) {
    const ScratchFolder scratch;
    write_text(scratch.path() / "deer.posepack", "old");
    {
        OutputFolder output = opened(scratch.path());
        OutputFolder moved = std::move(output);
        ASSERT_TRUE(moved.stage("deer.posepack", bytes_of("new")));
        ASSERT_TRUE(moved.stage("fox.posepack", bytes_of("new")));
    }
    EXPECT_EQ(names_in(scratch.path()), Names{"deer.posepack"});
    EXPECT_EQ(read_text(scratch.path() / "deer.posepack"), "old");
}

TEST(OutputFolder, TakesTheLaterOfTwoStagedContents) {
    const ScratchFolder scratch;
    OutputFolder output = opened(scratch.path());
    ASSERT_TRUE(output.stage("a", bytes_of("first")));
    ASSERT_TRUE(output.stage("a", bytes_of("second")));
    ASSERT_TRUE(output.publish("a"));
    EXPECT_EQ(names_in(scratch.path()), Names{"a"});
    EXPECT_EQ(read_text(scratch.path() / "a"), "second");
}

TEST(OutputFolder, RemovesTemporaryFilesOfDeadRuns) {
    const ScratchFolder scratch;
    const pid_t child = ::fork();
    if (child == 0) {
        OutputFolder output = opened(scratch.path());
        const bool staged = static_cast<bool>(output.stage("deer.posepack", bytes_of("half a bake")));
        ::kill(::getpid(), SIGKILL);
        ::_exit(staged ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(names_in(scratch.path()).size(), 1u) << "the dead run left its temporary file";
    write_text(scratch.path() / "posepack-tmp-mine", "not ours");
    OutputFolder output = opened(scratch.path());
    EXPECT_EQ(names_in(scratch.path()), Names{"posepack-tmp-mine"});
}

TEST(OutputFolder, WaitsForTheLockUntilTheTimeout) {
    const ScratchFolder scratch;
    const OutputFolder holder = opened(scratch.path());
    const auto start = std::chrono::steady_clock::now();
    const Result<OutputFolder> second = OutputFolder::open(scratch.path(), 0.2, false);
    const double waited_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_FALSE(second);
    EXPECT_EQ(second.issue().code, IssueCode::io_locked);
    EXPECT_GE(waited_s, 0.2);
    EXPECT_LT(waited_s, 5.0);
}

TEST(OutputFolder, TakesTheLockWhenTheHolderGoes) {
    const ScratchFolder scratch;
    auto holder = std::make_unique<OutputFolder>(opened(scratch.path()));
    std::thread release([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        holder.reset();
    });
    const Result<OutputFolder> second = OutputFolder::open(scratch.path(), 30.0, false);
    release.join();
    EXPECT_TRUE(second);
}

TEST(OutputFolder, StagesFromSeveralThreads) {
    const ScratchFolder scratch;
    OutputFolder output = opened(scratch.path());
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread) {
        threads.emplace_back([&output, thread] {
            for (int i = 0; i < 25; ++i) {
                const std::string name = std::to_string(thread) + "-" + std::to_string(i);
                EXPECT_TRUE(output.stage(name, bytes_of(name)));
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    ASSERT_TRUE(output.publish("3-24"));
    const Names names = names_in(scratch.path());
    EXPECT_EQ(names.size(), 100u);
    for (const std::string& name : names) EXPECT_EQ(read_text(scratch.path() / name), name);
}

TEST(OutputFolder, RefusesAFileAsFolder) {
    const ScratchFolder scratch;
    write_text(scratch.path() / "file", "x");
    for (const fs::path& path : {scratch.path() / "file", scratch.path() / "file/below"}) {
        const Result<OutputFolder> output = OutputFolder::open(path, 0.0, false);
        ASSERT_FALSE(output);
        EXPECT_EQ(output.issue().code, IssueCode::io_write);
    }
    EXPECT_EQ(read_text(scratch.path() / "file"), "x");
}

TEST(OutputFolder, RefusesNamesThatArePaths) {
    const ScratchFolder scratch;
    OutputFolder output = opened(scratch.path());
    for (const char* name : {"", ".", "..", "../a", "a/b", "/a"}) {
        const Status status = output.stage(name, bytes_of("x"));
        ASSERT_FALSE(status) << name;
        EXPECT_EQ(status.issue().code, IssueCode::io_write);
    }
    EXPECT_EQ(names_in(scratch.path()), Names{});
}

TEST(OutputFolder, ChangesNothingWhenAPublishCannotSucceed) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "b/full");  // a folder that no file can replace
    write_text(scratch.path() / "c", "old");
    {
        OutputFolder output = opened(scratch.path());
        for (const char* name : {"a", "b", "c", "manifest.json"})
            ASSERT_TRUE(output.stage(name, bytes_of("new")));
        const Status status = output.publish("manifest.json");
        ASSERT_FALSE(status);
        EXPECT_EQ(status.issue().code, IssueCode::io_write);
    }
    EXPECT_EQ(names_in(scratch.path()), (Names{"b", "c"})) << "no new file, no temporary file";
    EXPECT_EQ(read_text(scratch.path() / "c"), "old");
}

// A small file system of its own, unmounted at the end. Needs the right to mount.
class SmallDisk {
 public:
    explicit SmallDisk(const fs::path& path) : path_(path) {
        fs::create_directories(path);
        is_mounted_ = ::mount("posepack-test", path.c_str(), "tmpfs", 0, "size=1m") == 0;
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk() {
        if (is_mounted_) ::umount2(path_.c_str(), MNT_DETACH);
    }
    bool is_mounted() const { return is_mounted_; }
    bool make_read_only() const {
        return ::mount("posepack-test", path_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=1m") == 0;
    }

 private:
    fs::path path_;
    bool is_mounted_ = false;
};

TEST(OutputFolder, KeepsOldFilesWhenTheDiskIsFull) {
    const ScratchFolder scratch;
    const fs::path folder = scratch.path() / "disk";
    const SmallDisk disk(folder);
    if (!disk.is_mounted()) GTEST_SKIP() << "a small tmpfs could not be mounted";
    write_text(folder / "deer.posepack", "old");
    {
        OutputFolder output = opened(folder);
        ASSERT_TRUE(output.stage("deer.posepack", Bytes(500'000)));
        const Status status = output.stage("fox.posepack", Bytes(900'000));
        ASSERT_FALSE(status);
        EXPECT_EQ(status.issue().code, IssueCode::io_space);
    }
    EXPECT_EQ(names_in(folder), Names{"deer.posepack"});
    EXPECT_EQ(read_text(folder / "deer.posepack"), "old");
    const Status status = write_file(folder / "report.json", Bytes(2'000'000));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.issue().code, IssueCode::io_space);
    EXPECT_EQ(names_in(folder), Names{"deer.posepack"});
}

TEST(OutputFolder, FindsAReadOnlyFolderAtOnce) {
    const ScratchFolder scratch;
    const fs::path folder = scratch.path() / "disk";
    if (::geteuid() == 0) {
        const SmallDisk disk(folder);
        if (!disk.is_mounted()) GTEST_SKIP() << "root can write to any folder, and no tmpfs could be mounted";
        ASSERT_TRUE(opened(folder).stage("a", bytes_of("a")));  // leaves a lock file, which is no proof
        ASSERT_TRUE(disk.make_read_only());
        const Result<OutputFolder> output = OutputFolder::open(folder, 0.0, false);
        ASSERT_FALSE(output);
        EXPECT_EQ(output.issue().code, IssueCode::io_write);
        return;
    }
    fs::create_directories(folder);
    ASSERT_TRUE(opened(folder).stage("a", bytes_of("a")));
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    const Result<OutputFolder> output = OutputFolder::open(folder, 0.0, false);
    fs::permissions(folder, fs::perms::owner_all);
    ASSERT_FALSE(output);
    EXPECT_EQ(output.issue().code, IssueCode::io_write);
}

}  // namespace
}  // namespace posepack::base
