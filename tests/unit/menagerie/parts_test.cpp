// SPDX-License-Identifier: MIT
// The parts under the body plans: turns, legs, scripts, lofts.
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>

#include "menagerie/leg.hpp"
#include "menagerie/loft.hpp"
#include "menagerie/script.hpp"

namespace posepack::menagerie {
namespace {

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_NEAR(glm::length(a - b), 0.0, tolerance);
}

TEST(MenagerieMath, TurnsGoTheWayTheirNamesSay) {
    expect_near(pitch(90.0) * kAxisZ, -kAxisY, 1e-12);  // nose down
    expect_near(yaw(90.0) * kAxisZ, kAxisX, 1e-12);     // nose to the left
    expect_near(roll(90.0) * kAxisX, kAxisY, 1e-12);    // left side up
    expect_near(turn_about(kAxisY, 360.0) * kAxisX, kAxisX, 1e-12);
}

TEST(MenagerieMath, TurnBetweenTakesOneDirectionToTheOther) {
    const Vec3 directions[] = {kAxisX, kAxisY, -kAxisY, kAxisZ, {1.0, 2.0, -3.0}, {-1.0, -2.0, 3.0}};
    for (const Vec3& from : directions) {
        for (const Vec3& to : directions) {
            expect_near(turn_between(from, to) * glm::normalize(from), glm::normalize(to), 1e-9);
        }
    }
}

TEST(MenagerieMath, MirroredTurnMirrorsWhatItTurns) {
    const Quat turn = yaw(35.0) * roll(-20.0) * pitch(50.0);
    const Vec3 place(0.3, -0.7, 1.1);
    expect_near(mirrored(turn) * mirrored(place), mirrored(turn * place), 1e-12);
}

TEST(MenagerieMath, BlendedReachesBothEnds) {
    const Quat a = yaw(20.0);
    const Quat b = -pitch(70.0);  // the other sign of the same rotation
    expect_near(blended(a, b, 0.0) * kAxisZ, a * kAxisZ, 1e-12);
    expect_near(blended(a, b, 1.0) * kAxisZ, b * kAxisZ, 1e-12);
    expect_near(blended(kNoTurn, yaw(60.0), 0.5) * kAxisZ, yaw(30.0) * kAxisZ, 1e-12);
}

TEST(MenagerieScript, TracksHoldTheirEndsAndMeetTheirStops) {
    ClipScript script;
    script.tracks = {{0, {{0.25, 2.0}, {0.5, -4.0}}}};
    EXPECT_EQ(channel_values(script, 1, 0.0)[0], 2.0);
    EXPECT_EQ(channel_values(script, 1, 0.25)[0], 2.0);
    EXPECT_DOUBLE_EQ(channel_values(script, 1, 0.375)[0], -1.0);
    EXPECT_EQ(channel_values(script, 1, 0.5)[0], -4.0);
    EXPECT_EQ(channel_values(script, 1, 1.0)[0], -4.0);
}

TEST(MenagerieScript, WavesAddToTracks) {
    ClipScript script;
    script.tracks = {{1, {{0.0, 5.0}}}};
    script.waves = {{1, 2.0, 3, 0.25}};
    EXPECT_DOUBLE_EQ(channel_values(script, 2, 0.0)[1], 7.0);
    EXPECT_NEAR(channel_values(script, 2, 1.0 / 6.0)[1], 3.0, 1e-12);
    EXPECT_EQ(channel_values(script, 2, 0.3)[0], 0.0);
}

TEST(MenagerieScript, FeetMoveEvenlyOnTheGround) {
    const Gait gait{0.6, 0.5, 0.1, {0.0}};
    EXPECT_EQ(foot_step(gait, 0.0).forward, 0.5);
    EXPECT_NEAR(foot_step(gait, 0.3).forward, 0.0, 1e-15);
    EXPECT_EQ(foot_step(gait, 0.3).height, 0.0);
    EXPECT_NEAR(foot_step(gait, 0.8).height, 1.0, 1e-12);
    EXPECT_NEAR(foot_step(gait, 1.0 - 1e-9).forward, 0.5, 1e-6);
    EXPECT_EQ(foot_step(gait, 2.3).forward, foot_step(gait, 0.3 + 2.0).forward);
}

TEST(MenagerieScript, StepsScaleWithTheRate) {
    ClipScript script;
    script.steps_at_30_hz = 15;
    EXPECT_EQ(step_count(script, 30), 15);
    EXPECT_EQ(step_count(script, 24), 12);
    EXPECT_EQ(cycle_step_count(script, 24), 12);
    script.ending = Ending::open;
    EXPECT_EQ(cycle_step_count(script, 24), 13);
}

// A leg of four joints in the plane x = 0.1, its knee bent forward.
struct LegRig {
    Rig rig;
    Leg leg;

