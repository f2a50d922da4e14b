// SPDX-License-Identifier: MIT
// Where numbers may lie: element spans that no arithmetic leads astray, budgets, data URIs; and pointers at
// them.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "animal/data_uri.hpp"
#include "animal/decode_budget.hpp"
#include "animal/element_span.hpp"
#include "animal/gltf_facts.hpp"
#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using base::IssueCode;
using support::GlbBuilder;
using support::Json;

constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max();

TEST(ElementSpan, HoldsToItsBytes) {
    struct Row {
        std::size_t size, offset, count, components;
        int component;
        std::size_t stride;
        bool fits;
    };
    const Row rows[] = {
        {24, 0, 2, 3, kFloat, 0, true},
        {24, 0, 2, 3, kFloat, 12, true},
        {24, 1, 2, 3, kFloat, 0, false},
        {23, 0, 2, 3, kFloat, 0, false},
        {24, 24, 0, 3, kFloat, 0, true},
        {28, 0, 2, 3, kFloat, 16, true},  // the last element ends before its stride does
        {27, 0, 2, 3, kFloat, 16, false},
        {64, 0, 2, 3, kFloat, 8, false},  // shorter than an element
        {4096, 0, 2, 3, kFloat, 256, false},
        {4096, 0, 2, 3, kFloat, 252, true},
        {4, 0, 4, 1, kByte, 0, true},
        {4, 4, 1, 1, kByte, 0, false},
        {4, kHuge, 1, 1, kByte, 0, false},
        {4, kHuge - 2, 2, 1, kUnsignedShort, 0, false},
        {64, 0, kHuge, 1, kByte, 0, false},
        {64, 0, kHuge / 4 + 2, 1, kFloat, 0, false},  // times 4 it wraps to 4
        {64, 0, std::size_t{1} << 62, 16, kFloat, 0, false},
    };
    const std::vector<std::uint8_t> bytes(4096);
    for (const Row& row : rows) {
        const auto span = ElementSpan::over(std::span(bytes).first(row.size), row.offset,
                                            {row.count, row.components, row.component, row.stride});
        EXPECT_EQ(static_cast<bool>(span), row.fits) << row.size << " " << row.offset << " " << row.count;
        if (!span) {
            EXPECT_EQ(span.issue().code, IssueCode::glb_accessor_range);
        }
    }
}

TEST(DecodeBudget, TakesNoMoreThanThereIs) {
    DecodeBudget budget(0);  // 16 MiB
    EXPECT_TRUE(budget.take(1 << 18, 32));
    EXPECT_TRUE(budget.take(1 << 18, 32));
    EXPECT_TRUE(budget.take(0, 4));
    EXPECT_FALSE(budget.take(1, 1));
    DecodeBudget wide(kHuge / 32);
    EXPECT_FALSE(wide.take(kHuge, kHuge));
    EXPECT_FALSE(wide.take(1, kHuge));
    const auto many = wide.take((16u << 20) + 1, 1);
    ASSERT_FALSE(many);
    EXPECT_EQ(many.issue().code, IssueCode::lim_decoded);
}

TEST(DataUri, Base64OfRfc4648) {
    DecodeBudget budget(0);
    const std::pair<const char*, const char*> rows[] = {{"", ""},
                                                        {"Zg==", "f"},
                                                        {"Zm8=", "fo"},
                                                        {"Zm9v", "foo"},
                                                        {"Zm9vYg==", "foob"},
                                                        {"Zm9vYmE", "fooba"},
                                                        {"Zm9vYmFy", "foobar"},
                                                        {"+/+/", "\xFB\xFF\xBF"}};
    for (const auto& [text, bytes] : rows) {
        const auto decoded =
            decode_data_uri(std::string("data:application/octet-stream;base64,") + text, budget);
        ASSERT_TRUE(decoded) << text;
        EXPECT_EQ(std::string(decoded.value().begin(), decoded.value().end()), bytes);
    }
    for (const char* uri : {"data:text/plain,hello", "data:;base64", "data:;base64,Zm9vY",
                            "data:;base64,Zm9*", "data:;base64,Zm 9"}) {
        const auto decoded = decode_data_uri(uri, budget);
        ASSERT_FALSE(decoded) << uri;
        EXPECT_EQ(decoded.issue().code, IssueCode::glb_uri);
    }
}

