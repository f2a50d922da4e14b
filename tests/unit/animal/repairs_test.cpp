// SPDX-License-Identifier: MIT
// What the default reading mends, how it says so, and what stays good without a word.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using base::IssueCode;
using support::GlbBuilder;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

GlbBuilder good() {
    return support::builder_of(support::tail());
}

Animal mended(const GlbBuilder& glb) {
    return support::read_good(glb.build());
}

// The finding with this code; fails when there is not exactly one.
base::Issue only_finding(const Animal& animal, IssueCode code) {
    base::Issue found;
    int count = 0;
    for (const base::Issue& finding : animal.findings)
        if (finding.code == code) found = finding, ++count;
    EXPECT_EQ(count, 1) << base::issue_kind(code).id;
    return found;
}

TEST(Repairs, AGoodFileHasNone) {
    EXPECT_TRUE(mended(good()).findings.empty());
}

TEST(Repairs, WeightsAreCountedInVertices) {
    GlbBuilder glb = good();
    for (const std::size_t vertex : {0u, 1u, 2u})
        glb.set(glb.attribute(0, "WEIGHTS_0"), vertex * 4 + 1, kNan);
    const Animal animal = mended(glb);
    const base::Issue finding = only_finding(animal, IssueCode::warn_weights);
    EXPECT_EQ(finding.where, "meshes/0/primitives/0");
    EXPECT_NE(finding.detail.find("found 3 vertices "), std::string::npos) << finding.detail;
    EXPECT_EQ(animal.vertices.weights[0], (InfluenceWeights{1, 0, 0, 0}));
}

TEST(Repairs, AVertexWithoutWeightsFollowsItsNeighbour) {
    GlbBuilder glb = good();
    for (std::size_t i = 0; i < 4; ++i) glb.set(glb.attribute(0, "WEIGHTS_0"), 4 * 4 + i, 0.0f);
    const Animal animal = mended(glb);
    only_finding(animal, IssueCode::warn_weights);
    EXPECT_EQ(animal.vertices.weights[4], animal.vertices.weights[5]);
    EXPECT_EQ(animal.vertices.bones[4], animal.vertices.bones[5]);
}

TEST(Repairs, EqualTimesAreCounted) {
    GlbBuilder glb = good();
    glb.set(glb.times(2, 0), 1, 0.5f);
    const Animal animal = mended(glb);
    EXPECT_EQ(only_finding(animal, IssueCode::warn_times).where, "animations/2");
    EXPECT_EQ(animal.clips.size(), 3u);
}

TEST(Repairs, RotationsBecomeUnit) {
    GlbBuilder glb = good();
    for (std::size_t c = 0; c < 4; ++c) glb.set(glb.values(0, 0), 8 + c, c == 3 ? 2.0f : 0.0f);
    const Animal animal = mended(glb);
    only_finding(animal, IssueCode::warn_quat);
    EXPECT_EQ(animal.key_values[animal.clips[0].channels[0].first_value + 11], 1.0f);
}

TEST(Repairs, TheLastChannelOnATargetWins) {
    GlbBuilder glb = good();
    auto& animation = glb.document["animations"][2];
    const int values = glb.add_values(std::vector<float>(9, 0.75f), "VEC3");
    animation["samplers"].push_back({{"input", animation["samplers"][0]["input"]}, {"output", values}});
    animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 3}, {"path", "translation"}}}});
    const Animal animal = mended(glb);
    only_finding(animal, IssueCode::warn_channel);
    ASSERT_EQ(animal.clips[2].channels.size(), 1u);
    EXPECT_EQ(animal.key_values[animal.clips[2].channels[0].first_value], 0.75f);
    EXPECT_EQ(animal.clips[2].channels[0].interpolation, Interpolation::linear);
}

TEST(Repairs, WhatThePaletteCannotMoveIsNamed) {
    GlbBuilder glb = good();
    glb.add("nodes", {{"name", "Saddle"}, {"mesh", 0}});
    auto& primitive = glb.document["meshes"][0]["primitives"][0];
    primitive["targets"] = {{{"POSITION", primitive["attributes"]["POSITION"]}}};
    auto& animation = glb.document["animations"][0];
    animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", 5}, {"path", "weights"}}}});
    const Animal animal = mended(glb);
    const auto left_out =
        std::count_if(animal.findings.begin(), animal.findings.end(),
                      [](const base::Issue& f) { return f.code == IssueCode::warn_left_out; });
    EXPECT_EQ(left_out, 3) << "a rigid mesh, morph targets, a channel of morph weights";
    const auto says = [&](const std::string& part) {
        return std::count_if(animal.findings.begin(), animal.findings.end(),
                             [&](const base::Issue& f) { return f.detail.find(part) != std::string::npos; });
    };
    EXPECT_EQ(says("1 rigid mesh that nothing moves: not in the palette (Saddle)"), 1);
    EXPECT_EQ(says("'Rig|Wag' blends morph targets of 'Skin'"), 1) << "the clip and the mesh";
    EXPECT_EQ(animal.clips[0].channels.size(), 2u);
}

