// SPDX-License-Identifier: MIT
// What the generated files hold: counts, references, weights, and the same bytes everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/sha256.hpp"
#include "glb_probe.hpp"
#include "menagerie/menagerie.hpp"

namespace posepack::menagerie {
namespace {

using nlohmann::json;

std::vector<std::string> ids() {
    std::vector<std::string> ids;
    for (const MenagerieAnimal& animal : animals()) ids.emplace_back(animal.id);
    return ids;
}

class EveryAnimal : public testing::TestWithParam<std::string> {
 protected:
    GlbProbe probe{generate_glb(GetParam())};

    const json& attributes() const {
        return probe.document().at("meshes").at(0).at("primitives").at(0).at("attributes");
    }
    std::size_t joint_count() const { return probe.document().at("skins").at(0).at("joints").size(); }
};

TEST(Menagerie, ListsItsAnimalsInOrder) {
    ASSERT_EQ(animals().size(), 5u);
    for (std::size_t index = 0; index < animals().size(); ++index) {
        const MenagerieAnimal& animal = animals()[index];
        EXPECT_EQ(animal.file_name, std::string(animal.id) + ".glb");
        if (index > 0) {
            EXPECT_LT(animals()[index - 1].id, animal.id);
        }
    }
}

TEST(Menagerie, GivesNothingForUnknownIds) {
    for (const char* id : {"", "Goat", "goat.glb", "unicorn", " goat"}) {
        EXPECT_TRUE(generate_glb(id).empty()) << id;
        EXPECT_FALSE(build_model(id)) << id;
    }
}

// The published measures of the Goat.
TEST(Menagerie, GoatIsThePublishedGoat) {
    const GlbProbe probe(generate_glb("goat"));
    const json& document = probe.document();
    EXPECT_EQ(document.at("skins").at(0).at("joints").size(), 53u);
    EXPECT_EQ(document.at("animations").size(), 9u);
    const json& primitive = document.at("meshes").at(0).at("primitives").at(0);
    EXPECT_EQ(
        document.at("accessors").at(primitive.at("attributes").at("POSITION").get<std::size_t>()).at("count"),
        2500);
    std::size_t rows = 0;
    for (const json& animation : document.at("animations")) {
        const std::size_t steps = probe.key_times(animation).size() - 1;
        const bool closed = probe.largest_gap_m(animation, 0, steps) < 1e-6;
        rows += steps + (closed ? 0 : 1);
    }
    EXPECT_EQ(rows, 496u);
}

// A change of these digests is a change of the animals: bake everything again, and say so in the change log.
TEST(Menagerie, BytesAreTheSameOnEveryHost) {
    const std::map<std::string, std::string> digests = {
        {"goat", "2380704cec25a878851ad81140f1c769ed73e659c981bcf0d50b07a89c275529"},
        {"sparrow", "9f0af6eb1c6cdf2b3db3d2d6ae7f1f26f0fe2432c6d5339942c802eb476aaa8d"},
        {"trout", "8d4b3d6c627ef00d9102c4312717a6c5f6a765f35139332c8d0785b21a85a82d"},
        {"viper", "8910641c567dc426b0fdd0139818c7367179983246264a4ca97f9dcd492eefd0"},
        {"wolf", "15737b3db88cc2fda991bfcbab99023043e764e17d940e121882302130d94962"}};
    ASSERT_EQ(digests.size(), animals().size());
    for (const auto& [id, digest] : digests) {
        const std::vector<std::uint8_t> bytes = generate_glb(id);
        EXPECT_EQ(base::hexadecimal(base::sha256(bytes)), digest) << id;
        EXPECT_EQ(generate_glb(id), bytes) << id;
    }
}

TEST_P(EveryAnimal, HasTheMessOfRealFiles) {
    const json& document = probe.document();
    EXPECT_GE(document.at("animations").size(), 9u);
    const std::vector<std::vector<double>>& weights = probe.values(attributes().at("WEIGHTS_0"));
    const std::vector<std::vector<double>>& joints = probe.values(attributes().at("JOINTS_0"));
    EXPECT_GE(weights.size(), 800u);
    EXPECT_LE(weights.size(), 3000u);
    double influences = 0.0;
    std::set<double> weighted;
    for (std::size_t vertex = 0; vertex < weights.size(); ++vertex) {
        for (std::size_t slot = 0; slot < 4; ++slot) {
            if (weights[vertex][slot] == 0.0) continue;
            influences += 1.0;
            weighted.insert(joints[vertex][slot]);
        }
    }
    const double mean = influences / static_cast<double>(weights.size());
    EXPECT_GE(mean, 1.5);
    EXPECT_LE(mean, 2.2);
    const double weightless = 1.0 - static_cast<double>(weighted.size()) / static_cast<double>(joint_count());
    EXPECT_GE(weightless, 0.095);
    EXPECT_LE(weightless, 0.15);
}

TEST_P(EveryAnimal, WeightsSumToExactlyOne) {
    const auto& weights = probe.values(attributes().at("WEIGHTS_0"));
    const auto& joints = probe.values(attributes().at("JOINTS_0"));
    ASSERT_EQ(weights.size(), joints.size());
    for (std::size_t vertex = 0; vertex < weights.size(); ++vertex) {
        double sum = 0.0;
        for (std::size_t slot = 0; slot < 4; ++slot) {
            EXPECT_GE(weights[vertex][slot], 0.0);
            EXPECT_LT(joints[vertex][slot], static_cast<double>(joint_count()));
            sum += weights[vertex][slot];
        }
        EXPECT_EQ(sum, 1.0) << "vertex " << vertex;
    }
}

TEST_P(EveryAnimal, NormalsAreUnitAndColoursOpaque) {
    for (const auto& n : probe.values(attributes().at("NORMAL"))) {
        EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0, 1e-5);
    }
    for (const auto& colour : probe.values(attributes().at("COLOR_0"))) EXPECT_EQ(colour[3], 255.0);
}

// Every part is a closed surface: each edge is passed once in each direction.
TEST_P(EveryAnimal, SurfaceIsClosed) {
    const auto& indices =
        probe.values(probe.document().at("meshes").at(0).at("primitives").at(0).at("indices"));
    const std::size_t vertex_count = probe.values(attributes().at("POSITION")).size();
    ASSERT_EQ(indices.size() % 3, 0u);
    std::map<std::pair<double, double>, int> edges;
    std::set<double> used;
    for (std::size_t index = 0; index < indices.size(); index += 3) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const double from = indices[index + corner][0];
            const double to = indices[index + (corner + 1) % 3][0];
            ASSERT_LT(from, static_cast<double>(vertex_count));
            ++edges[{from, to}];
            used.insert(from);
        }
    }
    EXPECT_EQ(used.size(), vertex_count);
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

