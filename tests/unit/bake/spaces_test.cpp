// SPDX-License-Identifier: MIT
// Whole bakes in both spaces and all encodings: what a normalised space is worth, what dual quaternions
// refuse, and that both show the same animal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bake/bake_animal.hpp"
#include "menagerie/menagerie.hpp"
#include "posepack/loader.h"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using base::IssueCode;
using recipe::Encoding;
using recipe::Space;
using recipe::TexelFormat;
using support::ModelSpec;

recipe::AnimalEntry entry_of(Encoding encoding, Space space, TexelFormat format = TexelFormat::rgba16f) {
    recipe::AnimalEntry entry;
    entry.id = "animal";
    entry.model = "animal.glb";
    entry.output.encoding = encoding;
    entry.output.space = space;
    entry.output.texel_format = format;
    entry.canonical_json = "{}";
    return entry;
}

BakedAnimal bake(const support::Bytes& glb, const recipe::AnimalEntry& entry) {
    auto result = bake_animal(entry, glb, {});
    if (!result) throw std::runtime_error(base::format_issue(result.issue()));
    return std::move(result).value();
}

struct Opened {
    explicit Opened(const BakedAnimal& animal) {
        EXPECT_EQ(posepack_open(&view, animal.container.data(), animal.container.size()), POSEPACK_OK);
        posepack_get_space(&view, &space);
        posepack_get_mesh(&view, 0, &mesh);
    }
    posepack_view view;
    posepack_space space;
    posepack_mesh mesh;
};

// A disc of `scale` about the z axis of one bone, whole turns in a closed loop of eight keys.
ModelSpec spinning(double whole_turns, float size = 1.0f) {
    ModelSpec spec = support::one_bone({size, 0, 0, 0, size, 0, -size, 0, 0, 0, -size, 0});
    std::vector<std::array<float, 4>> keys;
    for (int key = 0; key <= 8; ++key) keys.push_back(support::turn(360.0 * whole_turns * key / 8, 0, 0, 1));
    spec.clips = {{"Spin", {{0, "rotation", support::grid(9, 24), support::turns(keys)}}}};
    return spec;
}

ModelSpec scaling(const std::vector<float>& scales) {
    ModelSpec spec = support::one_bone({1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0});
    spec.clips = {{"Grow", {{0, "scale", support::grid(scales.size() / 3, 24), scales}}}};
    return spec;
}

TEST(NormalisedSpace, IsTheDefaultButForMat4) {
    const support::Bytes glb = support::glb_of(spinning(1));
    for (const auto& [encoding, normalised] :
         {std::pair{Encoding::mat4, false}, std::pair{Encoding::affine, true},
          std::pair{Encoding::dualquat, true}}) {
        const BakedAnimal animal = bake(glb, entry_of(encoding, Space::automatic));
        EXPECT_EQ(Opened(animal).view.header.space_flags, normalised ? POSEPACK_SPACE_NORMALISED : 0u);
    }
}

// An armature of 1/100 with turned axes above a mesh 100 times too large: matrices near the identity remain.
TEST(NormalisedSpace, TakesTheUnitAndTheAxesOfTheArmatureOut) {
    ModelSpec spec = spinning(1, 100.0f);
    spec.nodes.push_back({{"name", "Armature"},
                          {"scale", {0.01, 0.01, 0.01}},
                          {"rotation", support::turn(-90, 1, 0, 0)},
                          {"translation", {50.017, 0, 0}},
                          {"children", {0}}});
    const support::Bytes glb = support::glb_of(spec);
    recipe::AnimalEntry entry = entry_of(Encoding::mat4, Space::normalised);
    entry.rate_hz = 480;  // so many rows that rounding is what is left of the error
    const BakedAnimal animal = bake(glb, entry);
    const Opened opened(animal);
    std::vector<float> matrices(12 * opened.view.header.bone_count);
    ASSERT_EQ(posepack_decode_row(&opened.view, 0, matrices.data()), POSEPACK_OK);
    for (std::size_t e = 0; e < 12; ++e) EXPECT_NEAR(matrices[e], e % 5 == 0 ? 1.0 : 0.0, 2e-3) << e;
    EXPECT_NEAR(opened.space.model_from_palette[3], 50.017f, 1e-3);
    EXPECT_NEAR(opened.space.model_from_palette[0], opened.view.header.radius_m, 1e-6) << "R is 1";
    posepack_clip clip;
    ASSERT_EQ(posepack_get_clip(&opened.view, 0, &clip), POSEPACK_OK);
    EXPECT_LE(clip.sphere_radius, 2.1f) << "bounds are of palette space";
    // Halves of model space hold 50 m to 0.03 only.
    entry.output.space = Space::model;
    const BakedAnimal plain = bake(glb, entry);
    EXPECT_LT(animal.record.error.rms, 0.2f * plain.record.error.rms);
    EXPECT_EQ(animal.record.radius_m, plain.record.radius_m);
}

