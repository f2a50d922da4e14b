// SPDX-License-Identifier: MIT
#include "bake/select_clips.hpp"

#include <gtest/gtest.h>

namespace posepack::bake {
namespace {

using base::IssueCode;
using recipe::AnimalEntry;
using recipe::ClipWish;

animal::Animal animal_with(const std::vector<std::pair<std::string, std::string>>& source_and_name) {
    animal::Animal animal;
    for (const auto& [source, name] : source_and_name) {
        animal::Clip clip;
        clip.source_name = source;
        clip.name = name;
        animal.clips.push_back(clip);
    }
    return animal;
}

const animal::Animal& cow() {
    static const animal::Animal animal = animal_with({{"Rig|Walk", "Walk"},
                                                      {"Rig|Attack_Kick", "Attack_Kick"},
                                                      {"Rig|Attack_Headbutt", "Attack_Headbutt"},
                                                      {"Other|Walk", "Walk_2"},
                                                      {"Rig|Idle", "Idle"}});
    return animal;
}

AnimalEntry entry_with(const std::vector<std::string>& names) {
    AnimalEntry entry;
    for (const std::string& name : names) {
        ClipWish wish;
        wish.name = name;
        entry.clips.push_back(wish);
    }
    return entry;
}

std::vector<std::uint32_t> chosen(const animal::Animal& animal, const std::vector<std::string>& names) {
    const auto choices = select_clips(animal, entry_with(names));
    EXPECT_TRUE(choices);
    std::vector<std::uint32_t> sources;
    if (choices)
        for (const ClipChoice& choice : choices.value()) sources.push_back(choice.source);
    return sources;
}

TEST(SelectClips, ByNameAndPattern) {
    using Sources = std::vector<std::uint32_t>;
    EXPECT_EQ(chosen(cow(), {}), (Sources{0, 1, 2, 3, 4})) << "no wish: every clip";
    EXPECT_EQ(chosen(cow(), {"Idle", "Walk"}), (Sources{4, 0})) << "in the order of the wishes";
    EXPECT_EQ(chosen(cow(), {"wALk"}), (Sources{0})) << "without case";
    EXPECT_EQ(chosen(cow(), {"walk_2"}), (Sources{3}));
    EXPECT_EQ(chosen(cow(), {"other|walk"}), (Sources{3})) << "the whole source name";
    EXPECT_EQ(chosen(cow(), {"attack*"}), (Sources{1, 2}));
    EXPECT_EQ(chosen(cow(), {"*kick", "attack*"}), (Sources{1, 2})) << "taken once, by the first wish";
    EXPECT_EQ(chosen(cow(), {"walk*"}), (Sources{0, 3}));
    EXPECT_EQ(chosen(cow(), {"*"}), (Sources{0, 1, 2, 3, 4}));
    EXPECT_EQ(chosen(cow(), {"idl?"}), (Sources{4}));
    EXPECT_EQ(chosen(cow(), {"Walk", "walk"}), (Sources{0})) << "a name means one clip";
}

TEST(SelectClips, MissingNamesListAtMostTen) {
    std::vector<std::pair<std::string, std::string>> names;
    for (int i = 0; i < 25; ++i) {
        const std::string name = "clip_" + std::string(1, static_cast<char>('a' + i));
        names.emplace_back(name, name);
    }
    const auto choices = select_clips(animal_with(names), entry_with({"Swim"}));
    ASSERT_FALSE(choices);
    EXPECT_EQ(choices.issue().code, IssueCode::cat_clip_missing);
    const std::string& detail = choices.issue().detail;
    std::size_t listed = 0;
    for (const auto& [source, name] : names) listed += detail.find(name) != std::string::npos ? 1 : 0;
    EXPECT_EQ(listed, 10u) << detail;
    EXPECT_NE(detail.find("15 more"), std::string::npos) << detail;
}

TEST(SelectClips, ANearMissIsSuggested) {
    const auto choices = select_clips(cow(), entry_with({"Wolk"}));
    ASSERT_FALSE(choices);
    EXPECT_NE(choices.issue().detail.find("'Walk'?"), std::string::npos) << choices.issue().detail;
    EXPECT_FALSE(select_clips(cow(), entry_with({"swim*"})));
    EXPECT_FALSE(select_clips(cow(), entry_with({"Idle", "Swim"}))) << "each wish must find something";
}

TEST(SelectClips, WishesTravelWithTheirClips) {
    AnimalEntry entry = entry_with({"attack*", "Walk"});
    entry.rate_hz = 15.0;
    entry.clips[0].rate_hz = 60.0;
    entry.clips[0].wrap = recipe::Wrap::once;
    entry.clips[1].seam = recipe::Seam::open;
    entry.clips[1].speed_mps = 1.2;
    entry.clips[1].stride_phase = 0.5;
    entry.clips[1].states = {"wander"};
    const auto choices = select_clips(cow(), entry);
    ASSERT_TRUE(choices);
    ASSERT_EQ(choices.value().size(), 3u);
    for (std::size_t i : {0u, 1u}) {
        EXPECT_EQ(choices.value()[i].wish.rate_hz, 60.0);
        EXPECT_EQ(choices.value()[i].wish.wrap, recipe::Wrap::once);
    }
    const ClipChoice& walk = choices.value()[2];
    EXPECT_EQ(walk.wish.rate_hz, 15.0) << "the animal's, where the wish names none";
    EXPECT_EQ(walk.wish.seam, recipe::Seam::open);
    EXPECT_EQ(walk.speed_mps, 1.2);
    EXPECT_EQ(walk.stride_phase, 0.5);
    EXPECT_EQ(walk.states, (std::vector<std::string>{"wander"}));
}

// The states as "name:clip" texts, the default one marked.
std::vector<std::string> states_of(const AnimalEntry& entry) {
    const auto choices = select_clips(cow(), entry);
    EXPECT_TRUE(choices);
    const auto states = choose_states(cow(), entry, choices.value());
    EXPECT_TRUE(states);
    std::vector<std::string> out;
    if (!states) return out;
    for (std::size_t s = 0; s < states.value().states.size(); ++s) {
        const palette::PaletteState& state = states.value().states[s];
        out.push_back(state.name + ":" + cow().clips[choices.value()[state.clip].source].name +
                      (s == states.value().default_state ? " *" : ""));
    }
    return out;
}

TEST(ChooseStates, ByKeywordsInTheirOrder) {
    AnimalEntry entry = entry_with({});
    entry.keywords = {{"attack", {"bite", "HEADBUTT", "attack"}},
                      {"flee", {"gallop", "run"}},
                      {"idle", {"idle"}},
                      {"wander", {"walk"}}};
    EXPECT_EQ(states_of(entry),
              (std::vector<std::string>{"attack:Attack_Headbutt", "idle:Idle *", "wander:Walk"}))
        << "the first keyword that some clip has; a state that none plays is left out";
}

TEST(ChooseStates, WishesBeforeKeywords) {
    AnimalEntry entry = entry_with({"Attack_Kick", "*"});
    entry.clips[0].states = {"attack", "kick"};
    entry.keywords = {{"attack", {"headbutt"}}, {"idle", {"idle"}}};
    EXPECT_EQ(states_of(entry),
              (std::vector<std::string>{"attack:Attack_Kick", "idle:Idle *", "kick:Attack_Kick"}));
}

TEST(ChooseStates, OneStateOfTwoWishesIsTheFirsts) {
    AnimalEntry entry = entry_with({"Idle", "Walk"});
    entry.clips[0].states = {"stand"};
    entry.clips[1].states = {"stand"};
    EXPECT_EQ(states_of(entry), (std::vector<std::string>{"stand:Idle *"}))
        << "the first state where none is idle";
}

TEST(ChooseStates, TheDefaultIsTheOneNamed) {
    AnimalEntry entry = entry_with({"*"});
    entry.keywords = {{"idle", {"idle"}}, {"wander", {"walk"}}};
    entry.default_state = "wander";
    EXPECT_EQ(states_of(entry), (std::vector<std::string>{"idle:Idle", "wander:Walk *"}));
}

TEST(ChooseStates, ADefaultThatPlaysNothingIsAnError) {
    for (const bool has_states : {false, true}) {
        AnimalEntry entry = entry_with({"Walk"});
        if (has_states) entry.clips[0].states = {"wander"};
        entry.default_state = "swim";
        const auto choices = select_clips(cow(), entry);
        ASSERT_TRUE(choices);
        const auto states = choose_states(cow(), entry, choices.value());
        ASSERT_FALSE(states);
        EXPECT_EQ(states.issue().code, IssueCode::cat_state_missing);
    }
}

TEST(ChooseStates, WithoutStatesThereIsNoDefault) {
    const auto choices = select_clips(cow(), entry_with({}));
    ASSERT_TRUE(choices);
    const auto states = choose_states(cow(), entry_with({}), choices.value());
    ASSERT_TRUE(states);
    EXPECT_TRUE(states.value().states.empty());
    EXPECT_EQ(states.value().default_state, animal::kNone);
}

}  // namespace
}  // namespace posepack::bake
