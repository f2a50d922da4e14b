// SPDX-License-Identifier: MIT
// Every way that glTF stores numbers gives the numbers that were meant.
#include <gtest/gtest.h>

#include <functional>

#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using support::GlbBuilder;
using support::Json;
using Position = std::array<float, 3>;

// Two vertices on one joint that moves.
GlbBuilder two_vertices() {
    support::ModelSpec spec = support::one_bone({1, 2, 3, -4, 5, -6});
    spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    return support::builder_of(spec);
}

Json& attributes(GlbBuilder& glb) {
    return glb.document["meshes"][0]["primitives"][0]["attributes"];
}

std::vector<Position> positions(const GlbBuilder& glb) {
    return support::read_good(glb.build()).vertices.positions;
}

TEST(Accessors, InterleavedStrides) {
    GlbBuilder glb = two_vertices();
    // position, a float of another use, normal: 28 bytes a vertex, after 8 bytes of something else.
    const int view =
        glb.add_view_of(std::vector<float>{99, 99, 1, 2, 3, 77, 0, 1, 0, -4, 5, -6, 77, 0, 0, -1}, 28);
    attributes(glb)["POSITION"] = glb.add_accessor(view, 8, support::kF32, 2, "VEC3");
    attributes(glb)["NORMAL"] = glb.add_accessor(view, 24, support::kF32, 2, "VEC3");
    const Animal animal = support::read_good(glb.build());
    EXPECT_EQ(animal.vertices.positions, (std::vector<Position>{{1, 2, 3}, {-4, 5, -6}}));
    EXPECT_EQ(animal.vertices.normals, (std::vector<Position>{{0, 1, 0}, {0, 0, -1}}));
}

TEST(Accessors, AMissingNormalIsZero) {
    EXPECT_EQ(support::read_good(two_vertices().build()).vertices.normals, (std::vector<Position>(2)));
}

TEST(Accessors, NormalisedIntegers) {
    struct Row {
        std::function<int(GlbBuilder&)> add;
        Position first, second;
    };
    const Row rows[] = {
        {[](auto& g) {
             return g.add_values(std::vector<std::uint8_t>{0, 51, 255, 255, 0, 102}, "VEC3", true);
         },
         {0.0f, 51.0f / 255, 1.0f},
         {1.0f, 0.0f, 102.0f / 255}},
        {[](auto& g) {
             return g.add_values(std::vector<std::uint16_t>{0, 13107, 65535, 1, 2, 3}, "VEC3", true);
         },
         {0.0f, 13107.0f / 65535, 1.0f},
         {1.0f / 65535, 2.0f / 65535, 3.0f / 65535}},
        {[](auto& g) {
             return g.add_values(std::vector<std::int8_t>{-128, -127, 127, 0, 1, -1}, "VEC3", true);
         },
         {-1.0f, -1.0f, 1.0f},
         {0.0f, 1.0f / 127, -1.0f / 127}},
        {[](auto& g) {
             return g.add_values(std::vector<std::int16_t>{-32768, -32767, 32767, 0, 1, -1}, "VEC3", true);
         },
         {-1.0f, -1.0f, 1.0f},
         {0.0f, 1.0f / 32767, -1.0f / 32767}},
        {[](auto& g) {
             return g.add_values(std::vector<std::int16_t>{-32768, 7, 32767, 0, 1, -1}, "VEC3");
         },
         {-32768.0f, 7.0f, 32767.0f},
         {0.0f, 1.0f, -1.0f}},
        {[](auto& g) {
             return g.add_values(std::vector<std::uint8_t>{0, 51, 255, 1, 2, 3}, "VEC3");
         },
         {0.0f, 51.0f, 255.0f},
         {1.0f, 2.0f, 3.0f}},
    };
    for (const Row& row : rows) {
        GlbBuilder glb = two_vertices();
        attributes(glb)["POSITION"] = row.add(glb);
        EXPECT_EQ(positions(glb), (std::vector<Position>{row.first, row.second}));
    }
}

