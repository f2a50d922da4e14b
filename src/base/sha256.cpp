// SPDX-License-Identifier: MIT
#include "base/sha256.hpp"

#include <nettle/sha2.h>

namespace posepack::base {

Sha256 sha256(std::span<const std::uint8_t> bytes) {
    static_assert(std::tuple_size_v<Sha256> == SHA256_DIGEST_SIZE);
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, bytes.size(), bytes.data());
    Sha256 digest{};
    sha256_digest(&context, digest.size(), digest.data());
    return digest;
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    text.reserve(2 * bytes.size());
    for (const std::uint8_t byte : bytes) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

}  // namespace posepack::base
