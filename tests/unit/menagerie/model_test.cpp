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
    ASSERT_EQ(animals().size(), 30u);
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
        {"bear", "ec1951cb68b7bc29e07bb1b935864595c3146aeb4bb444940f66b94188f35274"},
        {"bee", "548c773c2884579f57b829817a1395e2c809dc3aaef59ddd14d3ec94bc453e2b"},
        {"bull", "2bf396e9ab7dad758420d55a467f13f6231095adff8dabf00c672de141c6deb9"},
        {"cat", "e41a2b3df989b71a104ac3abee3e0ab13d189e01d8e58d0e494836df59885494"},
        {"cow", "120932aae25337b1598c55a72d41f6ea21621b87a44f680c1d5a7a78b1ba2c43"},
        {"crab", "6de80d180667d065740d1781c38879d811642bee67e301ccdf848d249bf7cd27"},
        {"crocodile", "25dd71ae0deb07891793fda5afe54a15af0f5ef716baa33865d0030b6b68c923"},
        {"crow", "8ec3ee4a31bda0c916454df4f10ca6684b59f0e9609bee76e678f679daadee8b"},
        {"deer", "e964760882e58cddcc653b0bb7043c8cea172273cc1062484b1c17c6df86f729"},
        {"donkey", "19a43acc60b78f20e3b241331bda8321b7b5aa80f810a716271ed7eec22e0e65"},
        {"duck", "a9121ce834e601e0d9acd92fa3db3253ba41da7e82b4a6281dd6a97882466fdd"},
        {"eagle", "ea73baa1a95721d603f9319b1faa6720abbafa94e352e7362a3349dc41f3a301"},
        {"elephant", "6de2bd80a3ac13f35359abb57db2bc47e1921ef370b5a81bbcd8fd8dc38ebdda"},
        {"fox", "28ed7a349bce67558309cbbc2208bc96b19f305923509c117d12caa6b27b38f6"},
        {"giraffe", "5f8eacd36aa449c4607811e51560348e986eaaa4ba3d8c8d2e9ba79b0ef5897e"},
        {"goat", "2380704cec25a878851ad81140f1c769ed73e659c981bcf0d50b07a89c275529"},
        {"horse", "8dd902ad46284927f0dda045158508ffbe91b788f172f662ec26cc87cad4ae10"},
        {"lion", "2f42d48548a6a6c69df5bd7d3e5a154867593c32dcd0956d0a7ac781beecf852"},
        {"mouse", "ccb36897529b3457ce3825cd889ea99087df3d2e0bdc6b994ca343d04d5614fe"},
        {"owl", "e165d885520a92ac69c53f6f131b13fa7c16b6912533041a0d47498ead78f1bf"},
        {"pig", "af246491b552760c5865b740e99c010bea32876f7f20cebdc111c48b807a3a7b"},
        {"rabbit", "342d586f15e6c546795fad55e5a7d721c05c07e342af724860f04b2ad703e717"},
        {"shark", "a278040bef94ef42acfe5a8a60fd10d00771a0c0b3f983a6914351c0f037e5e1"},
        {"sheep", "c484aa296f1ac2ff5b39ca0b63a795cd2b00ec8496767bd3f3474f3686519a92"},
        {"sparrow", "b68b2f3b524d432aee87e4d41b947292f4f4733fb891826783f604cce2bf73f6"},
        {"spider", "a6cb28139588914a8f8a8d2f0b991a8ed9471c29e9c5dba7eefe285cd57ca913"},
        {"stag", "c76fb17da7d139c1cbc6d22b839faa47419e0c51e1920f6ceceb47cbf9e84dcf"},
        {"trout", "94a2abec294e49a0008a516e56736236f78967e9e130e37585d699e18fc024b3"},
        {"viper", "def8e98a4e3e2731e1e4f724fb41dc0a0b0aa6abe98da7fa0e8d4ad354e48219"},
        {"wolf", "9f2909c731c6976846c3421a6d0377b36034a2762afd69d841c88681a6f64542"}};
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
    double highest = 0.0;
    for (const auto& position : positions) highest = std::max(highest, position[1]);
    EXPECT_NEAR(lowest, 0.0, std::max(0.001, 0.01 * highest));
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
