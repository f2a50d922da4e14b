// SPDX-License-Identifier: MIT
// Skins that differ from another by one matrix share its bones; all others do not.
#include "animal/bind_skins.hpp"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>

#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

glm::dmat4 moved(double x, double y = 0.0, double z = 0.0) {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(x, y, z, 1.0);
    return m;
}

glm::dmat4 scaled(double x, double y, double z) {
    glm::dmat4 m(1.0);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

// Numbers as a file holds them.
glm::dmat4 in_floats(glm::dmat4 m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) m[c][r] = static_cast<double>(static_cast<float>(m[c][r]));
    return m;
}

class BindSkins : public testing::Test {
 protected:
    BindSkins() : animal_(), binder_(animal_) { animal_.nodes.resize(2'000); }

    SkinBinder::Bound bind(const std::vector<std::uint32_t>& nodes, const std::vector<glm::dmat4>& binds) {
        const auto bound = binder_.bind(nodes, binds);
        EXPECT_TRUE(bound);
        return bound.value_or(SkinBinder::Bound{});
    }

    const std::vector<std::uint32_t> nodes_{3, 7, 5};
    const std::vector<glm::dmat4> binds_{in_floats(moved(0.1, 0.2, -0.3)),
                                         in_floats(scaled(0.7, 1.3, 0.9) * moved(2, 3, 4)),
                                         in_floats(moved(-5, 0.3, 0.123) * scaled(2, 2, 2))};
    Animal animal_;
    SkinBinder binder_;
};

std::vector<glm::dmat4> times(std::vector<glm::dmat4> binds, const glm::dmat4& x) {
    for (glm::dmat4& bind : binds) bind = in_floats(bind * x);
    return binds;
}

TEST_F(BindSkins, OneMatrixBetweenThemIsAFold) {
    const glm::dmat4 x = in_floats(moved(0.7, -11, 3) * scaled(100, -100, 25));
    EXPECT_EQ(bind(nodes_, binds_).fold, kNone);
    const auto bound = bind({5, 3, 7}, times({binds_[2], binds_[0], binds_[1]}, x));
    EXPECT_EQ(bound.bones, (std::vector<std::uint16_t>{2, 0, 1}));
    EXPECT_EQ(animal_.bones.size(), 3u);
    ASSERT_EQ(bound.fold, 0u);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r)
            EXPECT_NEAR(animal_.folds[0].bind_from_mesh[c][r], x[c][r], 1e-4) << c << r;
    EXPECT_EQ(animal_.folds[0].inverse_binds[1], times(binds_, x)[0]) << "as in the file";
}

TEST_F(BindSkins, AnEqualSkinIsNone) {
    bind(nodes_, binds_);
    const auto bound = bind({7, 3}, {binds_[1], binds_[0]});
    EXPECT_EQ(bound.fold, kNone);
    EXPECT_EQ(bound.bones, (std::vector<std::uint16_t>{1, 0}));
}

TEST_F(BindSkins, ASkinOffByRoundingIsAFoldByTheIdentity) {
    bind(nodes_, binds_);
    auto binds = binds_;
    binds[1][3].x *= 1.0 + 1e-7;
    const auto bound = bind(nodes_, binds);
    ASSERT_EQ(bound.fold, 0u);
    EXPECT_EQ(animal_.folds[0].bind_from_mesh, glm::dmat4(1.0));
    EXPECT_EQ(animal_.bones.size(), 3u);
}

TEST_F(BindSkins, BeyondRoundingItIsNone) {
    bind(nodes_, binds_);
    for (const double off : {1e-5, 1e-3}) {
        auto binds = times(binds_, moved(1));
        binds[1][3].x += off * 5;  // the largest translation is about 5
        EXPECT_EQ(bind(nodes_, binds).fold, kNone) << off;
    }
    EXPECT_EQ(animal_.bones.size(), 7u) << "the last two skins share two";
}

TEST_F(BindSkins, JointsOfItsOwnGetBonesBeforeTheMatrix) {
    const glm::dmat4 x = in_floats(moved(0.5, 1, 0) * scaled(4, 4, 4));
    bind(nodes_, binds_);
    const glm::dmat4 own = moved(9, 8, 7);
    const auto bound = bind({5, 11}, {in_floats(binds_[2] * x), own});
    ASSERT_EQ(bound.fold, 0u);
    EXPECT_EQ(bound.bones, (std::vector<std::uint16_t>{2, 3}));
    const glm::dmat4 back = animal_.bones[3].inverse_bind * animal_.folds[0].bind_from_mesh;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_NEAR(back[c][r], own[c][r], 1e-12);
    // And a third skin is folded onto what the second brought.
    EXPECT_EQ(bind({11}, {own * moved(1, 1, 1)}).bones, (std::vector<std::uint16_t>{3}));
}

TEST_F(BindSkins, NoJointInCommonIsNone) {
    bind(nodes_, binds_);
    EXPECT_EQ(bind({1, 2}, {moved(1), moved(2)}).fold, kNone);
    EXPECT_EQ(animal_.bones.size(), 5u);
}

TEST_F(BindSkins, OneFoldIsFoundAmongSeveralSkins) {
    bind(nodes_, binds_);
    auto other = binds_;
    other[0] = moved(4, 4, 4);
    bind(nodes_, other);
    const std::size_t bones = animal_.bones.size();
    EXPECT_EQ(bones, 4u) << "two of the three are equal";
    const auto bound = bind(nodes_, times(other, moved(1, 2, 3)));
    EXPECT_NE(bound.fold, kNone);
    EXPECT_EQ(bound.bones, (std::vector<std::uint16_t>{3, 1, 2}));
    EXPECT_EQ(animal_.bones.size(), bones);
}

// Nothing leads back from a matrix that flattens, so vertices behind it cannot share a space.
TEST_F(BindSkins, FlatMatricesAreNone) {
    bind(nodes_, binds_);
    EXPECT_EQ(bind(nodes_, times(binds_, scaled(1, 0, 1))).fold, kNone);
    EXPECT_EQ(bind(nodes_, times(binds_, glm::dmat4(0.0))).fold, kNone);
    const std::size_t bones = animal_.bones.size();
    EXPECT_EQ(bind({20}, {scaled(0, 0, 0)}).fold, kNone);
    EXPECT_EQ(bind({20}, {moved(1)}).fold, kNone) << "no X leads from zero to it";
    EXPECT_EQ(animal_.bones.size(), bones + 2);
}

TEST_F(BindSkins, HugeNumbersAreNone) {
    bind(nodes_, binds_);
    EXPECT_EQ(bind(nodes_, {scaled(1e38, 1e38, 1e38), scaled(1, 1, 1), scaled(1e-38, 1, 1)}).fold, kNone);
    EXPECT_EQ(bind(nodes_, {moved(3e38), moved(-3e38), moved(3e38)}).fold, kNone);
}

TEST_F(BindSkins, AJointNamedTwiceIsNotFolded) {
    bind(nodes_, binds_);
    EXPECT_EQ(bind({3, 3}, times({binds_[0], binds_[0]}, moved(1))).fold, kNone);
}

TEST_F(BindSkins, AThousandAndTwentyFourBonesAndNoMore) {
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t n = 0; n < kMaxBones; ++n) nodes.push_back(n);
    std::vector<glm::dmat4> binds(kMaxBones, moved(1, 2, 3));
    bind(nodes, binds);
    EXPECT_EQ(bind(nodes, times(binds, moved(5))).bones.size(), kMaxBones) << "folded: no new ones";
    nodes.back() = 1'500;
    EXPECT_FALSE(binder_.bind(nodes, binds));
    EXPECT_EQ(animal_.bones.size(), kMaxBones);
}

TEST(FoldedTail, IsReadOntoTheBonesOfTheFirst) {
    const Animal animal = support::animal_of(support::folded_twice(support::tail()));
    ASSERT_EQ(animal.bones.size(), 3u);
    ASSERT_EQ(animal.meshes.size(), 2u);
    EXPECT_EQ(animal.meshes[0].fold, kNone);
    EXPECT_EQ(animal.meshes[1].fold, 0u);
    EXPECT_EQ(animal.joint_map, (std::vector<std::uint16_t>{0, 1, 2, 0, 1, 2}));
    const support::Matrix16 x = support::fold_matrix();
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            EXPECT_NEAR(animal.folds[0].bind_from_mesh[c][r], x[static_cast<std::size_t>(4 * c + r)], 1e-5);
}

}  // namespace
}  // namespace posepack::animal
