// SPDX-License-Identifier: MIT
#include "palette/bounds.hpp"

#include <gtest/gtest.h>

#include "posepack/loader.h"
#include "support/baked.hpp"
#include "support/sample_models.hpp"

namespace posepack::palette {
namespace {

// Skins a vertex as a reader does: blended float matrices, its weights.
std::array<double, 3> skinned(const animal::Animal& animal, std::size_t v,
                              const std::vector<float>& matrices) {
    std::array<double, 3> sum{};
    const auto& p = animal.vertices.positions[v];
    for (std::size_t i = 0; i < animal::kMaxInfluences; ++i) {
        const float* m = &matrices[animal.vertices.bones[v][i] * std::size_t{12}];
        for (std::size_t r = 0; r < 3; ++r) {
            double image = static_cast<double>(m[r * 4 + 3]);
            for (std::size_t c = 0; c < 3; ++c) image += static_cast<double>(m[r * 4 + c]) * p[c];
            sum[r] += animal.vertices.weights[v][i] * image;
        }
    }
    return sum;
}

// Checks one pose against box and sphere. Float weights may sum to a hair more than 1.
void expect_inside(const animal::Animal& animal, const posepack_clip& clip,
                   const std::vector<float>& matrices) {
    for (std::size_t v = 0; v < animal.vertices.positions.size(); ++v) {
        const std::array<double, 3> p = skinned(animal, v, matrices);
        double square = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_GE(p[c], clip.box_min[c] - 1e-6);
            ASSERT_LE(p[c], clip.box_max[c] + 1e-6);
            square += (p[c] - clip.sphere_center[c]) * (p[c] - clip.sphere_center[c]);
        }
        ASSERT_LE(std::sqrt(square), clip.sphere_radius + 1e-6);
    }
}

TEST(Bounds, HoldEveryVertexAtRowsAndBlends) {
    const animal::Animal animal = support::animal_of(support::tail());
    for (const recipe::OutputOptions& output : {recipe::OutputOptions{}, support::in_floats()}) {
        const support::Baked baked = support::bake_all(animal, output);
        posepack_view view;
        ASSERT_EQ(posepack_open(&view, baked.container.data(), baked.container.size()), POSEPACK_OK);
        std::size_t poses = 0;
        for (std::uint32_t c = 0; c < view.header.clip_count; ++c) {
            posepack_clip clip;
            ASSERT_EQ(posepack_get_clip(&view, c, &clip), POSEPACK_OK);
            std::vector<float> a(animal.bones.size() * 12), b(a.size()), blend(a.size());
            for (std::uint32_t row = 0; row < clip.row_count; ++row) {
                posepack_decode_row(&view, clip.first_row + row, a.data());
                posepack_decode_row(&view, clip.first_row + (row + 1) % clip.row_count, b.data());
                for (const float factor : {0.0f, 0.25f, 0.5f, 0.9f}) {
                    for (std::size_t i = 0; i < a.size(); ++i) blend[i] = a[i] * (1 - factor) + b[i] * factor;
                    expect_inside(animal, clip, blend);
                    ++poses;
                }
            }
        }
        EXPECT_GT(poses, 100u);
    }
}

TEST(Bounds, AreTightForABoxThatOnlyMoves) {
    support::ModelSpec spec = support::one_bone({-1, -2, -3, 1, 2, 3});
    spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 10, 0, 0}}}}};
    const animal::Animal animal = support::animal_of(spec);
    const support::Baked baked = support::bake_all(animal, support::in_floats());
    const Box& box = baked.palette.clips[0].bounds;
    EXPECT_EQ(box.low, (std::array<double, 3>{-1, -2, -3}));
    EXPECT_EQ(box.high, (std::array<double, 3>{11, 2, 3}));
}

TEST(Bounds, BonesThatMoveNoVertexAreLeftOut) {
    support::ModelSpec spec = support::one_bone({1, 1, 1, 0, 0, 0});
    spec.nodes.push_back({{"name", "Far"}, {"translation", {1000, 0, 0}}});
    spec.skins[0].joints = {0, 1};
    spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
    const support::Baked baked = support::bake_all(support::animal_of(spec), support::in_floats());
    EXPECT_EQ(baked.palette.clips[0].bounds.high[0], 2.0);
}

TEST(Bounds, ABoxIsEmptyUntilSomethingIsAdded) {
    Box box;
    EXPECT_TRUE(box.is_empty());
    const BoneBoxes boxes(support::animal_of([] {
        support::ModelSpec spec = support::one_bone();
        spec.clips = {{"Move", {{0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}}}}};
        return spec;
    }()));
    boxes.add(std::vector<float>{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7}, box);
    EXPECT_FALSE(box.is_empty());
    EXPECT_EQ(box.low, (std::array<double, 3>{5, 6, 7}));
    EXPECT_EQ(box.high, (std::array<double, 3>{6, 7, 8}));
}

}  // namespace
}  // namespace posepack::palette
