// SPDX-License-Identifier: MIT
#include "animal/buffer_views.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "animal/data_uri.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;
using ByteSpan = std::span<const std::uint8_t>;

constexpr std::array<std::string_view, 2> kMeshoptExtensions{"EXT_meshopt_compression",
                                                             "KHR_meshopt_compression"};

const tinygltf::Value* compression_of(const tinygltf::BufferView& view) {
    for (const std::string_view name : kMeshoptExtensions)
        if (const auto found = view.extensions.find(std::string(name)); found != view.extensions.end())
            return &found->second;
    return nullptr;
}

// A count or an offset of the extension; below 0 where there is none, or none that is whole.
double whole_number(const tinygltf::Value& object, const char* key, double missing) {
    if (!object.IsObject() || !object.Has(key)) return missing;
    const tinygltf::Value& value = object.Get(key);
    if (!value.IsNumber()) return -1.0;
    const double number = value.GetNumberAsDouble();
    return number >= 0.0 && number <= 9007199254740992.0 && number == std::floor(number) ? number : -1.0;
}

std::string text_of(const tinygltf::Value& object, const char* key, const char* missing) {
    if (!object.IsObject() || !object.Has(key)) return missing;
    const tinygltf::Value& value = object.Get(key);
    return value.IsString() ? value.Get<std::string>() : "?";
}

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
                     "this posepack does not read the filter COLOR of KHR_meshopt_compression"};
    else
        return Issue{
            IssueCode::glb_meshopt, "",
            fmt::format("expected the filter NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL, found '{}'",
                        name.substr(0, 32))};
    return {};
}

}  // namespace

base::Result<ByteSpan> BufferViews::buffer(double index) {
    if (index < 0.0 || index >= static_cast<double>(gltf_.facts.buffers.size()))
        return Issue{IssueCode::glb_reference, "", fmt::format("buffer {} does not exist", index)};
    const auto b = static_cast<std::size_t>(index);
    const BufferFacts& facts = gltf_.facts.buffers[b];
    if (facts.is_fallback && (facts.has_uri || b > 0))
        return Issue{IssueCode::glb_uri, "",
                     fmt::format("expected compressed data, found only a use of the fallback buffer {}", b)};
    ByteSpan bytes = gltf_.bin;
    if (facts.has_uri) {
        const auto known = data_uris_.find(b);
        if (known != data_uris_.end()) {
            bytes = known->second;
        } else {
            auto decoded = decode_data_uri(facts.uri, budget_);
            if (!decoded) return base::at(fmt::format("buffers/{}", b), decoded.issue());
            bytes = data_uris_.emplace(b, std::move(decoded).value()).first->second;
        }
    } else if (b > 0) {
        return Issue{IssueCode::glb_uri, "",
                     fmt::format("buffer {} has no uri, and only the first one may be the BIN chunk", b)};
    }
    if (facts.byte_length > static_cast<double>(bytes.size()))
        return Issue{IssueCode::glb_view_range, "",
                     fmt::format("buffer {} declares {} bytes, found {}", b, facts.byte_length, bytes.size())};
    return bytes.first(static_cast<std::size_t>(facts.byte_length));
}

base::Result<ByteSpan> BufferViews::slice(double buffer_index, double offset, double length) {
    const auto whole = buffer(buffer_index);
    if (!whole) return whole.issue();
    const auto size = static_cast<double>(whole.value().size());
    if (offset < 0.0 || length < 0.0 || offset > size || length > size - offset)
        return Issue{IssueCode::glb_view_range, "",
                     fmt::format("{} bytes from {} on leave the buffer of {} bytes", length, offset, size)};
    return whole.value().subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

base::Result<MeshoptStream> BufferViews::stream_of(const tinygltf::BufferView& view,
                                                   const tinygltf::Value& extension) {
    MeshoptStream stream;
    if (auto status = read_mode(text_of(extension, "mode", "?"), stream.mode); !status) return status.issue();
    if (auto status = read_filter(text_of(extension, "filter", "NONE"), stream.filter); !status)
        return status.issue();
    const double count = whole_number(extension, "count", -1.0);
    const double stride = whole_number(extension, "byteStride", -1.0);
    if (count < 1.0 || stride < 1.0 || count * stride != static_cast<double>(view.byteLength))
        return Issue{IssueCode::glb_meshopt, "",
                     fmt::format("expected count x byteStride to be the view's {} bytes, found {} x {}",
                                 view.byteLength, count, stride)};
    stream.count = static_cast<std::size_t>(count);
    stream.stride_bytes = static_cast<std::size_t>(stride);
    const auto bytes =
        slice(whole_number(extension, "buffer", -1.0), whole_number(extension, "byteOffset", 0.0),
              whole_number(extension, "byteLength", -1.0));
    if (!bytes) return bytes.issue();
    stream.bytes = bytes.value();
    if (auto status = check_meshopt(stream); !status) return status.issue();
    return stream;
}

base::Result<ByteSpan> BufferViews::decode(const tinygltf::BufferView& view, const tinygltf::Value& extension,
                                           int view_index) {
    if (const auto known = decoded_views_.find(view_index); known != decoded_views_.end())
        return ByteSpan(known->second);
    const auto stream = stream_of(view, extension);
    if (!stream) return stream.issue();
    if (auto status = budget_.take(stream.value().count, stream.value().stride_bytes); !status)
        return status.issue();
    Bytes bytes(view.byteLength);
    if (auto status = decode_meshopt(stream.value(), bytes); !status) return status.issue();
    return ByteSpan(decoded_views_.emplace(view_index, std::move(bytes)).first->second);
}

base::Result<ByteSpan> BufferViews::bytes(int view_index) {
    const auto& views = gltf_.model->bufferViews;
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= views.size())
        return Issue{IssueCode::glb_reference, "", fmt::format("buffer view {} does not exist", view_index)};
    const tinygltf::BufferView& view = views[static_cast<std::size_t>(view_index)];
    const tinygltf::Value* compression = view.extensions.empty() ? nullptr : compression_of(view);
    auto found = compression != nullptr
                     ? decode(view, *compression, view_index)
                     : slice(view.buffer, static_cast<double>(view.byteOffset), static_cast<double>(view.byteLength));
    if (!found) return base::at(fmt::format("bufferViews/{}", view_index), found.issue());
    return found;
}

}  // namespace posepack::animal
