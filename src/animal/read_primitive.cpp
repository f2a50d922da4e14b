// SPDX-License-Identifier: MIT
#include "animal/read_primitive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";
constexpr std::size_t kMaxInfluenceSets = 4;
constexpr std::array<std::string_view, kMaxInfluenceSets> kJoints{"JOINTS_0", "JOINTS_1", "JOINTS_2",
                                                                  "JOINTS_3"};
constexpr std::array<std::string_view, kMaxInfluenceSets> kWeights{"WEIGHTS_0", "WEIGHTS_1", "WEIGHTS_2",
                                                                   "WEIGHTS_3"};

// glTF 2.0 section 3.7.2.1: modes whose faces a Draco stream may hold.
constexpr int kTriangles = 4, kTriangleStrip = 5;

int accessor_of(const tinygltf::Primitive& primitive, std::string_view name) {
    const auto found = primitive.attributes.find(std::string(name));
    return found == primitive.attributes.end() ? -1 : found->second;
}

// One primitive at work: where it is, its attributes, and its Draco stream once that is decoded.
class PrimitiveReader {
 public:
    PrimitiveReader(ReadContext& context, const Mesh& mesh, std::size_t index)
        : context_(context),
          mesh_(mesh),
          index_(index),
          source_(context.model().meshes[mesh.mesh].primitives[index]) {}

    base::Result<Primitive> read() {
        if (auto status = open_draco(); !status) return status.issue();
        if (auto status = read_geometry(); !status) return status.issue();
        if (mesh_.skin == kNone) {
            bind_rigidly();
        } else if (auto status = read_influences(); !status) {
            return status.issue();
        }
        return std::move(out_);
    }

 private:
    Place place(std::string_view leaf) const { return {"meshes", mesh_.mesh, "primitives", index_, leaf}; }

    AccessorUse use_of(std::string_view name, ElementType type, std::initializer_list<int> components,
                       bool allow_not_finite = false) const {
        AccessorUse use{place(name), type, components, allow_not_finite};
        const auto id = draco_id(name);
        if (!id) return use;
        use.draco = &*draco_;
        use.draco_id = *id;
        return use;
    }

    // The stream's own number of an attribute; none for an attribute beside the stream.
    std::optional<std::uint32_t> draco_id(std::string_view name) const {
        if (!draco_) return std::nullopt;
        const tinygltf::Value& attributes = source_.extensions.at(kDracoExtension).Get("attributes");
        const std::string key(name);
        if (!attributes.IsObject() || !attributes.Has(key) || !attributes.Get(key).IsInt())
            return std::nullopt;
        return static_cast<std::uint32_t>(attributes.Get(key).Get<int>());
    }

    // What the accessors of the compressed attributes and of the indices declare.
    DracoLimits limits() const {
        const AccessorReader& accessors = context_.accessors;
        DracoLimits limits;
        limits.point_count = accessors.declared_count(accessor_of(source_, "POSITION"));
        const int indices = accessors.facts().indices_of(mesh_.mesh, index_);
        const std::uint64_t corners = indices < 0 ? limits.point_count : accessors.declared_count(indices);
        // Of a strip, each index behind the second makes a face.
        limits.face_count = source_.mode == kTriangleStrip ? corners : corners / 3;
        return limits;
    }

    base::Status open_draco() {
        const auto extension = source_.extensions.find(kDracoExtension);
        if (extension == source_.extensions.end()) return {};
        const auto refuse = [&](std::string detail) {
            return Issue{IssueCode::glb_draco, place(kDracoExtension).text(), std::move(detail)};
        };
        const tinygltf::Value& value = extension->second;
        if (!value.IsObject() || !value.Has("bufferView") || !value.Get("bufferView").IsInt() ||
            !value.Has("attributes"))
            return refuse("expected a bufferView and attributes");
        if (source_.mode != kTriangles && source_.mode != kTriangleStrip)
            return refuse(fmt::format("expected triangles (mode 4 or 5), found mode {}", source_.mode));
        auto mesh = context_.accessors.read_draco(value.Get("bufferView").Get<int>(), limits());
        if (!mesh) return base::at(place(kDracoExtension).text(), mesh.issue());
        draco_.emplace(std::move(mesh).value());
        return {};
    }

    base::Status read_triples(std::string_view name, std::vector<std::array<float, 3>>& out) {
        const auto numbers = context_.accessors.read_floats(
            accessor_of(source_, name),
            use_of(name, ElementType::vec3, {kFloat, kByte, kShort, kUnsignedByte, kUnsignedShort}));
        if (!numbers) return numbers.issue();
        out.resize(numbers.value().size() / 3);
        std::memcpy(out.data(), numbers.value().data(), out.size() * sizeof out[0]);
        return {};
    }

