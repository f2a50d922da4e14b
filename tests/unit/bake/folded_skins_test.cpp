// SPDX-License-Identifier: MIT
// Skins folded onto the bones of another: in every encoding and space a reader of the container draws them
// where they belong, and what the fold leaves is measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "animal/read_animal.hpp"
#include "bake/bake_animal.hpp"
#include "posepack/loader.h"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

using recipe::Encoding;
using recipe::Space;
using recipe::TexelFormat;
using support::ModelSpec;

// The tail without its stretched node: dual quaternions hold it too.
ModelSpec even_tail() {
    ModelSpec spec = support::tail();
    spec.nodes[2].erase("scale");
    spec.skins[0].inverse_binds = support::inverse_binds_of(spec.nodes, spec.skins[0].joints);
    for (support::ClipSpec& clip : spec.clips)
        std::erase_if(clip.channels,
                      [](const support::ChannelSpec& channel) { return channel.path == "scale"; });
    return spec;
}

BakedAnimal bake(const support::Bytes& glb, Encoding encoding, Space space, TexelFormat format) {
    recipe::AnimalEntry entry;
    entry.id = "animal";
    entry.model = "animal.glb";
    entry.output.encoding = encoding;
    entry.output.space = space;
    entry.output.texel_format = format;
    entry.canonical_json = "{}";
    auto result = bake_animal(entry, glb, {});
    if (!result) throw std::runtime_error(base::format_issue(result.issue()));
    return std::move(result).value();
}

using Matrix = std::array<double, 12>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t r = 0; r < 12; r += 4)
        for (std::size_t c = 0; c < 4; ++c)
            out[r + c] = a[r] * b[c] + a[r + 1] * b[4 + c] + a[r + 2] * b[8 + c] + (c == 3 ? a[r + 3] : 0.0);
    return out;
}

Matrix matrix_of(const float* m) {
    Matrix out{};
    std::copy_n(m, 12, out.begin());
    return out;
}

// What the container draws: the vertices of a mesh in a row, in model space.
std::vector<std::array<double, 3>> drawn(const posepack_view& view, std::uint32_t mesh_index,
                                         const support::MeshSpec& mesh, std::uint32_t row) {
    posepack_space space;
    posepack_mesh record;
    EXPECT_EQ(posepack_get_space(&view, &space), POSEPACK_OK);
    EXPECT_EQ(posepack_get_mesh(&view, mesh_index, &record), POSEPACK_OK);
    std::vector<std::array<double, 3>> out;
    for (std::size_t v = 0; v * 3 < mesh.positions.size(); ++v) {
        out.push_back({0, 0, 0});
        for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
            if (mesh.weights[i] <= 0.0f) continue;
            std::uint32_t bone = 0;
            float stored[12];
            EXPECT_EQ(posepack_map_joint(&view, mesh_index, mesh.joints[i], &bone), POSEPACK_OK);
            EXPECT_EQ(posepack_decode_bone(&view, row, bone, stored), POSEPACK_OK);
            const Matrix m = product(product(matrix_of(space.model_from_palette), matrix_of(stored)),
                                     matrix_of(record.palette_from_mesh));
            for (std::size_t r = 0; r < 3; ++r)
                out.back()[r] +=
                    static_cast<double>(mesh.weights[i]) *
                    (m[4 * r] * mesh.positions[3 * v] + m[4 * r + 1] * mesh.positions[3 * v + 1] +
                     m[4 * r + 2] * mesh.positions[3 * v + 2] + m[4 * r + 3]);
        }
    }
    return out;
}

