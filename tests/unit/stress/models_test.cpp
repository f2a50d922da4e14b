// SPDX-License-Identifier: MIT
// The bodies and curves of stress cases, and their source poses against a second evaluation.
#include "stress/models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "animal/read_animal.hpp"
#include "motion/clip_sampler.hpp"
#include "stress/stress_case.hpp"
#include "support/naive_pose.hpp"

namespace posepack::stress {
namespace {

TEST(Models, DecayAsTheExponentialFunction) {
    for (double x = 0.0; x < 40.0; x += 1.37)
        EXPECT_NEAR(decayed(x), std::exp(-x), 1e-12 * std::exp(-x)) << x;
    EXPECT_LT(decayed(600.0), 1e-200);
}

TEST(Models, OfReedsHaveWeightsThatSumToOne) {
    for (const int joints : {1, 2, 4, 128}) {
        const RawModel model = reed({.joints = joints, .rings = 2 * joints + 1});
        ASSERT_EQ(model.weights.size() / 4, model.positions.size() / 3);
        ASSERT_EQ(model.inverse_binds.size(), model.nodes.size());
        std::set<std::uint16_t> used;
        for (std::size_t v = 0; v < model.weights.size(); v += 4) {
            EXPECT_EQ(model.weights[v] + model.weights[v + 1], 1.0f);
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_LT(model.joints[v + i], joints);
                if (model.weights[v + i] > 0.0f) used.insert(model.joints[v + i]);
            }
        }
        EXPECT_EQ(used.size(), static_cast<std::size_t>(joints)) << "every joint moves something";
    }
}

TEST(Cases, HaveNamesOfTheirOwnAndReasons) {
    std::set<std::string_view> names;
    for (const CaseGroup& group : case_groups()) {
        EXPECT_FALSE(group.title.empty() || group.lesson.empty());
        for (const StressCase& stress_case : group.cases) {
            EXPECT_TRUE(names.insert(stress_case.name).second) << stress_case.name;
            EXPECT_EQ(stress_case.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                      std::string_view::npos);
            EXPECT_FALSE(stress_case.trouble.empty()) << stress_case.name;
            EXPECT_GT(stress_case.bound.max, 0.0) << stress_case.name;
        }
    }
    EXPECT_GE(names.size(), 60u);
}

TEST(Cases, AreBuiltToTheSameBytes) {
    for (const CaseGroup& group : case_groups())
        for (const StressCase& stress_case : group.cases)
            EXPECT_EQ(write_glb(stress_case.build()), write_glb(stress_case.build())) << stress_case.name;
}

// The largest difference of any element of any bone, relative to the larger of 1 and the element.
double sampler_error(const animal::Animal& animal, motion::ClipSampler& sampler, double time_s) {
    std::vector<motion::Affine> bones(animal.bones.size());
    sampler.sample(time_s, bones);
    const auto expected = support::naive_bones(animal, animal.clips[0], static_cast<support::Real>(time_s));
    double largest = 0.0;
    for (std::size_t b = 0; b < bones.size(); ++b)
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 4; ++c) {
                const auto e = static_cast<double>(expected[b][static_cast<std::size_t>(r * 4 + c)]);
                const double v = c < 3 ? bones[b].linear[c][r] : bones[b].translation[r];
                largest = std::max(largest, std::abs(v - e) / std::max(1.0, std::abs(e)));
            }
    return largest;
}

// The source poses that all errors are measured from. Times within 1e-5 s of a jump are left out: the sampler
// may take a step up to 1e-6 s early.
TEST(Cases, MoveAsASecondEvaluationSays) {
    const std::uint32_t seed = 5;
    std::mt19937 random(seed);
    int looked_at = 0;
    for (const CaseGroup& group : case_groups())
        for (const StressCase& stress_case : group.cases) {
            const auto animal = animal::read_animal(write_glb(stress_case.build()));
            if (!animal) continue;
            const animal::Clip& clip = animal.value().clips[0];
            motion::ClipSampler sampler(animal.value(), clip);
            const std::vector<double> jumps = sampler.jump_times_s();
            std::uniform_real_distribution<double> time(0.0, std::max(clip.duration_s, 1e-9));
            for (int i = 0; i < 20; ++i) {
                const double time_s = time(random);
                const bool is_near_a_jump = std::any_of(jumps.begin(), jumps.end(), [&](double jump_s) {
                    return std::abs(jump_s - time_s) < 1e-5;
                });
                if (is_near_a_jump) continue;
                ++looked_at;
                ASSERT_LT(sampler_error(animal.value(), sampler, time_s), 1e-10)
                    << stress_case.name << " at " << time_s << " s, seed " << seed;
            }
        }
    EXPECT_GT(looked_at, 1000);
}

}  // namespace
}  // namespace posepack::stress