    base::Status read_geometry() {
        if (auto status = read_triples("POSITION", out_.positions); !status) return status;
        if (accessor_of(source_, "NORMAL") < 0)
            return out_.normals.resize(out_.positions.size()), base::Status{};
        if (auto status = read_triples("NORMAL", out_.normals); !status) return status;
        if (out_.normals.size() == out_.positions.size()) return {};
        return Issue{
            IssueCode::glb_accessor_count, place("NORMAL").text(),
            fmt::format("expected {} elements, found {}", out_.positions.size(), out_.normals.size())};
    }

    // Every vertex of a rigid mesh follows the one bone of its node.
    void bind_rigidly() {
        out_.influences = 1;
        out_.bones.assign(out_.positions.size(), context_.animal.joint_map[mesh_.first_joint]);
        out_.weights.assign(out_.positions.size(), 1.0f);
    }

    // Sets beyond the last that is read, behind a gap, or of weights alone. What leaving them out costs is
    // not known, so it is said.
    base::Status report_unread_sets(std::size_t sets) {
        const auto is_read = [&](std::string_view name) {
            const auto is_name = [&](std::string_view known) { return known == name; };
            return std::any_of(kJoints.begin(), kJoints.begin() + sets, is_name) ||
                   std::any_of(kWeights.begin(), kWeights.begin() + sets, is_name);
        };
        std::string unread;
        for (const auto& [name, accessor] : source_.attributes)
            if ((name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) && !is_read(name))
                unread += fmt::format("{}{}", unread.empty() ? "" : ", ", base::printable(name));
        if (unread.empty()) return {};
        return context_.repair(
            IssueCode::warn_left_out, IssueCode::glb_weights, place({}).text(),
            fmt::format("expected at most {} influences a vertex, in sets of joints and weights without a "
                        "gap, found more that are not read: {}",
                        kMaxInfluenceSets * 4, base::shortened(unread, 64)));
    }

    base::Status read_influences() {
        std::size_t sets = 1;
        while (sets < kMaxInfluenceSets && accessor_of(source_, kJoints[sets]) >= 0) ++sets;
        if (auto status = report_unread_sets(sets); !status) return status;
        out_.influences = sets * 4;
        out_.bones.resize(out_.positions.size() * out_.influences);
        out_.weights.resize(out_.positions.size() * out_.influences);
        for (std::size_t set = 0; set < sets; ++set)
            if (auto status = read_influence_set(set); !status) return status;
        return {};
    }

    base::Status read_influence_set(std::size_t set) {
        const auto joints = context_.accessors.read_integers(
            accessor_of(source_, kJoints[set]),
            use_of(kJoints[set], ElementType::vec4, {kUnsignedByte, kUnsignedShort}));
        if (!joints) return joints.issue();
        if (accessor_of(source_, kWeights[set]) < 0)
            return Issue{IssueCode::glb_reference, place({}).text(),
                         fmt::format("expected {} beside {}, found none", kWeights[set], kJoints[set])};
        const auto weights = context_.accessors.read_floats(
            accessor_of(source_, kWeights[set]),
            use_of(kWeights[set], ElementType::vec4, {kFloat, kUnsignedByte, kUnsignedShort}, true));
        if (!weights) return weights.issue();
        const std::size_t vertex_count = out_.positions.size();
        if (joints.value().size() != vertex_count * 4 || weights.value().size() != vertex_count * 4)
            return Issue{IssueCode::glb_accessor_count, place(kJoints[set]).text(),
                         fmt::format("expected {} elements, found {} joints and {} weights", vertex_count,
                                     joints.value().size() / 4, weights.value().size() / 4)};
        const std::span<const std::uint16_t> joint_map =
            std::span(context_.animal.joint_map).subspan(mesh_.first_joint, mesh_.joint_count);
        for (std::size_t i = 0; i < vertex_count * 4; ++i) {
            const std::uint32_t joint = joints.value()[i];
            const float weight = weights.value()[i];
            // An unused influence may hold anything (the weight says it is unused).
            if (joint >= joint_map.size() && weight != 0.0f)
                return Issue{IssueCode::glb_joint_index, place(kJoints[set]).text(),
                             fmt::format("expected joints below {}, found {} at vertex {}", joint_map.size(),
                                         joint, i / 4)};
            const std::size_t slot = i / 4 * out_.influences + set * 4 + i % 4;
            out_.bones[slot] = joint < joint_map.size() ? joint_map[joint] : std::uint16_t{0};
            out_.weights[slot] = weight;
        }
        return {};
    }

    ReadContext& context_;
    const Mesh& mesh_;
    std::size_t index_;
    const tinygltf::Primitive& source_;
    std::optional<DracoMesh> draco_;
    Primitive out_;
};

}  // namespace

base::Result<Primitive> read_primitive(ReadContext& context, const Mesh& mesh, std::size_t index) {
    return PrimitiveReader(context, mesh, index).read();
}

}  // namespace posepack::animal
