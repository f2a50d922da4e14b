// SPDX-License-Identifier: MIT
#include "menagerie/glb_writer.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "menagerie/glb_buffer.hpp"

namespace posepack::menagerie {
namespace {

constexpr int kVertexTarget = 34962;
constexpr int kIndexTarget = 34963;
constexpr int kArmatureNode = 0;
constexpr int kMeshNode = 1;
constexpr int kFirstJointNode = 2;

Json number(double value) {
    const auto single = static_cast<float>(value);
    return base::widened(single == 0.0f ? 0.0f : single);
}

Json vector_json(const Vec3& v) {
    return Json::array({number(v.x), number(v.y), number(v.z)});
}

Json quaternion_json(const Quat& q) {
    return Json::array({number(q.x), number(q.y), number(q.z), number(q.w)});
}

void put_vector(Payload& payload, const Vec3& v) {
    for (const double value : {v.x, v.y, v.z}) payload.put_f32(static_cast<float>(value));
}

void put_quaternion(Payload& payload, const Quat& q) {
    for (const double value : {q.x, q.y, q.z, q.w}) payload.put_f32(static_cast<float>(value));
}

// A joint's transform in its parent's bone axes, as glTF wants it.
struct Local {
    Vec3 translation{};
    Quat rotation = kNoTurn;
};

Quat armature_turn(const ExportStyle& style) {
    return style.z_up_armature ? pitch(-90.0) : kNoTurn;
}

Local local_of(const Model& model, std::size_t index, const Quat& turn, const Vec3& shift) {
    const RigJoint& joint = model.rig.joints[index];
    const bool is_root = joint.parent < 0;
    const Vec3 origin = is_root ? Vec3(0.0) : model.rig.joints[static_cast<std::size_t>(joint.parent)].head;
    const Quat axes = glm::conjugate(is_root ? armature_turn(model.style)
                                             : model.rig.joints[static_cast<std::size_t>(joint.parent)].bone);
    return {axes * (joint.head - origin + shift) * (1.0 / model.style.armature_scale),
            glm::normalize(axes * turn * joint.bone)};
}

// Nodes: the armature, the skinned mesh, the joints.
Json nodes_of(const Model& model) {
    const std::vector<RigJoint>& joints = model.rig.joints;
    std::vector<Json> children(joints.size() + 1, Json::array());
    for (std::size_t index = 0; index < joints.size(); ++index) {
        children[static_cast<std::size_t>(joints[index].parent + 1)].push_back(kFirstJointNode +
                                                                               static_cast<int>(index));
    }
    Json armature{{"name", model.style.armature}, {"children", std::move(children[0])}};
    if (model.style.z_up_armature) armature["rotation"] = quaternion_json(armature_turn(model.style));
    if (model.style.armature_scale != 1.0) armature["scale"] = vector_json(Vec3(model.style.armature_scale));
    Json nodes = Json::array({std::move(armature), {{"name", model.name}, {"mesh", 0}, {"skin", 0}}});
    for (std::size_t index = 0; index < joints.size(); ++index) {
        const Local local = local_of(model, index, kNoTurn, Vec3(0.0));
        Json node{{"name", joints[index].name},
                  {"translation", vector_json(local.translation)},
                  {"rotation", quaternion_json(local.rotation)}};
        if (!children[index + 1].empty()) node["children"] = std::move(children[index + 1]);
        nodes.push_back(std::move(node));
    }
    return nodes;
}

int add_positions(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    Vec3 low = mesh.vertices.front().position;
    Vec3 high = low;
    for (const Vertex& vertex : mesh.vertices) {
        put_vector(payload, vertex.position);
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    const int accessor =
        buffer.add_accessor(payload, ComponentType::f32, "VEC3", mesh.vertices.size(), kVertexTarget);
    buffer.accessor(accessor)["min"] = vector_json(low);
    buffer.accessor(accessor)["max"] = vector_json(high);
    return accessor;
}

int add_normals(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) put_vector(payload, vertex.normal);
    return buffer.add_accessor(payload, ComponentType::f32, "VEC3", mesh.vertices.size(), kVertexTarget);
}

int add_colours(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) {
        for (const double value : {vertex.colour.x, vertex.colour.y, vertex.colour.z, 1.0}) {
            payload.put_u8(static_cast<std::uint32_t>(std::floor(value * 255.0 + 0.5)));
        }
    }
    return buffer.add_accessor(payload, ComponentType::u8, "VEC4", mesh.vertices.size(), kVertexTarget, true);
}

int add_joints(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) {
        for (const int joint : vertex.influences.joints) payload.put_u8(static_cast<std::uint32_t>(joint));
    }
    return buffer.add_accessor(payload, ComponentType::u8, "VEC4", mesh.vertices.size(), kVertexTarget);
}

