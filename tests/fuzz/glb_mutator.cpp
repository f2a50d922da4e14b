// SPDX-License-Identifier: MIT
// Mutates GLBs as GLBs: the JSON text or the BIN chunk, with lengths made right again, so that most inputs
// get past the shell. One in sixteen is changed blindly, for the shell itself.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "animal/glb_file.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using Bytes = std::vector<std::uint8_t>;
using Random = std::minstd_rand;

// Counts, indices, enumerators and floats on which readers break.
constexpr std::array<std::string_view, 40> kNumbers{"0",
                                                    "1",
                                                    "2",
                                                    "3",
                                                    "4",
                                                    "5",
                                                    "-1",
                                                    "-2",
                                                    "7",
                                                    "8",
                                                    "16",
                                                    "255",
                                                    "256",
                                                    "65535",
                                                    "65536",
                                                    "0.5",
                                                    "-0.0",
                                                    "1e-30",
                                                    "1e30",
                                                    "1e38",
                                                    "3.5e38",
                                                    "1e308",
                                                    "-1e308",
                                                    "2147483647",
                                                    "5120",
                                                    "5121",
                                                    "5122",
                                                    "5123",
                                                    "5125",
                                                    "5126",
                                                    "4294967295",
                                                    "4294967296",
                                                    "null",
                                                    "[]",
                                                    "1e999",
                                                    "-2147483648",
                                                    "1099511627776",
                                                    "4611686018427387904",
                                                    "9223372036854775807",
                                                    "18446744073709551615"};

bool is_number_character(std::uint8_t c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

// Replaces a number, chosen from a random place on.
void replace_number(Bytes& json, Random& random) {
    if (json.empty()) return;
    const std::size_t from = random() % json.size();
    const auto is_digit = [](std::uint8_t c) { return c >= '0' && c <= '9'; };
    auto first = std::find_if(json.begin() + static_cast<std::ptrdiff_t>(from), json.end(), is_digit);
    while (first != json.begin() && first != json.end() && is_number_character(first[-1])) --first;
    const auto last = std::find_if_not(first, json.end(), is_number_character);
    const std::string_view number = kNumbers[random() % kNumbers.size()];
    const auto offset = first - json.begin();
    json.erase(first, last);
    json.insert(json.begin() + offset, number.begin(), number.end());
}

// A bracketed piece of JSON, brackets included; empty where none begins behind a random place.
struct Piece {
    std::size_t first = 0, size = 0;
};

Piece random_piece(const Bytes& json, Random& random) {
    if (json.empty()) return {};
    const auto from = json.begin() + static_cast<std::ptrdiff_t>(random() % json.size());
    const auto open = std::find_if(from, json.end(), [](std::uint8_t c) { return c == '{' || c == '['; });
    int depth = 0;
    for (auto at = open; at != json.end(); ++at) {
        if (*at == '{' || *at == '[') ++depth;
        if ((*at == '}' || *at == ']') && --depth == 0)
            return {static_cast<std::size_t>(open - json.begin()), static_cast<std::size_t>(at + 1 - open)};
    }
    return {};
}

// Doubles a piece (an accessor, a channel, a list of children), drops it, or puts it in the place of another.
void move_piece(Bytes& json, Random& random) {
    const Piece piece = random_piece(json, random);
    if (piece.size == 0) return;
    const auto first = json.begin() + static_cast<std::ptrdiff_t>(piece.first);
    const auto last = first + static_cast<std::ptrdiff_t>(piece.size);
    Bytes copy(first, last);
    const auto kind = random() % 3;
    if (kind == 0) {
        copy.insert(copy.begin(), ',');
        json.insert(last, copy.begin(), copy.end());
    } else if (kind == 1) {
        json.erase(first, last != json.end() && *last == ',' ? last + 1 : last);
    } else {
        const Piece other = random_piece(json, random);
        const auto place = json.begin() + static_cast<std::ptrdiff_t>(other.first);
        json.erase(place, place + static_cast<std::ptrdiff_t>(other.size));
        json.insert(json.begin() + static_cast<std::ptrdiff_t>(other.first), copy.begin(), copy.end());
    }
}

void mutate_blindly(Bytes& bytes, std::size_t max_size) {
    const std::size_t size = bytes.size();
    bytes.resize(std::max(max_size, size));
    bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

void append_chunk(Bytes& out, std::uint32_t type, const Bytes& payload, std::uint8_t fill) {
    const auto append_u32 = [&](std::uint32_t v) {
        for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(v >> (8 * i)));
    };
    const std::size_t padding = (4 - payload.size() % 4) % 4;
    append_u32(static_cast<std::uint32_t>(payload.size() + padding));
    append_u32(type);
    out.insert(out.end(), payload.begin(), payload.end());
    out.insert(out.end(), padding, fill);
}

Bytes assemble(const Bytes& json, const Bytes& bin) {
    Bytes out{'g', 'l', 'T', 'F', 2, 0, 0, 0, 0, 0, 0, 0};
    append_chunk(out, 0x4E4F534A, json, ' ');
    if (!bin.empty()) append_chunk(out, 0x004E4942, bin, 0);
    const auto size = static_cast<std::uint32_t>(out.size());
    for (int i = 0; i < 4; ++i)
        out[static_cast<std::size_t>(8 + i)] = static_cast<std::uint8_t>(size >> (8 * i));
    return out;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
    Random random(seed);
    const auto glb = posepack::animal::split_glb({data, size});
    if (!glb || random() % 16 == 0) return LLVMFuzzerMutate(data, size, max_size);
    Bytes json(glb.value().json.begin(), glb.value().json.end());
    Bytes bin(glb.value().bin.begin(), glb.value().bin.end());
    for (unsigned changes = 1 + random() % 3; changes > 0; --changes) {
        const auto kind = random() % 8;
        if (kind < 3)
            replace_number(json, random);
        else if (kind == 3)
            move_piece(json, random);
        else if (kind == 4)
            mutate_blindly(json, json.size() + 64);
        else
            mutate_blindly(bin, bin.size() + 64);
    }
    const Bytes out = assemble(json, bin);
    if (out.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
    std::memcpy(data, out.data(), out.size());
    return out.size();
}