TEST(Accessors, JointsAndWeightsOfBytes) {
    GlbBuilder glb = two_vertices();
    attributes(glb)["JOINTS_0"] = glb.add_values(std::vector<std::uint8_t>(8, 0), "VEC4");
    attributes(glb)["WEIGHTS_0"] =
        glb.add_values(std::vector<std::uint8_t>{255, 0, 0, 0, 127, 128, 0, 0}, "VEC4", true);
    const Animal animal = support::read_good(glb.build());
    EXPECT_TRUE(animal.findings.empty());
    for (const auto& weights : animal.vertices.weights) EXPECT_EQ(weights, (InfluenceWeights{1, 0, 0, 0}));
}

TEST(Accessors, RotationsOfShorts) {
    support::ModelSpec spec = support::one_bone();
    spec.clips = {{"Turn", {{0, "rotation", {0, 1}, {0, 0, 0, 1, 1, 0, 0, 0}}}}};
    GlbBuilder glb = support::builder_of(spec);
    glb.document["animations"][0]["samplers"][0]["output"] =
        glb.add_values(std::vector<std::int16_t>{0, 0, 0, 32767, 23170, 0, 0, 23170}, "VEC4", true);
    const Animal animal = support::read_good(glb.build());
    EXPECT_TRUE(animal.findings.empty()) << "rounded to shorts, a rotation is unit enough";
    const float* second = &animal.key_values[animal.clips[0].channels[0].first_value + 4];
    EXPECT_EQ(second[0], 23170.0f / 32767);
    EXPECT_EQ(second[3], 23170.0f / 32767);
}

// Two of two: sparse values over a view, and over nothing (zeros); indices of every size.
TEST(Accessors, Sparse) {
    const auto run = [](auto index, int base_view_of_positions) {
        GlbBuilder glb = two_vertices();
        const int indices = glb.add_view_of(std::vector<decltype(index)>{index});
        // A stride on the values' view is ignored: they are tightly packed.
        const int values = glb.add_view_of(std::vector<float>{7, 8, 9});
        const int accessor = glb.add_accessor(base_view_of_positions, 0, support::kF32, 2, "VEC3");
        glb.document["accessors"][static_cast<std::size_t>(accessor)]["sparse"] = {
            {"count", 1},
            {"indices",
             {{"bufferView", indices}, {"componentType", support::component_of<decltype(index)>()}}},
            {"values", {{"bufferView", values}}}};
        attributes(glb)["POSITION"] = accessor;
        return positions(glb);
    };
    const std::vector<Position> over_view{{1, 2, 3}, {7, 8, 9}};
    EXPECT_EQ(run(std::uint8_t{1}, 0), over_view);
    EXPECT_EQ(run(std::uint16_t{1}, 0), over_view);
    EXPECT_EQ(run(std::uint32_t{1}, 0), over_view);
    EXPECT_EQ(run(std::uint16_t{0}, -1), (std::vector<Position>{{7, 8, 9}, {0, 0, 0}}));
}

TEST(Accessors, SparseOffsets) {
    GlbBuilder glb = two_vertices();
    const int indices = glb.add_view_of(std::vector<std::uint16_t>{9, 0, 1});
    const int values = glb.add_view_of(std::vector<float>{99, 7, 8, 9, 10, 11, 12});
    const int accessor = glb.add_accessor(0, 0, support::kF32, 2, "VEC3");
    glb.document["accessors"][static_cast<std::size_t>(accessor)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"byteOffset", 2}, {"componentType", support::kU16}}},
        {"values", {{"bufferView", values}, {"byteOffset", 4}}}};
    attributes(glb)["POSITION"] = accessor;
    EXPECT_EQ(positions(glb), (std::vector<Position>{{7, 8, 9}, {10, 11, 12}}));
}

}  // namespace
}  // namespace posepack::animal
