// SPDX-License-Identifier: MIT
#include "animal/animation_target.hpp"

#include <charconv>

namespace posepack::animal {

std::optional<Path> path_of(std::string_view name) {
    if (name == "translation") return Path::translation;
    if (name == "rotation") return Path::rotation;
    if (name == "scale") return Path::scale;
    return std::nullopt;
}

std::optional<Aim> aim_of(const PointerChannel& channel) {
    constexpr std::string_view kNodes = "/nodes/";
    std::string_view text = channel.pointer;
    if (!text.starts_with(kNodes)) return std::nullopt;
    text.remove_prefix(kNodes.size());
    const char* last = text.data() + text.size();
    Aim aim;
    aim.sampler = channel.sampler;
    const auto [end, error] = std::from_chars(text.data(), last, aim.node);
    if (error != std::errc() || aim.node < 0 || end == last || *end != '/') return std::nullopt;
    const auto path = path_of({end + 1, static_cast<std::size_t>(last - end - 1)});
    if (!path) return std::nullopt;
    aim.path = *path;
    return aim;
}

std::vector<bool> animated_nodes(const tinygltf::Model& model, const GltfFacts& facts) {
    std::vector<bool> animated(model.nodes.size(), false);
    const auto note = [&](int node) {
        if (node >= 0 && static_cast<std::size_t>(node) < animated.size())
            animated[static_cast<std::size_t>(node)] = true;
    };
    for (const tinygltf::Animation& animation : model.animations)
        for (const tinygltf::AnimationChannel& channel : animation.channels)
            if (path_of(channel.target_path)) note(channel.target_node);
    for (const PointerChannel& pointer : facts.pointers)
        if (const auto aim = aim_of(pointer)) note(aim->node);
    return animated;
}

}  // namespace posepack::animal
