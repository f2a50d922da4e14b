// SPDX-License-Identifier: MIT
// How the animals move: seams as the catalog states them, and ground speeds from what stands on the ground.
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "glb_probe.hpp"
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
    EXPECT_GE(travelling, 14);
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
    EXPECT_EQ(open, 4);
}

struct GaitCase {
    const char* animal;
    const char* clip;
    std::vector<const char*> feet;
    int least_steps;  // key steps with a foot on the ground, over all feet
};

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
    for (const char* foot : gait.feet) {
        std::vector<glm::dvec3> places;
        double ground_m = 1e9;
        for (std::size_t key = 0; key < times.size(); ++key) {
            places.emplace_back(probe.globals(animation, key)[probe.node(foot)][3]);
            ground_m = std::min(ground_m, places.back().y);
        }
        for (std::size_t key = 0; key + 1 < times.size(); ++key) {
            if (std::max(places[key].y, places[key + 1].y) > ground_m + 1e-5) continue;
            const glm::dvec3 move = places[key + 1] - places[key];
            EXPECT_NEAR(-move.z / (times[key + 1] - times[key]), stated_mps, 0.01 * stated_mps)
                << foot << " key " << key;
            EXPECT_NEAR(move.x, 0.0, 1e-5) << foot << " key " << key;
            ++steps;
        }
    }
    EXPECT_GE(steps, gait.least_steps);
}

const std::vector<const char*> kFourFeet = {"FrontFoot.L", "FrontFoot.R", "BackFoot.L", "BackFoot.R"};

INSTANTIATE_TEST_SUITE_P(
    Menagerie, PlantedFeet,
    testing::Values(GaitCase{"goat", "Walk", kFourFeet, 60}, GaitCase{"goat", "Trot", kFourFeet, 24},
                    GaitCase{"goat", "Gallop", kFourFeet, 8}, GaitCase{"wolf", "Walk", kFourFeet, 40},
                    GaitCase{"wolf", "Trot", kFourFeet, 16}, GaitCase{"wolf", "Gallop", kFourFeet, 6},
                    GaitCase{"sparrow", "Hop", {"Toes.L", "Toes.R"}, 8}),
    [](const testing::TestParamInfo<GaitCase>& info) {
        return std::string(info.param.animal) + info.param.clip;
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
