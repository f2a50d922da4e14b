// SPDX-License-Identifier: MIT
// One animal through the whole pipeline: the record says what the container says.
#include "bake/bake_animal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/sha256.hpp"
#include "posepack/loader.h"
#include "support/sample_models.hpp"

namespace posepack::bake {
namespace {

recipe::AnimalEntry tail_entry() {
    recipe::AnimalEntry entry;
    entry.id = "tail";
    entry.model = "models/tail.glb";
    entry.keywords = {{"wander", {"wag"}}, {"flee", {"hop"}}};
    entry.metres_per_unit = 0.5;
    entry.canonical_json = "{\"model\":\"tail\"}";
    return entry;
}

std::string text(const posepack_string& s) {
    return {s.data, s.size_bytes};
}

BakedAnimal baked(const AnimalOptions& options = {}, const recipe::AnimalEntry& entry = tail_entry()) {
    auto result = bake_animal(entry, support::glb_of(support::tail()), options);
    if (!result) throw std::runtime_error(base::format_issue(result.issue()));
    return std::move(result).value();
}

TEST(BakeAnimal, TheRecordSaysWhatTheContainerSays) {
    const BakedAnimal animal = baked();
    const recipe::BakeRecord& record = animal.record;
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, animal.container.data(), animal.container.size()), POSEPACK_OK);
    EXPECT_EQ(record.id, "tail");
    EXPECT_EQ(record.container, "tail.posepack");
    EXPECT_EQ(record.model, "models/tail.glb");
    EXPECT_EQ(record.container_bytes, animal.container.size());
    EXPECT_EQ(record.container_sha256, base::hexadecimal(base::sha256(animal.container)));
    const support::Bytes glb = support::glb_of(support::tail());
    EXPECT_EQ(record.model_bytes, glb.size());
    EXPECT_EQ(record.model_sha256, base::hexadecimal(base::sha256(glb)));
    base::Sha256 recipe_digest;
    std::copy_n(view.header.recipe_sha256, recipe_digest.size(), recipe_digest.begin());
    EXPECT_EQ(record.recipe_sha256, base::hexadecimal(recipe_digest));
    EXPECT_EQ(record.bone_count, view.header.bone_count);
    EXPECT_EQ(record.row_count, view.header.row_count);
    EXPECT_EQ(record.vertex_count, 12u);
    EXPECT_EQ(record.radius_m, view.header.radius_m);
    EXPECT_EQ(record.texture_width, view.header.texture_width_texels);
    EXPECT_EQ(record.texture_height, view.header.texture_height_texels);
    EXPECT_EQ(record.texel_bytes, std::uint64_t{record.row_count} * 3 * 3 * 8);
    EXPECT_EQ(record.encoding, "affine");
    EXPECT_EQ(record.texel_format, "rgba16f");
    EXPECT_FALSE(record.has_vram);
    EXPECT_EQ(view.header.optional_features, POSEPACK_OPTIONAL_ERROR_MEASURED);
}

TEST(BakeAnimal, ClipsAndTheirErrors) {
    const BakedAnimal animal = baked();
    posepack_view view;
    ASSERT_EQ(posepack_open(&view, animal.container.data(), animal.container.size()), POSEPACK_OK);
    ASSERT_EQ(animal.record.clips.size(), 3u);
    float worst = 0;
    std::string worst_clip;
    for (std::uint32_t c = 0; c < 3; ++c) {
        const recipe::ClipRecord& record = animal.record.clips[c];
        posepack_clip clip;
        ASSERT_EQ(posepack_get_clip(&view, c, &clip), POSEPACK_OK);
        EXPECT_EQ(record.name, text(clip.name));
        EXPECT_EQ(record.source_name, text(clip.source_name));
        EXPECT_EQ(record.first_row, clip.first_row);
        EXPECT_EQ(record.row_count, clip.row_count);
        EXPECT_EQ(record.rate_hz, clip.rate_hz);
        EXPECT_EQ(record.period_s, clip.period_s);
        EXPECT_EQ(record.start_s, clip.start_s);
        EXPECT_EQ(record.seam_gap, clip.seam_gap);
        EXPECT_EQ(record.wrap == "loop", clip.wrap == POSEPACK_WRAP_LOOP);
        EXPECT_EQ(record.seam == "open", clip.seam == POSEPACK_SEAM_OPEN);
        EXPECT_EQ(record.interpolation == "step", clip.interpolation == POSEPACK_INTERPOLATION_STEP);
        EXPECT_TRUE(record.error.measured);
        EXPECT_EQ(record.error.max, clip.error.max);
        EXPECT_EQ(record.error.rms, clip.error.rms);
        EXPECT_EQ(record.error.vertex, clip.error.vertex);
        EXPECT_EQ(record.error.mesh, "Skin");
        posepack_bone bone;
        ASSERT_EQ(posepack_get_bone(&view, clip.error.bone, &bone), POSEPACK_OK);
        EXPECT_EQ(record.error.bone, text(bone.name));
        EXPECT_FLOAT_EQ(record.error.max_m, record.error.max * animal.record.radius_m);
        if (clip.error.max > worst) worst = clip.error.max, worst_clip = record.name;
    }
    EXPECT_EQ(animal.record.error.max, worst);
    EXPECT_EQ(animal.record.error.clip, worst_clip);
    ASSERT_EQ(animal.record.states.size(), 2u);
    EXPECT_EQ(animal.record.states[0].name, "flee");
    EXPECT_EQ(animal.record.states[0].clip, "Hop");
    EXPECT_EQ(animal.record.states[1].clip, "Wag");
    EXPECT_EQ(animal.record.default_state, "flee");
}

