// SPDX-License-Identifier: MIT
// What leaving influences out costs, against cases whose cost is known.
#include "measure/reduction_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "animal/read_animal.hpp"
#include "support/baked.hpp"
#include "support/sample_models.hpp"

namespace posepack::measure {
namespace {

// Five joints; vertex 0 hangs on all by 0.3, 0.2, 0.2, 0.2 and 0.1, the others on the first. In the clip the
// last joint moves away by `reach` along x and comes back.
support::Bytes five_joints(float reach) {
    support::ModelSpec spec = support::one_bone({1, 0, 0, -1, 0, 0, 0, 1, 0});
    for (int n = 1; n < 5; ++n) {
        spec.nodes.push_back({{"name", "Joint" + std::to_string(n)}});
        spec.skins[0].joints.push_back(n);
    }
    spec.clips = {{"Pull", {{4, "translation", {0, 0.5f, 1}, {0, 0, 0, reach, 0, 0, 0, 0, 0}}}}};
    support::GlbBuilder glb = support::builder_of(spec);
    auto& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] =
        glb.add_values(std::vector<std::uint8_t>{0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    attributes["WEIGHTS_0"] =
        glb.add_values(std::vector<float>{0.3f, 0.2f, 0.2f, 0.2f, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    attributes["JOINTS_1"] =
        glb.add_values(std::vector<std::uint8_t>{4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    attributes["WEIGHTS_1"] =
        glb.add_values(std::vector<float>{0.1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    return glb.build();
}

ReductionError measured(const animal::Animal& animal, double rate_hz) {
    const support::Baked baked = support::bake_all(animal, support::in_floats(),
                                                   {{rate_hz, recipe::Wrap::once, recipe::Seam::automatic}});
    const auto error = measure_reduction(animal, baked.palette);
    EXPECT_TRUE(error);
    return error ? error.value() : ReductionError{};
}

TEST(ReductionError, IsTheShareOfWhatIsLeftOut) {
    const auto animal = animal::read_animal(five_joints(2.0f));
    ASSERT_TRUE(animal);
    // Rows at 0, 0.5 and 1 s. The joint that is left out is 2 away in the second: a tenth of that is missing.
    const ReductionError error = measured(animal.value(), 2.0);
    const double radius = std::sqrt(1.25);  // about the centre of the box, (0, 0.5, 0)
    EXPECT_EQ(error.vertex_count, 1u);
    EXPECT_EQ(error.influences_most, 5u);
    EXPECT_NEAR(error.max, 0.2 / radius, 1e-6);
    EXPECT_NEAR(error.rms, 0.2 / radius / std::sqrt(3.0), 1e-6);
    EXPECT_EQ(error.clip, 0u);
    EXPECT_NEAR(error.time_s, 0.5, 1e-9);
    EXPECT_EQ(error.mesh, 0u);
    EXPECT_EQ(error.vertex, 0u);
}

TEST(ReductionError, IsNoneWhereEightAreKept) {
    const auto animal = animal::read_animal(five_joints(2.0f), {.influences = 8});
    ASSERT_TRUE(animal);
    const ReductionError error = measured(animal.value(), 2.0);
    EXPECT_EQ(error.vertex_count, 0u);
    EXPECT_EQ(error.max, 0.0);
}

TEST(ReductionError, HasALimitOfWork) {
    auto animal = animal::read_animal(five_joints(2.0f));
    ASSERT_TRUE(animal);
    palette::Palette palette;
    palette.clips.resize(1);
    palette.clips[0].plan.row_count = static_cast<std::uint32_t>(kMaxReductionSamples) + 1;
    const auto error = measure_reduction(animal.value(), palette);
    ASSERT_FALSE(error);
    EXPECT_EQ(error.issue().code, base::IssueCode::lim_work);
}

TEST(ReductionError, ThatNoFloatHoldsIsRefused) {
    const auto animal = animal::read_animal(five_joints(3e38f));
    ASSERT_TRUE(animal);
    const support::Baked baked = support::bake_all(animal.value(), support::in_floats(),
                                                   {{2.0, recipe::Wrap::once, recipe::Seam::automatic}});
    palette::Palette tiny = baked.palette;
    tiny.radius = 1e-3;
    const auto error = measure_reduction(animal.value(), tiny);
    ASSERT_FALSE(error);
    EXPECT_EQ(error.issue().code, base::IssueCode::lim_float_range);
}

}  // namespace
}  // namespace posepack::measure
