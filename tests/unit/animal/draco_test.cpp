// SPDX-License-Identifier: MIT
// KHR_draco_mesh_compression: both methods give the vertices that were stored; streams that ask for more than
// their accessors declare, or do not decode, are refused by name.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <tuple>

#include "animal/draco_mesh.hpp"
#include "animal/read_animal.hpp"
#include "support/compression.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using base::IssueCode;
using support::Bytes;
using support::DracoOptions;
using support::GlbBuilder;
using support::Json;

// A vertex with all it has; Draco may put them in another order.
using Vertex = std::tuple<std::array<float, 3>, std::array<float, 3>, InfluenceBones, InfluenceWeights>;

std::vector<Vertex> sorted_vertices(const Animal& animal) {
    std::vector<Vertex> out;
    const Vertices& v = animal.vertices;
    for (std::size_t i = 0; i < v.positions.size(); ++i)
        out.emplace_back(v.positions[i], v.normals[i], v.bones[i], v.weights[i]);
    std::sort(out.begin(), out.end());
    return out;
}

GlbBuilder draco_tail(bool edgebreaker) {
    GlbBuilder glb = support::builder_of(support::tail());
    support::compress_primitive(glb, 0, {edgebreaker});
    return glb;
}

Json& extension_of(GlbBuilder& glb) {
    return glb.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
}

std::uint8_t* stream_of(GlbBuilder& glb) {
    return support::view_data(glb, extension_of(glb)["bufferView"].get<int>());
}

void expect_refused(const char* what, IssueCode code, const GlbBuilder& glb) {
    const auto animal = read_animal(glb.build());
    ASSERT_FALSE(animal) << what;
    EXPECT_EQ(animal.issue().code, code) << what << ": " << base::format_issue(animal.issue());
}

TEST(Draco, BothMethodsHoldWhatPlainDataHolds) {
    const Animal plain = support::animal_of(support::tail());
    for (const bool edgebreaker : {false, true}) {
        const Animal animal = support::read_good(draco_tail(edgebreaker).build());
        EXPECT_EQ(sorted_vertices(animal), sorted_vertices(plain)) << edgebreaker;
        EXPECT_EQ(animal.key_values, plain.key_values);
        EXPECT_TRUE(animal.findings.empty());
    }
}

// The number of indices bounds the faces; without indices the number of vertices does.
TEST(Draco, IndicesMayBeMissing) {
    GlbBuilder glb = draco_tail(true);
    glb.document["meshes"][0]["primitives"][0].erase("indices");
    EXPECT_TRUE(read_animal(glb.build()));
}

// Attributes beside the stream are read as always. Sequential streams keep the order of vertices.
TEST(Draco, AttributesBesideTheStream) {
    GlbBuilder glb = draco_tail(false);
    const Animal plain = support::animal_of(support::tail());
    std::vector<float> normals;
    for (std::size_t v = 0; v < plain.vertices.normals.size(); ++v) normals.insert(normals.end(), {1, 0, 0});
    extension_of(glb)["attributes"].erase("NORMAL");
    glb.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = glb.add_values(normals, "VEC3");
    const Animal animal = support::read_good(glb.build());
    EXPECT_EQ(animal.vertices.positions, plain.vertices.positions);
    EXPECT_EQ(animal.vertices.normals[5], (std::array<float, 3>{1, 0, 0}));
}

struct Lie {
    const char* what;
    IssueCode code;
    std::function<void(GlbBuilder&)> tell;
};