TEST(BakeAnimal, TwiceGivesTheSameBytes) {
    const BakedAnimal first = baked();
    const BakedAnimal second = baked();
    EXPECT_EQ(first.container, second.container);
    EXPECT_EQ(first.record.container_sha256, second.record.container_sha256);
}

TEST(BakeAnimal, WithoutMeasurementTheTexelsAreTheSame) {
    AnimalOptions options;
    options.measure = false;
    const BakedAnimal plain = baked(options);
    EXPECT_FALSE(plain.record.error.measured);
    posepack_view view, measured_view;
    const BakedAnimal measured = baked();
    ASSERT_EQ(posepack_open(&view, plain.container.data(), plain.container.size()), POSEPACK_OK);
    ASSERT_EQ(posepack_open(&measured_view, measured.container.data(), measured.container.size()),
              POSEPACK_OK);
    EXPECT_EQ(view.header.optional_features, 0u);
    posepack_texels a, b;
    posepack_get_texels(&view, &a);
    posepack_get_texels(&measured_view, &b);
    ASSERT_EQ(a.size_bytes, b.size_bytes);
    EXPECT_TRUE(std::equal(static_cast<const char*>(a.data), static_cast<const char*>(a.data) + a.size_bytes,
                           static_cast<const char*>(b.data)));
}

TEST(BakeAnimal, TheRecipeKnowsModelAndEntry) {
    const BakedAnimal plain = baked();
    recipe::AnimalEntry other = tail_entry();
    other.canonical_json = "{\"model\":\"tail\",\"rate_hz\":30}";
    EXPECT_NE(baked({}, other).record.recipe_sha256, plain.record.recipe_sha256);
    other = tail_entry();
    other.model = "elsewhere/tail.glb";
    EXPECT_EQ(baked({}, other).record.recipe_sha256, plain.record.recipe_sha256) << "paths are no part of it";
    EXPECT_EQ(baked({}, other).container, plain.container);
}

TEST(BakeAnimal, VramOfEveryForm) {
    AnimalOptions options;
    options.compare_vat = true;
    const recipe::BakeRecord record = baked(options).record;
    ASSERT_TRUE(record.has_vram);
    const std::uint64_t rows = record.row_count;
    EXPECT_EQ(record.vram.mat4_rgba32f, rows * 3 * 64);
    EXPECT_EQ(record.vram.mat4_rgba16f, rows * 3 * 32);
    EXPECT_EQ(record.vram.affine_rgba32f, rows * 3 * 48);
    EXPECT_EQ(record.vram.affine_rgba16f, rows * 3 * 24);
    EXPECT_EQ(record.vram.dualquat_rgba16f, rows * 3 * 16);
    EXPECT_EQ(record.vram.vat_position_rgb32f, rows * 12 * 12);
    EXPECT_EQ(record.vram.vat_rgba32f, rows * 12 * 32);
    EXPECT_EQ(record.vram.vat_rgba16f, rows * 12 * 16);
}

TEST(BakeAnimal, FindingsBecomeRemarks) {
    support::GlbBuilder glb = support::builder_of(support::tail());
    glb.set(glb.attribute(0, "WEIGHTS_0"), 1, std::nanf(""));
    const auto animal = bake_animal(tail_entry(), glb.build(), {});
    ASSERT_TRUE(animal);
    ASSERT_FALSE(animal.value().findings.empty());
    EXPECT_EQ(animal.value().findings[0].code, base::IssueCode::warn_weights);
    EXPECT_EQ(animal.value().findings[0].where.substr(0, 16), "models/tail.glb:");
    ASSERT_EQ(animal.value().record.remarks.size(), animal.value().findings.size());
    EXPECT_NE(animal.value().record.remarks[0].find("W-GLB-WEIGHTS"), std::string::npos);
    AnimalOptions strict;
    strict.strict = true;
    const auto refused = bake_animal(tail_entry(), glb.build(), strict);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.issue().code, base::IssueCode::glb_weights);
}

TEST(BakeAnimal, ARecipeDeterminesTheBytes) {
    AnimalOptions unmeasured;
    unmeasured.measure = false;
    const BakedAnimal with = baked();
    const BakedAnimal without = baked(unmeasured);
    EXPECT_NE(with.record.container_sha256, without.record.container_sha256);
    EXPECT_NE(with.record.recipe_sha256, without.record.recipe_sha256);
}

TEST(BakeAnimal, OurOwnBytesThatDoNotOpenAreOurFault) {
    BakedAnimal animal = baked();
    EXPECT_TRUE(check_own_bytes(animal.container));
    animal.container[200] ^= 1;
    const auto status = check_own_bytes(animal.container);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.issue().code, base::IssueCode::internal);
}

}  // namespace
}  // namespace posepack::bake
