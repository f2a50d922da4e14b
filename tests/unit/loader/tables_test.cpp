// SPDX-License-Identifier: MIT
// Accessors and decoding: right values for right indices, the right result for wrong ones.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "container_builder.hpp"
#include "posepack/loader.h"

namespace posepack::test {
namespace {

std::string_view text(posepack_string string) {
    return {string.data, string.size_bytes};
}

class Tables : public testing::Test {
 protected:
    void SetUp() override { ASSERT_EQ(posepack_open(&view_, bytes_.data(), bytes_.size()), POSEPACK_OK); }

    Bytes bytes_ = make_container();
    posepack_view view_{};
    posepack_view empty_{};
};

TEST_F(Tables, HeaderIsCopied) {
    const posepack_header& header = view_.header;
    EXPECT_EQ(header.major, POSEPACK_FORMAT_MAJOR);
    EXPECT_EQ(header.minor, POSEPACK_FORMAT_MINOR);
    EXPECT_EQ(header.file_bytes, bytes_.size());
    EXPECT_EQ(header.section_count, 6u);
    EXPECT_EQ(header.required_features, 0u);
    EXPECT_EQ(header.optional_features, POSEPACK_OPTIONAL_ERROR_MEASURED);
    EXPECT_EQ(header.bone_count, kTinyBoneCount);
    EXPECT_EQ(header.row_count, kTinyRowCount);
    EXPECT_EQ(header.clip_count, 2u);
    EXPECT_EQ(header.encoding, POSEPACK_ENCODING_AFFINE);
    EXPECT_EQ(header.texel_format, POSEPACK_TEXEL_RGBA16F);
    EXPECT_EQ(header.texels_per_bone, 3u);
    EXPECT_EQ(header.texel_order, POSEPACK_ORDER_BONE_MAJOR);
    EXPECT_EQ(header.row_scheme, POSEPACK_ROWS_UNIFORM);
    EXPECT_EQ(header.space_flags, POSEPACK_SPACE_NORMALISED);
    EXPECT_EQ(header.texture_width_texels, 9u);
    EXPECT_EQ(header.texture_height_texels, 5u);
    EXPECT_EQ(header.row_pitch_bytes, 72u);
    EXPECT_EQ(header.rows_per_line, 1u);
    EXPECT_EQ(header.radius_m, 0.75f);
    EXPECT_EQ(header.dualquat_length, 0.f);
    EXPECT_EQ(header.bake_abi, POSEPACK_BAKE_ABI);
    EXPECT_EQ(header.recipe_sha256[0], 1u);
    EXPECT_EQ(header.recipe_sha256[31], 218u);
}

TEST_F(Tables, Clips) {
    posepack_clip clip;
    ASSERT_EQ(posepack_get_clip(&view_, 1, &clip), POSEPACK_OK);
    EXPECT_EQ(text(clip.name), "walk");
    EXPECT_EQ(text(clip.source_name), "Armature|Walk");
    EXPECT_EQ(clip.encoding, POSEPACK_ENCODING_AFFINE);
    EXPECT_EQ(clip.texels_per_bone, 3u);
    EXPECT_EQ(clip.row_scheme, POSEPACK_ROWS_UNIFORM);
    EXPECT_EQ(clip.wrap, POSEPACK_WRAP_LOOP);
    EXPECT_EQ(clip.seam, POSEPACK_SEAM_CLOSED);
    EXPECT_EQ(clip.closing_row, 0u);
    EXPECT_EQ(clip.interpolation, POSEPACK_INTERPOLATION_LINEAR);
    EXPECT_EQ(clip.measured, 1u);
    EXPECT_EQ(clip.first_row, 1u);
    EXPECT_EQ(clip.row_count, 4u);
    EXPECT_EQ(clip.first_texel, 9u);
    EXPECT_EQ(clip.cut_count, 1u);
    EXPECT_EQ(clip.rate_hz, 24.f);
    EXPECT_EQ(clip.period_s, 4.f / 24.f);
    EXPECT_EQ(clip.start_s, 0.5f);
    EXPECT_EQ(clip.speed_mps, 1.25f);
    EXPECT_EQ(clip.stride_phase, 0.f);
    EXPECT_EQ(clip.box_min[2], -3.5f);
    EXPECT_EQ(clip.box_max[2], 3.f);
    EXPECT_EQ(clip.sphere_center[1], 0.125f);
    EXPECT_EQ(clip.sphere_radius, 2.f);
    EXPECT_EQ(clip.seam_gap, 0.0005f);
    EXPECT_EQ(clip.error.max, 0.02f);
    EXPECT_EQ(clip.error.p999, 0.015f);
    EXPECT_EQ(clip.error.rms, 0.003f);
    EXPECT_EQ(clip.error.time_s, 0.125f);
    EXPECT_EQ(clip.error.mesh, 0u);
    EXPECT_EQ(clip.error.vertex, 5u);
    EXPECT_EQ(clip.error.bone, 1u);
    EXPECT_EQ(clip.error.normal_max_deg, 0.02f);
    EXPECT_EQ(clip.error.normal_p999_deg, 0.015f);
    EXPECT_EQ(clip.error.normal_rms_deg, 0.003f);
    EXPECT_EQ(clip.error.normal_time_s, 0.125f);
    EXPECT_EQ(clip.error.normal_mesh, 0u);
    EXPECT_EQ(clip.error.normal_vertex, 5u);
    EXPECT_EQ(clip.error.normal_bone, 1u);
}

TEST_F(Tables, ClipErrors) {
    posepack_clip clip;
    EXPECT_EQ(posepack_get_clip(&view_, 2, &clip), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_clip(&view_, POSEPACK_NONE, &clip), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_clip(&view_, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_clip(nullptr, 0, &clip), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_clip(&empty_, 0, &clip), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, Cuts) {
    std::uint32_t row = 99;
    EXPECT_EQ(posepack_get_cut(&view_, 1, 0, &row), POSEPACK_OK);
    EXPECT_EQ(row, 2u);
    EXPECT_EQ(posepack_get_cut(&view_, 0, 0, &row), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_cut(&view_, 1, 1, &row), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_cut(&view_, 2, 0, &row), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_cut(&view_, 1, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_cut(nullptr, 1, 0, &row), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_cut(&empty_, 1, 0, &row), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, FindingClips) {
    std::uint32_t index = 99;
    EXPECT_EQ(posepack_find_clip(&view_, "walk", &index), POSEPACK_OK);
    EXPECT_EQ(index, 1u);
    EXPECT_EQ(posepack_find_clip(&view_, "idle", &index), POSEPACK_OK);
    EXPECT_EQ(index, 0u);
    for (const char* name : {"", "wal", "walks", "Walk", "Armature|Walk"}) {
        EXPECT_EQ(posepack_find_clip(&view_, name, &index), POSEPACK_ERROR_NOT_FOUND) << name;
    }
    EXPECT_EQ(posepack_find_clip(&view_, nullptr, &index), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_clip(&view_, "walk", nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_clip(&empty_, "walk", &index), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, States) {
    std::uint32_t count = 0, default_state = 0, clip = 99;
    posepack_state state;
    EXPECT_EQ(posepack_count_states(&view_, &count, &default_state), POSEPACK_OK);
    EXPECT_EQ(count, 2u);
    EXPECT_EQ(default_state, 1u);
    EXPECT_EQ(posepack_get_state(&view_, 0, &state), POSEPACK_OK);
    EXPECT_EQ(text(state.name), "stand");
    EXPECT_EQ(state.clip, 0u);
    EXPECT_EQ(posepack_find_state(&view_, "walk", &clip), POSEPACK_OK);
    EXPECT_EQ(clip, 1u);
    EXPECT_EQ(posepack_find_state(&view_, "idle", &clip), POSEPACK_ERROR_NOT_FOUND);
    EXPECT_EQ(posepack_get_state(&view_, 2, &state), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_state(&view_, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_state(&empty_, 0, &state), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_count_states(&view_, nullptr, &default_state), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_count_states(&view_, &count, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_count_states(&empty_, &count, &default_state), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_state(&view_, nullptr, &clip), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_state(&view_, "walk", nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_state(&empty_, "walk", &clip), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, Bones) {
    posepack_bone bone;
    std::uint32_t index = 99;
    EXPECT_EQ(posepack_get_bone(&view_, 0, &bone), POSEPACK_OK);
    EXPECT_EQ(text(bone.name), "root");
    EXPECT_EQ(bone.parent, POSEPACK_NONE);
    EXPECT_EQ(bone.flags, 0u);
    EXPECT_EQ(posepack_get_bone(&view_, 1, &bone), POSEPACK_OK);
    EXPECT_EQ(text(bone.name), "tail");
    EXPECT_EQ(bone.parent, 2u);
    EXPECT_EQ(bone.flags, POSEPACK_BONE_FLAG_WEIGHTED);
    EXPECT_EQ(bone.node, 6u);
    EXPECT_EQ(posepack_find_bone(&view_, "leg", &index), POSEPACK_OK);
    EXPECT_EQ(index, 2u);
    EXPECT_EQ(posepack_find_bone(&view_, "arm", &index), POSEPACK_ERROR_NOT_FOUND);
    EXPECT_EQ(posepack_get_bone(&view_, 3, &bone), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_bone(&view_, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_bone(&empty_, 0, &bone), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_bone(&view_, nullptr, &index), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_bone(&view_, "leg", nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_find_bone(&empty_, "leg", &index), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, SpaceAndMeshes) {
    posepack_space space;
    posepack_mesh mesh;
    ASSERT_EQ(posepack_get_space(&view_, &space), POSEPACK_OK);
    EXPECT_EQ(space.model_from_palette[0], 1.f);
    EXPECT_EQ(space.model_from_palette[3], 0.5f);
    EXPECT_EQ(space.model_from_palette[11], -0.25f);
    EXPECT_EQ(space.forward_axis, POSEPACK_FORWARD_MINUS_Z);
    EXPECT_EQ(space.metres_per_unit, 0.01f);
    EXPECT_EQ(space.mesh_count, 2u);
    ASSERT_EQ(posepack_get_mesh(&view_, 0, &mesh), POSEPACK_OK);
    EXPECT_EQ(text(mesh.name), "body");
    ASSERT_EQ(posepack_get_mesh(&view_, 1, &mesh), POSEPACK_OK);
    EXPECT_EQ(text(mesh.name), "");
    EXPECT_EQ(mesh.node, 9u);
    EXPECT_EQ(mesh.mesh, 1u);
    EXPECT_EQ(mesh.skin, 1u);
    EXPECT_EQ(mesh.joint_count, 2u);
    EXPECT_EQ(mesh.vertex_count, 12u);
    EXPECT_EQ(mesh.palette_from_mesh[7], 3.f);
    EXPECT_EQ(posepack_get_mesh(&view_, 2, &mesh), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_get_mesh(&view_, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_mesh(&empty_, 0, &mesh), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_space(&view_, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_space(&empty_, &space), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, Joints) {
    std::uint32_t bone = 99;
    EXPECT_EQ(posepack_map_joint(&view_, 0, 2, &bone), POSEPACK_OK);
    EXPECT_EQ(bone, 2u);
    EXPECT_EQ(posepack_map_joint(&view_, 1, 0, &bone), POSEPACK_OK);
    EXPECT_EQ(bone, 2u);
    EXPECT_EQ(posepack_map_joint(&view_, 1, 1, &bone), POSEPACK_OK);
    EXPECT_EQ(bone, 1u);
    EXPECT_EQ(posepack_map_joint(&view_, 0, 3, &bone), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_map_joint(&view_, 1, 2, &bone), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_map_joint(&view_, 2, 0, &bone), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_map_joint(&view_, 0, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_map_joint(&empty_, 0, 0, &bone), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, TexelsAndSections) {
    posepack_texels texels;
    const void* data = nullptr;
    std::size_t size = 0;
    ASSERT_EQ(posepack_get_texels(&view_, &texels), POSEPACK_OK);
    EXPECT_EQ(texels.data, bytes_.data() + section_offset(bytes_, POSEPACK_SECTION_PIXL));
    EXPECT_EQ(section_offset(bytes_, POSEPACK_SECTION_PIXL) % 4096, 0u);
    EXPECT_EQ(texels.size_bytes, 360u);
    EXPECT_EQ(texels.width_texels, 9u);
    EXPECT_EQ(texels.height_texels, 5u);
    EXPECT_EQ(texels.row_pitch_bytes, 72u);
    EXPECT_EQ(texels.format, POSEPACK_TEXEL_RGBA16F);
    EXPECT_EQ(posepack_get_section(&view_, POSEPACK_SECTION_STAT, &data, &size), POSEPACK_OK);
    EXPECT_EQ(data, bytes_.data() + section_offset(bytes_, POSEPACK_SECTION_STAT));
    EXPECT_EQ(size, 24u);
    EXPECT_EQ(posepack_get_section(&view_, POSEPACK_SECTION_PROV, &data, &size), POSEPACK_ERROR_NOT_FOUND);
    EXPECT_EQ(posepack_get_section(&view_, 0, &data, &size), POSEPACK_ERROR_NOT_FOUND);
    EXPECT_EQ(posepack_get_section(&view_, POSEPACK_SECTION_STAT, nullptr, &size), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_section(&view_, POSEPACK_SECTION_STAT, &data, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_section(&empty_, POSEPACK_SECTION_STAT, &data, &size), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_texels(&view_, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_texels(nullptr, &texels), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_get_texels(&empty_, &texels), POSEPACK_ERROR_ARG);
}

TEST_F(Tables, DecodingErrors) {
    float matrices[36];
    EXPECT_EQ(posepack_decode_bone(&view_, 5, 0, matrices), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_decode_bone(&view_, 0, 3, matrices), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_decode_bone(&view_, 0, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_decode_bone(nullptr, 0, 0, matrices), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_decode_bone(&empty_, 0, 0, matrices), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_decode_row(&view_, 5, matrices), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_decode_row(&view_, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_decode_row(nullptr, 0, matrices), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_decode_row(&empty_, 0, matrices), POSEPACK_ERROR_ARG);
}

TEST(Decoding, EveryVariantGivesTheSameMatrices) {
    int compared = 0;
    for (std::uint32_t variant = 0; variant < 16 * kTinyRowCount; ++variant) {
        TinyOptions options;
        options.encoding = variant & 1 ? POSEPACK_ENCODING_MAT4 : POSEPACK_ENCODING_AFFINE;
        options.texel_format = variant & 2 ? POSEPACK_TEXEL_RGBA32F : POSEPACK_TEXEL_RGBA16F;
        options.texel_order = variant & 4 ? POSEPACK_ORDER_PLANAR : POSEPACK_ORDER_BONE_MAJOR;
        options.pad_pitch = (variant & 8) != 0;
        options.rows_per_line = variant / 16 + 1;
        const Bytes bytes = make_container(options);
        posepack_view view;
        ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
        for (std::uint32_t row = 0; row < kTinyRowCount; ++row) {
            float all[12 * kTinyBoneCount];
            ASSERT_EQ(posepack_decode_row(&view, row, all), POSEPACK_OK);
            for (std::uint32_t i = 0; i < 12 * kTinyBoneCount; ++i) {
                float one[12];
                ASSERT_EQ(posepack_decode_bone(&view, row, i / 12, one), POSEPACK_OK);
                ASSERT_EQ(all[i], tiny_element(row, i / 12, i % 12)) << variant << " row " << row;
                ASSERT_EQ(one[i % 12], all[i]) << variant << " row " << row;
                ++compared;
            }
        }
    }
    EXPECT_EQ(compared, 16 * 5 * 5 * 36);
}

TEST(Results, NamesAreDistinctAndKnown) {
    std::set<std::string> names;
    int known = 0;
    for (posepack_result result = -1; result <= 64; ++result) {
        const std::string name = posepack_result_name(result);
        if (name == "UNKNOWN") continue;
        names.insert(name);
        ++known;
    }
    EXPECT_EQ(known, 20);
    EXPECT_EQ(names.size(), 20u);
    EXPECT_STREQ(posepack_result_name(POSEPACK_ERROR_HEADER_CRC), "HEADER_CRC");
    EXPECT_STREQ(posepack_result_name(12345), "UNKNOWN");
}

// The formula of the specification, section 10, in double precision.
std::array<double, 12> dualquat_matrix(std::array<double, 4> q, std::array<double, 4> d, double scale) {
    const auto [x, y, z, w] = q;
    const double h = 2 / (x * x + y * y + z * z + w * w);
    return {scale * (1 - h * (y * y + z * z)), scale * h * (x * y - w * z),
            scale * h * (x * z + w * y),       h * (w * d[0] - d[3] * x + y * d[2] - z * d[1]),
            scale * h * (x * y + w * z),       scale * (1 - h * (x * x + z * z)),
            scale * h * (y * z - w * x),       h * (w * d[1] - d[3] * y + z * d[0] - x * d[2]),
            scale * h * (x * z - w * y),       scale * h * (y * z + w * x),
            scale * (1 - h * (x * x + y * y)), h * (w * d[2] - d[3] * z + x * d[1] - y * d[0])};
}

std::array<double, 12> expected_blend(std::uint32_t row0, std::uint32_t row1, double factor,
                                      std::uint32_t bone) {
    std::array<double, 4> q{}, d{};
    double scale = 0;
    for (const auto& [row, share] : {std::pair{row0, 1 - factor}, std::pair{row1, factor}}) {
        double square = 0, along = 0;
        for (std::uint32_t c = 0; c < 4; ++c) {
            const double real = tiny_dualquat(row, bone, c);
            square += real * real;
            along += real * tiny_dualquat(row, bone, 4 + c);
        }
        const double e = along / square;
        for (std::uint32_t c = 0; c < 4; ++c) {
            const double real = tiny_dualquat(row, bone, c);
            q[c] += share * real;
            d[c] += share * (tiny_dualquat(row, bone, 4 + c) - e * real);
        }
        scale += share * (1 + 2 * e / kTinyDualquatLength);
    }
    return dualquat_matrix(q, d, scale);
}

TEST(DualQuaternions, DecodeAndBlendAsSpecified) {
    for (const std::uint32_t format : {POSEPACK_TEXEL_RGBA16F, POSEPACK_TEXEL_RGBA32F})
        for (const std::uint32_t order : {POSEPACK_ORDER_BONE_MAJOR, POSEPACK_ORDER_PLANAR}) {
            TinyOptions options;
            options.encoding = POSEPACK_ENCODING_DUALQUAT;
            options.texel_format = static_cast<std::uint8_t>(format);
            options.texel_order = static_cast<std::uint8_t>(order);
            options.rows_per_line = 2;
            const Bytes bytes = make_container(options);
            posepack_view view;
            ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
            std::array<float, 12 * kTinyBoneCount> row{};
            for (const float factor : {0.0f, 0.25f, 1.0f}) {
                ASSERT_EQ(posepack_blend_row(&view, 1, 3, factor, row.data()), POSEPACK_OK);
                for (std::uint32_t bone = 0; bone < kTinyBoneCount; ++bone) {
                    std::array<float, 12> one{};
                    ASSERT_EQ(posepack_blend_bone(&view, 1, 3, factor, bone, one.data()), POSEPACK_OK);
                    const auto expected = expected_blend(1, 3, factor, bone);
                    for (std::size_t e = 0; e < 12; ++e) {
                        EXPECT_NEAR(one[e], expected[e], 2e-6) << factor << " " << bone << " " << e;
                        EXPECT_EQ(one[e], row[bone * 12 + e]);
                    }
                }
            }
            std::array<float, 12> decoded{}, blended{};
            ASSERT_EQ(posepack_decode_bone(&view, 2, 1, decoded.data()), POSEPACK_OK);
            ASSERT_EQ(posepack_blend_bone(&view, 2, 4, 0.0f, 1, blended.data()), POSEPACK_OK);
            EXPECT_EQ(decoded, blended);
        }
}

TEST(DualQuaternions, AClosingRowIsRowZeroToTheEye) {
    TinyOptions options;
    options.encoding = POSEPACK_ENCODING_DUALQUAT;
    options.closing_row = true;
    const Bytes bytes = make_container(options);
    posepack_view view;
    posepack_clip clip;
    ASSERT_EQ(posepack_open(&view, bytes.data(), bytes.size()), POSEPACK_OK);
    ASSERT_EQ(posepack_get_clip(&view, 1, &clip), POSEPACK_OK);
    EXPECT_EQ(clip.closing_row, 1);
    EXPECT_EQ(clip.row_count, 3u);
    std::array<float, 12 * kTinyBoneCount> first{}, closing{}, between{};
    ASSERT_EQ(posepack_decode_row(&view, clip.first_row, first.data()), POSEPACK_OK);
    ASSERT_EQ(posepack_decode_row(&view, clip.first_row + 3, closing.data()), POSEPACK_OK);
    EXPECT_EQ(first, closing) << "q and -q are one rotation, to the bit";
    // Opposite real parts meet at zero: no pose, but numbers.
    ASSERT_EQ(posepack_blend_row(&view, clip.first_row, clip.first_row + 3, 0.5f, between.data()),
              POSEPACK_OK);
    for (const float value : between) EXPECT_TRUE(std::isfinite(value));
}

TEST_F(Tables, BlendsMatricesEntryByEntry) {
    std::array<float, 12> matrix{};
    ASSERT_EQ(posepack_blend_bone(&view_, 1, 2, 0.25f, 2, matrix.data()), POSEPACK_OK);
    for (std::uint32_t e = 0; e < 12; ++e)
        EXPECT_EQ(matrix[e], 0.75f * tiny_element(1, 2, e) + 0.25f * tiny_element(2, 2, e));
}

TEST_F(Tables, BlendRefusesWhatIsNotThere) {
    std::array<float, 12 * kTinyBoneCount> out{};
    EXPECT_EQ(posepack_blend_bone(nullptr, 0, 0, 0, 0, out.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_blend_bone(&empty_, 0, 0, 0, 0, out.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_blend_bone(&view_, 0, 0, 0, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_blend_bone(&view_, kTinyRowCount, 0, 0, 0, out.data()), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_blend_bone(&view_, 0, kTinyRowCount, 0, 0, out.data()), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_blend_bone(&view_, 0, 0, 0, kTinyBoneCount, out.data()), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_blend_row(nullptr, 0, 0, 0, out.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_blend_row(&empty_, 0, 0, 0, out.data()), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_blend_row(&view_, 0, 0, 0, nullptr), POSEPACK_ERROR_ARG);
    EXPECT_EQ(posepack_blend_row(&view_, kTinyRowCount, 0, 0, out.data()), POSEPACK_ERROR_INDEX);
    EXPECT_EQ(posepack_blend_row(&view_, 0, kTinyRowCount, 0, out.data()), POSEPACK_ERROR_INDEX);
}

}  // namespace
}  // namespace posepack::test
