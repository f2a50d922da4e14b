// SPDX-License-Identifier: MIT
// Clips as read: names, channels, where they begin and how long they are.
#include <gtest/gtest.h>

#include "animal/read_animal.hpp"
#include "support/sample_models.hpp"

namespace posepack::animal {
namespace {

using support::ModelSpec;

support::ChannelSpec move(std::vector<float> times) {
    std::vector<float> values(times.size() * 3, 0.0f);
    values.back() = 1.0f;
    return {0, "translation", std::move(times), std::move(values)};
}

TEST(Clips, NamesAreShortUniqueAndKeptRaw) {
    ModelSpec spec = support::one_bone();
    for (const char* name : {"Rig|Walk", "Other|walk", "", "Rig|Run\n"})
        spec.clips.push_back({name, {move({0, 1})}});
    const Animal animal = support::animal_of(spec);
    ASSERT_EQ(animal.clips.size(), 4u);
    EXPECT_EQ(animal.clips[0].name, "Walk");
    EXPECT_EQ(animal.clips[0].source_name, "Rig|Walk");
    EXPECT_EQ(animal.clips[1].name, "walk_2");
    EXPECT_EQ(animal.clips[1].source_name, "Other|walk");
    EXPECT_EQ(animal.clips[2].name, "clip_2");
    EXPECT_EQ(animal.clips[3].name, "Run_");
}

TEST(Clips, BeginAtTheirFirstKeyAndEndAtTheirLast) {
    ModelSpec spec = support::one_bone();
    spec.nodes.push_back({{"name", "Other"}});
    spec.clips = {{"Late", {move({2.5f, 3.0f}), {1, "translation", {2.0f, 2.75f}, {0, 0, 0, 0, 1, 0}}}},
                  {"Pose", {move({1.25f})}}};
    const Animal animal = support::animal_of(spec);
    EXPECT_EQ(animal.clips[0].start_s, 2.0);
    EXPECT_EQ(animal.clips[0].duration_s, 1.0);
    EXPECT_EQ(animal.clips[1].start_s, 1.25);
    EXPECT_EQ(animal.clips[1].duration_s, 0.0);
}

TEST(Clips, SixHundredSecondsAreRead) {
    ModelSpec spec = support::one_bone();
    spec.clips = {{"Long", {move({5, 605})}}};
    EXPECT_EQ(support::animal_of(spec).clips[0].duration_s, 600.0);
}

TEST(Clips, ChannelsKeepTheirKeys) {
    const ModelSpec spec = support::tail();
    const Animal animal = support::animal_of(spec);
    std::size_t looked_at = 0;
    for (std::size_t c = 0; c < animal.clips.size(); ++c) {
        ASSERT_EQ(animal.clips[c].channels.size(), spec.clips[c].channels.size());
        for (std::size_t i = 0; i < animal.clips[c].channels.size(); ++i, ++looked_at) {
            const Channel& channel = animal.clips[c].channels[i];
            const support::ChannelSpec& source = spec.clips[c].channels[i];
            EXPECT_EQ(channel.node, static_cast<std::uint32_t>(source.node));
            ASSERT_EQ(channel.key_count, source.times.size());
            for (std::size_t k = 0; k < source.times.size(); ++k)
                EXPECT_EQ(animal.key_times[channel.first_time + k], source.times[k]);
            for (std::size_t v = 0; v < source.values.size(); ++v)
                EXPECT_EQ(animal.key_values[channel.first_value + v], source.values[v]);
        }
    }
    EXPECT_EQ(looked_at, 5u);
    EXPECT_EQ(animal.clips[1].channels[0].interpolation, Interpolation::cubic_spline);
    EXPECT_EQ(animal.clips[1].channels[1].path, Path::scale);
    EXPECT_EQ(animal.clips[2].channels[0].interpolation, Interpolation::step);
}

TEST(Clips, OneListOfTimesForManyChannelsIsReadOnce) {
    support::GlbBuilder glb = support::builder_of(support::tail());
    auto& samplers = glb.document["animations"][0]["samplers"];
    samplers[1]["input"] = samplers[0]["input"];
    samplers[0].erase("interpolation");
    const Animal animal = support::read_good(glb.build());
    EXPECT_EQ(animal.clips[0].channels[0].first_time, animal.clips[0].channels[1].first_time);
    EXPECT_EQ(animal.clips[0].channels[0].interpolation, Interpolation::linear)
        << "what glTF says without a word";
}

TEST(Clips, AnAnimationWithoutChannelsIsNoClip) {
    support::GlbBuilder glb = support::builder_of(support::tail());
    glb.document["animations"][1]["channels"] = support::Json::array();
    const Animal animal = support::read_good(glb.build());
    ASSERT_EQ(animal.clips.size(), 2u);
    EXPECT_EQ(animal.clips[1].name, "Blink");
}

// The same bytes give the same animal, and what is unused in a spline's last key changes nothing else.
TEST(Clips, SurplusValuesAreIgnored) {
    support::GlbBuilder glb = support::builder_of(support::tail());
    glb.document["animations"][0]["samplers"][0]["output"] =
        glb.add_values(std::vector<float>(20 * 4, 0.5f), "VEC4");
    const Animal animal = support::read_good(glb.build());
    EXPECT_EQ(animal.clips[0].channels[0].key_count, 13u);
}

}  // namespace
}  // namespace posepack::animal
