// SPDX-License-Identifier: MIT
#include "base/json.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/text.hpp"

namespace posepack::base {
namespace {

using namespace std::string_literals;

struct Row {
    std::string text;
    JsonFault fault;
    std::size_t offset;
};

void expect_rows(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        const JsonCheck check = check_json(row.text);
        EXPECT_EQ(check.fault, row.fault) << printable(row.text) << ": " << check.detail;
        EXPECT_EQ(check.offset, row.offset) << printable(row.text) << ": " << check.detail;
        EXPECT_EQ(check.detail.empty(), row.fault == JsonFault::none) << printable(row.text);
    }
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += text;
    return out;
}

TEST(CheckJson, AcceptsEveryKindOfValue) {
    for (const std::string text :
         {"{}", "[]", "null", "true", "false", "0", "-0", "1e5", "-1.5E-3", "\"\"", " \t\r\n[ 1 , 2 ]\n",
          R"({"a":{"a":[{"a":1},{"a":2}]},"b":[]})", R"("\" \\ \/ \b \f \n \r \t \u00e4 \ud83d\ude00")",
          "\"\xC3\xA4 \xF0\x9F\x98\x80 \xED\x9F\xBF\"", "1e-999", "1.7976931348623157e308",
          "123456789012345678901234567890"}) {
        const JsonCheck check = check_json(text);
        EXPECT_EQ(check.fault, JsonFault::none) << text << ": " << check.detail;
    }
}

TEST(CheckJson, NamesAByteOrderMark) {
    EXPECT_NE(check_json("\xEF\xBB\xBF{}").detail.find("byte-order mark"), std::string::npos);
    EXPECT_EQ(check_json("\xEF{}").detail.find("byte-order mark"), std::string::npos);
}

TEST(CheckJson, RefusesWhatIsNoJson) {
    expect_rows({
        {"", JsonFault::syntax, 0},
        {"  ", JsonFault::syntax, 2},
        {"\xEF\xBB\xBF{}", JsonFault::syntax, 0},  // a byte-order mark
        {"{} {}", JsonFault::syntax, 3},
        {"{}\0"s, JsonFault::syntax, 2},
        {"{}\0junk"s, JsonFault::syntax, 2},
        {"[1,]", JsonFault::syntax, 3},
        {"[1 2]", JsonFault::syntax, 3},
        {"[1", JsonFault::syntax, 2},
        {"{\"a\" 1}", JsonFault::syntax, 5},
        {"{\"a\":1,}", JsonFault::syntax, 7},
        {"{a:1}", JsonFault::syntax, 1},
        {"{'a':1}", JsonFault::syntax, 1},
        {"{\"a\":1", JsonFault::syntax, 6},
        {"[1] // remark", JsonFault::syntax, 4},
        {"/* remark */ 1", JsonFault::syntax, 0},
        {"]", JsonFault::syntax, 0},
        {"[}", JsonFault::syntax, 1},
    });
}

TEST(CheckJson, RefusesNumbersAndLiteralsOutsideTheGrammar) {
    for (const std::string text : {"NaN", "Infinity", "-Infinity", "nan", "inf", "nul", "True", "01", "-",
                                   "+1", ".5", "1.", "1e", "1e+", "0x10", "1_000", "1,5", "--1"}) {
        EXPECT_EQ(check_json(text).fault, JsonFault::syntax) << text;
    }
}

TEST(CheckJson, RefusesBrokenStrings) {
    expect_rows({
        {"\"abc", JsonFault::syntax, 4},
        {"\"a\nb\"", JsonFault::syntax, 2},
        {"\"a\x01\"", JsonFault::syntax, 2},
        {"\"a\0b\""s, JsonFault::syntax, 2},
        {R"("\x41")", JsonFault::syntax, 1},
        {R"("\u12g4")", JsonFault::syntax, 1},
        {R"("\ud83d")", JsonFault::syntax, 1},
        {R"("\ud83d\u0041")", JsonFault::syntax, 1},
        {R"("\ude00")", JsonFault::syntax, 0},
        {R"({"\ude00":1})", JsonFault::syntax, 1},
    });
}

TEST(CheckJson, RefusesMalformedUtf8) {
    expect_rows({
        {"\"ab\xFF\"", JsonFault::utf8, 3},
        {"\"\xC3\"", JsonFault::utf8, 1},
        {"\"\xC0\x80\"", JsonFault::utf8, 1},          // overlong
        {"\"\xED\xA0\x80\"", JsonFault::utf8, 1},      // surrogate
        {"\"\xF4\x90\x80\x80\"", JsonFault::utf8, 1},  // above U+10FFFF
        {"\"0123456789\xC3\xA4\x80\"", JsonFault::utf8, 13},
        {"{}\xE2\x82", JsonFault::utf8, 2},
    });
}