    LegRig() {
        const int body = add_joint(rig, "Body", -1, {0.0, 1.0, 0.0}, {0.0, 1.0, 1.0});
        leg.upper = add_joint(rig, "Upper", body, {0.1, 0.9, 0.0}, {0.1, 0.6, 0.1});
        leg.lower = add_joint(rig, "Lower", leg.upper, {0.1, 0.6, 0.1}, {0.1, 0.3, -0.1});
        leg.cannon = add_joint(rig, "Cannon", leg.lower, {0.1, 0.3, -0.1}, {0.1, 0.05, -0.1});
        leg.foot = add_joint(rig, "Foot", leg.cannon, {0.1, 0.05, -0.1}, {0.1, 0.0, 0.0});
        leg.target = add_joint(rig, "Target", -1, {0.1, 0.05, -0.1}, {0.1, 0.05, -0.2});
    }
};

TEST(MenagerieLeg, RestGoalGivesRestPose) {
    LegRig r;
    Pose pose = rest_pose(r.rig);
    pose_leg(r.rig, place(r.rig, pose), r.leg, {{0.1, 0.05, -0.1}, kNoTurn, kNoTurn}, pose);
    for (const Quat& turn : pose.turns) EXPECT_NEAR(std::abs(turn.w), 1.0, 1e-12);
}

TEST(MenagerieLeg, ReachesGoalsUnderATurnedBody) {
    LegRig r;
    for (const Vec3& ankle : {Vec3(0.1, 0.15, 0.2), Vec3(0.0, 0.05, -0.35), Vec3(0.25, 0.3, 0.0)}) {
        Pose pose = rest_pose(r.rig);
        pose.turns[0] = yaw(10.0) * pitch(-8.0);
        pose.shifts[0] = {0.02, -0.05, 0.03};
        pose_leg(r.rig, place(r.rig, pose), r.leg, {ankle, pitch(15.0), pitch(-5.0)}, pose);
        const Placement placed = place(r.rig, pose);
        expect_near(placed.heads[static_cast<std::size_t>(r.leg.foot)], ankle, 1e-12);
        expect_near(placed.heads[static_cast<std::size_t>(r.leg.target)], ankle, 1e-12);
        expect_near(placed.turns[static_cast<std::size_t>(r.leg.foot)] * kAxisZ, pitch(-5.0) * kAxisZ, 1e-12);
    }
}

TEST(MenagerieLeg, StretchesTowardsGoalsOutOfReach) {
    LegRig r;
    Pose pose = rest_pose(r.rig);
    pose_leg(r.rig, place(r.rig, pose), r.leg, {{0.1, -3.0, 0.0}, kNoTurn, kNoTurn}, pose);
    const Placement placed = place(r.rig, pose);
    const Vec3 hip = placed.heads[static_cast<std::size_t>(r.leg.upper)];
    const Vec3 hock = placed.heads[static_cast<std::size_t>(r.leg.cannon)];
    const double longest = glm::length(Vec3(0.0, -0.3, 0.1)) + glm::length(Vec3(0.0, -0.3, -0.2));
    EXPECT_NEAR(glm::length(hock - hip), longest, 1e-3);
    EXPECT_GT(placed.heads[static_cast<std::size_t>(r.leg.lower)].z, 0.0);  // the knee still bends forward
}

Loft straight_loft() {
    Loft loft;
    loft.segments = 8;
    loft.start_cap = 0.0;
    loft.end_cap = 0.1;
    loft.sections = {{{0.0, 0.0, 0.0}, 1.0, 1.0, 1.0, 0, plain(0xFF0000), 2},
                     {{0.0, 0.0, 1.0}, 1.0, 1.0, 1.0, 1, plain(0x00FF00), 2},
                     {{0.0, 0.0, 2.0}, 1.0, 1.0, 1.0, 2, plain(0x0000FF), 0}};
    return loft;
}

TEST(MenagerieMesh, LoftHasTheVerticesItPromises) {
    Mesh mesh;
    add_loft(mesh, straight_loft());
    EXPECT_EQ(mesh.vertices.size(), 5u * 8u + 2u);
    EXPECT_EQ(mesh.indices.size(), 3u * (4u * 8u * 2u + 2u * 8u));
    finish(mesh);
    for (const Vertex& vertex : mesh.vertices) {
        const Vec3 outside = vertex.position - Vec3(0.0, 0.0, 1.0);
        EXPECT_GT(glm::dot(vertex.normal, outside), 0.0);
    }
}

TEST(MenagerieMesh, EllipsoidLiesOnItsSurface) {
    Mesh mesh;
    Ellipsoid ellipsoid;
    ellipsoid.radii = {1.0, 2.0, 3.0};
    add_ellipsoid(mesh, ellipsoid);
    EXPECT_EQ(mesh.vertices.size(), 3u * 8u + 2u);
    for (const Vertex& vertex : mesh.vertices)
        EXPECT_NEAR(glm::length(vertex.position / ellipsoid.radii), 1.0, 1e-12);
}

TEST(MenagerieMesh, FullInfluencesMakeRoomForAnotherJoint) {
    Mesh mesh;
    add_loft(mesh, straight_loft());
    const Mark all;
    for (const int joint : {3, 4, 5}) attract(mesh, all, joint, {0.0, 0.0, 1.0}, 10.0, 0.4);
    finish(mesh);
    for (const Vertex& vertex : mesh.vertices) {
        double sum = 0.0;
        double fifth = 0.0;
        for (std::size_t slot = 0; slot < 4; ++slot) {
            sum += vertex.influences.weights[slot];
            if (vertex.influences.joints[slot] == 5) fifth += vertex.influences.weights[slot];
        }
        EXPECT_EQ(sum, 1.0);
        EXPECT_GT(fifth, 0.3);
    }
}

TEST(MenagerieMesh, MirrorImageIsOnTheOtherSideAndJoint) {
    Rig rig;
    const int left = add_joint_pair(rig, "Arm", -1, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
    Mesh mesh;
    Ellipsoid hand;
    hand.centre = {1.5, 0.0, 0.0};
    hand.radii = Vec3(0.2);
    hand.joint = left;
    add_ellipsoid(mesh, hand);
    const std::size_t count = mesh.vertices.size();
    add_mirror_image(mesh, rig, Mark{});
    ASSERT_EQ(mesh.vertices.size(), 2 * count);
    finish(mesh);
    for (std::size_t index = 0; index < count; ++index) {
        expect_near(mesh.vertices[count + index].position, mirrored(mesh.vertices[index].position), 1e-15);
        expect_near(mesh.vertices[count + index].normal, mirrored(mesh.vertices[index].normal), 1e-12);
        EXPECT_EQ(mesh.vertices[count + index].influences.joints[0], left + 1);
    }
}

}  // namespace
}  // namespace posepack::menagerie