TEST(FoldedSkins, AreDrawnInTheSamePlaceInEveryForm) {
    const ModelSpec spec = support::folded_twice(even_tail());
    const support::Bytes glb = support::glb_of(spec);
    std::size_t compared = 0;
    for (const Encoding encoding : {Encoding::mat4, Encoding::affine, Encoding::dualquat})
        for (const Space space : {Space::model, Space::normalised})
            for (const TexelFormat format : {TexelFormat::rgba16f, TexelFormat::rgba32f}) {
                const BakedAnimal animal = bake(glb, encoding, space, format);
                posepack_view view;
                ASSERT_EQ(posepack_open(&view, animal.container.data(), animal.container.size()),
                          POSEPACK_OK);
                ASSERT_EQ(view.header.bone_count, 3u);
                // Both meshes read the same texels, so that they agree whatever the texel format holds.
                for (std::uint32_t row = 0; row < view.header.row_count; ++row) {
                    const auto first = drawn(view, 0, spec.meshes[0], row);
                    const auto second = drawn(view, 1, spec.meshes[1], row);
                    for (std::size_t v = 0; v < first.size(); ++v)
                        for (std::size_t c = 0; c < 3; ++c, ++compared)
                            ASSERT_NEAR(first[v][c], second[v][c], 2e-6) << row << " " << v;
                }
            }
    EXPECT_GT(compared, 1'000u);
}

TEST(FoldedSkins, InModelSpaceTheMeshEntersByTheMatrix) {
    const BakedAnimal animal = bake(support::glb_of(support::folded_twice(support::tail())), Encoding::affine,
                                    Space::model, TexelFormat::rgba16f);
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, animal.container.data(), animal.container.size()), POSEPACK_OK);
    posepack_mesh plain, folded;
    ASSERT_EQ(posepack_get_mesh(&view, 0, &plain), POSEPACK_OK);
    ASSERT_EQ(posepack_get_mesh(&view, 1, &folded), POSEPACK_OK);
    const support::Matrix16 x = support::fold_matrix();
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_EQ(plain.palette_from_mesh[4 * r + c], r == c ? 1.0f : 0.0f);
            EXPECT_NEAR(folded.palette_from_mesh[4 * r + c], x[4 * c + r], 1e-5);
        }
    EXPECT_EQ(view.header.space_flags, 0);
}

// The same body without a fold: one mesh more with the first one's skin.
TEST(FoldedSkins, CostNoError) {
    ModelSpec doubled = even_tail();
    doubled.meshes.push_back(doubled.meshes[0]);
    const support::Bytes plain_glb = support::glb_of(doubled);
    const support::Bytes folded_glb = support::glb_of(support::folded_twice(even_tail()));
    for (const Encoding encoding : {Encoding::mat4, Encoding::affine, Encoding::dualquat})
        for (const Space space : {Space::model, Space::normalised})
            for (const TexelFormat format : {TexelFormat::rgba16f, TexelFormat::rgba32f}) {
                const auto plain = bake(plain_glb, encoding, space, format).record;
                const auto folded = bake(folded_glb, encoding, space, format).record;
                EXPECT_NEAR(folded.radius_m, plain.radius_m, 1e-6);
                EXPECT_NEAR(folded.error.max, plain.error.max, 0.02f * plain.error.max + 1e-6f);
                EXPECT_NEAR(folded.error.rms, plain.error.rms, 0.02f * plain.error.rms + 1e-6f);
                EXPECT_NEAR(folded.error.normal_max_deg, plain.error.normal_max_deg,
                            0.02f * plain.error.normal_max_deg + 1e-3f);
            }
}

// A fold that fits to rounding alone: what is left of it is seen, in the mesh and at the bone that has it.
TEST(FoldedSkins, WhatIsLeftOfThemIsMeasured) {
    ModelSpec spec = support::folded_twice(support::tail());
    spec.clips = {{"Rest", {{1, "translation", {0}, {0, 0, 0}}}}};
    const auto exact =
        bake(support::glb_of(spec), Encoding::affine, Space::model, TexelFormat::rgba32f).record;
    spec.skins[1].inverse_binds[2][13] += 2e-6f;
    const support::Bytes glb = support::glb_of(spec);
    ASSERT_EQ(support::read_good(glb).bones.size(), 3u) << "still a fold";
    const auto off = bake(glb, Encoding::affine, Space::model, TexelFormat::rgba32f).record;
    EXPECT_LT(exact.error.max_m, 4e-7f);
    EXPECT_GT(off.error.max_m, 8e-7f);
    EXPECT_LT(off.error.max_m, 4e-6f);
    EXPECT_EQ(off.error.mesh, "Folded");
    EXPECT_EQ(off.error.bone, "Tip");
}

}  // namespace
}  // namespace posepack::bake
