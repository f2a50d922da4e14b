// SPDX-License-Identifier: MIT
#include "glb_probe.hpp"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstring>
#include <map>

namespace posepack::menagerie {
namespace {

using nlohmann::json;

std::uint32_t word_at(const std::vector<std::uint8_t>& bytes, std::size_t offset) {
    return bytes.at(offset) | bytes.at(offset + 1) << 8 | bytes.at(offset + 2) << 16 |
           static_cast<std::uint32_t>(bytes.at(offset + 3)) << 24;
}

double component_at(const std::string& bytes, std::size_t offset, int type) {
    if (type == 5121) return static_cast<unsigned char>(bytes.at(offset));
    if (type == 5123) {
        std::uint16_t value = 0;
        std::memcpy(&value, bytes.substr(offset, 2).data(), 2);
        return value;
    }
    float value = 0.0f;
    std::memcpy(&value, bytes.substr(offset, 4).data(), 4);
    return value;
}

struct Local {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
};

void set(Local& local, const std::string& path, const std::vector<double>& v) {
    if (path == "translation") local.translation = {v.at(0), v.at(1), v.at(2)};
    if (path == "rotation") local.rotation = {v.at(3), v.at(0), v.at(1), v.at(2)};
    if (path == "scale") local.scale = {v.at(0), v.at(1), v.at(2)};
}

glm::dmat4 matrix_of(const Local& local) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), local.translation);
    return glm::scale(moved * glm::mat4_cast(local.rotation), local.scale);
}

}  // namespace

GlbProbe::GlbProbe(const std::vector<std::uint8_t>& glb) {
    EXPECT_EQ(word_at(glb, 0), 0x46546C67u);
    EXPECT_EQ(word_at(glb, 4), 2u);
    EXPECT_EQ(word_at(glb, 8), glb.size());
    const std::uint32_t json_size = word_at(glb, 12);
    EXPECT_EQ(word_at(glb, 16), 0x4E4F534Au);
    document_ = json::parse(glb.begin() + 20, glb.begin() + 20 + json_size);
    const std::size_t binary = 20 + json_size;
    EXPECT_EQ(word_at(glb, binary + 4), 0x004E4942u);
    EXPECT_EQ(word_at(glb, binary) + binary + 8, glb.size());
    binary_.assign(glb.begin() + static_cast<std::ptrdiff_t>(binary) + 8, glb.end());
}

const std::vector<std::vector<double>>& GlbProbe::values(int accessor) const {
    const auto [known, is_new] = known_.try_emplace(accessor);
    std::vector<std::vector<double>>& elements = known->second;
    if (!is_new) return elements;
    static const std::map<std::string, std::size_t> kCounts = {
        {"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const json& described = document_.at("accessors").at(static_cast<std::size_t>(accessor));
    const json& view = document_.at("bufferViews").at(described.at("bufferView").get<std::size_t>());
    const int type = described.at("componentType");
    const std::size_t size = type == 5121 ? 1 : type == 5123 ? 2 : 4;
    std::size_t offset =
        view.at("byteOffset").get<std::size_t>() + described.value("byteOffset", std::size_t{0});
    elements.resize(described.at("count").get<std::size_t>());
    for (std::vector<double>& element : elements) {
        for (std::size_t index = 0; index < kCounts.at(described.at("type")); ++index, offset += size) {
            element.push_back(component_at(binary_, offset, type));
        }
    }
    return elements;
}

const json& GlbProbe::animation(std::string_view name) const {
    for (const json& animation : document_.at("animations")) {
        const std::string full = animation.at("name");
        if (full.substr(full.rfind('|') + 1) == name) return animation;
    }
    ADD_FAILURE() << "no animation " << name;
    return document_.at("animations").at(0);
}

std::vector<double> GlbProbe::key_times(const json& animation) const {
    std::vector<double> longest;
    for (const json& sampler : animation.at("samplers")) {
        std::vector<double> times;
        for (const std::vector<double>& time : values(sampler.at("input"))) times.push_back(time.at(0));
        if (times.size() > longest.size()) longest = times;
    }
    return longest;
}

std::vector<glm::dmat4> GlbProbe::globals(const json& animation, std::size_t key) const {
    const json& nodes = document_.at("nodes");
    std::vector<Local> locals(nodes.size());
    for (std::size_t index = 0; index < nodes.size(); ++index) {
        for (const char* path : {"translation", "rotation", "scale"}) {
            if (nodes[index].contains(path))
                set(locals[index], path, nodes[index][path].get<std::vector<double>>());
        }
    }
    for (const json& channel : animation.at("channels")) {
        const json& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
        const auto& output = values(sampler.at("output"));
        // Each key of a cubic spline has its slopes before and behind its value (glTF 2.0, appendix C).
        const bool cubic = sampler.value("interpolation", "LINEAR") == "CUBICSPLINE";
        const std::size_t values_a_key = cubic ? 3 : 1;
        const std::size_t held = output.size() == 2 * values_a_key ? 0 : key;
        set(locals.at(channel.at("target").at("node").get<std::size_t>()), channel.at("target").at("path"),
            output.at(held * values_a_key + (cubic ? 1 : 0)));
    }
    std::vector<glm::dmat4> globals(nodes.size());
    for (std::size_t index = 0; index < nodes.size(); ++index) globals[index] = matrix_of(locals[index]);
    for (std::size_t index = 0; index < nodes.size(); ++index) {  // parents stand before children
        for (const json& child : nodes[index].value("children", json::array())) {
            EXPECT_GT(child.get<std::size_t>(), index);
            glm::dmat4& matrix = globals.at(child.get<std::size_t>());
            matrix = globals[index] * matrix;
        }
    }
    return globals;
}

std::size_t GlbProbe::node(std::string_view name) const {
    const json& nodes = document_.at("nodes");
    for (std::size_t index = 0; index < nodes.size(); ++index) {
        if (nodes[index].value("name", "") == name) return index;
    }
    ADD_FAILURE() << "no node " << name;
    return 0;
}

double GlbProbe::largest_gap_m(const json& animation, std::size_t key_a, std::size_t key_b) const {
    const std::vector<glm::dmat4> a = globals(animation, key_a);
    const std::vector<glm::dmat4> b = globals(animation, key_b);
    double largest = 0.0;
    for (std::size_t index = 0; index < a.size(); ++index) {
        largest = std::max(largest, glm::length(glm::dvec3(a[index][3]) - glm::dvec3(b[index][3])));
    }
    return largest;
}

}  // namespace posepack::menagerie
