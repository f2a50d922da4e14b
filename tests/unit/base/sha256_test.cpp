// SPDX-License-Identifier: MIT
#include "base/sha256.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace posepack::base {
namespace {

std::string digest_of(std::string_view text) {
    return hexadecimal(sha256({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

// Vectors of NIST's "Secure Hash Standard" examples (FIPS 180-4).
TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(digest_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, GivesThePublishedDigestOfAMillionBytes) {
    EXPECT_EQ(digest_of(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Hexadecimal, PrintsTwoLowerCaseDigitsAByte) {
    EXPECT_EQ(hexadecimal(std::vector<std::uint8_t>{0x00, 0x0F, 0xA0, 0xFF}), "000fa0ff");
    EXPECT_EQ(hexadecimal({}), "");
}

}  // namespace
}  // namespace posepack::base
