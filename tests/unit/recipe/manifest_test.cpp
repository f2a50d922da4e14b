// SPDX-License-Identifier: MIT
#include "recipe/manifest.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "sample_manifest.hpp"

namespace posepack::recipe {
namespace {

using base::IssueCode;

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t place = text.find(from);
    if (place == std::string::npos) throw std::runtime_error("nothing to replace: " + std::string(from));
    return text.replace(place, from.size(), to);
}

IssueCode code_of(const std::string& text) {
    const base::Result<Manifest> manifest = read_manifest(text);
    EXPECT_FALSE(manifest) << text;
    return manifest ? IssueCode::usage : manifest.issue().code;
}

TEST(WriteManifest, IsCanonicalJsonWithAFinalNewline) {
    const std::string text = write_manifest(sample_manifest());
    EXPECT_EQ(base::check_json(text).fault, base::JsonFault::none);
    EXPECT_TRUE(text.ends_with("}\n"));
    EXPECT_TRUE(text.starts_with("{\n \"bake_abi\": 3,\n \"catalog_sha256\": \"f"));
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_NE(text.find("\"rate_hz\": 23.976,"), std::string::npos) << "floats print short";
    EXPECT_EQ(text, write_manifest(sample_manifest()));
}

TEST(ReadManifest, GivesBackEveryField) {
    const std::string text = write_manifest(sample_manifest());
    const base::Result<Manifest> manifest = read_manifest(text);
    ASSERT_TRUE(manifest) << base::format_issue(manifest.issue());
    EXPECT_EQ(write_manifest(manifest.value()), text);
    const Manifest expected = sample_manifest();
    ASSERT_EQ(manifest.value().records.size(), 2u);
    EXPECT_EQ(manifest.value().bake_abi, 3u);
    EXPECT_EQ(manifest.value().options_json, expected.options_json);
    const BakeRecord& deer = manifest.value().records[0];
    EXPECT_EQ(deer.container_bytes, 1ull << 40);
    EXPECT_EQ(deer.error.clip, "Walk");
    EXPECT_EQ(deer.error.vertex, 4'294'967'295u);
    EXPECT_EQ(deer.error.max, 1.234e-4f);
    EXPECT_EQ(deer.clips[0].rate_hz, 23.976f);
    EXPECT_TRUE(deer.clips[0].error.measured);
    EXPECT_FALSE(deer.clips[1].error.measured);
    EXPECT_EQ(deer.vram.dualquat_rgba16f, 8u);
    EXPECT_EQ(deer.vram.vat_rgba16f, 7u);
    EXPECT_FALSE(manifest.value().records[1].has_vram);
    EXPECT_TRUE(deer.reduction.measured);
    EXPECT_EQ(deer.reduction.influences_most, 7u);
    EXPECT_FALSE(manifest.value().records[1].reduction.measured);
    EXPECT_EQ(deer.remarks, expected.records[0].remarks);
}

TEST(ReadManifest, AcceptsAnEmptyOne) {
    const Manifest empty{1, "0.1.0", std::string(64, '0'), "", {}};
    const base::Result<Manifest> manifest = read_manifest(write_manifest(empty));
    ASSERT_TRUE(manifest);
    EXPECT_TRUE(manifest.value().records.empty());
    EXPECT_EQ(manifest.value().options_json, "{}");
}

TEST(ReadManifest, RefusesEveryTruncation) {
    const std::string text = write_manifest(sample_manifest());
    for (std::size_t size = 0; size + 1 < text.size(); ++size) {
        ASSERT_EQ(code_of(text.substr(0, size)), IssueCode::man_json) << size;
    }
    EXPECT_TRUE(read_manifest(text.substr(0, text.size() - 1))) << "the newline alone may be missing";
}

// Every key of every object of `json`, as JSON pointers; the options, which may all be missing, are left out.
void collect_keys(const nlohmann::json& json, const std::string& place, std::vector<std::string>* keys) {
    if (place == "/options") return;
    for (const auto& [key, member] : json.items()) {
        const std::string inner = std::string(place).append("/").append(key);
        if (json.is_object()) keys->push_back(inner);
        if (member.is_structured()) collect_keys(member, inner, keys);
    }
}

TEST(ReadManifest, RefusesEveryMissingKey) {
    const nlohmann::json whole = nlohmann::json::parse(write_manifest(sample_manifest()));
    std::vector<std::string> keys;
    collect_keys(whole, "", &keys);
    EXPECT_GT(keys.size(), 100u);
    for (const std::string& key : keys) {
        const nlohmann::json::json_pointer pointer(key);
        nlohmann::json less = whole;
        less[pointer.parent_pointer()].erase(pointer.back());
        EXPECT_EQ(code_of(less.dump()), IssueCode::man_json) << key;
        less[pointer] = nlohmann::json::array({true});
        EXPECT_EQ(code_of(less.dump()), IssueCode::man_json) << key;
    }
}

TEST(ReadManifest, RefusesWrongValues) {
    const std::string text = write_manifest(sample_manifest());
    struct Row {
        std::string from, to;
    };
    for (const Row& row : {
             Row{"\"bake_abi\": 3", "\"bake_abi\": -3"},
             {"\"bake_abi\": 3", "\"bake_abi\": 3.5"},
             {"\"bake_abi\": 3", "\"bake_abi\": 4294967296"},
             {"\"bake_abi\": 3", "\"bake_abi\": 3, \"bake_abj\": 3"},
             {"\"bake_abi\": 3", "\"bake_abi\": 3, \"bake_abi\": 3"},
             {"\"schema\": 1", "\"schema\": 0"},
             {"\"schema\": 1", "\"schema\": \"1\""},
             {"\"options\": {", "\"options\": [], \"options_\": {"},
             {"\"options\": {", "\"options\": {\"hats\": 1,"},
             {"\"options\": {", "\"options\": {\"rate_hz\": 0,"},
             {"\"options\": {", "\"options\": {\"rate_hz\": null,"},
             {"\"options\": {", "\"options\": {\"measure\": 0,"},
             {"\"options\": {", "\"options\": {\"only\": \"deer\","},
             {"\"options\": {", "\"options\": {\"only\": [\"../deer\"],"},
             {"\"options\": {", "\"options\": {\"caps\": \"small\","},
             {"\"options\": {", "\"options\": {\"influences\": 5,"},
             {"\"options\": {", "\"options\": {\"unused_bones\": true,"},
             {"\"encoding\": \"affine\",\n   \"error\"", "\"encoding\": \"dual\",\n   \"error\""},
             {"\"ffff", "\"FFFF"},
             {"\"ffff", "\"fff"},
             {"\"max\": 0.0001234", "\"max\": 1e39"},
             {"\"max\": 0.0001234", "\"max\": null"},
             {"\"wrap\": \"loop\"", "\"wrap\": \"auto\""},
             {"\"seam\": \"closed\"", "\"seam\": \"auto\""},
             {"\"interpolation\": \"linear\"", "\"interpolation\": \"cubic\""},
             {"\"id\": \"deer\"", "\"id\": \"zebra\""},
             {"\"container\": \"deer.posepack\"", "\"container\": \"../deer.posepack\""},
             {"\"container\": \"deer.posepack\"", "\"container\": \"fox.posepack\""},
             {"\"model\": \"herd/deer.glb\"", "\"model\": \"/herd/deer.glb\""},
             {"\"model\": \"herd/deer.glb\"", "\"model\": \"herd/../../deer.glb\""},
         }) {
        EXPECT_EQ(code_of(replaced(text, row.from, row.to)), IssueCode::man_json) << row.to;
    }
    EXPECT_EQ(code_of(replaced(text, "\"schema\": 1", "\"schema\": 2")), IssueCode::man_version);
}

TEST(ReadManifest, RefusesHostileIds) {
    const std::string text = write_manifest(sample_manifest());
    for (const std::string id : {"../deer", "a/b", "CON", "", "-x"}) {
        std::string hostile = replaced(text, "\"id\": \"deer\"", "\"id\": \"" + id + "\"");
        hostile =
            replaced(hostile, "\"container\": \"deer.posepack\"", "\"container\": \"" + id + ".posepack\"");
        EXPECT_EQ(code_of(hostile), IssueCode::man_json) << id;
    }
}

TEST(ReadManifest, RefusesRecordsOutOfOrder) {
    Manifest manifest = sample_manifest();
    std::swap(manifest.records[0], manifest.records[1]);
    EXPECT_EQ(code_of(write_manifest(manifest)), IssueCode::man_json);
    manifest.records[1] = manifest.records[0];
    EXPECT_EQ(code_of(write_manifest(manifest)), IssueCode::man_json);
}

TEST(ReadManifest, HoldsItsLimits) {
    EXPECT_EQ(code_of(std::string(200'000, '[')), IssueCode::lim_json_depth);
    EXPECT_EQ(code_of(std::string(kMaxManifestBytes + 1, ' ')), IssueCode::lim_file);
    EXPECT_EQ(code_of("[]"), IssueCode::man_json);
    EXPECT_EQ(code_of("{}"), IssueCode::man_json);
    EXPECT_EQ(code_of("\xFF"), IssueCode::man_json);
}

}  // namespace
}  // namespace posepack::recipe
