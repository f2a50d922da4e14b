// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>
#include <string_view>

#include "scratch_folder.hpp"

namespace posepack::base {
namespace {

namespace fs = std::filesystem;

Bytes bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

template <class Outcome>
IssueCode code_of(const Outcome& outcome) {
    EXPECT_FALSE(outcome);
    return outcome ? IssueCode::usage : outcome.issue().code;
}

TEST(ReadFile, ReadsEveryByte) {
    const ScratchFolder scratch;
    write_text(scratch.path() / "a", std::string("\0\xFF\r\n", 4));
    write_text(scratch.path() / "empty", "");
    EXPECT_EQ(read_file(scratch.path() / "a", 4).value(), bytes_of(std::string("\0\xFF\r\n", 4)));
    EXPECT_TRUE(read_file(scratch.path() / "empty", 0).value().empty());
}

TEST(ReadFile, HoldsItsLimit) {
    const ScratchFolder scratch;
    write_text(scratch.path() / "a", "12345");
    EXPECT_EQ(read_file(scratch.path() / "a", 5).value().size(), 5u);
    EXPECT_EQ(code_of(read_file(scratch.path() / "a", 4)), IssueCode::lim_file);
}

TEST(ReadFile, RefusesWhatIsNoRegularFile) {
    const ScratchFolder scratch;
    ASSERT_EQ(::mkfifo((scratch.path() / "pipe").c_str(), 0600), 0);
    for (const fs::path& path : {scratch.path() / "missing", scratch.path() / "pipe", scratch.path(),
                                 fs::path("/dev/zero"), fs::path("")}) {
        EXPECT_EQ(code_of(read_file(path, 100)), IssueCode::io_open) << path;
    }
}

// Files of /proc say that they have no bytes, like a file that grows after it was opened.
TEST(ReadFile, ReadsBehindTheSizeThatTheSystemStated) {
    const Result<Bytes> status = read_file("/proc/self/status", 1 << 20);
    ASSERT_TRUE(status);
    EXPECT_GT(status.value().size(), 100u);
    EXPECT_EQ(code_of(read_file("/proc/self/status", 10)), IssueCode::lim_file);
}

TEST(ResolveBelow, FindsFilesInsideTheRoot) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "root/herd");
    write_text(scratch.path() / "root/herd/deer.glb", "x");
    fs::create_symlink("herd/deer.glb", scratch.path() / "root/link.glb");
    const Result<fs::path> plain = resolve_below(scratch.path() / "root", "herd/deer.glb");
    const Result<fs::path> linked = resolve_below(scratch.path() / "root", "link.glb");
    ASSERT_TRUE(plain);
    ASSERT_TRUE(linked);
    EXPECT_TRUE(fs::equivalent(plain.value(), linked.value()));
}

TEST(ResolveBelow, RefusesWhatLeadsOut) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "root");
    fs::create_directories(scratch.path() / "root2");
    write_text(scratch.path() / "root2/deer.glb", "x");
    fs::create_symlink("../root2/deer.glb", scratch.path() / "root/link.glb");
    fs::create_symlink("../root2", scratch.path() / "root/folder");
    const std::string absolute = (scratch.path() / "root2/deer.glb").string();
    for (const std::string& path : {std::string("link.glb"), std::string("folder/deer.glb"),
                                    std::string("../root2/deer.glb"), absolute}) {
        EXPECT_EQ(code_of(resolve_below(scratch.path() / "root", path)), IssueCode::cat_path) << path;
    }
}

TEST(ResolveBelow, RefusesMissingFilesAndLoopsOfLinks) {
    const ScratchFolder scratch;
    fs::create_symlink("loop", scratch.path() / "loop");
    for (const char* path : {"missing.glb", "no/such/folder.glb", "loop"}) {
        EXPECT_EQ(code_of(resolve_below(scratch.path(), path)), IssueCode::io_open) << path;
    }
    EXPECT_EQ(code_of(resolve_below(scratch.path() / "missing", "a")), IssueCode::io_open);
}

TEST(WriteFile, ReplacesTheWholeContent) {
    const ScratchFolder scratch;
    const fs::path path = scratch.path() / "report.json";
    ASSERT_TRUE(write_file(path, bytes_of("a long first text")));
    ASSERT_TRUE(write_file(path, bytes_of("short")));
    EXPECT_EQ(read_text(path), "short");
    EXPECT_EQ(names_in(scratch.path()), std::set<std::string>{"report.json"});
}

TEST(WriteFile, WritesBehindASymbolicLink) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "real");
    write_text(scratch.path() / "real/report.json", "old");
    fs::create_symlink("real/report.json", scratch.path() / "link.json");
    ASSERT_TRUE(write_file(scratch.path() / "link.json", bytes_of("new")));
    EXPECT_TRUE(fs::is_symlink(scratch.path() / "link.json"));
    EXPECT_EQ(read_text(scratch.path() / "real/report.json"), "new");
}

TEST(WriteFile, RefusesFoldersDevicesAndMissingFolders) {
    const ScratchFolder scratch;
    for (const fs::path& path :
         {scratch.path(), fs::path("/dev/null"), scratch.path() / "missing/report.json"}) {
        EXPECT_EQ(code_of(write_file(path, bytes_of("x"))), IssueCode::io_write) << path;
    }
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace posepack::base
