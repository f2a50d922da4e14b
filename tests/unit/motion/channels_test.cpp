// SPDX-License-Identifier: MIT
// Channels as exporters leave them: of different lengths, of one key, missing, with keys at one time, a
// little off unit length.
#include "sampled.hpp"

namespace posepack::motion {
namespace {

using support::ChannelSpec;
using support::ModelSpec;
using support::turn;
using support::turns;

// What a spline channel holds of keys whose tangents are all zero.
std::vector<float> flat_spline(const std::vector<float>& places) {
    std::vector<float> values;
    for (const float x : places) values.insert(values.end(), {0, 0, 0, x, 0, 0, 0, 0, 0});
    return values;
}

// A parent and a child, both joints.
ModelSpec two_bones() {
    ModelSpec spec = support::one_bone();
    spec.nodes.push_back({{"name", "Child"}, {"translation", {0, 2, 0}}, {"rotation", turn(30, 0, 0, 1)}});
    spec.nodes[0]["children"] = {1};
    spec.skins[0].joints = {0, 1};
    spec.skins[0].inverse_binds = support::inverse_binds_of(spec.nodes, spec.skins[0].joints);
    return spec;
}

TEST(Channels, OfDifferentLengthsHoldTheirEnds) {
    ModelSpec spec = two_bones();
    spec.clips = {
        {"Ragged",
         {{0, "translation", {0.25f, 0.5f}, {1, 0, 0, 2, 0, 0}},
          {0, "rotation", {0, 0.125f, 1}, turns({turn(0, 0, 1, 0), turn(50, 0, 1, 0), turn(80, 1, 1, 0)})},
          {1, "scale", {0.75f}, {2, 2, 2}},
          {1,
           "translation",
           {0.5f, 0.625f},
           {0, 0, 0, 0, 1, 0, 5, 0, 0, -5, 0, 0, 0, 3, 0, 0, 0, 0},
           "CUBICSPLINE"},
          {1, "rotation", {0.3f, 0.4f}, turns({turn(10, 1, 0, 0), turn(90, 1, 0, 0)}), "STEP"}}}};
    const animal::Animal animal = support::animal_of(spec);
    EXPECT_EQ(animal.clips[0].start_s, 0.0);
    EXPECT_EQ(animal.clips[0].duration_s, 1.0);
    for (int step = 0; step <= 80; ++step) EXPECT_LT(sampler_error(animal, 0, step / 80.0), 1e-14) << step;
    EXPECT_EQ(bones_at(animal, 0, 0.0)[0].translation.x, 1.0) << "the first value, before the first key";
    EXPECT_EQ(bones_at(animal, 0, 1.0)[0].translation.x, 2.0) << "the last value, after the last key";
}

TEST(Channels, OfOneKeyHoldItThroughout) {
    ModelSpec spec = two_bones();
    spec.clips = {
        {"Mixed", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}, {1, "scale", {0.5f}, {3, 3, 3}}}},
        {"Poses", {{0, "translation", {0}, {7, 0, 0}}, {1, "scale", {0.5f}, {3, 3, 3}}}},
        {"Spline", {{0, "translation", {0.5f}, flat_spline({4}), "CUBICSPLINE"}}}};
    const animal::Animal animal = support::animal_of(spec);
    for (const double time_s : {0.0, 0.25, 0.5, 1.0}) EXPECT_LT(sampler_error(animal, 0, time_s), 1e-14);
    ClipSampler poses(animal, animal.clips[1]);
    EXPECT_FALSE(poses.moves()) << "keys at two times, but no channel changes";
    EXPECT_EQ(bones_at(animal, 1, 0.0)[0].translation.x, 7.0);
    EXPECT_EQ(animal.clips[2].duration_s, 0.0);
    EXPECT_EQ(bones_at(animal, 2, 0.0)[0].translation.x, 4.0);
}

// A joint that a clip does not name stands as its node does: not as another clip left it, not at the origin.
TEST(Channels, AMissingOneIsTheRestPose) {
    ModelSpec spec = two_bones();
    spec.clips = {
        {"Child", {{1, "rotation", {0, 1}, turns({turn(0, 1, 0, 0), turn(120, 1, 0, 0)})}}},
        {"Parent", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}},
    };
    const animal::Animal animal = support::animal_of(spec);
    EXPECT_LT(sampler_error(animal, 0, 1.0), 1e-14);
    const std::vector<Affine> rest = rest_pose(animal);
    const std::vector<Affine> parent = bones_at(animal, 1, 0.0);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) EXPECT_EQ(parent[1].linear[c][r], rest[1].linear[c][r]);
    EXPECT_EQ(parent[1].translation, rest[1].translation);
    EXPECT_LT(sampler_error(animal, 1, 0.5), 1e-14);
}