// Sets `first` and on, each with a quarter of the weight of every vertex on joint 1, the first set with what
// is left.
void add_sets(GlbBuilder& glb, int first, int count) {
    auto& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
    for (int set = first; set < first + count; ++set) {
        std::vector<std::uint16_t> joints(12 * 4, 0);
        std::vector<float> weights(12 * 4, 0.0f);
        for (std::size_t v = 0; v < 12; ++v) joints[v * 4] = 1, weights[v * 4] = 0.25f;
        attributes["JOINTS_" + std::to_string(set)] = glb.add_values(joints, "VEC4");
        attributes["WEIGHTS_" + std::to_string(set)] = glb.add_values(weights, "VEC4");
    }
}

TEST(Repairs, SetsOfInfluencesThatAreNotReadAreNamed) {
    struct Case {
        int first, count;
        const char* unread;  // nothing: all sets are read
    };
    for (const Case& c : {Case{1, 2, nullptr},
                          {1, 3, nullptr},
                          {1, 4, ": JOINTS_4, WEIGHTS_4"},
                          {1, 5, ": JOINTS_4, JOINTS_5, WEIGHTS_4, WEIGHTS_5"},
                          {2, 1, ": JOINTS_2, WEIGHTS_2"}}) {
        GlbBuilder glb = good();
        add_sets(glb, c.first, c.count);
        const Animal animal = mended(glb);
        const auto left_out = std::count_if(
            animal.findings.begin(), animal.findings.end(),
            [](const base::Issue& finding) { return finding.code == IssueCode::warn_left_out; });
        EXPECT_EQ(left_out, c.unread == nullptr ? 0 : 1) << c.first << " " << c.count;
        if (c.unread == nullptr) continue;
        const base::Issue finding = only_finding(animal, IssueCode::warn_left_out);
        EXPECT_EQ(finding.where, "meshes/0/primitives/0");
        EXPECT_TRUE(finding.detail.ends_with(c.unread)) << finding.detail;
        const auto strict = read_animal(glb.build(), {true});
        ASSERT_FALSE(strict);
        EXPECT_EQ(strict.issue().code, IssueCode::glb_weights);
    }
}

// Twelve and sixteen influences count with all their weight: three quarters of it lie on joint 1 here.
TEST(Repairs, UpToSixteenInfluencesAreRead) {
    for (const int sets : {3, 4}) {
        GlbBuilder glb = good();
        for (std::size_t i = 0; i < 12 * 4; ++i) glb.set(glb.attribute(0, "WEIGHTS_0"), i, 0.0f);
        for (std::size_t v = 0; v < 12; ++v) {
            glb.set(glb.attribute(0, "JOINTS_0"), v * 4, std::uint16_t{0});
            glb.set(glb.attribute(0, "WEIGHTS_0"), v * 4, 1.0f - 0.25f * static_cast<float>(sets - 1));
        }
        add_sets(glb, 1, sets - 1);
        const Animal animal = mended(glb);
        EXPECT_TRUE(animal.findings.empty());
        const std::uint16_t bone = animal.joint_map[1];
        float weight = 0.0f;
        for (std::size_t i = 0; i < kMaxInfluences; ++i)
            if (animal.vertices.bones[0][i] == bone) weight += animal.vertices.weights[0][i];
        EXPECT_FLOAT_EQ(weight, 0.25f * static_cast<float>(sets - 1)) << sets;
    }
}

TEST(Repairs, APrimitiveWithoutJointsIsLeftOut) {
    GlbBuilder glb = good();
    auto& primitives = glb.document["meshes"][0]["primitives"];
    auto bare = primitives[0];
    bare["attributes"].erase("JOINTS_0");
    primitives.push_back(bare);
    const Animal animal = mended(glb);
    EXPECT_EQ(only_finding(animal, IssueCode::warn_left_out).where, "meshes/0/primitives/1");
    EXPECT_EQ(animal.meshes[0].vertex_count, 12u);
}

TEST(Repairs, AnUnknownChunkIsSkipped) {
    support::Bytes bytes = good().build();
    const support::Bytes more{4, 0, 0, 0, 'X', 'T', 'R', 'A', 1, 2, 3, 4};
    bytes.insert(bytes.end(), more.begin(), more.end());
    for (std::size_t i = 0; i < 4; ++i) bytes[8 + i] = static_cast<std::uint8_t>(bytes.size() >> (8 * i));
    const Animal animal = support::read_good(bytes);
    only_finding(animal, IssueCode::warn_glb_chunk);
    EXPECT_EQ(animal.vertices.positions, mended(good()).vertices.positions);
    EXPECT_EQ(animal.key_values, mended(good()).key_values);
}

TEST(Repairs, AnUnusedInfluenceMayNameAnything) {
    GlbBuilder glb = good();
    glb.set(glb.attribute(0, "JOINTS_0"), 3, std::uint16_t{65535});
    EXPECT_TRUE(mended(glb).findings.empty());
}

// Files that must not be refused though they hold odd things.
TEST(Repairs, HarmlessThingsPassWithoutAWord) {
    GlbBuilder glb = good();
    glb.document["images"] = {{{"uri", "a`touch x`"}}, {{"uri", "file:///etc/hostname"}}};
    glb.document["extensionsRequired"] = {"KHR_materials_unlit", "KHR_mesh_quantization"};
    glb.document["extensionsUsed"] = glb.document["extensionsRequired"];
    glb.document["extras"] = {{"uri", "not a buffer"}, {"deep", {{"buffers", {{{"uri", "x"}}}}}}};
    glb.document["nodes"][5]["translation"] = {5, 6, 7};  // a skinned node's own transform is ignored
    EXPECT_TRUE(mended(glb).findings.empty());
}

}  // namespace
}  // namespace posepack::animal
