// SPDX-License-Identifier: MIT
#include "animal/names.hpp"

#include <gtest/gtest.h>

namespace posepack::animal {
namespace {

TEST(Names, TakesTheTextAfterTheLastBar) {
    EXPECT_EQ(after_last_bar("AnimalArmature|Walk"), "Walk");
    EXPECT_EQ(after_last_bar("A|B|C"), "C");
    EXPECT_EQ(after_last_bar("Walk"), "Walk");
    EXPECT_EQ(after_last_bar("Rig|"), "");
    EXPECT_EQ(after_last_bar(""), "");
}

TEST(Names, ClipNamesAreUniqueWithoutCase) {
    struct Row {
        std::vector<std::string> source, expected;
    };
    const Row rows[] = {
        {{"Rig|Walk", "Rig|Run"}, {"Walk", "Run"}},
        {{"A|Walk", "B|Walk", "walk"}, {"Walk", "Walk_2", "walk_3"}},
        {{"walk_2", "walk", "Walk"}, {"walk_2", "walk", "Walk_3"}},
        {{"walk", "walk", "walk_2"}, {"walk", "walk_2", "walk_2_2"}},
        {{"", "Rig|", "clip_0"}, {"clip_0", "clip_1", "clip_0_2"}},
        {{"a\nb",
          "a\x01"
          "b"},
         {"a_b", "a_b_2"}},
        {{"tab\there", "del\x7F", "next\xC2\x85line", "caf\xC3\xA9"},
         {"tab_here", "del_", "next_line", "caf\xC3\xA9"}},
        {{"\xC2\xA0space"}, {"\xC2\xA0space"}},
        {{}, {}},
    };
    for (const Row& row : rows) EXPECT_EQ(clip_names(row.source), row.expected);
}

TEST(Names, UsableNames) {
    EXPECT_EQ(usable_name("Hips", "node_3").value(), "Hips");
    EXPECT_EQ(usable_name("", "node_3").value(), "node_3");
    EXPECT_EQ(usable_name("a\rb", "node_3").value(), "a_b");
    EXPECT_EQ(usable_name(std::string(255, 'n'), "node_3").value().size(), 255u);
    const auto longer = usable_name(std::string(256, 'n'), "node_3");
    ASSERT_FALSE(longer);
    EXPECT_EQ(longer.issue().code, base::IssueCode::lim_string);
}

}  // namespace
}  // namespace posepack::animal