struct TimesCase {
    const char* what;
    std::vector<float> times;  // of keys with the values 0, 1, 2, ...
    double at_s;               // after the first key
    double expected;
};

// Equal and nearly equal times: the later key wins, and nothing is divided by their distance.
TEST(Channels, KeysAtOneTime) {
    const TimesCase cases[] = {
        {"first two, at the start", {0, 0, 1}, 0.0, 1},
        {"last two, at the end", {0, 1, 1}, 1.0, 2},
        {"three in the middle", {0, 0.5f, 0.5f, 0.5f, 1}, 0.5, 3},
        {"all", {1, 1, 1}, 0.0, 2},
        {"nearly equal, behind both", {0, 0.5f, 0.5000004f, 1}, 0.5000005, 2},
        {"nearly equal, at the end", {0, 0.5f, 0.5000004f}, 0.6, 2},
    };
    for (const TimesCase& c : cases)
        for (const char* interpolation : {"LINEAR", "STEP", "CUBICSPLINE"}) {
            std::vector<float> places;
            for (std::size_t k = 0; k < c.times.size(); ++k) places.push_back(static_cast<float>(k));
            std::vector<float> values;
            for (const float x : places) values.insert(values.end(), {x, 0, 0});
            const bool is_spline = std::string(interpolation) == "CUBICSPLINE";
            const animal::Animal animal =
                one_channel("translation", c.times, is_spline ? flat_spline(places) : values, interpolation);
            EXPECT_NEAR(bones_at(animal, 0, c.at_s)[0].translation.x, c.expected, 1e-5)
                << c.what << ", " << interpolation;
            for (int step = 0; step <= 40; ++step)
                EXPECT_TRUE(std::isfinite(bones_at(animal, 0, step / 40.0)[0].translation.x))
                    << c.what << ", " << interpolation;
        }
}

// Spans of a tenth and of three seconds with steep tangents: the curve leaves the range of its keys, and
// stays so.
TEST(Channels, SplinesOfUnequalSpansOvershoot) {
    std::vector<float> values = flat_spline({0, 1, 0});
    values[6] = 40;   // out of key 0, a second
    values[9] = -40;  // into key 1
    values[15] = 8;   // out of key 1
    values[18] = -8;  // into key 2
    const animal::Animal animal = one_channel("translation", {0, 0.1f, 3.1f}, values, "CUBICSPLINE");
    for (int step = 0; step <= 310; ++step) EXPECT_LT(sampler_error(animal, 0, step / 100.0), 1e-13) << step;
    // Halfway: (v0 + v1) / 2 + d (out0 - in1) / 8.
    EXPECT_NEAR(bones_at(animal, 0, 0.05)[0].translation.x, 0.5 + 0.1 * 80 / 8, 1e-6);
    EXPECT_NEAR(bones_at(animal, 0, 1.6)[0].translation.x, 0.5 + 3.0 * 16 / 8, 1e-6);
}

// Quantised rotations are off unit length by less than what is reported: bones must not grow for it.
TEST(Channels, RotationsALittleOffUnitKeepTheSizeOfBones) {
    std::vector<float> values = turns({turn(20, 1, 2, 3), turn(75, 0, 2, 1), turn(160, 1, 0, 0)});
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= i / 4 == 1 ? 0.9991f : 1.0009f;
    for (const char* interpolation : {"LINEAR", "STEP"}) {
        const animal::Animal animal = one_channel("rotation", {0, 1, 2}, values, interpolation);
        EXPECT_TRUE(animal.findings.empty());
        for (int step = 0; step <= 20; ++step) {
            const glm::dmat3 m = bones_at(animal, 0, step / 10.0)[0].linear;
            EXPECT_NEAR(glm::determinant(m), 1.0, 1e-12) << interpolation << " step " << step;
            EXPECT_NEAR(glm::length(m[0]), 1.0, 1e-12) << interpolation << " step " << step;
        }
    }
}

}  // namespace
}  // namespace posepack::motion