TEST(Draco, LiesAreRefused) {
    const Lie lies[] = {
        {"fewer vertices declared than the stream has", IssueCode::lim_decoded,
         [](GlbBuilder& g) { g.attribute(0, "POSITION")["count"] = 11; }},
        {"fewer indices declared than the stream has", IssueCode::lim_decoded,
         [](GlbBuilder& g) {
             const auto& primitive = g.document["meshes"][0]["primitives"][0];
             g.document["accessors"][primitive["indices"].get<std::size_t>()]["count"] = 9;
         }},
        {"no magic", IssueCode::glb_draco, [](GlbBuilder& g) { stream_of(g)[0] = 'd'; }},
        {"an older bitstream", IssueCode::glb_draco, [](GlbBuilder& g) { stream_of(g)[6] = 1; }},
        {"a point cloud", IssueCode::glb_draco, [](GlbBuilder& g) { stream_of(g)[7] = 0; }},
        {"an unknown method", IssueCode::glb_draco, [](GlbBuilder& g) { stream_of(g)[8] = 9; }},
        {"metadata that are none", IssueCode::glb_draco, [](GlbBuilder& g) { stream_of(g)[10] |= 0x80; }},
        {"no view", IssueCode::glb_draco, [](GlbBuilder& g) { extension_of(g).erase("bufferView"); }},
        {"a view that does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { extension_of(g)["bufferView"] = 99; }},
        {"a negative view", IssueCode::glb_reference,
         [](GlbBuilder& g) { extension_of(g)["bufferView"] = -1; }},
        {"no attributes", IssueCode::glb_draco, [](GlbBuilder& g) { extension_of(g).erase("attributes"); }},
        {"an id that the stream does not have", IssueCode::glb_draco,
         [](GlbBuilder& g) { extension_of(g)["attributes"]["POSITION"] = 3; }},
        {"another number of components", IssueCode::glb_draco,
         [](GlbBuilder& g) {
             extension_of(g)["attributes"]["POSITION"] = extension_of(g)["attributes"]["JOINTS_0"];
         }},
        {"lines", IssueCode::glb_draco,
         [](GlbBuilder& g) { g.document["meshes"][0]["primitives"][0]["mode"] = 1; }},
        {"a stream cut in half", IssueCode::glb_draco,
         [](GlbBuilder& g) {
             Json& view = g.document["bufferViews"][extension_of(g)["bufferView"].get<std::size_t>()];
             view["byteLength"] = view["byteLength"].get<int>() / 2;
         }},
        {"a stream of ten bytes", IssueCode::glb_draco,
         [](GlbBuilder& g) {
             g.document["bufferViews"][extension_of(g)["bufferView"].get<std::size_t>()]["byteLength"] = 10;
         }},
    };
    for (const Lie& lie : lies)
        for (const bool edgebreaker : {false, true}) {
            GlbBuilder glb = draco_tail(edgebreaker);
            lie.tell(glb);
            expect_refused(lie.what, lie.code, glb);
        }
}

// Numbers of faces and points in the header count before anything is decoded.
TEST(Draco, HeadersAreBounded) {
    for (const bool edgebreaker : {false, true}) {
        Bytes stream{'D', 'R', 'A', 'C', 'O', 2, 2, 1, static_cast<std::uint8_t>(edgebreaker ? 1 : 0), 0, 0};
        if (edgebreaker) stream.push_back(0);  // standard traversal
        for (int number = 0; number < 2; ++number)
            stream.insert(stream.end(), {0x80, 0x80, 0x80, 0x80, 0x04});  // 2^30 as a varint
        DecodeBudget budget(stream.size());
        const auto bounded = DracoMesh::decode(stream, {1'000, 1'000}, budget);
        ASSERT_FALSE(bounded);
        EXPECT_EQ(bounded.issue().code, IssueCode::lim_decoded);
        const auto capped = DracoMesh::decode(stream, {1ull << 31, 1ull << 31}, budget);
        ASSERT_FALSE(capped);
        EXPECT_EQ(capped.issue().code, IssueCode::lim_decoded) << "the accessors lie as well";
    }
}

// What a stream decodes to is looked at like everything else.
TEST(Draco, DecodedValuesAreChecked) {
    for (const bool edgebreaker : {false, true}) {
        GlbBuilder joints = support::builder_of(support::tail());
        joints.set<std::uint16_t>(joints.attribute(0, "JOINTS_0"), 4 * 4 + 1, 3);
        support::compress_primitive(joints, 0, {edgebreaker});
        expect_refused("a joint that the skin does not have", IssueCode::glb_joint_index, joints);

        GlbBuilder wide = support::builder_of(support::tail());
        wide.set<std::uint16_t>(wide.attribute(0, "JOINTS_0"), 5, 300);
        support::compress_primitive(wide, 0, {edgebreaker});
        wide.attribute(0, "JOINTS_0")["componentType"] = support::kU8;
        expect_refused("a joint that its component type does not hold", IssueCode::glb_draco, wide);
    }
    GlbBuilder positions = support::builder_of(support::tail());
    positions.set(positions.attribute(0, "POSITION"), 4, std::numeric_limits<float>::quiet_NaN());
    support::compress_primitive(positions, 0, {false});
    expect_refused("a position that is NaN", IssueCode::glb_number, positions);
}

// No byte of a stream that is changed leads out of memory or time (run with AddressSanitizer).
TEST(Draco, AnyByteMayChange) {
    for (const bool edgebreaker : {false, true}) {
        const GlbBuilder good = draco_tail(edgebreaker);
        GlbBuilder glb = good;
        const auto view = extension_of(glb)["bufferView"].get<std::size_t>();
        const auto begin = glb.document["bufferViews"][view]["byteOffset"].get<std::size_t>();
        const auto size = glb.document["bufferViews"][view]["byteLength"].get<std::size_t>();
        std::size_t refused = 0;
        for (std::size_t i = begin; i < begin + size; ++i)
            for (const int flip : {0x01, 0x80, 0xFF}) {
                glb.bin = good.bin;
                glb.bin[i] = static_cast<std::uint8_t>(glb.bin[i] ^ flip);
                if (!read_animal(glb.build())) ++refused;
            }
        EXPECT_GT(refused, size / 4);
    }
}

}  // namespace
}  // namespace posepack::animal
