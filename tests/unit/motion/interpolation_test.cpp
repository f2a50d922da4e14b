// SPDX-License-Identifier: MIT
// One channel at a time: the three interpolations of glTF 2.0 appendix C.
#include <random>

#include "sampled.hpp"

namespace posepack::motion {
namespace {

using support::turn;
using support::turns;

// The quaternions of a channel, with every angle between them.
struct Pair {
    const char* what;
    std::array<float, 4> from, to;
};

std::array<float, 4> negated(std::array<float, 4> q) {
    for (float& c : q) c = -c;
    return q;
}

TEST(Slerp, AgreesWithTheTextbookForEveryAngle) {
    const std::array<float, 4> start = turn(40, 1, -2, 0.5);
    const Pair pairs[] = {
        {"equal", start, start},
        {"nearly equal", start, turn(40.00002, 1, -2, 0.5)},
        {"a thousandth of a degree", start, turn(40.001, 1, -2, 0.5)},
        {"one degree", start, turn(41, 1, -2, 0.5)},
        {"another axis", start, turn(70, 0, 1, 0)},
        {"90 degrees", turn(0, 0, 0, 1), turn(90, 0, 0, 1)},
        {"179.9 degrees", turn(0, 0, 0, 1), turn(179.9, 0, 0, 1)},
        {"180 degrees", turn(0, 0, 0, 1), {0, 0, 1, 0}},
        {"180.1 degrees: the other way round", turn(0, 0, 0, 1), turn(180.1, 0, 0, 1)},
        {"equal, of opposite sign", start, negated(start)},
        {"nearly equal, of opposite sign", start, negated(turn(40.00002, 1, -2, 0.5))},
        {"one degree, of opposite sign", start, negated(turn(41, 1, -2, 0.5))},
    };
    for (const Pair& pair : pairs) {
        const animal::Animal animal = one_channel("rotation", {0, 1}, turns({pair.from, pair.to}));
        for (int step = 0; step <= 64; ++step)
            EXPECT_LT(sampler_error(animal, 0, step / 64.0), 1e-14) << pair.what << " at " << step / 64.0;
    }
}

TEST(Slerp, AgreesForRandomRotations) {
    const std::uint32_t seed = 7;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        const auto from = turn(180 * number(random), number(random), number(random), number(random));
        const auto to = turn(180 * number(random), number(random), number(random), number(random));
        const animal::Animal animal = one_channel("rotation", {0.25f, 1.5f}, turns({from, to}));
        for (const double time_s : {0.0, 0.1, 0.5, 0.93, 1.25})
            ASSERT_LT(sampler_error(animal, 0, time_s), 1e-14) << "seed " << seed << " round " << round;
    }
}

// A rotation and its negative are one: no pose may change when a file flips the sign of a key.
TEST(Slerp, SignsOfKeysDoNotMatter) {
    std::vector<std::array<float, 4>> keys;
    for (int k = 0; k < 6; ++k) keys.push_back(turn(50 * k, 1, k, 2));
    const animal::Animal plain = one_channel("rotation", support::grid(6, 10), turns(keys));
    for (std::size_t k = 1; k < 6; k += 2) keys[k] = negated(keys[k]);
    const animal::Animal flipped = one_channel("rotation", support::grid(6, 10), turns(keys));
    for (int step = 0; step <= 100; ++step) {
        const double time_s = 0.005 * step;
        const std::vector<Affine> a = bones_at(plain, 0, time_s);
        const std::vector<Affine> b = bones_at(flipped, 0, time_s);
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) EXPECT_EQ(a[0].linear[c][r], b[0].linear[c][r]) << time_s;
    }
}

