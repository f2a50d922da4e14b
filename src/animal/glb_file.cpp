// SPDX-License-Identifier: MIT
#include "animal/glb_file.hpp"

#include <fmt/format.h>

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJsonType = 0x4E4F534A;
constexpr std::uint32_t kBinType = 0x004E4942;

std::uint32_t read_u32(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

base::Status check_header(std::span<const std::uint8_t> bytes) {
    if (bytes.size() >= 4 && read_u32(bytes, 0) != kMagic)
        return Issue{IssueCode::glb_magic, "",
                     fmt::format("expected the bytes 'glTF', found {:02x} {:02x} {:02x} {:02x}", bytes[0],
                                 bytes[1], bytes[2], bytes[3])};
    if (bytes.size() < kHeaderBytes)
        return Issue{IssueCode::glb_truncated, "",
                     fmt::format("expected a 12-byte GLB header, found {} bytes", bytes.size())};
    if (const std::uint32_t version = read_u32(bytes, 4); version != 2)
        return Issue{IssueCode::glb_version, "", fmt::format("expected GLB version 2, found {}", version)};
    const std::uint32_t length = read_u32(bytes, 8);
    if (length > bytes.size())
        return Issue{
            IssueCode::glb_length, "",
            fmt::format("expected the {} bytes that the header declares, found {}", length, bytes.size())};
    if (length < kHeaderBytes + kChunkHeaderBytes)
        return Issue{IssueCode::glb_truncated, "",
                     fmt::format("expected a JSON chunk, found a declared length of {} bytes", length)};
    if (length < bytes.size())
        return Issue{
            IssueCode::glb_trailing, "",
            fmt::format("expected the file to end at byte {}, found {} more", length, bytes.size() - length)};
    return {};
}

}  // namespace

base::Result<GlbFile> split_glb(std::span<const std::uint8_t> bytes) {
    if (const base::Status header = check_header(bytes); !header) return header.issue();
    GlbFile file;
    std::size_t offset = kHeaderBytes;
    for (std::size_t chunk = 0; offset < bytes.size(); ++chunk) {
        const std::string where = fmt::format("chunk {}", chunk);
        if (bytes.size() - offset < kChunkHeaderBytes)
            return Issue{IssueCode::glb_chunk, where,
                         fmt::format("expected an 8-byte chunk header at byte {}, found {} bytes", offset,
                                     bytes.size() - offset)};
        const std::uint32_t size = read_u32(bytes, offset);
        const std::uint32_t type = read_u32(bytes, offset + 4);
        offset += kChunkHeaderBytes;
        if (size > bytes.size() - offset)
            return Issue{IssueCode::glb_chunk, where,
                         fmt::format("expected the {} bytes that the chunk declares, found {}", size,
                                     bytes.size() - offset)};
        if ((chunk == 0) != (type == kJsonType))
            return Issue{
                IssueCode::glb_chunk, where,
                fmt::format("expected exactly one JSON chunk, as the first; found type {:08x} here", type)};
        const auto payload = bytes.subspan(offset, size);
        if (chunk == 0)
            file.json = {reinterpret_cast<const char*>(payload.data()), payload.size()};
        else if (type == kBinType && chunk != 1)
            return Issue{IssueCode::glb_chunk, where,
                         "expected at most one BIN chunk, right after the JSON, found another"};
        else if (type == kBinType)
            file.bin = payload;
        else
            ++file.unknown_chunk_count;
        offset += size;
    }
    return file;
}

}  // namespace posepack::animal
