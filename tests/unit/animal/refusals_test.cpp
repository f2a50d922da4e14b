// SPDX-License-Identifier: MIT
// Every way in which read_animal says no: what is broken in a good file, and the code it must give.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using base::IssueCode;
using support::Bytes;
using support::GlbBuilder;
using support::Json;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Refusal {
    const char* what;
    IssueCode code;
    std::function<void(GlbBuilder&)> damage;
};

struct RawRefusal {
    const char* what;
    IssueCode code;
    std::function<Bytes(GlbBuilder)> make;
};

// The good file with a piece of its JSON text replaced.
Bytes with_text(const GlbBuilder& glb, const std::string& from, const std::string& to) {
    Json filled = glb.document;
    filled["buffers"][0]["byteLength"] = glb.bin.size();
    std::string text = filled.dump();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    return support::pack_glb(text, glb.bin);
}

Bytes with_byte(const GlbBuilder& glb, std::size_t offset, std::uint8_t value) {
    Bytes bytes = glb.build();
    bytes.at(offset) = value;
    return bytes;
}

Bytes cut(const GlbBuilder& glb, std::size_t size) {
    Bytes bytes = glb.build();
    bytes.resize(size);
    return bytes;
}

// The good file with more bytes at its end; `declared` of them count into the length of the header.
Bytes grown(const GlbBuilder& glb, const Bytes& more, std::size_t declared) {
    Bytes bytes = glb.build();
    const std::size_t length = bytes.size() + declared;
    bytes.insert(bytes.end(), more.begin(), more.end());
    for (std::size_t i = 0; i < 4; ++i) bytes[8 + i] = static_cast<std::uint8_t>(length >> (8 * i));
    return bytes;
}

const std::vector<RawRefusal>& raw_refusals() {
    static const std::vector<RawRefusal> rows{
        {"empty", IssueCode::glb_truncated, [](GlbBuilder) { return Bytes{}; }},
        {"3 bytes", IssueCode::glb_truncated, [](GlbBuilder g) { return cut(g, 3); }},
        {"11 bytes", IssueCode::glb_truncated, [](GlbBuilder g) { return cut(g, 11); }},
        {"header alone", IssueCode::glb_truncated,
         [](GlbBuilder) { return Bytes{'g', 'l', 'T', 'F', 2, 0, 0, 0, 12, 0, 0, 0}; }},
        {"magic glTG", IssueCode::glb_magic, [](GlbBuilder g) { return with_byte(g, 3, 'G'); }},
        {"version 1", IssueCode::glb_version, [](GlbBuilder g) { return with_byte(g, 4, 1); }},
        {"cut after the header", IssueCode::glb_length, [](GlbBuilder g) { return cut(g, 40); }},
        {"length one more than the file", IssueCode::glb_length,
         [](GlbBuilder g) { return grown(g, {}, 1); }},
        {"junk behind the end", IssueCode::glb_trailing,
         [](GlbBuilder g) { return grown(g, Bytes(4096), 0); }},
        {"JSON chunk length wraps", IssueCode::glb_chunk,
         [](GlbBuilder g) {
             Bytes bytes = g.build();
             for (std::size_t i = 12; i < 16; ++i) bytes[i] = i == 12 ? 0xFC : 0xFF;
             return bytes;
         }},
        {"first chunk is no JSON", IssueCode::glb_chunk, [](GlbBuilder g) { return with_byte(g, 16, 'X'); }},
        {"second BIN chunk", IssueCode::glb_chunk,
         [](GlbBuilder g) {
             return grown(g, {4, 0, 0, 0, 'B', 'I', 'N', 0, 1, 2, 3, 4}, 12);
         }},
        {"second JSON chunk", IssueCode::glb_chunk,
         [](GlbBuilder g) {
             return grown(g, {4, 0, 0, 0, 'J', 'S', 'O', 'N', '{', '}', ' ', ' '}, 12);
         }},
        {"half a chunk header", IssueCode::glb_chunk,
         [](GlbBuilder g) {
             return grown(g, {4, 0, 0, 0}, 4);
         }},
        {"JSON cut", IssueCode::glb_json,
         [](GlbBuilder g) { return with_text(g, "\"asset\":{", "\"asset\":[{"); }},
        {"root is a list", IssueCode::glb_json, [](GlbBuilder g) { return support::pack_glb("[1]", g.bin); }},
        {"invalid UTF-8 in a name", IssueCode::glb_json,
         [](GlbBuilder g) { return with_text(g, "\"Hips\"", "\"Hi\xC3(s\""); }},
        {"key twice", IssueCode::glb_json_dup,
         [](GlbBuilder g) { return with_text(g, "\"asset\":", "\"accessors\":[],\"asset\":"); }},
        {"number 1e999", IssueCode::glb_number,
         [](GlbBuilder g) { return with_text(g, "\"translation\":[0,", "\"translation\":[1e999,"); }},
        {"JSON 65 deep", IssueCode::lim_json_depth,
         [](GlbBuilder g) {
             return with_text(g, "\"asset\":{",
                              "\"extras\":" + std::string(64, '[') + std::string(64, ']') + ",\"asset\":{");
         }},
    };
    return rows;
}