int add_weights(GlbBuffer& buffer, const Mesh& mesh) {
    Payload payload;
    for (const Vertex& vertex : mesh.vertices) {
        for (const double weight : vertex.influences.weights) payload.put_f32(static_cast<float>(weight));
    }
    return buffer.add_accessor(payload, ComponentType::f32, "VEC4", mesh.vertices.size(), kVertexTarget);
}

Json mesh_json(GlbBuffer& buffer, const Model& model) {
    Payload indices;
    for (const std::uint16_t index : model.mesh.indices) indices.put_u16(index);
    Json attributes{{"POSITION", add_positions(buffer, model.mesh)},
                    {"NORMAL", add_normals(buffer, model.mesh)},
                    {"COLOR_0", add_colours(buffer, model.mesh)},
                    {"JOINTS_0", add_joints(buffer, model.mesh)},
                    {"WEIGHTS_0", add_weights(buffer, model.mesh)}};
    Json primitive{{"attributes", std::move(attributes)},
                   {"indices", buffer.add_accessor(indices, ComponentType::u16, "SCALAR",
                                                   model.mesh.indices.size(), kIndexTarget)},
                   {"material", 0}};
    return {{"name", model.name}, {"primitives", Json::array({std::move(primitive)})}};
}

// Inverse of T(head) R(bone) S(armature scale), column by column.
void put_inverse_bind(Payload& payload, const RigJoint& joint, double scale) {
    const Quat inverse = glm::conjugate(joint.bone);
    const double shrink = 1.0 / scale;
    for (const Vec3& axis : {kAxisX, kAxisY, kAxisZ}) {
        put_vector(payload, inverse * axis * shrink);
        payload.put_f32(0.0f);
    }
    put_vector(payload, inverse * -joint.head * shrink);
    payload.put_f32(1.0f);
}

Json skin_json(GlbBuffer& buffer, const Model& model) {
    Payload matrices;
    Json joints = Json::array();
    for (std::size_t index = 0; index < model.rig.joints.size(); ++index) {
        put_inverse_bind(matrices, model.rig.joints[index], model.style.armature_scale);
        joints.push_back(kFirstJointNode + static_cast<int>(index));
    }
    const int accessor =
        buffer.add_accessor(matrices, ComponentType::f32, "MAT4", model.rig.joints.size(), 0);
    return {{"name", model.style.armature},
            {"inverseBindMatrices", accessor},
            {"skeleton", kArmatureNode},
            {"joints", std::move(joints)}};
}

enum class Path { translation, rotation, scale };

constexpr std::array<std::string_view, 3> kPathNames = {"translation", "rotation", "scale"};

// The samplers and channels of one clip on their way into the document.
class ClipWriter {
 public:
    ClipWriter(GlbBuffer& buffer, const Model& model, const Clip& clip)
        : buffer_(buffer),
          model_(model),
          clip_(clip),
          all_times_(add_times(1)),
          end_times_(model.style.full_constant_keys ? all_times_ : add_times(clip.keys.size() - 1)) {}

    Json write() {
        for (std::size_t joint = 0; joint < model_.rig.joints.size(); ++joint) {
            add_channel(joint, Path::translation);
            add_channel(joint, Path::rotation);
            // Helpers directly under the armature are never scaled, and exporters know it.
            if (model_.rig.joints[joint].parent >= 0) add_channel(joint, Path::scale);
        }
        return {{"name", model_.style.armature + "|" + clip_.name},
                {"samplers", std::move(samplers_)},
                {"channels", std::move(channels_)}};
    }

