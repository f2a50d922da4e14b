// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <string_view>
#include <utility>

#include "menagerie/glb_buffer.hpp"
#include "menagerie/glb_values.hpp"
#include "menagerie/raw_model.hpp"

namespace posepack::menagerie {
namespace {

constexpr int kVertexTarget = 34962;

Payload payload_of(const std::vector<float>& numbers) {
    Payload payload;
    for (const float value : numbers) payload.put_f32(value);
    return payload;
}

// min and max as glTF 2.0, section 3.6.2.5 asks for, over the numbers that JSON can hold.
void bound(Json& accessor, const std::vector<float>& numbers, std::size_t width) {
    Json low = Json::array();
    Json high = Json::array();
    for (std::size_t part = 0; part < width; ++part) {
        float least = HUGE_VALF;
        float greatest = -HUGE_VALF;
        for (std::size_t i = part; i < numbers.size(); i += width) {
            if (!std::isfinite(numbers[i])) continue;
            least = std::min(least, numbers[i]);
            greatest = std::max(greatest, numbers[i]);
        }
        low.push_back(number(std::isfinite(least) ? static_cast<double>(least) : 0.0));
        high.push_back(number(std::isfinite(greatest) ? static_cast<double>(greatest) : 0.0));
    }
    accessor["min"] = std::move(low);
    accessor["max"] = std::move(high);
}

int add_vertex_floats(GlbBuffer& buffer, const std::vector<float>& numbers, std::size_t width) {
    const char* type = width == 3 ? "VEC3" : "VEC4";
    return buffer.add_accessor(payload_of(numbers), ComponentType::f32, type, numbers.size() / width,
                               kVertexTarget);
}

Json mesh_json(GlbBuffer& buffer, const RawModel& model) {
    Payload joints;
    for (const std::uint16_t joint : model.joints) joints.put_u16(joint);
    const int positions = add_vertex_floats(buffer, model.positions, 3);
    bound(buffer.accessor(positions), model.positions, 3);
    Json attributes{{"POSITION", positions},
                    {"NORMAL", add_vertex_floats(buffer, model.normals, 3)},
                    {"JOINTS_0", buffer.add_accessor(joints, ComponentType::u16, "VEC4",
                                                     model.joints.size() / 4, kVertexTarget)},
                    {"WEIGHTS_0", add_vertex_floats(buffer, model.weights, 4)}};
    // Points: no indices are needed, and nothing here reads them.
    return {{"name", model.name},
            {"primitives", Json::array({Json{{"attributes", std::move(attributes)}, {"mode", 0}}})}};
}

Json skin_json(GlbBuffer& buffer, const RawModel& model) {
    Payload matrices;
    Json joints = Json::array();
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
        for (const float value : model.inverse_binds[node]) matrices.put_f32(value);
        joints.push_back(node);
    }
    return {{"inverseBindMatrices",
             buffer.add_accessor(matrices, ComponentType::f32, "MAT4", model.nodes.size(), 0)},
            {"joints", std::move(joints)}};
}

// The joints, then the node of the mesh.
Json nodes_json(const RawModel& model) {
    std::vector<Json> children(model.nodes.size(), Json::array());
    for (std::size_t node = 0; node < model.nodes.size(); ++node)
        if (model.nodes[node].parent >= 0)
            children[static_cast<std::size_t>(model.nodes[node].parent)].push_back(node);
    Json nodes = Json::array();
    for (std::size_t index = 0; index < model.nodes.size(); ++index) {
        const RawNode& node = model.nodes[index];
        Json out{{"name", node.name},
                 {"translation", vector_json(node.translation)},
                 {"rotation", quaternion_json(node.rotation)},
                 {"scale", vector_json(node.scale)}};
        if (!children[index].empty()) out["children"] = std::move(children[index]);
        nodes.push_back(std::move(out));
    }
    nodes.push_back({{"name", model.name}, {"mesh", 0}, {"skin", 0}});
    return nodes;
}

Json clip_json(GlbBuffer& buffer, const RawClip& clip) {
    constexpr std::array kWords = {"LINEAR", "STEP", "CUBICSPLINE"};
    constexpr std::array kPaths = {"translation", "rotation", "scale"};
    Json samplers = Json::array();
    Json channels = Json::array();
    for (const RawChannel& channel : clip.channels) {
        const std::size_t width = channel.path == RawPath::rotation ? 4 : 3;
        const int times =
            buffer.add_animation_accessor(payload_of(channel.times_s), "SCALAR", channel.times_s.size());
        bound(buffer.accessor(times), channel.times_s, 1);
        const int values = buffer.add_animation_accessor(
            payload_of(channel.values), width == 4 ? "VEC4" : "VEC3", channel.values.size() / width);
        channels.push_back(
            {{"sampler", samplers.size()},
             {"target", {{"node", channel.node}, {"path", kPaths[static_cast<std::size_t>(channel.path)]}}}});
        samplers.push_back({{"input", times},
                            {"output", values},
                            {"interpolation", kWords[static_cast<std::size_t>(channel.interpolation)]}});
    }
    return {{"name", clip.name}, {"samplers", std::move(samplers)}, {"channels", std::move(channels)}};
}

glm::dmat4 local_of(const RawNode& node) {
    glm::dmat4 local(glm::mat3_cast(node.rotation));
    for (int axis = 0; axis < 3; ++axis) local[axis] *= node.scale[axis];
    local[3] = glm::dvec4(node.translation, 1.0);
    return local;
}

}  // namespace

void bind_at_rest(RawModel& model) {
    std::vector<glm::dmat4> globals;
    model.inverse_binds.clear();
    for (const RawNode& node : model.nodes) {
        const glm::dmat4 local = local_of(node);
        globals.push_back(node.parent < 0 ? local : globals[static_cast<std::size_t>(node.parent)] * local);
        const glm::dmat4 inverse = glm::inverse(globals.back());
        std::array<float, 16>& out = model.inverse_binds.emplace_back();
        for (int i = 0; i < 16; ++i)
            out[static_cast<std::size_t>(i)] = static_cast<float>(inverse[i / 4][i % 4]);
        for (std::size_t column = 0; column < 4; ++column) out[column * 4 + 3] = column == 3 ? 1.0f : 0.0f;
    }
}

std::vector<std::uint8_t> write_glb(const RawModel& model) {
    GlbBuffer buffer;
    Json roots = Json::array();
    for (std::size_t node = 0; node < model.nodes.size(); ++node)
        if (model.nodes[node].parent < 0) roots.push_back(node);
    roots.push_back(model.nodes.size());
    Json document{{"asset", {{"version", "2.0"}, {"generator", "posepack menagerie"}}},
                  {"scene", 0},
                  {"scenes", Json::array({{{"nodes", std::move(roots)}}})},
                  {"nodes", nodes_json(model)},
                  {"meshes", Json::array({mesh_json(buffer, model)})},
                  {"skins", Json::array({skin_json(buffer, model)})}};
    Json animations = Json::array();
    for (const RawClip& clip : model.clips) animations.push_back(clip_json(buffer, clip));
    document["animations"] = std::move(animations);
    const std::string bytes = buffer.finish(document);
    return pack_glb(document.dump(), bytes);
}

}  // namespace posepack::menagerie
