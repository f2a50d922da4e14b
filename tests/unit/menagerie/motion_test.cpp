// SPDX-License-Identifier: MIT
// How the animals move: seams as the catalog states them, and ground speeds from what stands on the ground.
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "glb_probe.hpp"
#include "menagerie/catalog_text.hpp"
#include "menagerie/menagerie.hpp"

namespace posepack::menagerie {
namespace {

using nlohmann::json;

const json& catalog() {
    static const json catalog =
        json::parse(std::ifstream(std::string(POSEPACK_CATALOGS) + "/menagerie.json"));
    return catalog;
}

const json& wish(const std::string& id, const std::string& clip) {
    for (const json& wish : catalog().at("animals").at(id).at("clips")) {
        if (wish.at("name") == clip) return wish;
    }
    ADD_FAILURE() << id << " has no clip " << clip << " in the catalog";
    return catalog();
}

TEST(MenagerieCatalog, NamesEveryAnimalAndClip) {
    ASSERT_EQ(catalog().at("animals").size(), animals().size());
    for (const MenagerieAnimal& animal : animals()) {
        const Model model = *build_model(animal.id);
        const json& entry = catalog().at("animals").at(std::string(animal.id));
        EXPECT_EQ(entry.at("model"), std::string(animal.file_name));
        ASSERT_EQ(entry.at("clips").size(), model.clips.size()) << animal.id;
        for (std::size_t index = 0; index < model.clips.size(); ++index) {
            EXPECT_EQ(entry.at("clips").at(index).at("name"), model.clips[index].name);
        }
    }
}

// posepack menagerie DIR --animals 30, or --birds, writes the same text, but for the schema's path.
void expect_catalog(const char* name, const std::vector<CatalogAnimal>& entries) {
    std::ifstream file(std::string(POSEPACK_CATALOGS) + "/" + name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(text == catalog_text(entries, "../schemas/catalog-1.schema.json"))
        << "bring catalogs/" << name << " up to date";
}

TEST(MenagerieCatalog, IsTheTextThatTheModelsGive) {
    std::vector<CatalogAnimal> entries;
    for (const MenagerieAnimal& animal : animals())
        entries.push_back(catalog_animal(std::string(animal.id), *build_model(animal.id)));
    expect_catalog("menagerie.json", entries);
}

TEST(MenagerieCatalog, OfTheBirdsIsTheTextThatTheModelsGive) {
    std::vector<CatalogAnimal> entries;
    for (const std::string_view id : birds())
        entries.push_back(catalog_animal(std::string(id), *build_bird(id)));
    expect_catalog("birds.json", entries);
}

TEST(MenagerieCatalog, OfTheToyIsTheTextThatTheModelGives) {
    expect_catalog("toy.json", {catalog_animal("toy", build_toy())});
}

TEST(MenagerieCatalog, SpeedsAreTheModels) {
    int travelling = 0;
    for (const MenagerieAnimal& animal : animals()) {
        const Model model = *build_model(animal.id);
        for (const Clip& clip : model.clips) {
            const double stated = wish(std::string(animal.id), clip.name).value("speed_mps", 0.0);
            EXPECT_NEAR(stated, clip.ground_speed_mps, 1e-4 * std::max(1.0, stated))
                << animal.id << ' ' << clip.name;
            travelling += clip.ground_speed_mps > 0.0 ? 1 : 0;
        }
    }
    EXPECT_EQ(travelling, 87);
}

// Gaps in units of the largest move of any joint between neighbouring keys.
TEST(MenagerieSeams, AreWhatTheCatalogStates) {
    int open = 0;
    for (const MenagerieAnimal& animal : animals()) {
        const GlbProbe probe(generate_glb(animal.id));
        const Model model = *build_model(animal.id);
        for (const Clip& clip : model.clips) {
            const json& animation = probe.animation(clip.name);
            const std::size_t last = probe.key_times(animation).size() - 1;
            double step = 0.0;
            for (std::size_t key = 0; key < last; ++key)
                step = std::max(step, probe.largest_gap_m(animation, key, key + 1));
            const double gap = probe.largest_gap_m(animation, 0, last);
            const json& stated = wish(std::string(animal.id), clip.name);
            const std::string name = std::string(animal.id) + ' ' + clip.name;
            if (stated.at("wrap") == "once") {
                EXPECT_GT(gap, 1.5 * step) << name;
            } else if (stated.at("seam") == "open") {
                EXPECT_GT(gap, 0.3 * step) << name;
                EXPECT_LT(gap, 1.5 * step) << name;
                ++open;
            } else {
                EXPECT_EQ(gap, 0.0) << name;
            }
        }
    }
    EXPECT_EQ(open, 25);
}

struct GaitCase {
    std::string animal;
    std::string action;
    std::string clip;
    std::vector<std::string> feet;
};

// Every clip of every animal that goes on its feet.
std::vector<GaitCase> gait_cases() {
    std::vector<GaitCase> cases;
    for (const MenagerieAnimal& animal : animals()) {
        const Model model = *build_model(animal.id);
        std::vector<std::string> feet;
        for (const RigJoint& joint : model.rig.joints) {
            const std::string part = joint.name.substr(0, joint.name.find('.'));
            if (part == "FrontFoot" || part == "BackFoot" || part == "Toes" ||
                (part.starts_with("Leg") && part.ends_with("Foot")))
                feet.push_back(joint.name);
        }
        for (const Clip& clip : model.clips) {
            if (feet.empty() || clip.ground_speed_mps == 0.0 || clip.action == "Fly" ||
                clip.action == "Glide")
                continue;
            cases.push_back({std::string(animal.id), clip.action, clip.name, feet});
        }
    }
    return cases;
}

class PlantedFeet : public testing::TestWithParam<GaitCase> {};

// Between two keys at which a foot is on the ground, it moves backwards as fast as the body goes, and nowhere
// else.
TEST_P(PlantedFeet, MoveAtTheGroundSpeed) {
    const GaitCase& gait = GetParam();
    const GlbProbe probe(generate_glb(gait.animal));
    const json& animation = probe.animation(gait.clip);
    const std::vector<double> times = probe.key_times(animation);
    const double stated_mps = wish(gait.animal, gait.clip).at("speed_mps");
    int steps = 0;
    for (const std::string& foot : gait.feet) {
        std::vector<glm::dvec3> places;
        double ground_m = 1e9;
        double highest_m = -1e9;
        for (std::size_t key = 0; key < times.size(); ++key) {
            places.emplace_back(probe.globals(animation, key)[probe.node(foot)][3]);
            ground_m = std::min(ground_m, places.back().y);
            highest_m = std::max(highest_m, places.back().y);
        }
        for (std::size_t key = 0; key + 1 < times.size(); ++key) {
            if (std::max(places[key].y, places[key + 1].y) > ground_m + 1e-4 * (highest_m - ground_m))
                continue;
            const glm::dvec3 move = places[key + 1] - places[key];
            EXPECT_NEAR(-move.z / (times[key + 1] - times[key]), stated_mps, 0.01 * stated_mps)
                << foot << " key " << key;
            EXPECT_NEAR(move.x, 0.0, 1e-5) << foot << " key " << key;
            ++steps;
        }
    }
    EXPECT_GE(steps, static_cast<int>(gait.feet.size()));
}

INSTANTIATE_TEST_SUITE_P(Menagerie, PlantedFeet, testing::ValuesIn(gait_cases()),
                         [](const testing::TestParamInfo<GaitCase>& info) {
                             return info.param.animal + info.param.action;
                         });

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const double along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(p - (a + (b - a) * along));
}

// The body of a snake in a clip's key, tail first, seen from above.
std::vector<glm::dvec3> body_line(const GlbProbe& probe, const json& animation, std::size_t key) {
    const std::vector<glm::dmat4> globals = probe.globals(animation, key);
    std::vector<glm::dvec3> line;
    for (int index = 10; index >= 1; --index)
        line.emplace_back(globals[probe.node("Back" + std::to_string(index))][3]);
    for (int index = 1; index <= 8; ++index)
        line.emplace_back(globals[probe.node("Front" + std::to_string(index))][3]);
    for (glm::dvec3& place : line) place.y = 0.0;
    return line;
}

// How far the body slips off its own track when it goes at a speed: root mean square over joints, metres.
double slip_m(const GlbProbe& probe, const json& animation, double speed_mps) {
    const std::vector<double> times = probe.key_times(animation);
    double sum = 0.0;
    int count = 0;
    for (std::size_t key = 0; key + 1 < times.size(); ++key) {
        const std::vector<glm::dvec3> before = body_line(probe, animation, key);
        const std::vector<glm::dvec3> after = body_line(probe, animation, key + 1);
        const glm::dvec3 ahead(0.0, 0.0, speed_mps * (times[key + 1] - times[key]));
        for (std::size_t joint = 2; joint + 3 < after.size(); ++joint) {
            double nearest = 1e9;
            for (std::size_t index = 0; index + 1 < before.size(); ++index) {
                nearest = std::min(
                    nearest, distance_to_segment(after[joint] + ahead, before[index], before[index + 1]));
            }
            sum += nearest * nearest;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

TEST(MenagerieSnake, FollowsItsTrackAtTheStatedSpeed) {
    const GlbProbe probe(generate_glb("viper"));
    for (const char* clip : {"Crawl", "Slither"}) {
        const json& animation = probe.animation(clip);
        const double stated_mps = wish("viper", clip).at("speed_mps");
        const double slip = slip_m(probe, animation, stated_mps);
        EXPECT_LT(slip, 0.002)
            << clip;  // the joints are corners of the curve: the chords lie off it by this much
        EXPECT_LT(slip, slip_m(probe, animation, 0.95 * stated_mps)) << clip;
        EXPECT_LT(slip, slip_m(probe, animation, 1.05 * stated_mps)) << clip;
    }
}

// Real attacks turn a joint 60 to 140 degrees between two keys.
TEST(MenagerieMotion, GoatsAttackIsFast) {
    const GlbProbe probe(generate_glb("goat"));
    const json& animation = probe.animation("Attack");
    double largest = 0.0;
    for (const json& channel : animation.at("channels")) {
        if (channel.at("target").at("path") != "rotation") continue;
        const auto& keys =
            probe.values(animation.at("samplers").at(channel.at("sampler").get<std::size_t>()).at("output"));
        for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
            double dot = 0.0;
            for (std::size_t part = 0; part < 4; ++part) dot += keys[key][part] * keys[key + 1][part];
            EXPECT_GE(dot, 0.0);  // neighbours lie on the same half of the sphere
            largest = std::max(largest, 2.0 * std::acos(std::min(1.0, std::abs(dot))) * 57.29577951308232);
        }
    }
    EXPECT_GE(largest, 60.0);
    EXPECT_LE(largest, 140.0);
}

}  // namespace
}  // namespace posepack::menagerie
