// SPDX-License-Identifier: MIT
#include "animal/draco_mesh.hpp"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <exception>
#include <string>

#include "animal/element_span.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr int kBitstreamMajor = 2, kBitstreamMinor = 2;

// Bytes of working memory: corner tables for a face; for a value, itself and its portable form.
constexpr std::uint64_t kBytesPerFace = 48;
constexpr std::uint64_t kCopiesPerValue = 2;

Issue malformed(std::string detail) {
    return {IssueCode::glb_draco, "", std::move(detail)};
}

// What a stream says of itself ahead of its data (Draco bitstream 2.2, "Decode Header" and "Decode
// Connectivity Data").
struct StreamFacts {
    int method = 0;
    std::uint32_t face_count = 0;
    std::uint32_t point_count = 0;  // edgebreaker: vertices, each of which is at least one point
};

base::Result<StreamFacts> read_header(std::span<const std::uint8_t> bytes) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok())
        return malformed("expected a stream that begins with 'DRACO'");
    if (header.version_major != kBitstreamMajor || header.version_minor != kBitstreamMinor)
        return malformed(fmt::format("expected bitstream 2.2, found {}.{}", header.version_major,
                                     header.version_minor));
    if (header.encoder_type != draco::TRIANGULAR_MESH)
        return malformed("expected a triangle mesh, found a point cloud");
    const std::uint16_t version = DRACO_BITSTREAM_VERSION(kBitstreamMajor, kBitstreamMinor);
    buffer.set_bitstream_version(version);
    if ((header.flags & METADATA_FLAG_MASK) != 0) {
        draco::GeometryMetadata metadata;
        if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
            return malformed("the metadata does not decode");
    }
    StreamFacts facts;
    facts.method = header.encoder_method;
    bool is_read = false;
    if (facts.method == draco::MESH_SEQUENTIAL_ENCODING) {
        is_read = draco::DecodeVarint(&facts.face_count, &buffer) &&
                  draco::DecodeVarint(&facts.point_count, &buffer);
    } else if (facts.method == draco::MESH_EDGEBREAKER_ENCODING) {
        std::uint8_t traversal = 0;
        is_read = buffer.Decode(&traversal) && draco::DecodeVarint(&facts.point_count, &buffer) &&
                  draco::DecodeVarint(&facts.face_count, &buffer);
    } else {
        return malformed(fmt::format("unknown encoding method {}", facts.method));
    }
    if (!is_read) return malformed("the header is cut off");
    return facts;
}

base::Status check_limits(const StreamFacts& facts, const DracoLimits& limits) {
    if (facts.face_count <= limits.face_count && facts.point_count <= limits.point_count) return {};
    return Issue{IssueCode::lim_decoded, "",
                 fmt::format("the Draco stream asks for {} points and {} faces, its accessors declare {} and {}",
                             facts.point_count, facts.face_count, limits.point_count, limits.face_count)};
}

// A decoder that looks at what the attributes ask for before it makes room for them. An edgebreaker stream
// tells its number of points, and both methods their attributes, only behind the faces.
template <class Decoder>
class BoundedDecoder final : public Decoder {
 public:
    BoundedDecoder(const DracoLimits& limits, DecodeBudget& budget) : limits_(limits), budget_(budget) {}

    base::Status refusal;

 protected:
    bool DecodeAllAttributes() override {
        const draco::PointCloud& cloud = *this->point_cloud();
        refusal = check(cloud);
        return refusal && Decoder::DecodeAllAttributes();
    }

 private:
    base::Status check(const draco::PointCloud& cloud) {
        if (cloud.num_points() > limits_.point_count)
            return Issue{IssueCode::lim_decoded, "",
                         fmt::format("the Draco stream asks for {} points, its accessors declare {}",
                                     cloud.num_points(), limits_.point_count)};
        for (int a = 0; a < cloud.num_attributes(); ++a) {
            const draco::PointAttribute& attribute = *cloud.attribute(a);
            const int value_bytes = std::max(4, draco::DataTypeLength(attribute.data_type()));
            const auto bytes = static_cast<std::uint64_t>(value_bytes) * attribute.num_components();
            if (auto status = budget_.take(cloud.num_points(), kCopiesPerValue * bytes); !status) return status;
        }
        return {};
    }