 private:
    int add_times(std::size_t stride) {
        Payload payload;
        std::size_t count = 0;
        double last = 0.0;
        for (std::size_t key = 0; key < clip_.keys.size(); key += stride, ++count) {
            last = static_cast<double>(key) / clip_.rate_hz;
            payload.put_f32(static_cast<float>(last));
        }
        const int accessor = buffer_.add_animation_accessor(payload, "SCALAR", count);
        buffer_.accessor(accessor)["min"] = Json::array({0.0});
        buffer_.accessor(accessor)["max"] = Json::array({number(last)});
        return accessor;
    }

    std::vector<std::string> key_values(std::size_t joint, Path path) const {
        std::vector<std::string> values;
        Quat previous = kNoTurn;
        for (const Pose& pose : clip_.keys) {
            Local local = local_of(model_, joint, pose.turns[joint], pose.shifts[joint]);
            if (!values.empty() && glm::dot(previous, local.rotation) < 0.0) local.rotation = -local.rotation;
            previous = local.rotation;
            Payload payload;
            if (path == Path::translation) put_vector(payload, local.translation);
            if (path == Path::rotation) put_quaternion(payload, local.rotation);
            if (path == Path::scale) put_vector(payload, pose.scales[joint]);
            values.push_back(std::move(payload.bytes));
        }
        return values;
    }

    void add_channel(std::size_t joint, Path path) {
        std::vector<std::string> values = key_values(joint, path);
        bool is_constant = true;
        for (const std::string& value : values) is_constant = is_constant && value == values.front();
        const bool two_keys = is_constant && !model_.style.full_constant_keys;
        if (two_keys) values.resize(2);
        Payload payload;
        for (const std::string& value : values) payload.bytes += value;
        const int output =
            buffer_.add_animation_accessor(payload, path == Path::rotation ? "VEC4" : "VEC3", values.size());
        channels_.push_back({{"sampler", add_sampler(two_keys ? end_times_ : all_times_, output)},
                             {"target",
                              {{"node", kFirstJointNode + static_cast<int>(joint)},
                               {"path", kPathNames[static_cast<std::size_t>(path)]}}}});
    }

    // Channels with the same values share a sampler.
    int add_sampler(int input, int output) {
        const auto [place, is_new] = known_.try_emplace(output, static_cast<int>(samplers_.size()));
        if (is_new) samplers_.push_back({{"input", input}, {"output", output}});
        return place->second;
    }

    GlbBuffer& buffer_;
    const Model& model_;
    const Clip& clip_;
    int all_times_;
    int end_times_;
    std::map<int, int> known_;
    Json samplers_ = Json::array();
    Json channels_ = Json::array();
};

std::vector<std::uint8_t> glb_bytes(std::string json, const std::string& buffer) {
    json.resize((json.size() + 3u) & ~std::size_t{3}, ' ');
    Payload out;
    const auto put_u32 = [&out](std::size_t value) {
        out.put_u16(static_cast<std::uint32_t>(value));
        out.put_u16(static_cast<std::uint32_t>(value >> 16));
    };
    put_u32(0x46546C67u);  // "glTF"
    put_u32(2);
    put_u32(12 + 8 + json.size() + 8 + buffer.size());
    put_u32(json.size());
    put_u32(0x4E4F534Au);  // "JSON"
    out.bytes += json;
    put_u32(buffer.size());
    put_u32(0x004E4942u);  // "BIN"
    out.bytes += buffer;
    return {out.bytes.begin(), out.bytes.end()};
}

}  // namespace

std::vector<std::uint8_t> write_glb(const Model& model) {
    GlbBuffer buffer;
    Json document{{"asset", {{"version", "2.0"}, {"generator", "posepack menagerie"}}},
                  {"scene", 0},
                  {"scenes", Json::array({{{"nodes", {kArmatureNode, kMeshNode}}}})},
                  {"nodes", nodes_of(model)}};
    document["materials"] =
        Json::array({{{"name", "Hide"},
                      {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", number(0.8)}}}}});
    document["meshes"] = Json::array({mesh_json(buffer, model)});
    document["skins"] = Json::array({skin_json(buffer, model)});
    Json animations = Json::array();
    for (const Clip& clip : model.clips) animations.push_back(ClipWriter(buffer, model, clip).write());
    document["animations"] = std::move(animations);
    const std::string bytes = buffer.finish(document);
    return glb_bytes(document.dump(), bytes);
}

}  // namespace posepack::menagerie
