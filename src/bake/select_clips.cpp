// SPDX-License-Identifier: MIT
#include "bake/select_clips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/text.hpp"

namespace posepack::bake {
namespace {

using animal::Animal;
using base::Issue;
using base::IssueCode;

constexpr std::size_t kListedNames = 10;

std::string after_last_bar(const std::string& name) {
    const std::size_t bar = name.rfind('|');
    return bar == std::string::npos ? name : name.substr(bar + 1);
}

bool is_pattern(const std::string& wish) {
    return wish.find_first_of("*?") != std::string::npos;
}

// All clips the wish means. A plain name prefers the unique name over the bare one, so that "walk_2" and
// "walk" can both be named; it then takes one clip.
std::vector<std::uint32_t> clips_named(const Animal& animal, const std::string& wish) {
    const std::string wanted = base::lowered(wish);
    std::vector<std::uint32_t> by_name, by_source;
    for (std::uint32_t c = 0; c < animal.clips.size(); ++c) {
        const animal::Clip& clip = animal.clips[c];
        const auto is_match = [&](const std::string& name) {
            const std::string low = base::lowered(name);
            return is_pattern(wish) ? base::matches_pattern(low, wanted) : low == wanted;
        };
        if (is_match(clip.name))
            by_name.push_back(c);
        else if (is_match(clip.source_name) || is_match(after_last_bar(clip.source_name)))
            by_source.push_back(c);
    }
    if (is_pattern(wish)) {
        by_name.insert(by_name.end(), by_source.begin(), by_source.end());
        std::sort(by_name.begin(), by_name.end());
        return by_name;
    }
    if (by_name.empty() && !by_source.empty()) by_name.push_back(by_source.front());
    return by_name;
}

Issue missing_clip(const Animal& animal, const std::string& wish) {
    std::string names;
    std::vector<std::string> all;
    for (std::size_t c = 0; c < animal.clips.size(); ++c) {
        all.push_back(animal.clips[c].name);
        if (c < kListedNames) names += (c == 0 ? "" : ", ") + base::shortened(animal.clips[c].name, 64);
    }
    if (all.size() > kListedNames) names += fmt::format(" and {} more", all.size() - kListedNames);
    const std::string near = base::nearest(wish, all);
    return {IssueCode::cat_clip_missing, "",
            fmt::format("expected a clip '{}', found {}{}", base::shortened(wish, 64), names,
                        near.empty() ? "" : fmt::format("; did you mean '{}'?", near))};
}

}  // namespace

base::Result<std::vector<ClipChoice>> select_clips(const Animal& animal, const recipe::AnimalEntry& entry) {
    std::vector<ClipChoice> choices;
    if (entry.clips.empty()) {
        for (std::uint32_t c = 0; c < animal.clips.size(); ++c) {
            ClipChoice choice;
            choice.source = c;
            choice.wish.rate_hz = entry.rate_hz;
            choices.push_back(choice);
        }
        return choices;
    }
    std::set<std::uint32_t> taken;
    for (const recipe::ClipWish& wish : entry.clips) {
        const std::vector<std::uint32_t> found = clips_named(animal, wish.name);
        if (found.empty()) return missing_clip(animal, wish.name);
        for (const std::uint32_t c : found) {
            if (!taken.insert(c).second) continue;
            choices.push_back({c,
                               {wish.rate_hz ? wish.rate_hz : entry.rate_hz, wish.wrap, wish.seam},
                               wish.speed_mps,
                               wish.stride_phase,
                               wish.states,
                               wish.bound});
        }
    }
    return choices;
}

base::Result<StateChoice> choose_states(const Animal& animal, const recipe::AnimalEntry& entry,
                                        const std::vector<ClipChoice>& choices) {
    std::map<std::string, std::uint32_t> clip_of_state;
    for (std::uint32_t i = 0; i < choices.size(); ++i)
        for (const std::string& state : choices[i].states) clip_of_state.try_emplace(state, i);
    for (const auto& [state, keywords] : entry.keywords)
        for (const std::string& keyword : keywords) {
            if (clip_of_state.contains(state)) break;
            for (std::uint32_t i = 0; i < choices.size(); ++i)
                if (base::lowered(animal.clips[choices[i].source].name).find(base::lowered(keyword)) !=
                    std::string::npos) {
                    clip_of_state.emplace(state, i);
                    break;
                }
        }
    StateChoice result;
    const std::string wanted = entry.default_state.empty() ? "idle" : entry.default_state;
    for (const auto& [name, clip] : clip_of_state) {
        if (name == wanted) result.default_state = static_cast<std::uint32_t>(result.states.size());
        result.states.push_back({name, clip});
    }
    if (result.default_state != animal::kNone || result.states.empty()) {
        if (entry.default_state.empty() || result.default_state != animal::kNone) return result;
    }
    if (!entry.default_state.empty())
        return Issue{IssueCode::cat_state_missing, "",
                     fmt::format("expected a default state that plays a clip, found '{}'",
                                 base::shortened(entry.default_state, 64))};
    result.default_state = 0;
    return result;
}

}  // namespace posepack::bake