TEST(CheckJson, RefusesNumbersThatNoDoubleHolds) {
    expect_rows({
        {"1e999", JsonFault::number_range, 0},
        {"[0, -1e309]", JsonFault::number_range, 4},
        {"[1.8e308]", JsonFault::number_range, 1},
        {repeated("1", 400), JsonFault::number_range, 0},
    });
}

TEST(CheckJson, FindsRepeatedKeysHoweverTheyAreEscaped) {
    expect_rows({
        {R"({"a":1,"a":2})", JsonFault::duplicate_key, 7},
        {R"({"a":1,"\u0061":2})", JsonFault::duplicate_key, 7},
        {R"({"\/":1,"/":2})", JsonFault::duplicate_key, 8},
        {R"({"":1,"":2})", JsonFault::duplicate_key, 6},
        {"{\"\xC3\xA4\":1,\"\\u00e4\":2}", JsonFault::duplicate_key, 8},
        {R"({"a":{"b":1,"c":{"b":1},"b":2}})", JsonFault::duplicate_key, 24},
        {R"({"a\u0000b":1,"a\u0000c":2})", JsonFault::none, 0},
        {R"({"a":1,"A":2,"a ":3,"b":{"a":1},"c":[{"a":1}]})", JsonFault::none, 0},
    });
}

TEST(CheckJson, FindsTheFirstRepeatedKeyOfALargeObject) {
    std::string text = "{";
    for (int i = 0; i < 20'000; ++i) text.append("\"key").append(std::to_string(i)).append("\":0,");
    EXPECT_EQ(check_json(text + "\"last\":0}").fault, JsonFault::none);
    const JsonCheck check = check_json(text + "\"key77\":0,\"key3\":0}");
    EXPECT_EQ(check.fault, JsonFault::duplicate_key);
    EXPECT_EQ(check.offset, text.size());
    EXPECT_NE(check.detail.find("'key77'"), std::string::npos);
}

TEST(CheckJson, FindsARepeatWhereverTheObjectGrowsOverItsSmallSize) {
    for (int count = 1; count < 40; ++count) {
        for (int repeat = 0; repeat < count; ++repeat) {
            std::string text = "{";
            for (int i = 0; i < count; ++i) text.append("\"").append(std::to_string(i)).append("\":0,");
            text.append("\"").append(std::to_string(repeat)).append("\":0}");
            EXPECT_EQ(check_json(text).fault, JsonFault::duplicate_key) << text;
        }
    }
}

TEST(CheckJson, HoldsTheDepthLimit) {
    EXPECT_EQ(check_json(repeated("[", 64) + repeated("]", 64)).fault, JsonFault::none);
    EXPECT_EQ(check_json(repeated("{\"a\":", 63) + "{}" + repeated("}", 63)).fault, JsonFault::none);
    expect_rows({
        {repeated("[", 65) + repeated("]", 65), JsonFault::too_deep, 64},
        {repeated("{\"a\":", 65) + "0" + repeated("}", 65), JsonFault::too_deep, 64 * 5},
        {repeated("[", 200'000), JsonFault::too_deep, 64},
        {repeated("[{\"a\":", 200'000), JsonFault::too_deep, 32 * 6},
    });
    // Depth is what is open at once, not what was opened.
    EXPECT_EQ(check_json("[" + repeated("[[]],", 1000) + "0]").fault, JsonFault::none);
}

TEST(CheckJson, RefusesEveryTruncation) {
    const std::string text =
        R"({"asset":{"version":"2.0"},"nodes":[{"name":"\u00e4","translation":[0,-1.5e1,2]}]})";
    ASSERT_EQ(check_json(text).fault, JsonFault::none);
    for (std::size_t size = 0; size < text.size(); ++size) {
        EXPECT_NE(check_json(text.substr(0, size)).fault, JsonFault::none) << size;
    }
}

TEST(CheckJson, SaysWhatWasExpectedAndFound) {
    EXPECT_EQ(check_json("[1 2]").detail, "expected ',' or ']' in the array, found '2'");
    EXPECT_EQ(check_json("[1").detail, "expected ',' or ']' in the array, found the end of the text");
    EXPECT_EQ(check_json("\"\xFF\"").detail, "expected well-formed UTF-8, found byte 0xFF");
}

}  // namespace
}  // namespace posepack::base