// A rigid motion of the whole changes nothing in the normalised space.
TEST(NormalisedSpace, ErrorDoesNotDependOnThePlaceOfTheModel) {
    ModelSpec spec = spinning(1);
    const BakedAnimal here = bake(support::glb_of(spec), entry_of(Encoding::dualquat, Space::normalised));
    spec.nodes.push_back({{"name", "World"},
                          {"translation", {300, -20, 7}},
                          {"rotation", support::turn(77, 1, 2, -1)},
                          {"children", {0}}});
    const BakedAnimal there = bake(support::glb_of(spec), entry_of(Encoding::dualquat, Space::normalised));
    EXPECT_NEAR(there.record.error.max, here.record.error.max, 2e-4f);
    EXPECT_NEAR(there.record.error.rms, here.record.error.rms, 1e-4f);
}

TEST(DualQuaternions, AWholeTurnTakesAClosingRow) {
    for (const double turns : {1.0, 2.0, -1.0}) {
        const BakedAnimal animal =
            bake(support::glb_of(spinning(turns)), entry_of(Encoding::dualquat, Space::automatic));
        const Opened opened(animal);
        posepack_clip clip;
        ASSERT_EQ(posepack_get_clip(&opened.view, 0, &clip), POSEPACK_OK);
        const bool odd = std::abs(turns) == 1.0;
        EXPECT_EQ(clip.closing_row, odd ? 1 : 0) << turns << ": two turns come back to q itself";
        EXPECT_EQ(clip.row_count, 8u);
        EXPECT_EQ(opened.view.header.row_count, odd ? 9u : 8u);
        // Blended the wrong way, the last interval would pass through zero: an error of R and more.
        EXPECT_LT(animal.record.error.max, std::abs(turns) == 1.0 ? 2.5e-3f : 2e-2f) << turns;
    }
}

TEST(DualQuaternions, ClipsBehindAClosingRowKeepTheirRows) {
    ModelSpec spec = spinning(1);
    spec.clips.push_back(spec.clips[0]);
    spec.clips[1].name = "Again";
    const BakedAnimal animal = bake(support::glb_of(spec), entry_of(Encoding::dualquat, Space::automatic));
    const Opened opened(animal);
    posepack_clip first, second;
    ASSERT_EQ(posepack_get_clip(&opened.view, 0, &first), POSEPACK_OK);
    ASSERT_EQ(posepack_get_clip(&opened.view, 1, &second), POSEPACK_OK);
    EXPECT_EQ(second.first_row, 9u);
    EXPECT_EQ(first.error.max, second.error.max);
    EXPECT_EQ(animal.record.clips[1].first_row, 9u);
    EXPECT_EQ(animal.record.row_count, 18u);
}

TEST(DualQuaternions, CarryScaleMirrorsAndNothing) {
    // Uniform: growth, a mirrored bone, through zero and out on the other side.
    const std::vector<std::vector<float>> cases = {{1, 1, 1, 2, 2, 2, 3, 3, 3},
                                                   {-1, -1, -1, -1.5f, -1.5f, -1.5f, -1, -1, -1},
                                                   {1, 1, 1, 0, 0, 0, 1, 1, 1},
                                                   {1, 1, 1, 0, 0, 0, -1, -1, -1}};
    for (const std::vector<float>& scales : cases) {
        const support::Bytes glb = support::glb_of(scaling(scales));
        const BakedAnimal half = bake(glb, entry_of(Encoding::dualquat, Space::automatic));
        const BakedAnimal full =
            bake(glb, entry_of(Encoding::dualquat, Space::automatic, TexelFormat::rgba32f));
        EXPECT_LT(half.record.error.max, 5e-3f) << scales[0] << " to " << scales[6];
        EXPECT_LT(full.record.error.max, 1e-5f) << scales[0] << " to " << scales[6];
    }
}

