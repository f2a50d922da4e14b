// SPDX-License-Identifier: MIT
#include "support/model_spec.hpp"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

namespace posepack::support {
namespace {

glm::dmat4 local_of(const Json& node) {
    glm::dmat4 local(1.0);
    if (node.contains("matrix")) {
        for (int i = 0; i < 16; ++i) local[i / 4][i % 4] = node.at("matrix").at(static_cast<std::size_t>(i));
        return local;
    }
    if (node.contains("rotation")) {
        const Json& q = node.at("rotation");
        local = glm::dmat4(glm::normalize(glm::dquat(q.at(3), q.at(0), q.at(1), q.at(2))));
    }
    for (int c = 0; c < 3; ++c) {
        if (node.contains("scale"))
            local[c] *= node.at("scale").at(static_cast<std::size_t>(c)).get<double>();
        if (node.contains("translation"))
            local[3][c] = node.at("translation").at(static_cast<std::size_t>(c));
    }
    return local;
}

int parent_of(const std::vector<Json>& nodes, int node) {
    for (std::size_t n = 0; n < nodes.size(); ++n)
        for (const Json& child : nodes[n].value("children", Json::array()))
            if (child == node) return static_cast<int>(n);
    return -1;
}

void add_mesh(GlbBuilder& glb, const MeshSpec& mesh) {
    Json attributes{{"POSITION", glb.add_values(mesh.positions, "VEC3")}};
    if (!mesh.normals.empty()) attributes["NORMAL"] = glb.add_values(mesh.normals, "VEC3");
    attributes["JOINTS_0"] = glb.add_values(mesh.joints, "VEC4");
    attributes["WEIGHTS_0"] = glb.add_values(mesh.weights, "VEC4");
    const Json primitive{{"attributes", attributes}};
    const int index = glb.add("meshes", {{"name", mesh.name}, {"primitives", Json::array({primitive})}});
    glb.add("nodes", {{"name", mesh.name + " node"}, {"mesh", index}, {"skin", mesh.skin}});
}

void add_clip(GlbBuilder& glb, const ClipSpec& clip) {
    Json animation{{"name", clip.name}, {"channels", Json::array()}, {"samplers", Json::array()}};
    for (const ChannelSpec& channel : clip.channels) {
        const bool rotation = channel.path == "rotation";
        animation["channels"].push_back({{"sampler", animation["samplers"].size()},
                                         {"target", {{"node", channel.node}, {"path", channel.path}}}});
        const int input = glb.add_values(channel.times, "SCALAR");
        const int output = glb.add_values(channel.values, rotation ? "VEC4" : "VEC3");
        animation["samplers"].push_back(
            {{"input", input}, {"output", output}, {"interpolation", channel.interpolation}});
    }
    glb.add("animations", std::move(animation));
}

}  // namespace

GlbBuilder builder_of(const ModelSpec& spec) {
    GlbBuilder glb;
    for (const Json& node : spec.nodes) glb.add("nodes", node);
    for (const MeshSpec& mesh : spec.meshes) add_mesh(glb, mesh);
    for (const SkinSpec& skin : spec.skins) {
        Json out{{"joints", skin.joints}};
        if (!skin.inverse_binds.empty()) {
            std::vector<float> numbers;
            for (const Matrix16& m : skin.inverse_binds) numbers.insert(numbers.end(), m.begin(), m.end());
            out["inverseBindMatrices"] = glb.add_values(numbers, "MAT4");
        }
        glb.add("skins", std::move(out));
    }
    for (const ClipSpec& clip : spec.clips) add_clip(glb, clip);
    return glb;
}

Bytes glb_of(const ModelSpec& spec) {
    return builder_of(spec).build();
}

std::vector<Matrix16> inverse_binds_of(const std::vector<Json>& nodes, const std::vector<int>& joints) {
    std::vector<Matrix16> out;
    for (const int joint : joints) {
        glm::dmat4 global(1.0);
        for (int n = joint; n >= 0; n = parent_of(nodes, n))
            global = local_of(nodes[static_cast<std::size_t>(n)]) * global;
        const glm::dmat4 inverse = glm::inverse(global);
        Matrix16 floats{};
        for (int i = 0; i < 16; ++i)
            floats[static_cast<std::size_t>(i)] = static_cast<float>(inverse[i / 4][i % 4]);
        out.push_back(floats);
    }
    return out;
}

std::array<float, 4> turn(double degrees, double x, double y, double z) {
    const double half = degrees * 3.14159265358979323846 / 360.0;
    const double length = std::sqrt(x * x + y * y + z * z);
    const double s = std::sin(half) / length;
    return {static_cast<float>(x * s), static_cast<float>(y * s), static_cast<float>(z * s),
            static_cast<float>(std::cos(half))};
}

std::vector<float> turns(const std::vector<std::array<float, 4>>& rotations) {
    std::vector<float> out;
    for (const auto& q : rotations) out.insert(out.end(), q.begin(), q.end());
    return out;
}

std::vector<float> grid(std::size_t count, double rate_hz, double first_s) {
    std::vector<float> times;
    for (std::size_t k = 0; k < count; ++k)
        times.push_back(static_cast<float>(first_s + static_cast<double>(k) / rate_hz));
    return times;
}

}  // namespace posepack::support
