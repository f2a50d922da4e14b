// SPDX-License-Identifier: MIT
#include "recipe/file_rules.hpp"

#include <gtest/gtest.h>

namespace posepack::recipe {
namespace {

TEST(IdFault, AcceptsFileNamesOfEverySystem) {
    for (const std::string id :
         {"a", "deer", "Deer_2-b", "_", "0", "com", "com0", "com10", "console", "nul_", "lpt"}) {
        EXPECT_EQ(id_fault(id), "") << id;
    }
    EXPECT_EQ(id_fault(std::string(kMaxIdBytes, 'a')), "");
}

TEST(IdFault, RefusesAllOthers) {
    for (const std::string id : {"", "-", "-a", "a b", "a.b", ".a", "a/b", "a\\b", "a:b", "\xC3\xA4", "a\n",
                                 "con", "Prn", "AUX", "nul", "COM1", "com9", "LPT1", "lpt9"}) {
        EXPECT_NE(id_fault(id), "") << id;
    }
    EXPECT_NE(id_fault(std::string(kMaxIdBytes + 1, 'a')), "");
    EXPECT_NE(id_fault(std::string("a\0b", 3)), "");
}

TEST(PathFault, AcceptsRelativePaths) {
    for (const std::string path : {"deer.glb", "herd/deer.glb", "a/b/c/d", "...a", "..a/b", "a..b",
                                   ".hidden/x", "my deer.glb", "d\xC3\xA4r.glb", "com/console.glb", "-x"}) {
        EXPECT_EQ(path_fault(path), "") << path;
    }
    EXPECT_EQ(path_fault(std::string(kMaxPathBytes, 'a')), "");
}

TEST(PathFault, RefusesAllOthers) {
    for (const std::string path :
         {"",     "/",     "/a",     "//srv/a", "a/",      "a//b",       ".",    "..",   "./a",
          "../a", "a/..",  "a/../b", "a/./b",   "a\\b",    "\\\\srv\\a", "C:/a", "c:a",  "a:stream",
          "a\tb", "a\x7F", "nul",    "NUL.glb", "a/con/b", "a/Com3.x.y", "a.",   "a /b", "a/b. "}) {
        EXPECT_NE(path_fault(path), "") << path;
    }
    EXPECT_NE(path_fault(std::string(kMaxPathBytes + 1, 'a')), "");
    EXPECT_NE(path_fault(std::string("a\0b", 3)), "");
}

}  // namespace
}  // namespace posepack::recipe
