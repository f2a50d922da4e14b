// SPDX-License-Identifier: MIT
#include "animal/meshopt.hpp"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <string>

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

// First byte of a stream: what it is in the high half, its version in the low one (EXT_meshopt_compression,
// "Bitstreams").
constexpr int kAttributesHeader = 0xA0, kTrianglesHeader = 0xE0, kIndicesHeader = 0xD0;

struct ModeFacts {
    const char* name;
    int header;
    int newest_version;  // that this meshoptimizer decodes
};

// meshoptimizer before 0.23 knows no attributes of version 1, which KHR_meshopt_compression adds.
constexpr int kNewestAttributes = MESHOPTIMIZER_VERSION >= 230 ? 1 : 0;
constexpr ModeFacts kModes[] = {{"ATTRIBUTES", kAttributesHeader, kNewestAttributes},
                                {"TRIANGLES", kTrianglesHeader, 1},
                                {"INDICES", kIndicesHeader, 1}};

const ModeFacts& facts_of(MeshoptMode mode) {
    return kModes[static_cast<std::size_t>(mode)];
}

Issue malformed(std::string detail) {
    return {IssueCode::glb_meshopt, "", std::move(detail)};
}

// What the extension asks of count and stride; the library asserts it.
base::Status check_shape(const MeshoptStream& stream) {
    const std::size_t stride = stream.stride_bytes;
    const bool is_filtered = stream.filter != MeshoptFilter::none;
    if (stream.mode == MeshoptMode::attributes) {
        if (stride < 4 || stride > 256 || stride % 4 != 0)
            return malformed(
                fmt::format("expected a stride of 4, 8, ... 256 bytes for ATTRIBUTES, found {}", stride));
    } else if (stride != 2 && stride != 4) {
        return malformed(fmt::format("expected a stride of 2 or 4 bytes for indices, found {}", stride));
    } else if (is_filtered) {
        return malformed("expected no filter on indices");
    }
    if (stream.mode == MeshoptMode::triangles && stream.count % 3 != 0)
        return malformed(fmt::format("expected a multiple of 3 indices for TRIANGLES, found {}", stream.count));
    if (stream.filter == MeshoptFilter::octahedral && stride != 4 && stride != 8)
        return malformed(fmt::format("expected a stride of 4 or 8 bytes for OCTAHEDRAL, found {}", stride));
    if (stream.filter == MeshoptFilter::quaternion && stride != 8)
        return malformed(fmt::format("expected a stride of 8 bytes for QUATERNION, found {}", stride));
    return {};
}

// Fewest bytes of a stream of so many elements. ATTRIBUTES: two bits for each 16 values of each byte of an
// element; TRIANGLES: a byte a triangle; INDICES: a byte an index; each with its header and tail.
std::size_t fewest_bytes(const MeshoptStream& stream) {
    switch (stream.mode) {
        case MeshoptMode::attributes:
            return 1 + stream.count / 64 * stream.stride_bytes + stream.stride_bytes;
        case MeshoptMode::triangles:
            return 1 + stream.count / 3 + 16;
        case MeshoptMode::indices:
            return 1 + stream.count + 4;
    }
    return 0;
}

int decode_raw(const MeshoptStream& stream, void* out) {
    const unsigned char* bytes = stream.bytes.data();
    const std::size_t size = stream.bytes.size();
    switch (stream.mode) {
        case MeshoptMode::attributes:
            return meshopt_decodeVertexBuffer(out, stream.count, stream.stride_bytes, bytes, size);
        case MeshoptMode::triangles:
            return meshopt_decodeIndexBuffer(out, stream.count, stream.stride_bytes, bytes, size);
        case MeshoptMode::indices:
            return meshopt_decodeIndexSequence(out, stream.count, stream.stride_bytes, bytes, size);
    }
    return -1;
}

}  // namespace

base::Status check_meshopt(const MeshoptStream& stream) {
    if (auto status = check_shape(stream); !status) return status;
    const ModeFacts& mode = facts_of(stream.mode);
    if (stream.bytes.empty()) return malformed("expected a stream, found no bytes");
    const int header = stream.bytes[0];
    if ((header & 0xF0) != mode.header)
        return malformed(fmt::format("expected a stream of {} that begins with 0x{:02x}, found 0x{:02x}", mode.name,
                                     mode.header, header));
    if ((header & 0x0F) > mode.newest_version)
        return Issue{IssueCode::glb_extension, "",
                     fmt::format("this posepack does not read {} of version {} (0x{:02x}), which "
                                 "KHR_meshopt_compression has and EXT_meshopt_compression has not",
                                 mode.name, header & 0x0F, header)};
    // Divisions keep a count of any size from wrapping.
    if (stream.count / 64 > stream.bytes.size() || fewest_bytes(stream) > stream.bytes.size())
        return malformed(fmt::format("{} elements of {} bytes cannot come from a stream of {} bytes", stream.count,
                                     stream.stride_bytes, stream.bytes.size()));
    return {};
}

base::Status decode_meshopt(const MeshoptStream& stream, std::span<std::uint8_t> out) {
    if (const int code = decode_raw(stream, out.data()); code != 0)
        return malformed(fmt::format("the stream of {} does not decode (meshoptimizer: {})",
                                     facts_of(stream.mode).name, code));
    switch (stream.filter) {
        case MeshoptFilter::none:
            break;
        case MeshoptFilter::octahedral:
            meshopt_decodeFilterOct(out.data(), stream.count, stream.stride_bytes);
            break;
        case MeshoptFilter::quaternion:
            meshopt_decodeFilterQuat(out.data(), stream.count, stream.stride_bytes);
            break;
        case MeshoptFilter::exponential:
            meshopt_decodeFilterExp(out.data(), stream.count, stream.stride_bytes);
            break;
    }
    return {};
}

}  // namespace posepack::animal