TEST(Linear, TranslationAndScale) {
    for (const char* path : {"translation", "scale"}) {
        const animal::Animal animal = one_channel(path, {0, 0.5f, 2}, {1, 2, 3, 2, 4, 8, 1, 1, 1});
        for (const double time_s : {-1.0, 0.0, 0.25, 0.5, 0.75, 1.999, 2.0, 3.0})
            EXPECT_LT(sampler_error(animal, 0, time_s), 1e-15) << path << " at " << time_s;
    }
    const animal::Animal animal = one_channel("translation", {0, 0.5f, 2}, {1, 2, 3, 2, 4, 8, 1, 1, 1});
    EXPECT_EQ(bones_at(animal, 0, 0.25)[0].translation, glm::dvec3(1.5, 3, 5.5));
    EXPECT_EQ(bones_at(animal, 0, -1.0)[0].translation, glm::dvec3(1, 2, 3)) << "held before the first key";
    EXPECT_EQ(bones_at(animal, 0, 9.0)[0].translation, glm::dvec3(1, 1, 1)) << "and after the last";
}

// A row that lies on a key shows that key, though float32 moved the key up or down a little.
TEST(Step, RowsOnTheGridSeeTheirOwnKey) {
    for (const double rate_hz : {24.0, 25.0, 30.0, 60.0, 24000.0 / 1001}) {
        const std::size_t count = 120;
        std::vector<float> values;
        for (std::size_t k = 0; k < count; ++k) values.insert(values.end(), {static_cast<float>(k), 0, 0});
        const animal::Animal animal =
            one_channel("translation", support::grid(count, rate_hz), values, "STEP");
        ClipSampler sampler(animal, animal.clips[0]);
        std::vector<Affine> bones(1);
        EXPECT_TRUE(sampler.all_steps());
        for (std::size_t k = 0; k < count; ++k) {
            sampler.sample(static_cast<double>(k) / rate_hz, bones);
            EXPECT_EQ(bones[0].translation.x, static_cast<double>(k)) << rate_hz << " Hz";
            sampler.sample((static_cast<double>(k) + 0.999) / rate_hz, bones);
            EXPECT_EQ(bones[0].translation.x, static_cast<double>(k)) << rate_hz << " Hz";
        }
    }
}

// Hermite with tangents, over spans of unequal length: tangents are per second.
TEST(CubicSpline, AgreesWithASecondFormula) {
    const std::uint32_t seed = 11;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(-2.0f, 2.0f);
    for (const char* path : {"translation", "rotation", "scale"})
        for (int round = 0; round < 20; ++round) {
            const std::size_t n = std::string(path) == "rotation" ? 4 : 3;
            std::vector<float> values(4 * 3 * n);
            for (float& v : values) v = number(random);
            const animal::Animal animal =
                one_channel(path, {0.5f, 0.625f, 2.0f, 2.25f}, values, "CUBICSPLINE");
            for (int step = 0; step <= 70; ++step)
                ASSERT_LT(sampler_error(animal, 0, step / 40.0), 1e-13)
                    << path << " seed " << seed << " round " << round << " step " << step;
        }
}

TEST(CubicSpline, KnownValues) {
    // From 0 to 1 in two seconds: out-tangent 1 a second, in-tangent -0.5 a second.
    const animal::Animal animal = one_channel(
        "translation", {0, 2}, {9, 9, 9, 0, 0, 0, 1, 0, 0, -0.5f, 0, 0, 1, 0, 0, 9, 9, 9}, "CUBICSPLINE");
    // Halfway: (v0 + v1) / 2 + d (b0 - a1) / 8.
    EXPECT_EQ(bones_at(animal, 0, 1.0)[0].translation.x, 0.5 + 2 * (1 + 0.5) / 8);
    EXPECT_EQ(bones_at(animal, 0, 0.0)[0].translation.x, 0.0);
    EXPECT_EQ(bones_at(animal, 0, 2.0)[0].translation.x, 1.0);
}

