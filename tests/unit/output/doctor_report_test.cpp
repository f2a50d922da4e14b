// SPDX-License-Identifier: MIT
// A diagnosis as text and JSON: what is there is said, what is not there is not.
#include "output/doctor_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace posepack::output {
namespace {

using base::IssueCode;

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Diagnosis sample() {
    Diagnosis diagnosis;
    diagnosis.file_name = "elk.glb";
    diagnosis.file_bytes = 12'345;
    diagnosis.facts.emplace();
    diagnosis.facts->generator = "hand";
    diagnosis.facts->skinned_node_count = 1;
    diagnosis.facts->rigid_nodes = {"Antler", ""};
    diagnosis.facts->skins = {{"Rig", 3, 1, true}};
    diagnosis.skeleton.emplace();
    diagnosis.skeleton->bone_count = 3;
    for (int i = 0; i < 12; ++i) diagnosis.skeleton->unused_bones.push_back("ik" + std::to_string(i));
    diagnosis.extent_m = {1.0, 2.0, 3.0};
    diagnosis.vertex_count = 4'000;
    DiagnosedClip clip;
    clip.name = "Walk";
    clip.duration_s = 1.25;
    clip.linear_channels = 2;
    clip.is_planned = true;
    clip.row_count = 30;
    clip.wrap = "loop";
    clip.seam = "open";
    clip.error_max_m = 0.00125;
    diagnosis.clips = {clip};
    diagnosis.oddities = {{"late-start", "It starts late."}};
    diagnosis.findings = {
        {Treatment::repair, {IssueCode::warn_weights, "elk.glb: meshes/0", "3 vertices are odd"}},
        {Treatment::repair, {IssueCode::warn_weights, "elk.glb: meshes/1", "5 vertices are odd"}},
        {Treatment::left_out, {IssueCode::warn_left_out, "elk.glb: nodes", "2 rigid meshes"}}};
    DiagnosedBake bake;
    bake.row_count = 30;
    bake.forms = {{"affine RGBA16F", 2'160}};
    bake.is_measured = true;
    bake.error_max_m = 0.00125;
    bake.worst_clip = "Walk";
    diagnosis.bake = bake;
    return diagnosis;
}

TEST(DoctorText, SaysEverySection) {
    const std::string text = doctor_text(sample());
    for (const char* part :
         {"elk.glb: can be baked.", "2 repairs, 1 part left out, 1 oddity", "12,345 bytes, written by hand",
          "1 with 3 joints", "12 bones move no vertex: ik0, ik1", "ik7 and 4 more", "1 x 2 x 3 m",
          "Clips (1)", "Walk", "1.250", "1.25  loops (one more step", "It starts late.",
          "meshes/0: 3 vertices are odd", "meshes/1: 5 vertices are odd", "elk.glb", "2,160 bytes (2.1 KiB)",
          "1.25 mm"})
        EXPECT_TRUE(holds(text, part)) << part << "\n" << text;
    EXPECT_FALSE(holds(text, "--strict"));
    const std::string meaning(issue_kind(IssueCode::warn_weights).meaning);
    EXPECT_EQ(text.find(meaning), text.rfind(meaning)) << "one item for both places";
}

TEST(DoctorText, ARefusalIsTheErrorLineWithItsExitCode) {
    Diagnosis diagnosis;
    diagnosis.file_name = "elk.glb";
    diagnosis.refusal = base::Issue{IssueCode::glb_magic, "elk.glb", "expected glTF"};
    const std::string text = doctor_text(diagnosis);
    EXPECT_TRUE(holds(text, "elk.glb: cannot be baked."));
    EXPECT_TRUE(holds(text, base::format_issue(*diagnosis.refusal)));
    EXPECT_TRUE(holds(text, "(exit code 3)"));
    for (const char* part : {"What is in the file", "Clips", "What a bake would give", "What is odd"})
        EXPECT_FALSE(holds(text, part)) << part;
}

TEST(DoctorText, EscapesAndCutsNames) {
    Diagnosis diagnosis = sample();
    diagnosis.file_name = "e\x1b[1mlk.glb";
    diagnosis.facts->generator = "g\x07" + std::string(500, 'y');
    diagnosis.clips[0].name = "W\x1b[31m" + std::string(500, 'x');
    diagnosis.skeleton->unused_bones = {"\x9b"};
    const std::string text = doctor_text(diagnosis);
    for (const char c : text)
        EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << static_cast<int>(c);
    EXPECT_LT(text.size(), 5'000u);
}

TEST(DoctorJson, NamesItsSchemaAndKeepsEveryKey) {
    using nlohmann::json;
    const json full = json::parse(doctor_json(sample(), -1));
    EXPECT_EQ(full.at("schema"), "posepack-doctor-1");
    EXPECT_EQ(full.at("exit_code"), 0);
    EXPECT_EQ(full.at("findings").at(0).at("treatment"), "repair");
    EXPECT_EQ(full.at("findings").at(2).at("treatment"), "left-out");
    EXPECT_EQ(full.at("bake").at("error").at("max_m"), 0.00125);
    EXPECT_EQ(full.at("clips").at(0).at("plan").at("seam"), "open");
    Diagnosis nothing;
    nothing.file_name = "\xff\xfe";
    nothing.refusal = base::Issue{IssueCode::lim_bones, "", "many"};
    const json empty = json::parse(doctor_json(nothing, 1));
    EXPECT_EQ(empty.at("exit_code"), 6);
    EXPECT_EQ(empty.at("ok"), false);
    EXPECT_EQ(empty.size(), full.size()) << "every key is there, null where nothing was read";
    for (const char* key : {"contents", "skeleton", "size", "vertices", "bake", "strict_refusal"})
        EXPECT_TRUE(empty.at(key).is_null()) << key;
}

}  // namespace
}  // namespace posepack::output
