// SPDX-License-Identifier: MIT
// The doctor: its counts are those of the model, its verdict that of a bake.
#include "bake/doctor.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bake/bake_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using base::IssueCode;
using output::Diagnosis;
using output::Treatment;
using support::GlbBuilder;
using support::ModelSpec;

Diagnosis examined(const support::Bytes& glb, const DoctorOptions& options = {}) {
    return diagnose("tail.glb", glb, options);
}

std::vector<std::string> oddities_of(const Diagnosis& diagnosis) {
    std::vector<std::string> ids;
    for (const output::Oddity& oddity : diagnosis.oddities) {
        EXPECT_FALSE(oddity.detail.empty()) << oddity.id;
        ids.push_back(oddity.id);
    }
    std::sort(ids.begin(), ids.end());
    return ids;
}

TEST(Doctor, CountsWhatTheModelHolds) {
    const support::Bytes glb = support::glb_of(support::tail());
    const Diagnosis found = examined(glb);
    EXPECT_FALSE(found.refusal);
    EXPECT_FALSE(found.strict_refusal);
    EXPECT_EQ(found.file_bytes, glb.size());
    ASSERT_TRUE(found.facts && found.skeleton && found.bake);
    EXPECT_EQ(found.facts->node_count, 6u);
    EXPECT_EQ(found.facts->skinned_node_count, 1u);
    EXPECT_EQ(found.facts->influence_set_count, 1u);
    ASSERT_EQ(found.facts->skins.size(), 1u);
    EXPECT_EQ(found.facts->skins[0].joint_count, 3u);
    EXPECT_EQ(found.facts->skins[0].user_count, 1u);
    EXPECT_TRUE(found.facts->skins[0].has_inverse_binds);
    EXPECT_EQ(found.vertex_count, 12u);
    EXPECT_EQ(found.skeleton->bone_count, 3u);
    EXPECT_EQ(found.skeleton->longest_chain, 3u);
    for (const output::DiagnosedFinding& finding : found.findings)
        EXPECT_EQ(finding.treatment, Treatment::remark) << base::format_issue(finding.issue);
}

TEST(Doctor, ClipsSayTheirKeysAndTheirEnds) {
    const Diagnosis found = examined(support::glb_of(support::tail()));
    ASSERT_EQ(found.clips.size(), 3u);
    const output::DiagnosedClip& wag = found.clips[0];
    EXPECT_EQ(wag.name, "Wag");
    EXPECT_EQ(wag.source_name, "Rig|Wag");
    EXPECT_NEAR(wag.key_rate_hz, 30.0, 1e-3);
    EXPECT_EQ(wag.wrap, "loop");
    EXPECT_EQ(wag.seam, "closed");
    EXPECT_TRUE(wag.moves);
    EXPECT_GT(wag.linear_channels, 0u);
    EXPECT_EQ(wag.cubic_channels + wag.step_channels, 0u);
    EXPECT_GT(found.clips[1].cubic_channels, 0u);
    EXPECT_GT(found.clips[2].step_channels, 0u);
}

TEST(Doctor, GivesTheFiguresOfABake) {
    const support::Bytes glb = support::glb_of(support::tail());
    recipe::AnimalEntry entry;
    entry.canonical_json = "{}";
    const auto baked = bake_animal(entry, glb, {});
    ASSERT_TRUE(baked);
    const recipe::BakeRecord& record = baked.value().record;
    const Diagnosis found = examined(glb);
    ASSERT_TRUE(found.bake);
    EXPECT_EQ(found.bake->row_count, record.row_count);
    EXPECT_EQ(found.bake->texel_bytes, record.texel_bytes);
    EXPECT_EQ(found.bake->worst_clip, record.error.clip);
    EXPECT_EQ(found.bake->error_max, static_cast<double>(record.error.max));
    EXPECT_NEAR(found.radius_m, static_cast<double>(record.radius_m), 1e-6);
    ASSERT_EQ(found.bake->forms.size(), 5u);
    EXPECT_EQ(found.bake->forms[0].bytes, std::uint64_t{record.row_count} * 3 * 64);
    EXPECT_EQ(found.bake->forms[3].bytes, std::uint64_t{record.row_count} * 3 * 24);
    EXPECT_EQ(found.bake->forms[4].bytes, std::uint64_t{record.row_count} * 3 * 16);
    DoctorOptions quick;
    quick.measure = false;
    EXPECT_FALSE(examined(glb, quick).bake->is_measured);
}

TEST(Doctor, RepairsAreRefusedUnderStrict) {
    GlbBuilder glb = support::builder_of(support::tail());
    glb.set(glb.attribute(0, "WEIGHTS_0"), 0, 3.0f);
    const Diagnosis found = examined(glb.build());
    ASSERT_FALSE(found.findings.empty());
    EXPECT_EQ(found.findings[0].treatment, Treatment::repair);
    EXPECT_EQ(found.findings[0].issue.code, IssueCode::warn_weights);
    ASSERT_TRUE(found.strict_refusal);
    EXPECT_EQ(found.strict_refusal->code, IssueCode::glb_weights);
    DoctorOptions strict;
    strict.strict = true;
    const Diagnosis refused = examined(glb.build(), strict);
    ASSERT_TRUE(refused.refusal);
    EXPECT_EQ(refused.refusal->code, IssueCode::glb_weights);
    EXPECT_TRUE(refused.skeleton) << "what could be read is still shown";
    EXPECT_FALSE(refused.bake);
}