// Faces look outwards: the volume that the surface encloses is positive.
TEST_P(EveryAnimal, SurfaceLooksOutwards) {
    const auto& indices =
        probe.values(probe.document().at("meshes").at(0).at("primitives").at(0).at("indices"));
    const auto& positions = probe.values(attributes().at("POSITION"));
    const auto at = [&](std::size_t index) {
        const std::vector<double>& p = positions[static_cast<std::size_t>(indices[index][0])];
        return glm::dvec3(p[0], p[1], p[2]);
    };
    double volume = 0.0;
    for (std::size_t index = 0; index < indices.size(); index += 3) {
        volume += glm::dot(at(index), glm::cross(at(index + 1), at(index + 2))) / 6.0;
    }
    EXPECT_GT(volume, 0.0);
}

TEST_P(EveryAnimal, StandsOnTheGroundFacingForward) {
    const auto& positions = probe.values(attributes().at("POSITION"));
    double lowest = 1e9;
    for (const auto& position : positions) lowest = std::min(lowest, position[1]);
    EXPECT_NEAR(lowest, 0.0, 0.001);
    const Model model = *build_model(GetParam());
    const int head = find_joint(model.rig, "Head");
    ASSERT_GE(head, 0);
    EXPECT_GT(model.rig.joints[static_cast<std::size_t>(head)].head.z, 0.0);
    EXPECT_GT(model.rig.joints[static_cast<std::size_t>(head)].head.y, 0.0);
}

// At rest, joint global x inverse bind is the identity: the node's rest pose is the bind pose.
TEST_P(EveryAnimal, RestPoseIsBindPose) {
    json still = json::object();
    still["channels"] = json::array();
    const std::vector<glm::dmat4> globals = probe.globals(still, 0);
    const json& skin = probe.document().at("skins").at(0);
    const auto& inverse = probe.values(skin.at("inverseBindMatrices"));
    ASSERT_EQ(inverse.size(), joint_count());
    for (std::size_t joint = 0; joint < inverse.size(); ++joint) {
        glm::dmat4 bind(1.0);
        for (int entry = 0; entry < 16; ++entry)
            bind[entry / 4][entry % 4] = inverse[joint][static_cast<std::size_t>(entry)];
        const glm::dmat4 product = globals[skin.at("joints").at(joint).get<std::size_t>()] * bind;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row)
                EXPECT_NEAR(product[column][row], column == row ? 1.0 : 0.0, 1e-5);
        }
    }
}

TEST_P(EveryAnimal, KeysLieOnTheGridOfTheFile) {
    const Model model = *build_model(GetParam());
    for (const json& animation : probe.document().at("animations")) {
        const int rate_hz = model.clips.front().rate_hz;
        const std::vector<double> times = probe.key_times(animation);
        ASSERT_GE(times.size(), 2u);
        for (std::size_t key = 0; key < times.size(); ++key) {
            EXPECT_EQ(times[key], static_cast<float>(static_cast<double>(key) / rate_hz));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Menagerie, EveryAnimal, testing::ValuesIn(ids()),
                         [](const testing::TestParamInfo<std::string>& info) { return info.param; });

}  // namespace
}  // namespace posepack::menagerie
