// SPDX-License-Identifier: MIT
// Why a clip has its form and rows: what was taken, and what became of the others.
#include "output/choice_text.hpp"

#include <gtest/gtest.h>

namespace posepack::output {
namespace {

recipe::TryRecord attempt(const char* encoding, const char* row_scheme, std::uint64_t bytes,
                          bool keeps_bound) {
    recipe::TryRecord one;
    one.encoding = encoding;
    one.row_scheme = row_scheme;
    one.bytes = bytes;
    one.keeps_bound = keeps_bound;
    return one;
}

std::string sentence(std::vector<recipe::TryRecord> tried) {
    recipe::ClipRecord clip;
    clip.tried = std::move(tried);
    return choice_sentence(clip);
}

TEST(ChoiceSentence, NamesTheSmallestThatKeepsTheBound) {
    EXPECT_EQ(sentence({attempt("dualquat", "runs", 900, false), attempt("dualquat", "runs", 1400, true),
                        attempt("dualquat", "runs", 1200, true)}),
              "runs of dualquat, 1,200 bytes: the smallest of 2 that keep the bound, of 3 tried");
}

TEST(ChoiceSentence, SaysWhatOthersNeed) {
    EXPECT_EQ(sentence({attempt("dualquat", "runs", 14136, true), attempt("dualquat", "slots", 3004, true)}),
              "slots of dualquat, 3,004 bytes: the smallest of 2 that keep the bound, of 2 tried; runs need "
              "14,136");
}

TEST(ChoiceSentence, SaysWhatMissesTheBound) {
    EXPECT_EQ(sentence({attempt("dualquat", "runs", 100, false), attempt("dualquat", "slots", 90, false),
                        attempt("affine", "runs", 300, true), attempt("affine", "slots", 200, false)}),
              "runs of affine, 300 bytes: the only one that keeps the bound, of 4 tried; slots miss it; "
              "dualquat miss it");
}

TEST(ChoiceSentence, OfAFixedFormThereIsNothingToSay) {
    EXPECT_EQ(sentence({}), "as asked for");
}

}  // namespace
}  // namespace posepack::output
