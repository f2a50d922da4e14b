// SPDX-License-Identifier: MIT
#include "animal/buffer_views.hpp"

#include <fmt/format.h>

#include <string>

#include "animal/data_uri.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;
using ByteSpan = std::span<const std::uint8_t>;

base::Status read_mode(const std::string& name, MeshoptMode& mode) {
    if (name == "ATTRIBUTES")
        mode = MeshoptMode::attributes;
    else if (name == "TRIANGLES")
        mode = MeshoptMode::triangles;
    else if (name == "INDICES")
        mode = MeshoptMode::indices;
    else
        return Issue{IssueCode::glb_meshopt, "",
                     fmt::format("expected the mode ATTRIBUTES, TRIANGLES or INDICES, found '{}'",
                                 name.substr(0, 32))};
    return {};
}

base::Status read_filter(const std::string& name, MeshoptFilter& filter) {
    if (name == "NONE")
        filter = MeshoptFilter::none;
    else if (name == "OCTAHEDRAL")
        filter = MeshoptFilter::octahedral;
    else if (name == "QUATERNION")
        filter = MeshoptFilter::quaternion;
    else if (name == "EXPONENTIAL")
        filter = MeshoptFilter::exponential;
    else if (name == "COLOR")
        return Issue{IssueCode::glb_extension, "",
                     "expected a filter of EXT_meshopt_compression, found COLOR of KHR_meshopt_compression"};
    else
        return Issue{
            IssueCode::glb_meshopt, "",
            fmt::format("expected the filter NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL, found '{}'",
                        name.substr(0, 32))};
    return {};
}

}  // namespace

base::Result<ByteSpan> BufferViews::buffer(std::uint64_t index) {
    if (index >= gltf_.facts.buffers.size())
        return Issue{
            IssueCode::glb_reference, "",
            fmt::format("expected one of {} buffers, found index {}", gltf_.facts.buffers.size(), index)};
    const BufferFacts& facts = gltf_.facts.buffers[index];
    if (facts.is_fallback && (facts.has_uri || index > 0))
        return Issue{
            IssueCode::glb_uri, "",
            fmt::format("expected compressed data, found only a use of the fallback buffer {}", index)};
    ByteSpan bytes = gltf_.bin;
    if (facts.has_uri) {
        const auto known = data_uris_.find(index);
        if (known != data_uris_.end()) {
            bytes = known->second;
        } else {
            auto decoded = decode_data_uri(facts.uri, budget_);
            if (!decoded) return base::at(fmt::format("buffers/{}", index), decoded.issue());
            bytes = data_uris_.emplace(index, std::move(decoded).value()).first->second;
        }
    } else if (index > 0) {
        return Issue{
            IssueCode::glb_uri, "",
            fmt::format("expected a uri for buffer {}, found none (only buffer 0 is the BIN chunk)", index)};
    }
    if (facts.byte_length > static_cast<double>(bytes.size()))
        return Issue{IssueCode::glb_view_range, "",
                     fmt::format("expected the {} bytes that buffer {} declares, found {}", facts.byte_length,
                                 index, bytes.size())};
    return bytes.first(static_cast<std::size_t>(facts.byte_length));
}

base::Result<ByteSpan> BufferViews::slice(std::uint64_t buffer_index, std::uint64_t offset_bytes,
                                          std::uint64_t length_bytes) {
    const auto whole = buffer(buffer_index);
    if (!whole) return whole.issue();
    const std::size_t size = whole.value().size();
    if (offset_bytes > size || length_bytes > size - offset_bytes)
        return Issue{
            IssueCode::glb_view_range, "",
            fmt::format("expected a range within the buffer's {} bytes, found {} bytes from byte {} on", size,
                        length_bytes, offset_bytes)};
    return whole.value().subspan(offset_bytes, length_bytes);
}

base::Result<MeshoptStream> BufferViews::stream_of(const ViewFacts& view) {
    const CompressionFacts& facts = *view.compression;
    MeshoptStream stream;
    if (auto status = read_mode(facts.mode, stream.mode); !status) return status.issue();
    if (auto status = read_filter(facts.filter, stream.filter); !status) return status.issue();
    if (facts.count == kMissing || facts.stride_bytes == kMissing || facts.length_bytes == kMissing)
        return Issue{IssueCode::glb_meshopt, "",
                     "expected count, byteStride and byteLength of the stream, found at least one missing"};
    // A division, so that nothing wraps.
    if (facts.count == 0 || facts.stride_bytes == 0 || view.length_bytes % facts.stride_bytes != 0 ||
        view.length_bytes / facts.stride_bytes != facts.count)
        return Issue{IssueCode::glb_meshopt, "",
                     fmt::format("expected count x byteStride to be the view's {} bytes, found {} x {}",
                                 view.length_bytes, facts.count, facts.stride_bytes)};
    stream.count = facts.count;
    stream.stride_bytes = facts.stride_bytes;
    const auto bytes = slice(facts.buffer, facts.offset_bytes, facts.length_bytes);
    if (!bytes) return bytes.issue();
    stream.bytes = bytes.value();
    if (auto status = check_meshopt(stream); !status) return status.issue();
    return stream;
}

base::Result<ByteSpan> BufferViews::decode(const ViewFacts& view, std::uint64_t view_index) {
    if (const auto known = decoded_views_.find(view_index); known != decoded_views_.end())
        return ByteSpan(known->second);
    const auto stream = stream_of(view);
    if (!stream) return stream.issue();
    if (auto status = budget_.take(stream.value().count, stream.value().stride_bytes); !status)
        return status.issue();
    Bytes bytes(view.length_bytes);
    if (auto status = decode_meshopt(stream.value(), bytes); !status) return status.issue();
    return ByteSpan(decoded_views_.emplace(view_index, std::move(bytes)).first->second);
}

base::Result<ByteSpan> BufferViews::bytes(std::uint64_t view_index) {
    if (view_index >= gltf_.facts.views.size())
        return Issue{IssueCode::glb_reference, "",
                     fmt::format("expected one of {} buffer views, found index {}", gltf_.facts.views.size(),
                                 view_index)};
    const ViewFacts& view = gltf_.facts.views[view_index];
    auto found = view.compression ? decode(view, view_index)
                                  : slice(view.buffer, view.offset_bytes, view.length_bytes);
    if (!found) return base::at(fmt::format("bufferViews/{}", view_index), found.issue());
    return found;
}

}  // namespace posepack::animal