std::string base64(const support::Bytes& bytes) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : kLetters[bits >> (18 - 6 * k) & 63];
    }
    return out;
}

TEST(DataUri, BuffersAreReadWhereTheyAreAllowed) {
    GlbBuilder glb = support::builder_of(support::tail());
    glb.document["buffers"][0] = {{"byteLength", glb.bin.size()},
                                  {"uri", "data:application/gltf-buffer;base64," + base64(glb.bin)}};
    glb.bin.clear();
    const auto refused = read_animal(glb.build());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.issue().code, IssueCode::glb_uri);
    EXPECT_NE(refused.issue().detail.find("--allow-data-uris"), std::string::npos);
    EXPECT_LT(refused.issue().detail.size(), 256u);
    const auto animal = read_animal(glb.build(), {false, true});
    ASSERT_TRUE(animal) << base::format_issue(animal.issue());
    EXPECT_EQ(animal.value().key_values, support::animal_of(support::tail()).key_values);
    glb.document["buffers"][0]["byteLength"] = 1 << 20;
    EXPECT_FALSE(read_animal(glb.build(), {false, true})) << "more bytes declared than the text holds";
}

// Aims the channels of a clip by KHR_animation_pointer.
void use_pointers(Json& animation) {
    for (Json& channel : animation["channels"]) {
        const Json target = channel["target"];
        channel["target"] = {{"path", "pointer"},
                             {"extensions",
                              {{"KHR_animation_pointer",
                                {{"pointer", "/nodes/" + std::to_string(target["node"].get<int>()) + "/" +
                                                 target["path"].get<std::string>()}}}}}};
    }
}

TEST(AnimationPointer, OnNodesIsAChannel) {
    GlbBuilder glb = support::builder_of(support::tail());
    for (Json& animation : glb.document["animations"]) use_pointers(animation);
    glb.document["extensionsRequired"] = {"KHR_animation_pointer"};
    const Animal animal = support::read_good(glb.build());
    const Animal plain = support::animal_of(support::tail());
    EXPECT_TRUE(animal.findings.empty());
    EXPECT_EQ(animal.key_values, plain.key_values);
    ASSERT_EQ(animal.clips.size(), plain.clips.size());
    for (std::size_t c = 0; c < plain.clips.size(); ++c) {
        ASSERT_EQ(animal.clips[c].channels.size(), plain.clips[c].channels.size());
        for (std::size_t i = 0; i < plain.clips[c].channels.size(); ++i) {
            EXPECT_EQ(animal.clips[c].channels[i].node, plain.clips[c].channels[i].node);
            EXPECT_EQ(animal.clips[c].channels[i].path, plain.clips[c].channels[i].path);
        }
    }
}