    const DracoLimits& limits_;
    DecodeBudget& budget_;
};

template <class Decoder>
base::Status decode_with(std::span<const std::uint8_t> bytes, const DracoLimits& limits, DecodeBudget& budget,
                         draco::Mesh& mesh) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    BoundedDecoder<Decoder> decoder(limits, budget);
    std::string reason;
    try {
        const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, &mesh);
        if (status.ok()) return {};
        reason = status.error_msg_string();
    } catch (const std::exception& exception) {
        reason = exception.what();
    }
    if (!decoder.refusal) return decoder.refusal;
    return malformed(fmt::format("the stream does not decode{}{}", reason.empty() ? "" : ": ", reason));
}

template <class T>
bool copy_values(const draco::PointAttribute& attribute, std::size_t point_count, std::uint8_t* out) {
    const auto components = static_cast<std::int8_t>(attribute.num_components());
    T values[16];
    for (std::size_t p = 0; p < point_count; ++p) {
        const auto index = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(p)));
        if (index.value() >= attribute.size() || !attribute.ConvertValue<T>(index, components, values))
            return false;
        const std::size_t size = sizeof(T) * attribute.num_components();
        std::memcpy(out + p * size, values, size);
    }
    return true;
}

bool copy_as(int component, const draco::PointAttribute& attribute, std::size_t points, std::uint8_t* out) {
    switch (component) {
        case kByte:
            return copy_values<std::int8_t>(attribute, points, out);
        case kUnsignedByte:
            return copy_values<std::uint8_t>(attribute, points, out);
        case kShort:
            return copy_values<std::int16_t>(attribute, points, out);
        case kUnsignedShort:
            return copy_values<std::uint16_t>(attribute, points, out);
        case kUnsignedInt:
            return copy_values<std::uint32_t>(attribute, points, out);
        default:
            return copy_values<float>(attribute, points, out);
    }
}

}  // namespace

struct DracoMesh::Body {
    draco::Mesh mesh;
};

DracoMesh::DracoMesh(std::unique_ptr<Body> body) : body_(std::move(body)) {}
DracoMesh::DracoMesh(DracoMesh&&) noexcept = default;
DracoMesh& DracoMesh::operator=(DracoMesh&&) noexcept = default;
DracoMesh::~DracoMesh() = default;

base::Result<DracoMesh> DracoMesh::decode(std::span<const std::uint8_t> bytes, const DracoLimits& limits,
                                          DecodeBudget& budget) {
    const auto header = read_header(bytes);
    if (!header) return header.issue();
    if (auto status = check_limits(header.value(), limits); !status) return status.issue();
    if (auto status = budget.take(header.value().face_count, kBytesPerFace); !status) return status.issue();
    auto body = std::make_unique<Body>();
    const auto status =
        header.value().method == draco::MESH_SEQUENTIAL_ENCODING
            ? decode_with<draco::MeshSequentialDecoder>(bytes, limits, budget, body->mesh)
            : decode_with<draco::MeshEdgebreakerDecoder>(bytes, limits, budget, body->mesh);
    if (!status) return status.issue();
    return DracoMesh(std::move(body));
}

std::size_t DracoMesh::point_count() const {
    return body_->mesh.num_points();
}

base::Result<std::vector<std::uint8_t>> DracoMesh::values(std::uint32_t unique_id, int component,
                                                          std::size_t components) const {
    const draco::PointAttribute* attribute = body_->mesh.GetAttributeByUniqueId(unique_id);
    if (attribute == nullptr) return malformed(fmt::format("the stream has no attribute {}", unique_id));
    if (attribute->num_components() != components)
        return malformed(fmt::format("attribute {} has {} components, its accessor {}", unique_id,
                                     attribute->num_components(), components));
    std::vector<std::uint8_t> out(point_count() * components * component_bytes(component));
    if (!copy_as(component, *attribute, point_count(), out.data()))
        return malformed(fmt::format("attribute {} has a value that its accessor's component type {} does not hold",
                                     unique_id, component));
    return out;
}

}  // namespace posepack::animal