TEST(Doctor, RefusalsAreThoseOfABake) {
    GlbBuilder still = support::builder_of(support::tail());
    still.document.erase("animations");
    GlbBuilder extended = support::builder_of(support::tail());
    extended.document["extensionsRequired"] = {"ACME_x"};
    const support::Bytes files[] = {
        {}, still.build(), extended.build(), support::glb_of(support::one_bone())};
    for (const support::Bytes& file : files) {
        recipe::AnimalEntry entry;
        entry.model = "tail.glb";
        entry.canonical_json = "{}";
        const auto baked = bake_animal(entry, file, {});
        const Diagnosis found = examined(file);
        ASSERT_FALSE(baked);
        ASSERT_TRUE(found.refusal);
        EXPECT_EQ(base::format_issue(*found.refusal), base::format_issue(baked.issue()));
        EXPECT_FALSE(found.bake);
    }
}

struct OddCase {
    const char* id;
    void (*change)(GlbBuilder&);
};

// The armature is put above node 0, the root joint of the tail.
void add_armature(GlbBuilder& glb, support::Json node) {
    node["children"] = {0};
    glb.add("nodes", std::move(node));
}

const OddCase kOdd[] = {
    {"armature-scale",
     [](GlbBuilder& glb) {
         add_armature(glb, {{"scale", {2, 2, 2}}});
     }},
    {"armature-stretch",
     [](GlbBuilder& glb) {
         add_armature(glb, {{"scale", {1, 2, 1}}});
     }},
    {"armature-mirror",
     [](GlbBuilder& glb) {
         add_armature(glb, {{"scale", {-1, 1, 1}}});
     }},
    {"huge",
     [](GlbBuilder& glb) {
         add_armature(glb, {{"scale", {1000, 1000, 1000}}});
     }},
    {"tiny",
     [](GlbBuilder& glb) {
         add_armature(glb, {{"scale", {1e-4, 1e-4, 1e-4}}});
     }},
    {"armature-shear",
     [](GlbBuilder& glb) {
         add_armature(glb, {{"matrix", {1, 0, 0, 0, 0.5, 0.8660254037844386, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
     }},
    {"mesh-node-moved",
     [](GlbBuilder& glb) {
         glb.document["nodes"][5]["translation"] = {1, 0, 0};
     }},
    {"no-bind-pose", [](GlbBuilder& glb) { glb.document["skins"][0].erase("inverseBindMatrices"); }},
    {"unused-skin",
     [](GlbBuilder& glb) {
         glb.add("skins", {{"joints", {0}}});
     }},
    {"several-scenes",
     [](GlbBuilder& glb) {
         glb.document["scenes"] = {{{"nodes", {0}}}, {{"nodes", {5}}}};
     }},
    {"outside-images",
     [](GlbBuilder& glb) {
         glb.add("images", {{"uri", "fur.png"}});
     }},
    {"same-name", [](GlbBuilder& glb) { glb.document["animations"][1]["name"] = "rig|WAG"; }},
};

TEST(Doctor, NamesEveryOddity) {
    const std::vector<std::string> usual = oddities_of(examined(support::glb_of(support::tail())));
    for (const OddCase& odd : kOdd) {
        GlbBuilder glb = support::builder_of(support::tail());
        odd.change(glb);
        const Diagnosis found = examined(glb.build());
        const std::vector<std::string> ids = oddities_of(found);
        EXPECT_EQ(std::count(usual.begin(), usual.end(), odd.id), 0) << odd.id << " of a plain model";
        EXPECT_EQ(std::count(ids.begin(), ids.end(), odd.id), 1) << odd.id;
    }
}

TEST(Doctor, FoldedSkinsAreToldOf) {
    const Diagnosis found = examined(support::glb_of(support::folded_twice(support::tail())));
    ASSERT_TRUE(found.skeleton);
    EXPECT_EQ(found.skeleton->bone_count, 3u);
    const std::vector<std::string> ids = oddities_of(found);
    EXPECT_EQ(std::count(ids.begin(), ids.end(), "folded-skins"), 1);
}

TEST(Doctor, OdditiesOfClipsAndBones) {
    ModelSpec spec = support::one_bone();
    spec.nodes.push_back({{"name", "Helper"}});
    spec.skins[0].joints.push_back(1);
    if (!spec.skins[0].inverse_binds.empty())
        spec.skins[0].inverse_binds.push_back(spec.skins[0].inverse_binds[0]);
    spec.clips = {
        {"Pose", {{0, "translation", {0}, {1, 2, 3}}}},
        {"Still", {{0, "translation", {0, 1}, {1, 2, 3, 1, 2, 3}}}},
        {"Late", {{0, "translation", {2, 3}, {0, 0, 0, 1, 2, 3}}}},
        {"Uneven",
         {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}, {1, "scale", {0.5, 1}, {1, 1, 1, 2, 2, 2}}}},
        {"Mixed",
         {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}, {1, "scale", {0, 1}, {1, 1, 1, 2, 2, 2}, "STEP"}}}};
    const Diagnosis found = examined(support::glb_of(spec));
    ASSERT_TRUE(found.skeleton);
    EXPECT_EQ(found.skeleton->unused_bones, std::vector<std::string>{"Helper"});
    const std::vector<std::string> ids = oddities_of(found);
    for (const char* id :
         {"single-pose", "still-clip", "late-start", "uneven-channels", "mixed-steps", "unused-bones"})
        EXPECT_EQ(std::count(ids.begin(), ids.end(), id), 1) << id;
}

}  // namespace
}  // namespace posepack::bake
