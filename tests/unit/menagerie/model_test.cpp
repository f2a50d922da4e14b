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
        {"bear", "07ba69d37355b93175489b70a127d1ec78bfebab786b9f064087a098c35ce368"},
        {"bee", "548c773c2884579f57b829817a1395e2c809dc3aaef59ddd14d3ec94bc453e2b"},
        {"bull", "6444134059f2b0b7f2f2bf8bdc89cd345fd0040e6385be9396061977d8453669"},
        {"cat", "e6c1d656c2d7cfff43a6e86d7224aa4d3f79cc7c0f7f4e4d1c48613fe484a523"},
        {"cow", "9f446dbfc1ab5f74db089b9f099cdc8ef04be02c21d0a578532a0378cba23070"},
        {"crab", "6de80d180667d065740d1781c38879d811642bee67e301ccdf848d249bf7cd27"},
        {"crocodile", "328a4b73361ae5db678b6ab6ba0f5f1d62c0d9150847e5767c274bd8a60a133f"},
        {"crow", "50327f47feaa506f7935b255acb1f506615d037cfb5075e442310de55f16697c"},
        {"deer", "210d9da9bbc8c83180692642c901decd8aadd2aa060189b0df6d28e986c61086"},
        {"donkey", "7db33295046b252f8d7495994cf1f52e1b044bfdb8bfe2e60f03f04946c15536"},
        {"duck", "cd3e7bc6f34b23010c0e25f4b3f191f07d4de3359fe1e3173c7bd26081100242"},
        {"eagle", "8d2a96807c405eb00ea4ea527bedc10d3f37e84414a923750929b06c2ea16133"},
        {"elephant", "4a0f0101d6eed00b5f5b958cb597798d11ff30df01cc554dcbeda320adfba8c3"},
        {"fox", "cfff5ba3e5275310ca829a10ca2364e87bfe0fdc5aa8c923ff017fcc15a2dd2d"},
        {"giraffe", "fbb24184ea8ae44030f13afb8ea374875dcea19cecbb482e09614cd0606f1514"},
        {"goat", "2380704cec25a878851ad81140f1c769ed73e659c981bcf0d50b07a89c275529"},
        {"horse", "fee7a5b789b12d17a7438789508ba4d17535fbe92b7a9ee2fb6f47f5c7c1d7cb"},
        {"lion", "6ab3d86123569ef248572c9f0d3a3594dd3f218a4df9ed242407c4014c3fb2e3"},
        {"mouse", "4c6e442f86acfa65765109131540dfce9a91790db8a251751235c3a8e5245765"},
        {"owl", "7439950b01d6a70fc1ec32b6969b7ccf83d594a5754001580c81e153cd01d592"},
        {"pig", "f920e1a3243f9e7d477d4a516754ba240d0f6943a6534527add94638a342eff8"},
        {"rabbit", "34a72e0269aaf55fa203c419193701a71bf8074087b9ce9f32a4fb7b0a04a1b7"},
        {"shark", "686153cc54223bf8c0f7240e42c69f3c0cd2a66016f09e41f56c1833dc96bdd9"},
        {"sheep", "7c3e7054765ee0d014aec972ad1200e0e830e774ec3edf5ad088b758c325729d"},
        {"sparrow", "95ea44c8be9c96ca72c3e3167a0af099b179c97881132e9cdb80c2615c1d89ac"},
        {"spider", "a6cb28139588914a8f8a8d2f0b991a8ed9471c29e9c5dba7eefe285cd57ca913"},
        {"stag", "f230c0fe7efd0df08b0a7c0d77c9a0b557e9c9ad3e9dfb1f486508ca3289e0b5"},
        {"trout", "94a2abec294e49a0008a516e56736236f78967e9e130e37585d699e18fc024b3"},
        {"viper", "def8e98a4e3e2731e1e4f724fb41dc0a0b0aa6abe98da7fa0e8d4ad354e48219"},
        {"wolf", "8f67eb86390056571a1425fdca80531cced11d5b7459b503f00465ba69e09f76"}};
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