TEST(DualQuaternions, RefuseAStretchAndSayWhere) {
    const support::Bytes glb = support::glb_of(scaling({1, 1, 1, 1, 3, 1, 1, 1, 1}));
    const auto refused = bake_animal(entry_of(Encoding::dualquat, Space::automatic), glb, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.issue().code, IssueCode::lim_similarity);
    const std::string line = base::format_issue(refused.issue());
    for (const char* part : {"animal", "Grow", "'Bone'", "3 to 1", "row 1", "--encoding affine"})
        EXPECT_NE(line.find(part), std::string::npos) << part << " in " << line;
    EXPECT_TRUE(bake_animal(entry_of(Encoding::affine, Space::automatic), glb, {}));
    // What nobody can see is let through.
    const support::Bytes close = support::glb_of(scaling({1, 1, 1, 1, 1.0001f, 1, 1, 1, 1}));
    EXPECT_TRUE(bake_animal(entry_of(Encoding::dualquat, Space::automatic), close, {}));
}

// On generated animals, at the rows of their keys: what is left is rounding and the blend between rows.
TEST(Menagerie, DualQuaternionsAreSmallerAndNoWorse) {
    std::size_t animals = 0;
    for (const char* id : {"horse", "snake", "spider"}) {
        const std::vector<std::uint8_t> glb = menagerie::generate_glb(id);
        if (glb.empty()) continue;
        ++animals;
        const BakedAnimal raw = bake(glb, entry_of(Encoding::mat4, Space::model));
        const BakedAnimal affine = bake(glb, entry_of(Encoding::affine, Space::automatic));
        const BakedAnimal dual = bake(glb, entry_of(Encoding::dualquat, Space::automatic));
        EXPECT_LE(3 * dual.record.texel_bytes,
                  2 * affine.record.texel_bytes + 3 * 16 * 64 * dual.record.clips.size())
            << id << ": two texels to three, and closing rows";
        EXPECT_LE(affine.record.error.rms, 1.02f * raw.record.error.rms + 1e-5f) << id;
        EXPECT_LE(dual.record.error.rms, 1.05f * affine.record.error.rms + 1e-4f) << id;
    }
    EXPECT_GT(animals, 1u);
}

// The bounds of a clip hold along the arcs of dual quaternions, at many places between rows.
TEST(Menagerie, BoundsHoldBetweenRows) {
    ModelSpec spec = spinning(3);  // 135 degrees a row
    spec.clips[0].channels.push_back(
        {0, "translation", {0, 4.0f / 24, 8.0f / 24}, {0, 0, 0, 0, 0, 2, 0, 0, 0}});
    const BakedAnimal animal = bake(support::glb_of(spec), entry_of(Encoding::dualquat, Space::automatic));
    const Opened opened(animal);
    posepack_clip clip;
    ASSERT_EQ(posepack_get_clip(&opened.view, 0, &clip), POSEPACK_OK);
    std::vector<float> m(12 * opened.view.header.bone_count);
    const float* enter = opened.mesh.palette_from_mesh;
    for (std::uint32_t row = 0; row < clip.row_count; ++row)
        for (int i = 0; i <= 32; ++i) {
            const std::uint32_t behind = clip.closing_row != 0 ? clip.row_count : 0;
            const std::uint32_t next = row + 1 < clip.row_count ? row + 1 : behind;
            ASSERT_EQ(posepack_blend_row(&opened.view, row, next, static_cast<float>(i) / 32, m.data()),
                      POSEPACK_OK);
            for (const auto& p :
                 {std::array{1.f, 0.f, 0.f}, {0.f, 1.f, 0.f}, {-1.f, 0.f, 0.f}, {0.f, -1.f, 0.f}}) {
                std::array<float, 3> entered{}, posed{};
                for (std::size_t r = 0; r < 3; ++r)
                    entered[r] = enter[4 * r] * p[0] + enter[4 * r + 1] * p[1] + enter[4 * r + 2] * p[2] +
                                 enter[4 * r + 3];
                for (std::size_t r = 0; r < 3; ++r) {
                    posed[r] = m[4 * r] * entered[0] + m[4 * r + 1] * entered[1] + m[4 * r + 2] * entered[2] +
                               m[4 * r + 3];
                    ASSERT_GE(posed[r], clip.box_min[r] - 1e-5f) << row << " " << i;
                    ASSERT_LE(posed[r], clip.box_max[r] + 1e-5f) << row << " " << i;
                }
            }
        }
}

}  // namespace
}  // namespace posepack::bake