TEST(Keys, OfEqualTimesTheLaterWins) {
    for (const char* interpolation : {"LINEAR", "STEP"}) {
        const animal::Animal animal = one_channel("translation", {0, 0.5f, 0.5f, 1},
                                                  {0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0}, interpolation);
        EXPECT_EQ(bones_at(animal, 0, 0.5)[0].translation.x, 5.0) << interpolation;
        const bool linear = std::string(interpolation) == "LINEAR";
        EXPECT_NEAR(bones_at(animal, 0, 0.499)[0].translation.x, linear ? 0.998 : 0.0, 1e-12)
            << interpolation;
        EXPECT_NEAR(bones_at(animal, 0, 0.75)[0].translation.x, linear ? 5.5 : 5.0, 1e-12) << interpolation;
    }
}

TEST(Keys, TimesMayBeAskedForInAnyOrder) {
    const animal::Animal animal = support::animal_of(support::tail());
    ClipSampler sampler(animal, animal.clips[0]);
    std::vector<Affine> bones(animal.bones.size());
    std::mt19937 random(3);
    for (int round = 0; round < 100; ++round) {
        const double time_s = static_cast<double>(random() % 1000) / 1000.0 * animal.clips[0].duration_s;
        sampler.sample(time_s, bones);
        EXPECT_LT(difference(bones, support::naive_bones(animal, animal.clips[0], time_s)), 1e-14) << time_s;
    }
}

TEST(Jumps, AreStepsAndKeysWithoutTimeBetween) {
    const auto jumps = [](const animal::Animal& animal) {
        return ClipSampler(animal, animal.clips[0]).jump_times_s();
    };
    const std::vector<float> places{0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0};
    EXPECT_EQ(jumps(one_channel("translation", {1, 1.5f, 2, 3}, places, "STEP")), (std::vector{0.5, 2.0}))
        << "the third key has the value of the second";
    EXPECT_EQ(jumps(one_channel("translation", {1, 1.5f, 2, 3}, places)), std::vector<double>{});
    EXPECT_EQ(jumps(one_channel("translation", {1, 1, 2, 2}, places)), (std::vector{0.0, 1.0}));
    EXPECT_EQ(jumps(one_channel("translation", {0, 5e-7f, 1, 2}, places)).size(), 1u) << "nearer than 1e-6 s";
    EXPECT_EQ(jumps(one_channel("translation", {0, 2e-6f, 1, 2}, places)).size(), 0u);
}

// 0.1 and the next float: a row that was meant for them lies between the two.
TEST(Jumps, BetweenKeysThatAreOneMomentAreTakenEarlyLikeSteps) {
    const float later = std::nextafter(0.1f, 1.0f);
    const animal::Animal animal =
        one_channel("translation", {0, 0.1f, later, 0.2f}, {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0});
    const double key_s = static_cast<double>(0.1f);
    for (const double time_s : {key_s - 5e-7, key_s, 0.5 * (key_s + static_cast<double>(later)), 0.15})
        EXPECT_EQ(bones_at(animal, 0, time_s)[0].translation.x, 1.0) << time_s;
    EXPECT_EQ(bones_at(animal, 0, key_s - 2e-6)[0].translation.x, 0.0);
}

TEST(Jumps, OfSplinesCompareValuesNotTangents) {
    const std::vector<float> keys{0, 0, 0, 0, 0, 0, 9, 0, 0, 5, 0, 0, 0, 0,
                                  0, 9, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0};
    const animal::Animal animal = one_channel("translation", {0, 0, 1}, keys, "CUBICSPLINE");
    ClipSampler sampler(animal, animal.clips[0]);
    EXPECT_EQ(sampler.jump_times_s(), std::vector<double>{});
    EXPECT_TRUE(sampler.has_splines());
    const animal::Animal linear = one_channel("translation", {0, 1}, {0, 0, 0, 1, 0, 0});
    EXPECT_FALSE(ClipSampler(linear, linear.clips[0]).has_splines());
}

}  // namespace
}  // namespace posepack::motion
