// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace posepack::base {
namespace {

TEST(IsUtf8, FollowsRfc3629) {
    for (const char* good : {"", "a", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF",
                             "\xEE\x80\x80", "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
        EXPECT_TRUE(is_utf8(good)) << printable(good);
    }
    for (const char* bad : {"\x80", "\xC0\x80", "\xC1\xBF", "\xC2",
                            "\xC2"
                            "a",
                            "\xE0\x9F\xBF", "\xE0\xA0", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                            "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
        EXPECT_FALSE(is_utf8(bad)) << printable(bad);
        EXPECT_FALSE(is_utf8(std::string("a").append(bad))) << printable(bad);
    }
}

TEST(Printable, EscapesControlsAndMalformedBytes) {
    EXPECT_EQ(printable("deer.glb"), "deer.glb");
    EXPECT_EQ(printable("a\nb\x1B[31m\x7F"), "a\\x0ab\\x1b[31m\\x7f");
    EXPECT_EQ(printable("\xC3\xA4\xFF"), "\xC3\xA4\\xff");
    EXPECT_EQ(printable("\xC2\x9B"), "\\xc2\\x9b") << "a C1 control: it starts an escape sequence";
    const std::string cut = printable(std::string(5000, 'a'));
    EXPECT_LT(cut.size(), 1100u);
    EXPECT_TRUE(cut.ends_with("..."));
}

TEST(Shortened, CutsAtACharacter) {
    EXPECT_EQ(shortened("abc", 3), "abc");
    EXPECT_EQ(shortened("abcd", 3), "abc...");
    EXPECT_EQ(shortened("a\xC3\xA4z", 2), "a...");
    EXPECT_EQ(shortened("", 0), "");
}

TEST(Lowered, ChangesAsciiOnly) {
    EXPECT_EQ(lowered("ABCxyz\xC3\x84[@`{0"), "abcxyz\xC3\x84[@`{0");
}

TEST(MatchesPattern, KnowsStarsAndQuestionMarks) {
    struct Row {
        const char* text;
        const char* pattern;
        bool matches;
    };
    for (const Row& row : {Row{"walk", "walk", true},
                           {"walk", "Walk", false},
                           {"walk", "*", true},
                           {"", "*", true},
                           {"", "", true},
                           {"", "?", false},
                           {"walk", "w?lk", true},
                           {"walk", "w*", true},
                           {"walk", "*k", true},
                           {"walk", "*a*", true},
                           {"walk", "walk*", true},
                           {"walk", "wal", false},
                           {"walk", "walks", false},
                           {"aab", "*ab", true},
                           {"abcabd", "*ab?", true},
                           {"abcabd", "a*c*c", false},
                           {"walk", "**k**", true}}) {
        EXPECT_EQ(matches_pattern(row.text, row.pattern), row.matches) << row.text << " " << row.pattern;
    }
}

TEST(MatchesPattern, StaysFastOnManyStars) {
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "a*";
    EXPECT_FALSE(matches_pattern(std::string(2000, 'a').append("b"), pattern.append("c")));
}

TEST(Nearest, FindsCloseWordsOnly) {
    const std::vector<std::string> words{"clips", "model", "output", "rate_hz"};
    EXPECT_EQ(nearest("clip", words), "clips");
    EXPECT_EQ(nearest("rate-hz", words), "rate_hz");
    EXPECT_EQ(nearest("metres", words), "");
    EXPECT_EQ(nearest("clip", {}), "");
}

TEST(Shortest, PrintsWhatReadsBack) {
    EXPECT_EQ(shortest(0.1f), "0.1");
    EXPECT_EQ(shortest(30.0f), "30");
    EXPECT_EQ(shortest(-0.0f), "-0");
    EXPECT_EQ(widened(0.1f), 0.1);
    EXPECT_EQ(widened(23.976f), 23.976);
}

TEST(Widened, ReadsBackAsTheSameFloat) {
    std::mt19937 random(20260101);
    int tested = 0;
    for (int i = 0; i < 200'000; ++i) {
        const std::uint32_t bits = random();
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        ++tested;
        ASSERT_EQ(static_cast<float>(widened(value)), value) << "bits " << bits;
    }
    EXPECT_GT(tested, 190'000);
    EXPECT_EQ(static_cast<float>(widened(std::numeric_limits<float>::max())),
              std::numeric_limits<float>::max());
    EXPECT_EQ(static_cast<float>(widened(std::numeric_limits<float>::denorm_min())),
              std::numeric_limits<float>::denorm_min());
}

TEST(Grouped, SetsCommasEveryThreeDigits) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(18446744073709551615ull), "18,446,744,073,709,551,615");
}

TEST(Counted, AgreesWithItsNumber) {
    EXPECT_EQ(counted(0, "animal"), "0 animals");
    EXPECT_EQ(counted(1, "animal"), "1 animal");
    EXPECT_EQ(counted(2'500, "vertex", "vertices"), "2,500 vertices");
    EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
}

}  // namespace
}  // namespace posepack::base
