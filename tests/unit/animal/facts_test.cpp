// SPDX-License-Identifier: MIT
// What the streaming pass says of a glTF before any parser builds its tree.
#include <gtest/gtest.h>

#include <string>

#include "animal/gltf_facts.hpp"
#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using base::IssueCode;

std::string repeated(const std::string& item, std::size_t count) {
    std::string list = item;
    for (std::size_t i = 1; i < count; ++i) list += "," + item;
    return list;
}

TEST(Facts, RefusalsByNamedRules) {
    const std::vector<std::pair<std::string, IssueCode>> rows{
        {R"([])", IssueCode::glb_json},
        {R"({"buffers":[{"byteLength":4,"uri":"a.bin"}]})", IssueCode::glb_uri},
        {R"({"extensionsRequired":["EXT_of_nobody"]})", IssueCode::glb_extension},
        {R"({"asset":{"version":"2.0","minVersion":"2.1"}})", IssueCode::glb_version},
        {R"({"asset":{"version":"2.0","minVersion":"10.0"}})", IssueCode::glb_version},
        {R"({"asset":{"version":"3.0"}})", IssueCode::glb_version},
        {R"({"asset":{"version":"1.0","generator":"2.0"}})", IssueCode::glb_version},
        {R"({"asset":{"version":"20"}})", IssueCode::glb_version},
        {R"({"nodes":[{"scale":"big"}]})", IssueCode::glb_schema},
        {R"({"nodes":[{"rotation":1}]})", IssueCode::glb_schema},
        {R"({"nodes":[{"children":[0.5]}]})", IssueCode::glb_schema},
        {R"({"nodes":[)" + repeated("{}", 65'537) + "]}", IssueCode::lim_count},
        {R"({"animations":[{"channels":[)" + repeated("{}", 131'072) + "]}]}", IssueCode::lim_count},
    };
    for (const auto& [json, code] : rows) {
        const auto facts = read_gltf_facts(json, false);
        ASSERT_FALSE(facts) << json.substr(0, 80);
        EXPECT_EQ(facts.issue().code, code) << json.substr(0, 80);
    }
}

TEST(Facts, WhatLiesOnALimitPasses) {
    for (const std::string& json :
         {R"({"nodes":[)" + repeated("{}", 65'536) + "]}",
          R"({"animations":[{"channels":[)" + repeated("{}", 131'070) + "]}]}",
          std::string(R"({"asset":{"version":"2.7"}})"), std::string(R"({"asset":{"version":"two"}})"),
          std::string(R"({"asset":{"version":"3.0","minVersion":"2.0"}})"),
          std::string(R"({"asset":{"extras":{"version":"9.0"}},"extras":{"version":"9.0"}})"),
          std::string(R"({"asset":{"minVersion":"2.0"},"nodes":[{"children":[1.0]}]})")})
        EXPECT_TRUE(read_gltf_facts(json, false)) << json.substr(0, 80);
}

TEST(Facts, ATargetIsANodeOrAPointer) {
    const auto has_target = [](const std::string& target) {
        const auto facts = read_gltf_facts(
            R"({"animations":[{"channels":[{"sampler":0,"target":)" + target + "}]}]}", false);
        return facts && facts.value().has_target;
    };
    EXPECT_TRUE(has_target(R"({"node":3,"path":"rotation"})"));
    EXPECT_TRUE(has_target(R"({"path":"pointer","extensions":{"KHR_animation_pointer":{"pointer":"/x"}}})"));
    EXPECT_FALSE(has_target(R"({"path":"translation"})"));
}

// A file in which nothing moves is refused for that, whatever tinygltf thinks of the rest.
TEST(Facts, AStillFileIsNotCalledMalformed) {
    const std::string json =
        R"({"asset":{"version":"2.0"},"accessors":[{"type":"NONE","componentType":5126,"count":1}]})";
    const auto animal = read_animal(support::pack_glb(json, {}), {});
    ASSERT_FALSE(animal);
    EXPECT_EQ(animal.issue().code, IssueCode::glb_no_animation);
}

// Otherwise a small file asks for its values as often as it has channels.
TEST(Facts, ChannelsThatShareAnOutputShareItsValues) {
    support::ModelSpec spec = support::one_bone();
    spec.clips = {{"Slide", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    support::GlbBuilder glb = support::builder_of(spec);
    auto& channels = glb.document["animations"][0]["channels"];
    for (int i = 0; i < 99; ++i) channels.push_back(channels[0]);
    const Animal animal = support::read_good(glb.build());
    EXPECT_EQ(animal.key_values.size(), 6u);
    EXPECT_EQ(animal.clips[0].channels.size(), 1u);
}

}  // namespace
}  // namespace posepack::animal
