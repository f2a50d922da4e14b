// SPDX-License-Identifier: MIT
// Every field of a manifest that its container can answer: one is edited, and verify names the file and the
// field.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "bake/bake_catalog.hpp"
#include "bake/verify.hpp"
#include "scratch_folder.hpp"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using base::IssueCode;
using base::read_text;
using base::write_text;
using nlohmann::json;

class Fields : public testing::Test {
 protected:
    Fields() {
        const support::Bytes glb = support::glb_of(support::tail());
        write_text(scratch.path() / "tail.glb", {reinterpret_cast<const char*>(glb.data()), glb.size()});
        write_text(
            scratch.path() / "catalog.json",
            R"({"schema":1,"animals":{"tail":{"model":"tail.glb","keywords":{"flee":["a","e","i","o","u"]},
                       "clips":[{"name":"*","states":[],"speed_mps":1.5}]}}})");
        CatalogSource source;
        source.catalog = scratch.path() / "catalog.json";
        BakeOptions options;
        options.output = out();
        options.sync_to_disk = false;
        options.animal.compare_vat = true;
        auto outcome = bake_catalog(source, options);
        if (!outcome) throw std::runtime_error(base::format_issue(outcome.issue()));
        manifest = json::parse(read_text(out() / "manifest.json"));
    }

    std::filesystem::path out() const { return scratch.path() / "out"; }

    // What verify finds under a manifest in which the field of the record has another value.
    std::vector<base::Issue> found(const json::json_pointer& field, const json& value) {
        json edited = manifest;
        edited.at(field) = value;
        write_text(out() / "manifest.json", edited.dump(1) + "\n");
        const auto outcome = verify(out(), false);
        if (outcome) return outcome.value().findings;
        return {outcome.issue()};
    }

    base::ScratchFolder scratch;
    json manifest;
};

// Another value of the same type, near enough that nothing but the comparison can refuse it.
json other_than(const json& value, const std::string& key) {
    static const std::map<std::string, std::map<std::string, std::string>> choices{
        {"encoding", {{"affine", "mat4"}}},
        {"row_scheme", {{"uniform", "runs"}}},
        {"texel_format", {{"rgba16f", "rgba32f"}}},
        {"texel_order", {{"bone-major", "planar"}}},
        {"wrap", {{"loop", "once"}, {"once", "loop"}, {"ping-pong", "once"}}},
        {"seam", {{"closed", "open"}, {"open", "closed"}}},
        {"interpolation", {{"linear", "step"}, {"step", "linear"}}}};
    if (const auto choice = choices.find(key); choice != choices.end())
        return choice->second.at(value.get<std::string>());
    if (value.is_string() && value.get<std::string>().size() == 64) {
        std::string digest = value.get<std::string>();
        digest[7] = digest[7] == '0' ? '1' : '0';
        return digest;
    }
    if (value.is_string()) return value.get<std::string>() + "x";
    if (value.is_number_integer()) return value.get<std::uint64_t>() + 1;
    if (value.is_number()) return value.get<double>() * 1.25 + 0.125;
    return nullptr;
}

// Pointers of all plain values in `json`.
void collect(const json& value, const std::string& place, std::vector<std::string>* places) {
    for (const auto& [key, member] : value.items()) {
        const std::string inner = std::string(place).append("/").append(key);
        if (member.is_structured())
            collect(member, inner, places);
        else
            places->push_back(inner);
    }
}

TEST_F(Fields, AllOfTheRecordThatTheContainerAnswers) {
    // What no container holds.
    const std::set<std::string> beyond{"/id", "/container", "/model", "/model_bytes", "/reduction"};
    const json& record = manifest.at("records").at(0);
    ASSERT_FALSE(record.at("error").is_null());
    ASSERT_FALSE(record.at("vram").is_null());
    ASSERT_FALSE(record.at("states").empty());
    std::vector<std::string> places;
    collect(record, "", &places);
    int checked = 0;
    for (const std::string& place : places) {
        if (beyond.contains(place) || place.starts_with("/remarks")) continue;
        const std::string key = place.substr(place.rfind('/') + 1);
        const json::json_pointer field("/records/0" + place);
        const auto findings = found(field, other_than(manifest.at(field), key));
        ++checked;
        ASSERT_FALSE(findings.empty()) << place;
        EXPECT_EQ(base::issue_kind(findings.front().code).exit_code, base::ExitCode::mismatch) << place;
        EXPECT_NE(findings.front().where.find("tail.posepack"), std::string::npos) << place;
        if (place == "/container_sha256") {
            EXPECT_EQ(findings.front().code, IssueCode::man_hash);
            continue;
        }
        bool named = false;
        for (const base::Issue& finding : findings) {
            EXPECT_EQ(finding.code, IssueCode::man_field) << place;
            named = named || finding.where == "tail.posepack: " + place.substr(1);
        }
        EXPECT_TRUE(named) << place << ", found " << base::format_issue(findings.front());
    }
    EXPECT_GT(checked, 60);
    std::cout << checked << " fields edited\n";
}

TEST_F(Fields, WhatIsThereAndWhatIsNot) {
    struct Row {
        const char* field;
        json value;
        const char* named;
    };
    const json clips = manifest.at("records").at(0).at("clips");
    json one_more = clips;
    one_more.push_back(clips.at(0));
    const Row rows[] = {{"/records/0/clips", one_more, "clips/"},
                        {"/records/0/clips", json::array(), "clips"},
                        {"/records/0/states", json::array(), "states"},
                        {"/records/0/error", nullptr, "error"},
                        {"/records/0/clips/0/error", nullptr, "clips/0/error"},
                        {"/records/0/default_state", "", "default_state"},
                        {"/bake_abi", 7, "bake_abi"}};
    for (const Row& row : rows) {
        const auto findings = found(json::json_pointer(row.field), row.value);
        ASSERT_FALSE(findings.empty()) << row.field;
        EXPECT_EQ(findings.front().code, IssueCode::man_field) << row.field;
        EXPECT_TRUE(findings.front().where.starts_with(std::string("tail.posepack: ") + row.named))
            << row.field << ": " << findings.front().where;
    }
    EXPECT_TRUE(found(json::json_pointer("/records/0/remarks"), json::array()).empty());
    EXPECT_TRUE(found(json::json_pointer("/records/0/vram"), nullptr).empty());
}

}  // namespace
}  // namespace posepack::bake