TEST(AnimationPointer, AtAnythingElseIsNamed) {
    for (const char* pointer : {"/materials/0/pbrMetallicRoughness/baseColorFactor", "/nodes/1/weights",
                                "/nodes/1", "/nodes/x/rotation", "/nodes/-1/rotation", "/nodes/1/rotation/0",
                                "/nodes/99999999999/rotation", "nodes/1/rotation"}) {
        GlbBuilder glb = support::builder_of(support::tail());
        Json& channels = glb.document["animations"][0]["channels"];
        channels[1]["target"] = {{"path", "pointer"},
                                 {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
        const Animal animal = support::read_good(glb.build());
        EXPECT_EQ(animal.clips[0].channels.size(), 1u) << pointer;
        ASSERT_EQ(animal.findings.size(), 1u) << pointer;
        EXPECT_EQ(animal.findings[0].code, IssueCode::warn_left_out);
    }
    GlbBuilder glb = support::builder_of(support::tail());
    use_pointers(glb.document["animations"][0]);
    glb.document["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"]["pointer"] =
        "/nodes/77/rotation";
    const auto animal = read_animal(glb.build());
    ASSERT_FALSE(animal);
    EXPECT_EQ(animal.issue().code, IssueCode::glb_reference);
}

// Lists are read whatever order the file has them in, and however odd the JSON is.
TEST(GltfFacts, GathersWhatTheParserMustNotSee) {
    const char* text = R"({"images":[{"uri":"x"}],"meshes":[{"primitives":[{"attributes":{}},{"indices":4}]}],
        "accessors":[{"count":3,"type":"VEC3","componentType":5126}],"\u0062ufferViews":[{"buffer":0,"byteLength":9}],
        "buffers":[{"byteLength":9},{"byteLength":5,"uri":"f.bin","extensions":{"EXT_meshopt_compression":{"fallback":true}}}]})";
    const auto facts = read_gltf_facts(text, false);
    ASSERT_TRUE(facts) << base::format_issue(facts.issue());
    EXPECT_EQ(facts.value().indices_of(0, 1), 4);
    EXPECT_EQ(facts.value().indices_of(0, 0), -1);
    ASSERT_EQ(facts.value().accessors.size(), 1u);
    ASSERT_EQ(facts.value().views.size(), 1u);
    EXPECT_TRUE(facts.value().buffers.at(1).is_fallback);
    const Json seen = Json::parse(text_for_parser(text, facts.value()));
    for (const char* list : {"images", "accessors", "bufferViews", "buffers"})
        EXPECT_TRUE(seen.at(list).empty());
    EXPECT_FALSE(seen["meshes"][0]["primitives"][1].contains("indices"));
    EXPECT_TRUE(seen["meshes"][0]["primitives"][0].contains("attributes"));
}

TEST(GltfFacts, OddShapesAreRefusedOrHarmless) {
    for (const char* text : {R"({"accessors":[[{"count":1}]]})", R"({"accessors":[1]})",
                             R"({"accessors":[{"count":null,"type":"VEC3"}]})",
                             R"({"accessors":[{"count":-1,"type":"VEC3","componentType":5126}]})",
                             R"({"accessors":[{"count":1.5,"type":"VEC3","componentType":5126}]})",
                             R"({"accessors":[{"count":1,"type":"VEC9","componentType":5126}]})",
                             R"({"accessors":[{"count":1,"type":"VEC3","componentType":5126,"sparse":{}}]})",
                             R"({"bufferViews":[{"buffer":0}]})",
                             R"({"bufferViews":[{"buffer":0,"byteLength":4,"byteStride":3}]})",
                             R"({"bufferViews":[{"buffer":{},"byteLength":4}]})", R"({"buffers":[{}]})"}) {
        // In a file that moves; where nothing does, that is said instead.
        const std::string moving =
            R"({"animations":[{"channels":[{"target":{"node":0}}]}],)" + std::string(text + 1);
        const auto facts = read_gltf_facts(moving, false);
        ASSERT_FALSE(facts) << moving;
        EXPECT_EQ(facts.issue().code, IssueCode::glb_schema) << moving;
    }
    for (
        const char* text :
        {R"({"accessors":{}})", R"({"buffers":[[[[[{"fallback":true}]]]]]})",
         R"({"animations":[[[[[[[[1]]]]]]]]})", R"({"meshes":{"primitives":[{"indices":[]}]}})",
         R"({"bufferViews":"none"})",
         R"({"bufferViews":[{"buffer":0,"byteLength":4,"extensions":{"EXT_meshopt_compression":[{"count":"x"}]}}]})",
         R"({"accessors":[{"count":1,"type":"VEC3","componentType":5126,"sparse":[{"count":"x"}]}]})"})
        EXPECT_TRUE(read_gltf_facts(text, false)) << text;
}

}  // namespace
}  // namespace posepack::animal
