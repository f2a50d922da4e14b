// SPDX-License-Identifier: MIT
// Small steps that the motion tests share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/clip_sampler.hpp"
#include "support/naive_pose.hpp"
#include "support/sample_models.hpp"

namespace posepack::motion {

inline std::vector<Affine> bones_at(const animal::Animal& animal, std::size_t clip, double time_s) {
    ClipSampler sampler(animal, animal.clips[clip]);
    std::vector<Affine> bones(animal.bones.size());
    sampler.sample(time_s, bones);
    return bones;
}

// The largest difference of any element, relative to the larger of 1 and the element.
inline double difference(const std::vector<Affine>& bones, const std::vector<support::Matrix34>& expected) {
    double largest = bones.size() == expected.size() ? 0.0 : HUGE_VAL;
    for (std::size_t b = 0; b < std::min(bones.size(), expected.size()); ++b)
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 4; ++c) {
                const support::Real e = expected[b][static_cast<std::size_t>(r * 4 + c)];
                const double v = c < 3 ? bones[b].linear[c][r] : bones[b].translation[r];
                const support::Real d = std::fabs(v - e) / std::max<support::Real>(1, std::fabs(e));
                largest = std::max(largest, static_cast<double>(d));
            }
    return largest;
}

// How far the sampler lies from the second evaluation at one time.
inline double sampler_error(const animal::Animal& animal, std::size_t clip, double time_s) {
    return difference(bones_at(animal, clip, time_s),
                      support::naive_bones(animal, animal.clips[clip], time_s));
}

// One bone with one channel.
inline animal::Animal one_channel(const std::string& path, std::vector<float> times,
                                  std::vector<float> values, const std::string& interpolation = "LINEAR") {
    support::ModelSpec spec = support::one_bone();
    spec.clips = {{"Clip", {{0, path, std::move(times), std::move(values), interpolation}}}};
    return support::animal_of(spec);
}

}  // namespace posepack::motion