Json sparse_of(GlbBuilder& glb, std::vector<std::uint16_t> indices, std::size_t count) {
    const int index_view = glb.add_view_of(indices);
    const int value_view = glb.add_view_of(std::vector<float>(indices.size() * 3, 0.5f));
    return {{"count", count},
            {"indices", {{"bufferView", index_view}, {"componentType", support::kU16}}},
            {"values", {{"bufferView", value_view}}}};
}

void chain_of_nodes(GlbBuilder& glb, std::size_t count) {
    const std::size_t first = glb.document["nodes"].size();
    for (std::size_t n = 0; n < count; ++n)
        glb.add("nodes", n + 1 < count ? Json{{"children", {first + n + 1}}} : Json::object());
}

void many_bones(GlbBuilder& glb, std::size_t count) {
    const std::size_t first = glb.document["nodes"].size();
    Json joints = Json::array();
    for (std::size_t n = 0; n < count; ++n) {
        glb.add("nodes", Json::object());
        joints.push_back(first + n);
    }
    glb.document["skins"][0] = {{"joints", joints}};
}

// A node that a matrix places and that "Rig|Wag" moves.
void matrix_on_animated_node(GlbBuilder& glb) {
    glb.document["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

const std::vector<Refusal>& structure_refusals() {
    static const std::vector<Refusal> rows{
        {"mesh without primitives", IssueCode::glb_no_mesh,
         [](GlbBuilder& g) { g.document["meshes"][0].erase("primitives"); }},
        {"accessor without a type", IssueCode::glb_schema,
         [](GlbBuilder& g) { g.attribute(0, "POSITION").erase("type"); }},
        {"accessors of numbers", IssueCode::glb_schema,
         [](GlbBuilder& g) {
             g.document["accessors"] = {1, 2};
         }},
        {"nodes is a number", IssueCode::glb_reference, [](GlbBuilder& g) { g.document["nodes"] = 5; }},
        {"rotation of three numbers", IssueCode::glb_schema,
         [](GlbBuilder& g) {
             g.document["nodes"][0]["rotation"] = {0, 0, 1};
         }},
        {"buffer uri", IssueCode::glb_uri,
         [](GlbBuilder& g) { g.document["buffers"][0]["uri"] = "../secret.bin"; }},
        {"buffer data uri", IssueCode::glb_uri,
         [](GlbBuilder& g) {
             g.document["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA";
         }},
        {"unknown required extension", IssueCode::glb_extension,
         [](GlbBuilder& g) { g.document["extensionsRequired"] = {"EXT_nobody_knows"}; }},
        {"meshopt stream without a mode", IssueCode::glb_meshopt,
         [](GlbBuilder& g) {
             g.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
         }},
        {"Draco primitive whose stream is none", IssueCode::glb_draco,
         [](GlbBuilder& g) {
             Json& primitive = g.document["meshes"][0]["primitives"][0];
             primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                                      {"attributes", {{"POSITION", 0}}}};
             g.attribute(0, "POSITION").erase("bufferView");
         }},
        {"child does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.document["nodes"][4]["children"] = {99}; }},
        {"cycle", IssueCode::glb_node_loop, [](GlbBuilder& g) { g.document["nodes"][4]["children"] = {0}; }},
        {"own child", IssueCode::glb_node_loop,
         [](GlbBuilder& g) { g.document["nodes"][4]["children"] = {4}; }},
        {"two parents", IssueCode::glb_node_loop,
         [](GlbBuilder& g) {
             g.document["nodes"][0]["children"] = {1, 3};
         }},
        {"chain of 4,098 nodes", IssueCode::lim_node_depth, [](GlbBuilder& g) { chain_of_nodes(g, 4098); }},
        {"65,537 nodes", IssueCode::lim_count,
         [](GlbBuilder& g) { g.document["nodes"].get_ref<Json::array_t&>().resize(65'537, Json::object()); }},
        {"zero rotation", IssueCode::glb_quat,
         [](GlbBuilder& g) {
             g.document["nodes"][0]["rotation"] = {0, 0, 0, 0};
         }},
        {"matrix with a perspective row", IssueCode::glb_ibm,
         [](GlbBuilder& g) {
             g.document["nodes"][2]["matrix"] = {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
         }},
        {"name of 256 bytes", IssueCode::lim_string,
         [](GlbBuilder& g) { g.document["nodes"][1]["name"] = std::string(256, 'n'); }},
        {"mesh does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.document["nodes"][5]["mesh"] = 9; }},
        {"skin does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.document["nodes"][5]["skin"] = 9; }},
        {"joint does not exist", IssueCode::glb_skin_joint,
         [](GlbBuilder& g) { g.document["skins"][0]["joints"][2] = g.document["nodes"].size(); }},
        {"no joints", IssueCode::glb_skin_joint,
         [](GlbBuilder& g) { g.document["skins"][0]["joints"] = Json::array(); }},
        {"1,025 bones", IssueCode::lim_bones, [](GlbBuilder& g) { many_bones(g, 1025); }},
        {"one inverse bind too few", IssueCode::glb_ibm_count,
         [](GlbBuilder& g) {
             g.document["accessors"][g.document["skins"][0]["inverseBindMatrices"].get<std::size_t>()]
                       ["count"] = 2;
         }},
        {"inverse bind not affine", IssueCode::glb_ibm,
         [](GlbBuilder& g) {
             g.set(g.document["accessors"][g.document["skins"][0]["inverseBindMatrices"].get<std::size_t>()],
                   15, 0.5f);
         }},
        {"inverse bind is NaN", IssueCode::glb_number,
         [](GlbBuilder& g) {
             g.set(g.document["accessors"][g.document["skins"][0]["inverseBindMatrices"].get<std::size_t>()],
                   12, kNan);
         }},
        {"no node has a mesh", IssueCode::glb_no_mesh,
         [](GlbBuilder& g) { g.document["nodes"][5].erase("skin"), g.document["nodes"][5].erase("mesh"); }},
        {"no vertex has joints", IssueCode::glb_no_mesh,
         [](GlbBuilder& g) { g.document["meshes"][0]["primitives"][0]["attributes"].erase("JOINTS_0"); }},
        {"no animations", IssueCode::glb_no_animation, [](GlbBuilder& g) { g.document.erase("animations"); }},
        {"animations without channels", IssueCode::glb_no_animation,
         [](GlbBuilder& g) {
             for (Json& a : g.document["animations"]) a["channels"] = Json::array();
         }},
        {"morph targets only", IssueCode::glb_morph_only,
         [](GlbBuilder& g) {
             for (Json& a : g.document["animations"])
                 for (Json& c : a["channels"]) c["target"]["path"] = "weights";
         }},
    };
    return rows;
}

const std::vector<Refusal>& accessor_refusals() {
    static const std::vector<Refusal> rows{
        {"accessor does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 999; }},
        {"weights do not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.document["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0"); }},
        {"buffer view does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.attribute(0, "POSITION")["bufferView"] = 999; }},
        {"buffer does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.document["bufferViews"][0]["buffer"] = 3; }},
        {"view ends one byte past the buffer", IssueCode::glb_view_range,
         [](GlbBuilder& g) {
             Json& view = g.document["bufferViews"][0];
             view["byteLength"] = (g.bin.size() + 3) / 4 * 4 - view["byteOffset"].get<std::size_t>() + 1;
         }},
        {"last element ends past the view", IssueCode::glb_accessor_range,
         [](GlbBuilder& g) { g.attribute(0, "POSITION")["count"] = 13; }},
        {"offset past the view", IssueCode::glb_accessor_range,
         [](GlbBuilder& g) { g.attribute(0, "POSITION")["byteOffset"] = 4; }},
        {"count whose size wraps", IssueCode::glb_accessor_range,
         [](GlbBuilder& g) { g.attribute(0, "POSITION")["count"] = 4611686018427387904u; }},
        {"stride shorter than an element", IssueCode::glb_accessor_range,
         [](GlbBuilder& g) { g.document["bufferViews"][0]["byteStride"] = 8; }},
        {"no elements", IssueCode::glb_accessor_count, [](GlbBuilder& g) { g.times(0, 0)["count"] = 0; }},
        {"fewer normals than positions", IssueCode::glb_accessor_count,
         [](GlbBuilder& g) { g.attribute(0, "NORMAL")["count"] = 11; }},
        {"fewer joints than positions", IssueCode::glb_accessor_count,
         [](GlbBuilder& g) { g.attribute(0, "JOINTS_0")["count"] = 11; }},
        {"fewer weights than positions", IssueCode::glb_accessor_count,
         [](GlbBuilder& g) { g.attribute(0, "WEIGHTS_0")["count"] = 11; }},
        {"fewer values than keys", IssueCode::glb_accessor_count,
         [](GlbBuilder& g) { g.values(0, 0)["count"] = 12; }},
        {"spline without tangents", IssueCode::glb_accessor_count,
         [](GlbBuilder& g) { g.values(1, 0)["count"] = 3; }},
        {"positions are VEC2", IssueCode::glb_accessor_type,
         [](GlbBuilder& g) { g.attribute(0, "POSITION")["type"] = "VEC2"; }},
        {"joints are floats", IssueCode::glb_accessor_type,
         [](GlbBuilder& g) { g.attribute(0, "JOINTS_0")["componentType"] = support::kF32; }},
        {"joints are bytes with a sign", IssueCode::glb_accessor_type,
         [](GlbBuilder& g) { g.attribute(0, "JOINTS_0")["componentType"] = support::kI8; }},
        {"times are VEC3", IssueCode::glb_accessor_type,
         [](GlbBuilder& g) { g.times(0, 0)["type"] = "VEC3"; }},
        {"times are integers", IssueCode::glb_accessor_type,
         [](GlbBuilder& g) { g.times(0, 0)["componentType"] = support::kU16; }},
        {"rotations are VEC3", IssueCode::glb_accessor_type,
         [](GlbBuilder& g) { g.values(0, 0)["type"] = "VEC3"; }},
        {"position is NaN", IssueCode::glb_number,
         [](GlbBuilder& g) { g.set(g.attribute(0, "POSITION"), 5, kNan); }},
        {"normal is infinite", IssueCode::glb_number,
         [](GlbBuilder& g) { g.set(g.attribute(0, "NORMAL"), 2, kInfinity); }},
        {"sparse index equal to the count", IssueCode::glb_sparse,
         [](GlbBuilder& g) {
             g.attribute(0, "POSITION")["sparse"] = sparse_of(g, {3, 12}, 2);
         }},
        {"sparse indices fall", IssueCode::glb_sparse,
         [](GlbBuilder& g) {
             g.attribute(0, "POSITION")["sparse"] = sparse_of(g, {4, 3}, 2);
         }},
        {"sparse indices repeat", IssueCode::glb_sparse,
         [](GlbBuilder& g) {
             g.attribute(0, "POSITION")["sparse"] = sparse_of(g, {4, 4}, 2);
         }},
        {"more sparse values than elements", IssueCode::glb_sparse,
         [](GlbBuilder& g) {
             g.attribute(0, "POSITION")["sparse"] = sparse_of(g, std::vector<std::uint16_t>(13), 13);
         }},
        {"sparse indices are floats", IssueCode::glb_sparse,
         [](GlbBuilder& g) {
             Json sparse = sparse_of(g, {1, 2}, 1);
             sparse["indices"]["componentType"] = support::kF32;
             g.attribute(0, "POSITION")["sparse"] = sparse;
         }},
        {"sparse indices leave their view", IssueCode::glb_accessor_range,
         [](GlbBuilder& g) {
             g.attribute(0, "POSITION")["sparse"] = sparse_of(g, {1, 2}, 3);
         }},
        {"zeros of 16,000,000 matrices", IssueCode::lim_decoded,
         [](GlbBuilder& g) {
             g.document["skins"][0]["inverseBindMatrices"] =
                 g.add_accessor(-1, 0, support::kF32, 16'000'000, "MAT4");
         }},
        {"joint index out of range", IssueCode::glb_joint_index,
         [](GlbBuilder& g) { g.set(g.attribute(0, "JOINTS_0"), 0, std::uint16_t{3}); }},
    };
    return rows;
}

const std::vector<Refusal>& clip_refusals() {
    static const std::vector<Refusal> rows{
        {"target node does not exist", IssueCode::glb_reference,
         [](GlbBuilder& g) { g.document["animations"][0]["channels"][0]["target"]["node"] = 99; }},
        {"sampler does not exist", IssueCode::glb_channel,
         [](GlbBuilder& g) { g.document["animations"][0]["channels"][0]["sampler"] = 9; }},
        {"unknown interpolation", IssueCode::glb_interpolation,
         [](GlbBuilder& g) { g.document["animations"][0]["samplers"][0]["interpolation"] = "BOUNCE"; }},
        {"node with a matrix moves", IssueCode::glb_channel, matrix_on_animated_node},
        {"times fall", IssueCode::glb_times, [](GlbBuilder& g) { g.set(g.times(0, 0), 3, 0.01f); }},
        {"times begin below zero", IssueCode::glb_times,
         [](GlbBuilder& g) { g.set(g.times(0, 0), 0, -0.5f); }},
        {"time is NaN", IssueCode::glb_number, [](GlbBuilder& g) { g.set(g.times(0, 0), 3, kNan); }},
        {"time is infinite", IssueCode::glb_number,
         [](GlbBuilder& g) { g.set(g.times(0, 0), 12, kInfinity); }},
        {"value is NaN", IssueCode::glb_number, [](GlbBuilder& g) { g.set(g.values(1, 0), 5, kNan); }},
        {"rotation key is zero", IssueCode::glb_quat,
         [](GlbBuilder& g) {
             for (std::size_t c = 0; c < 4; ++c) g.set(g.values(0, 0), 8 + c, 0.0f);
         }},
        {"clip of 601 s", IssueCode::lim_duration, [](GlbBuilder& g) { g.set(g.times(0, 0), 12, 601.0f); }},
        {"clip name of 256 bytes", IssueCode::lim_string,
         [](GlbBuilder& g) { g.document["animations"][0]["name"] = std::string(256, 'n'); }},
    };
    return rows;
}

// What the default mends and --strict refuses.
const std::vector<Refusal>& strict_refusals() {
    static const std::vector<Refusal> rows{
        {"weight is NaN", IssueCode::glb_weights,
         [](GlbBuilder& g) { g.set(g.attribute(0, "WEIGHTS_0"), 1, kNan); }},
        {"weight is negative", IssueCode::glb_weights,
         [](GlbBuilder& g) { g.set(g.attribute(0, "WEIGHTS_0"), 1, -0.1f); }},
        {"weights sum to 0.6", IssueCode::glb_weights,
         [](GlbBuilder& g) { g.set(g.attribute(0, "WEIGHTS_0"), 0, 0.6f); }},
        {"vertex without weights", IssueCode::glb_weights,
         [](GlbBuilder& g) { g.set(g.attribute(0, "WEIGHTS_0"), 0, 0.0f); }},
        {"more than four influences", IssueCode::glb_weights,
         [](GlbBuilder& g) {
             support::Json joints = Json::array();
             for (int i = 0; i < 3; ++i) joints.push_back(g.add("nodes", Json::object()));
             for (const Json& joint : joints) g.document["skins"][0]["joints"].push_back(joint);
             g.document["skins"][0].erase("inverseBindMatrices");
             std::vector<std::uint16_t> more(12 * 4, 5);
             std::vector<float> weights(12 * 4, 0.0f);
             for (std::size_t v = 0; v < 12; ++v)
                 for (std::size_t i = 0; i < 3; ++i) {
                     more[v * 4 + i] = static_cast<std::uint16_t>(3 + i);
                     weights[v * 4 + i] = v == 11 ? 0.001f : 0.0f;
                 }
             support::Json& attributes = g.document["meshes"][0]["primitives"][0]["attributes"];
             attributes["JOINTS_1"] = g.add_values(more, "VEC4");
             attributes["WEIGHTS_1"] = g.add_values(weights, "VEC4");
         }},
        {"two keys at one time", IssueCode::glb_times, [](GlbBuilder& g) { g.set(g.times(0, 0), 1, 0.0f); }},
        {"two keys within a microsecond", IssueCode::glb_times,
         [](GlbBuilder& g) { g.set(g.times(0, 0), 1, 5e-7f); }},
        {"rotation key of length 2", IssueCode::glb_quat,
         [](GlbBuilder& g) {
             for (std::size_t c = 0; c < 4; ++c) g.set(g.values(0, 0), 8 + c, 1.0f);
         }},
        {"node rotation of length 2", IssueCode::glb_quat,
         [](GlbBuilder& g) {
             g.document["nodes"][0]["rotation"] = {1, 1, 1, 1};
         }},
        {"two channels on one target", IssueCode::glb_channel,
         [](GlbBuilder& g) {
             support::Json& channels = g.document["animations"][0]["channels"];
             channels.push_back(channels[0]);
         }},
    };
    return rows;
}

void expect_refused(const char* what, IssueCode code, const Bytes& bytes, bool strict) {
    const auto animal = read_animal(bytes, {strict});
    ASSERT_FALSE(animal) << what << ": was read";
    EXPECT_EQ(animal.issue().code, code) << what << ": " << base::format_issue(animal.issue());
    EXPECT_FALSE(animal.issue().detail.empty()) << what;
}

TEST(Refusals, TheFileBeforeTheDamageIsGood) {
    EXPECT_TRUE(read_animal(support::glb_of(support::tail()), {true}));
}

TEST(Refusals, Shell) {
    for (const RawRefusal& row : raw_refusals())
        for (const bool strict : {false, true})
            expect_refused(row.what, row.code, row.make(support::builder_of(support::tail())), strict);
}

class DamagedDocument : public testing::TestWithParam<const std::vector<Refusal>*> {};

TEST_P(DamagedDocument, IsRefused) {
    for (const Refusal& row : *GetParam()) {
        GlbBuilder glb = support::builder_of(support::tail());
        row.damage(glb);
        for (const bool strict : {false, true}) expect_refused(row.what, row.code, glb.build(), strict);
    }
}

INSTANTIATE_TEST_SUITE_P(Refusals, DamagedDocument,
                         testing::Values(&structure_refusals(), &accessor_refusals(), &clip_refusals()));

TEST(Refusals, StrictRefusesWhatTheDefaultMends) {
    for (const Refusal& row : strict_refusals()) {
        GlbBuilder glb = support::builder_of(support::tail());
        row.damage(glb);
        expect_refused(row.what, row.code, glb.build(), true);
        const auto mended = read_animal(glb.build());
        ASSERT_TRUE(mended) << row.what << ": " << base::format_issue(mended.issue());
        EXPECT_FALSE(mended.value().findings.empty()) << row.what;
        for (const base::Issue& finding : mended.value().findings)
            EXPECT_EQ(base::issue_kind(finding.code).severity, base::Severity::warning) << row.what;
    }
}

// A code of the GLB room that no row gives would be a check that nothing tests.
TEST(Refusals, EveryCodeOfTheRoomIsTested) {
    std::set<IssueCode> given;
    for (const RawRefusal& row : raw_refusals()) given.insert(row.code);
    for (const auto* rows :
         {&structure_refusals(), &accessor_refusals(), &clip_refusals(), &strict_refusals()})
        for (const Refusal& row : *rows) given.insert(row.code);
    std::size_t looked_at = 0;
    for (const base::IssueKind& kind : base::issue_kinds()) {
        if (!kind.id.starts_with("E-GLB-")) continue;
        if (kind.code == IssueCode::glb_no_extent) continue;  // given by the baker, which knows the rest pose
        ++looked_at;
        EXPECT_TRUE(given.contains(kind.code)) << kind.id;
    }
    EXPECT_GE(looked_at, 25u);
}

// Every cut of a good file is refused, and none reads outside it (run with AddressSanitizer).
TEST(Refusals, EveryTruncation) {
    const Bytes good = support::glb_of(support::tail());
    for (std::size_t size = 0; size < good.size(); ++size) {
        const Bytes bytes(good.begin(), good.begin() + static_cast<long>(size));
        ASSERT_FALSE(read_animal(bytes)) << size << " bytes";
    }
}

}  // namespace
}  // namespace posepack::animal
