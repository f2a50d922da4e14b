// SPDX-License-Identifier: MIT
// Composition: joint global x inverse bind, over whatever nodes lie between.
#include "sampled.hpp"

namespace posepack::motion {
namespace {

using support::ModelSpec;
using support::turn;

TEST(Hierarchy, AgreesWithTheSecondEvaluationInEveryClip) {
    const animal::Animal animal = support::animal_of(support::tail());
    std::size_t compared = 0;
    for (std::size_t c = 0; c < animal.clips.size(); ++c)
        for (int step = 0; step <= 200; ++step, ++compared)
            EXPECT_LT(sampler_error(animal, c, animal.clips[c].duration_s * step / 200.0), 1e-14)
                << animal.clips[c].name << " step " << step;
    EXPECT_EQ(compared, 603u);
}

TEST(Hierarchy, MatrixNodesAndMovingPlainNodes) {
    ModelSpec spec = support::one_bone();
    spec.nodes = {{{"name", "Bone"}, {"translation", {0, 1, 0}}},
                  {{"matrix", {0, 2, 0, 0, -1, 0, 0, 0, 0, 0.5, 3, 0, 5, 6, 7, 1}}, {"children", {0}}},
                  {{"name", "Mover"}, {"scale", {1, 2, 3}}, {"children", {1}}},
                  {{"name", "Top"}, {"rotation", turn(33, 1, 1, 0)}, {"children", {2}}}};
    spec.skins[0].inverse_binds = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, -2, -3, 1}};
    spec.clips = {
        {"Move",
         {{2, "translation", {0, 1}, {0, 0, 0, 1, 2, 3}}, {3, "scale", {0, 1}, {1, 1, 1, 2, 0, -1}}}}};
    const animal::Animal animal = support::animal_of(spec);
    for (int step = 0; step <= 32; ++step) EXPECT_LT(sampler_error(animal, 0, step / 32.0), 1e-14) << step;
}

TEST(Hierarchy, TheMeshNodesOwnTransformIsIgnored) {
    ModelSpec spec = support::tail();
    support::GlbBuilder glb = support::builder_of(spec);
    const animal::Animal plain = support::read_good(glb.build());
    glb.document["nodes"][5]["translation"] = {10, 20, 30};
    glb.document["nodes"][5]["scale"] = {2, 2, 2};
    const animal::Animal moved = support::read_good(glb.build());
    EXPECT_LT(difference(bones_at(moved, 0, 0.1), support::naive_bones(plain, plain.clips[0], 0.1)), 1e-14);
}

TEST(Hierarchy, TheBindPoseGivesIdentity) {
    ModelSpec spec = support::tail();
    // Values that float32 and double hold exactly, so that nothing is left to rounding.
    spec.nodes[0]["rotation"] = {0, 1, 0, 0};
    spec.nodes[2]["rotation"] = {0, 0, 1, 0};
    spec.nodes[4]["rotation"] = {1, 0, 0, 0};
    spec.nodes[2]["scale"] = {0.5, 2, 1};
    spec.skins[0].inverse_binds = support::inverse_binds_of(spec.nodes, spec.skins[0].joints);
    spec.clips = {{"Still", {{1, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, 0, 1}}}}};
    const animal::Animal animal = support::animal_of(spec);
    for (const std::vector<Affine>& bones : {rest_pose(animal), bones_at(animal, 0, 0.5)}) {
        ASSERT_EQ(bones.size(), 3u);
        for (const Affine& bone : bones) {
            EXPECT_EQ(bone.linear, glm::dmat3(1.0));
            EXPECT_EQ(bone.translation, glm::dvec3(0.0));
        }
    }
}

// Channels that do not change, and those of nodes that no bone hangs from, move nothing, but set the pose.
TEST(Constant, ChannelsSetThePoseAndCostNothing) {
    ModelSpec spec = support::one_bone();
    spec.nodes.push_back({{"name", "Prop"}});
    spec.clips = {
        {"Still",
         {{0, "translation", {0, 1, 2}, {1, 2, 3, 1, 2, 3, 1, 2, 3}},
          {1, "translation", {0, 1}, {0, 0, 0, 9, 9, 9}}}},
        {"Spline",
         {{0, "translation", {0, 1}, {0, 0, 0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 1, 2, 3, 0, 0, 0}, "CUBICSPLINE"}}},
        {"Arc",
         {{0,
           "translation",
           {0, 1},
           {0, 0, 0, 1, 2, 3, 4, 0, 0, 0, 0, 0, 1, 2, 3, 0, 0, 0},
           "CUBICSPLINE"}}}};
    const animal::Animal animal = support::animal_of(spec);
    for (std::size_t clip : {0u, 1u}) {
        ClipSampler still(animal, animal.clips[clip]);
        EXPECT_FALSE(still.moves());
        EXPECT_FALSE(still.all_steps());
        EXPECT_TRUE(still.key_times_s().empty());
        EXPECT_EQ(bones_at(animal, clip, 0.5)[0].translation, glm::dvec3(1, 2, 3));
    }
    ClipSampler arc(animal, animal.clips[2]);
    EXPECT_TRUE(arc.moves()) << "equal values with tangents: the curve leaves them and comes back";
    EXPECT_EQ(bones_at(animal, 2, 0.5)[0].translation.x, 1 + 4 / 8.0);
}

TEST(KeyTimes, AreMergedSortedAndCountedFromTheFirst) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Clip",
                   {{0, "translation", {1.0f, 1.5f, 3.0f}, {0, 0, 0, 1, 0, 0, 2, 0, 0}},
                    {0, "scale", {0.5f, 1.5f, 1.5000005f}, {1, 1, 1, 2, 2, 2, 3, 3, 3}}}}};
    const animal::Animal animal = support::animal_of(spec);
    ClipSampler sampler(animal, animal.clips[0]);
    EXPECT_EQ(sampler.key_times_s(), (std::vector<double>{0.0, 0.5, 1.0, 2.5}));
}

TEST(LeadIn, TheClipStartsAtItsFirstKey) {
    const animal::Animal animal = one_channel("translation", {2, 3}, {5, 0, 0, 7, 0, 0});
    EXPECT_EQ(bones_at(animal, 0, 0.0)[0].translation.x, 5.0);
    EXPECT_EQ(bones_at(animal, 0, 0.5)[0].translation.x, 6.0);
    EXPECT_EQ(bones_at(animal, 0, 1.0)[0].translation.x, 7.0);
}

}  // namespace
}  // namespace posepack::motion
