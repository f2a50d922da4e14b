// SPDX-License-Identifier: MIT
// The generated animals are as messy as those that people make: each number in the range of real files.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "glb_probe.hpp"
#include "menagerie/glb_writer.hpp"
#include "menagerie/menagerie.hpp"
#include "menagerie/statistics.hpp"

namespace posepack::menagerie {
namespace {

using nlohmann::json;

std::vector<Model> all_models() {
    std::vector<Model> models;
    for (const MenagerieAnimal& animal : animals()) models.push_back(*build_model(animal.id));
    return models;
}

std::size_t json_bytes_of(const Model& model) {
    const std::vector<std::uint8_t> glb = write_glb(model);
    return glb[12] + (std::size_t{glb[13]} << 8) + (std::size_t{glb[14]} << 16);
}

TEST(MenagerieStatistics, EveryRowLiesInItsRange) {
    for (const Model& model : all_models()) {
        SCOPED_TRACE(model.name);
        const Statistics s = statistics_of(model, json_bytes_of(model));
        EXPECT_GE(s.depth, 8u);
        EXPECT_LE(s.depth, 13u);
        EXPECT_GE(s.clips, 9u);
        EXPECT_GE(s.mean_influences, 1.5);
        EXPECT_LE(s.mean_influences, 2.2);
        EXPECT_GE(s.weightless_share, 0.10 - 1e-9);
        EXPECT_LE(s.weightless_share, 0.15);
        EXPECT_NEAR(s.constant_channel_share, 0.8, 0.07);
        EXPECT_GE(s.json_bytes, 100'000u);
        EXPECT_LE(s.json_bytes, 160u << 10);
        EXPECT_GE(s.step_p50_degrees, 0.3);
        EXPECT_LE(s.step_p50_degrees, 1.5);
        EXPECT_GE(s.step_p99_degrees, 5.0);
        EXPECT_LE(s.step_p99_degrees, 30.0);
        EXPECT_GE(s.step_max_degrees, 35.0);
        EXPECT_LE(s.step_max_degrees, 140.0);
    }
}

TEST(MenagerieStatistics, HalfTheAnimalsHaveKeysAtFilmRate) {
    const std::vector<Model> models = all_models();
    EXPECT_EQ(std::count_if(models.begin(), models.end(),
                            [](const Model& model) { return model.clips.front().rate_hz == 24; }),
              15);
}

TEST(MenagerieStatistics, TheirExportersDiffer) {
    int hundredfold = 0;
    int without_prefix = 0;
    std::set<std::string> armatures;
    std::set<Naming> namings;
    for (const Model& model : all_models()) {
        hundredfold += model.style.armature_scale == 100.0 ? 1 : 0;
        without_prefix += model.style.prefixed ? 0 : 1;
        armatures.insert(model.style.armature);
        namings.insert(model.style.naming);
    }
    EXPECT_EQ(hundredfold, 2);
    EXPECT_GE(without_prefix, 4);
    EXPECT_GE(armatures.size(), 8u);
    EXPECT_EQ(namings.size(), 4u);
}

TEST(MenagerieStatistics, OneClipIsCubicAndOneHoldsItsKeys) {
    std::map<std::string, int> words;
    for (const MenagerieAnimal& animal : animals()) {
        const GlbProbe probe(generate_glb(animal.id));
        for (const json& animation : probe.document().at("animations"))
            ++words[animation.at("samplers").at(0).value("interpolation", "LINEAR")];
    }
    EXPECT_EQ(words["CUBICSPLINE"], 1);
    EXPECT_EQ(words["STEP"], 1);
}

// Only the rabbit's Jump scales a joint that carries others, and not alike in all directions.
TEST(MenagerieStatistics, OneClipSquashesAndStretches) {
    std::vector<std::string> found;
    for (const Model& model : all_models()) {
        std::set<int> parents;
        for (const RigJoint& joint : model.rig.joints) parents.insert(joint.parent);
        for (const Clip& clip : model.clips) {
            bool squashes = false;
            for (const Pose& pose : clip.keys) {
                for (const int joint : parents) {
                    if (joint < 0) continue;
                    const Vec3& scale = pose.scales[static_cast<std::size_t>(joint)];
                    squashes = squashes || scale.x != scale.z;
                }
            }
            if (squashes) found.push_back(model.name + ' ' + clip.action);
        }
    }
    EXPECT_EQ(found, std::vector<std::string>{"Rabbit Jump"});
}

// Names, parents and rest places of two rigs.
void expect_same_rig(const Rig& a, const Rig& b) {
    ASSERT_EQ(a.joints.size(), b.joints.size());
    for (std::size_t joint = 0; joint < a.joints.size(); ++joint) {
        EXPECT_EQ(a.joints[joint].name, b.joints[joint].name);
        EXPECT_EQ(a.joints[joint].parent, b.joints[joint].parent);
        EXPECT_EQ(a.joints[joint].head, b.joints[joint].head) << a.joints[joint].name;
    }
}

TEST(MenagerieStatistics, TwoPairsShareRigs) {
    expect_same_rig(build_model("cow")->rig, build_model("bull")->rig);
    expect_same_rig(build_model("deer")->rig, build_model("stag")->rig);
}

TEST(MenagerieBirds, ShareTheFiveRigsOfTheDefaultCatalog) {
    ASSERT_EQ(birds().size(), 25u);
    std::map<std::string, int> sharers;
    for (const std::string_view id : birds()) {
        SCOPED_TRACE(id);
        const Model bird = *build_bird(id);
        EXPECT_FALSE(build_model(id));
        EXPECT_GE(bird.clips.size(), 9u);
        for (const char* kind : {"crow", "duck", "eagle", "owl", "sparrow"}) {
            const Rig rig = build_model(kind)->rig;
            if (rig.joints.back().head != bird.rig.joints.back().head) continue;
            expect_same_rig(bird.rig, rig);
            ++sharers[kind];
        }
    }
    EXPECT_EQ(sharers.size(), 5u);
    for (const auto& [kind, count] : sharers) EXPECT_EQ(count, 5) << kind;
    EXPECT_FALSE(build_bird("goat"));
}

// Its triangles are all there, under the joints, and none of them is skinned.
TEST(MenagerieToy, HangsItsPartsUnderItsJoints) {
    const Model toy = build_toy();
    const GlbProbe probe(write_glb(toy));
    const json& document = probe.document();
    EXPECT_FALSE(document.contains("skins"));
    EXPECT_GE(document.at("meshes").size(), 20u);
    std::size_t indices = 0;
    for (const json& mesh : document.at("meshes")) {
        const json& primitive = mesh.at("primitives").at(0);
        EXPECT_FALSE(primitive.at("attributes").contains("JOINTS_0"));
        indices += probe.values(primitive.at("indices")).size();
    }
    EXPECT_EQ(indices, toy.mesh.indices.size());
    std::size_t carriers = 0;
    for (const json& node : document.at("nodes")) carriers += node.contains("mesh") ? 1 : 0;
    EXPECT_EQ(carriers, document.at("meshes").size());
}

TEST(MenagerieHerd, BeginsWithThePublishedAnimals) {
    const std::vector<HerdMember> members = herd(65, 7);
    ASSERT_EQ(members.size(), 65u);
    for (std::size_t index = 0; index < animals().size(); ++index) {
        EXPECT_EQ(members[index].id, animals()[index].id);
        EXPECT_EQ(members[index].seed, 0u);
    }
    EXPECT_EQ(members[30].id, std::string(animals()[0].id) + "_0031");
    EXPECT_EQ(members[64].id, std::string(animals()[4].id) + "_0065");
    EXPECT_EQ(herd(40, 7)[35].seed, members[35].seed);
    EXPECT_NE(herd(40, 8)[35].seed, members[35].seed);
}

// Others of a kind differ from it and from each other, and stand on the ground like it.
TEST(MenagerieHerd, OthersOfAKindAreWhole) {
    for (const HerdMember& member : herd(60, 3)) {
        if (member.seed == 0) continue;
        SCOPED_TRACE(member.id);
        const Model other = *build_model(member.kind, member.seed);
        const Model published = *build_model(member.kind);
        EXPECT_NE(write_glb(other), write_glb(published));
        EXPECT_EQ(other.rig.joints.size(), published.rig.joints.size());
        double lowest = 1e9;
        double highest = -1e9;
        for (const Vertex& vertex : other.mesh.vertices) {
            lowest = std::min(lowest, vertex.position.y);
            highest = std::max(highest, vertex.position.y);
        }
        EXPECT_NEAR(lowest, 0.0, std::max(0.001, 0.01 * highest));
    }
}

}  // namespace
}  // namespace posepack::menagerie
