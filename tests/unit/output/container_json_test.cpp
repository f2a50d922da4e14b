// SPDX-License-Identifier: MIT
#include "output/container_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/baked.hpp"
#include "support/sample_models.hpp"

namespace posepack::output {
namespace {

using nlohmann::json;

class ContainerJson : public testing::Test {
 protected:
    ContainerJson() { opened = posepack_open(&view, baked.container.data(), baked.container.size()); }

    const animal::Animal animal = support::animal_of(support::tail());
    const support::Baked baked = support::bake_all(animal);
    posepack_view view;
    posepack_result opened = POSEPACK_ERROR_ARG;
};

TEST_F(ContainerJson, SaysWhatTheLoaderSays) {
    ASSERT_EQ(opened, POSEPACK_OK);
    const json clips = json::parse(clips_json(view));
    ASSERT_EQ(clips.size(), 3u);
    for (std::uint32_t c = 0; c < 3; ++c) {
        posepack_clip clip;
        ASSERT_EQ(posepack_get_clip(&view, c, &clip), POSEPACK_OK);
        EXPECT_EQ(clips[c].at("name"), std::string(clip.name.data, clip.name.size_bytes));
        EXPECT_EQ(clips[c].at("first_row"), clip.first_row);
        EXPECT_EQ(clips[c].at("row_count"), clip.row_count);
        EXPECT_FLOAT_EQ(clips[c].at("period_s").get<float>(), clip.period_s);
        EXPECT_EQ(clips[c].at("wrap"), wrap_name(clip.wrap));
    }
    const json bones = json::parse(bones_json(view));
    ASSERT_EQ(bones.size(), 3u);
    EXPECT_EQ(bones[1].at("name"), "Tail");
    EXPECT_FALSE(json::parse(states_json(view)).is_discarded());
    EXPECT_FALSE(json::parse(space_json(view)).is_discarded());
}

TEST_F(ContainerJson, WholeAndIndented) {
    ASSERT_EQ(opened, POSEPACK_OK);
    const std::string line = container_json(view, -1);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const std::string lines = container_json(view, 2);
    EXPECT_NE(lines.find('\n'), std::string::npos);
    EXPECT_EQ(json::parse(line), json::parse(lines));
    EXPECT_EQ(json::parse(line).dump(), line) << "canonical: keys sorted, no spaces";
}

TEST(Names, AreOnesOwn) {
    EXPECT_EQ(encoding_name(POSEPACK_ENCODING_MAT4), "mat4");
    EXPECT_EQ(encoding_name(POSEPACK_ENCODING_AFFINE), "affine");
    EXPECT_EQ(texel_format_name(POSEPACK_TEXEL_RGBA16F), "rgba16f");
    EXPECT_EQ(texel_format_name(POSEPACK_TEXEL_RGBA32F), "rgba32f");
    EXPECT_EQ(texel_order_name(POSEPACK_ORDER_BONE_MAJOR), "bone-major");
    EXPECT_EQ(texel_order_name(POSEPACK_ORDER_PLANAR), "planar");
    EXPECT_EQ(wrap_name(POSEPACK_WRAP_LOOP), "loop");
    EXPECT_EQ(wrap_name(POSEPACK_WRAP_ONCE), "once");
    EXPECT_EQ(wrap_name(POSEPACK_WRAP_PING_PONG), "ping-pong");
    EXPECT_EQ(seam_name(POSEPACK_SEAM_CLOSED), "closed");
    EXPECT_EQ(seam_name(POSEPACK_SEAM_OPEN), "open");
}

}  // namespace
}  // namespace posepack::output
