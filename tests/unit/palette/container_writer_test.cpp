// SPDX-License-Identifier: MIT
// A written container opens with the shipped loader, and every table says what was put in.
#include "palette/container_writer.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "posepack/loader.h"
#include "support/baked.hpp"
#include "support/sample_models.hpp"

namespace posepack::palette {
namespace {

std::string text(const posepack_string& s) {
    return {s.data, s.size_bytes};
}

// A tail with states, units and speeds, so that every table has something to say.
class Container : public testing::Test {
 protected:
    Container() {
        palette = baked.palette;
        palette.states = {{"idle", 2}, {"run", 1}, {"walk", 0}};
        palette.default_state = 0;
        palette.forward = recipe::ForwardAxis::minus_x;
        palette.metres_per_unit = 0.01;
        palette.clips[2].plan.seam = recipe::Seam::open;
        palette.clips[0].speed_mps = 1.5;
        palette.clips[0].stride_phase = 0.25;
        bytes = write_container(animal, palette, kRecipe);
        opened = posepack_open(&view, bytes.data(), bytes.size());
    }

    static constexpr std::string_view kRecipe = "{\"a\":1}";
    const animal::Animal animal = support::animal_of(support::tail());
    const support::Baked baked = support::bake_all(animal);
    Palette palette;
    std::vector<std::uint8_t> bytes;
    posepack_view view;
    posepack_result opened = POSEPACK_ERROR_ARG;
};

TEST_F(Container, Header) {
    ASSERT_EQ(opened, POSEPACK_OK);
    const posepack_header& h = view.header;
    EXPECT_EQ(h.file_bytes, bytes.size());
    EXPECT_EQ(h.bone_count, 3u);
    EXPECT_EQ(h.clip_count, 3u);
    EXPECT_EQ(h.row_count, palette.layout.row_count);
    EXPECT_EQ(h.encoding, POSEPACK_ENCODING_AFFINE);
    EXPECT_EQ(h.texel_format, POSEPACK_TEXEL_RGBA16F);
    EXPECT_EQ(h.texels_per_bone, 3u);
    EXPECT_EQ(h.row_scheme, POSEPACK_ROWS_UNIFORM);
    EXPECT_EQ(h.space_flags, 0u);
    EXPECT_EQ(h.texture_width_texels, palette.layout.texture_width);
    EXPECT_EQ(h.texture_height_texels, palette.layout.texture_height);
    EXPECT_EQ(h.row_pitch_bytes, palette.layout.row_pitch_bytes);
    EXPECT_EQ(h.rows_per_line, palette.layout.rows_per_line);
    EXPECT_EQ(h.radius_m, static_cast<float>(palette.radius * 0.01));
    EXPECT_EQ(h.bake_abi, POSEPACK_BAKE_ABI);
    EXPECT_EQ(h.required_features, 0u);
    EXPECT_EQ(h.optional_features, 0u);
    const base::Sha256 digest =
        base::sha256({reinterpret_cast<const std::uint8_t*>(kRecipe.data()), kRecipe.size()});
    EXPECT_EQ(std::memcmp(h.recipe_sha256, digest.data(), digest.size()), 0);
}

TEST_F(Container, Clips) {
    ASSERT_EQ(opened, POSEPACK_OK);
    const char* const names[] = {"Wag", "Hop", "Blink"};
    const std::uint8_t wraps[] = {POSEPACK_WRAP_LOOP, POSEPACK_WRAP_ONCE, POSEPACK_WRAP_LOOP};
    const std::uint8_t seams[] = {POSEPACK_SEAM_CLOSED, POSEPACK_SEAM_CLOSED, POSEPACK_SEAM_OPEN};
    for (std::uint32_t c = 0; c < 3; ++c) {
        const motion::RowPlan& plan = palette.clips[c].plan;
        posepack_clip clip;
        ASSERT_EQ(posepack_get_clip(&view, c, &clip), POSEPACK_OK);
        EXPECT_EQ(text(clip.name), names[c]);
        EXPECT_EQ(text(clip.source_name), std::string("Rig|") + names[c]);
        EXPECT_EQ(clip.encoding, POSEPACK_ENCODING_AFFINE);
        EXPECT_EQ(clip.wrap, wraps[c]) << names[c];
        EXPECT_EQ(clip.seam, seams[c]) << names[c];
        EXPECT_EQ(clip.closing_row, 0);
        EXPECT_EQ(clip.interpolation, c == 2 ? POSEPACK_INTERPOLATION_STEP : POSEPACK_INTERPOLATION_LINEAR);
        EXPECT_EQ(clip.measured, 0);
        EXPECT_EQ(clip.first_row, palette.clips[c].first_row);
        EXPECT_EQ(clip.row_count, plan.row_count);
        EXPECT_EQ(clip.first_texel, palette.clips[c].first_row * 9);
        EXPECT_EQ(clip.cut_count, 0u);
        EXPECT_EQ(clip.rate_hz, static_cast<float>(plan.rate_hz));
        EXPECT_EQ(clip.period_s, static_cast<float>(plan.period_s));
        EXPECT_EQ(clip.start_s, c == 1 ? 0.5f : 0.0f);
        EXPECT_EQ(clip.speed_mps, c == 0 ? 1.5f : 0.0f);
        EXPECT_EQ(clip.stride_phase, c == 0 ? 0.25f : 0.0f);
        EXPECT_EQ(clip.seam_gap, static_cast<float>(plan.seam_gap));
        EXPECT_EQ(clip.error.max, 0.0f);
        EXPECT_EQ(clip.error.vertex, POSEPACK_NONE);
        std::uint32_t found = 9;
        EXPECT_EQ(posepack_find_clip(&view, names[c], &found), POSEPACK_OK);
        EXPECT_EQ(found, c);
    }
}

TEST_F(Container, States) {
    ASSERT_EQ(opened, POSEPACK_OK);
    std::uint32_t count = 0, default_state = 9;
    ASSERT_EQ(posepack_count_states(&view, &count, &default_state), POSEPACK_OK);
    EXPECT_EQ(count, 3u);
    EXPECT_EQ(default_state, 0u);
    for (std::uint32_t s = 0; s < count; ++s) {
        posepack_state state;
        ASSERT_EQ(posepack_get_state(&view, s, &state), POSEPACK_OK);
        EXPECT_EQ(text(state.name), palette.states[s].name);
        EXPECT_EQ(state.clip, palette.states[s].clip);
    }
}

TEST_F(Container, BonesMeshesAndJoints) {
    ASSERT_EQ(opened, POSEPACK_OK);
    for (std::uint32_t b = 0; b < 3; ++b) {
        posepack_bone bone;
        ASSERT_EQ(posepack_get_bone(&view, b, &bone), POSEPACK_OK);
        EXPECT_EQ(text(bone.name), animal.bones[b].name);
        EXPECT_EQ(bone.parent, animal.bones[b].parent);
        EXPECT_EQ(bone.node, animal.bones[b].node);
        EXPECT_EQ(bone.flags, POSEPACK_BONE_FLAG_WEIGHTED);
        std::uint32_t mapped = 9;
        EXPECT_EQ(posepack_map_joint(&view, 0, b, &mapped), POSEPACK_OK);
        EXPECT_EQ(mapped, b);
    }
    posepack_mesh mesh;
    ASSERT_EQ(posepack_get_mesh(&view, 0, &mesh), POSEPACK_OK);
    EXPECT_EQ(text(mesh.name), "Skin");
    EXPECT_EQ(mesh.node, 5u);
    EXPECT_EQ(mesh.mesh, 0u);
    EXPECT_EQ(mesh.skin, 0u);
    EXPECT_EQ(mesh.joint_count, 3u);
    EXPECT_EQ(mesh.vertex_count, 12u);
    posepack_space space;
    ASSERT_EQ(posepack_get_space(&view, &space), POSEPACK_OK);
    EXPECT_EQ(space.forward_axis, POSEPACK_FORWARD_MINUS_X);
    EXPECT_EQ(space.metres_per_unit, 0.01f);
    EXPECT_EQ(space.mesh_count, 1u);
    for (int e = 0; e < 12; ++e) {
        EXPECT_EQ(space.model_from_palette[e], e % 5 == 0 ? 1.0f : 0.0f);
        EXPECT_EQ(mesh.palette_from_mesh[e], e % 5 == 0 ? 1.0f : 0.0f);
    }
}

TEST_F(Container, TexelsAndRecipeStandAsGiven) {
    ASSERT_EQ(opened, POSEPACK_OK);
    posepack_texels texels;
    ASSERT_EQ(posepack_get_texels(&view, &texels), POSEPACK_OK);
    ASSERT_EQ(texels.size_bytes, palette.pixels.size());
    EXPECT_EQ(std::memcmp(texels.data, palette.pixels.data(), palette.pixels.size()), 0);
    EXPECT_EQ((static_cast<const std::uint8_t*>(texels.data) - bytes.data()) % 4096, 0);
    const void* data = nullptr;
    std::size_t size = 0;
    ASSERT_EQ(posepack_get_section(&view, POSEPACK_SECTION_PROV, &data, &size), POSEPACK_OK);
    EXPECT_EQ(std::string_view(static_cast<const char*>(data), size), kRecipe);
}

TEST_F(Container, EqualInputsGiveEqualBytes) {
    EXPECT_EQ(write_container(animal, palette, kRecipe), bytes);
    EXPECT_EQ(support::bake_all(animal).container, baked.container);
}

// Each input of the container shows in its bytes.
TEST_F(Container, OtherInputsGiveOtherBytes) {
    EXPECT_NE(write_container(animal, palette, "{\"a\":2}"), bytes);
    Palette other = palette;
    other.states[0].name = "stand";
    EXPECT_NE(write_container(animal, other, kRecipe), bytes);
    other = palette;
    other.clips[0].plan.seam = recipe::Seam::open;
    EXPECT_NE(write_container(animal, other, kRecipe), bytes);
    other = palette;
    other.pixels[0] ^= 1;
    EXPECT_NE(write_container(animal, other, kRecipe), bytes);
}

ClipError error_number(float n) {
    return {n * 0.004f, n * 0.003f, n * 0.002f, n * 0.01f, 0, 7, 2,
            n,          n * 0.5f,   n * 0.25f,  n * 0.02f, 0, 5, 1};
}

TEST_F(Container, StoredErrorsAreReadBackAndSealed) {
    std::vector<std::uint8_t> measured = bytes;
    const ClipError errors[] = {error_number(1), error_number(2), error_number(3)};
    store_errors(measured, errors);
    ASSERT_EQ(measured.size(), bytes.size());
    ASSERT_EQ(posepack_open(&view, measured.data(), measured.size()), POSEPACK_OK);
    EXPECT_EQ(view.header.optional_features, POSEPACK_OPTIONAL_ERROR_MEASURED);
    for (std::uint32_t c = 0; c < 3; ++c) {
        posepack_clip clip;
        ASSERT_EQ(posepack_get_clip(&view, c, &clip), POSEPACK_OK);
        EXPECT_EQ(clip.measured, 1);
        EXPECT_EQ(clip.error.max, errors[c].max);
        EXPECT_EQ(clip.error.p999, errors[c].p999);
        EXPECT_EQ(clip.error.rms, errors[c].rms);
        EXPECT_EQ(clip.error.time_s, errors[c].time_s);
        EXPECT_EQ(clip.error.mesh, 0u);
        EXPECT_EQ(clip.error.vertex, 7u);
        EXPECT_EQ(clip.error.bone, 2u);
        EXPECT_EQ(clip.error.normal_max_deg, errors[c].normal_max_deg);
        EXPECT_EQ(clip.error.normal_p999_deg, errors[c].normal_p999_deg);
        EXPECT_EQ(clip.error.normal_rms_deg, errors[c].normal_rms_deg);
        EXPECT_EQ(clip.error.normal_time_s, errors[c].normal_time_s);
        EXPECT_EQ(clip.error.normal_vertex, 5u);
        EXPECT_EQ(clip.error.normal_bone, 1u);
        EXPECT_EQ(text(clip.name), animal.clips[c].name) << "nothing else of the record changes";
    }
    std::vector<std::uint8_t> again = measured;
    store_errors(again, errors);
    EXPECT_EQ(again, measured);
}

TEST_F(Container, WithoutStatesThereIsNoDefault) {
    palette.states.clear();
    palette.default_state = animal::kNone;
    bytes = write_container(animal, palette, kRecipe);
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    std::uint32_t count = 9, default_state = 9;
    ASSERT_EQ(posepack_count_states(&view, &count, &default_state), POSEPACK_OK);
    EXPECT_EQ(count, 0u);
    EXPECT_EQ(default_state, POSEPACK_NONE);
}

}  // namespace
}  // namespace posepack::palette
