// SPDX-License-Identifier: MIT
#include "output/text_table.hpp"

#include <gtest/gtest.h>

namespace posepack::output {
namespace {

TEST(TextTable, ColumnsLineUp) {
    const TextTable table{{{"animal", Align::left}, {"rows"}, {"note", Align::left}},
                          {{"goat", "496", "fine"}, {"a very long name", "7", ""}},
                          {"total", "503", "x"}};
    EXPECT_EQ(format_text(table),
              "animal            rows  note\n"
              "----------------------------\n"
              "goat               496  fine\n"
              "a very long name     7\n"
              "----------------------------\n"
              "total              503  x\n");
}

TEST(TextTable, WithoutTotalAndWithoutRows) {
    const TextTable table{{{"a", Align::left}, {"b"}}, {}, {}};
    EXPECT_EQ(format_text(table), "a  b\n----\n");
}

// A character takes one column however many bytes it has.
TEST(TextTable, CountsCharacters) {
    const TextTable table{{{"name", Align::left}, {"n"}}, {{"Füchsin", "1"}, {"Fuchs", "2"}}, {}};
    EXPECT_EQ(format_text(table), "name     n\n----------\nFüchsin  1\nFuchs    2\n");
}

TEST(Csv, QuotesWhatNeedsIt) {
    const TextTable table{{{"plain"}, {"comma, in title"}},
                          {{"a b", "1,5"}, {"say \"no\"", "two\nlines"}, {"", "cr\r"}},
                          {"no", "totals"}};
    EXPECT_EQ(format_csv(table),
              "plain,\"comma, in title\"\n"
              "a b,\"1,5\"\n"
              "\"say \"\"no\"\"\",\"two\nlines\"\n"
              ",\"cr\r\"\n");
}

TEST(Readable, Bytes) {
    EXPECT_EQ(readable_bytes(0), "0 B");
    EXPECT_EQ(readable_bytes(1023), "1023 B");
    EXPECT_EQ(readable_bytes(1024), "1.0 KiB");
    EXPECT_EQ(readable_bytes(12'345), "12.1 KiB");
    EXPECT_EQ(readable_bytes(1'682'432), "1.6 MiB");
    EXPECT_EQ(readable_bytes(446'400'000), "425.7 MiB");
    EXPECT_EQ(readable_bytes(3ull << 30), "3.0 GiB");
    EXPECT_EQ(readable_bytes(5ull << 40), "5120.0 GiB");
}

TEST(Readable, Errors) {
    EXPECT_EQ(readable_error(0.0), "0");
    EXPECT_EQ(readable_error(0.000123), "1.23e-04");
    EXPECT_EQ(readable_error(1.0), "1.00e+00");
}

}  // namespace
}  // namespace posepack::output
