// SPDX-License-Identifier: MIT
#include "animal/morph_findings.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <set>

#include "animal/names.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

constexpr std::size_t kMostAnimations = 32;  // that get a finding of their own
constexpr std::size_t kMostMeshes = 4;       // named in one finding

// The N of "/nodes/N/weights" or "/nodes/N/weights/2", where `prefix` is "/nodes/".
std::optional<std::size_t> index_in(std::string_view pointer, std::string_view prefix) {
    if (!pointer.starts_with(prefix)) return std::nullopt;
    pointer.remove_prefix(prefix.size());
    const char* last = pointer.data() + pointer.size();
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(pointer.data(), last, index);
    if (error != std::errc() ||
        !std::string_view(end, static_cast<std::size_t>(last - end)).starts_with("/weights"))
        return std::nullopt;
    return index;
}

// The meshes that the channels of one animation blend, by their names.
class BlendedMeshes {
 public:
    explicit BlendedMeshes(ReadContext& context) : context_(context) {}

    void add_node(std::size_t node) {
        const auto& nodes = context_.model().nodes;
        const int mesh = node < nodes.size() ? nodes[node].mesh : -1;
        add_mesh(static_cast<std::size_t>(mesh), node);
    }
    void add_mesh(std::size_t mesh, std::size_t node = kNone) {
        const auto& meshes = context_.model().meshes;
        std::string name = mesh < meshes.size() ? meshes[mesh].name : "";
        if (name.empty() && node < context_.animal.nodes.size()) name = context_.animal.nodes[node].name;
        names_.insert(name.empty() ? "a mesh without a name"
                                   : fmt::format("'{}'", base::shortened(name, 40)));
    }
    bool is_empty() const { return names_.empty(); }
    std::string text() const {
        std::string out;
        std::size_t written = 0;
        for (const std::string& name : names_) {
            if (written == kMostMeshes) return out + fmt::format(" and {} more", names_.size() - written);
            out += (written++ > 0 ? ", " : "") + name;
        }
        return out;
    }

 private:
    ReadContext& context_;
    std::set<std::string> names_;
};

BlendedMeshes meshes_blended_by(ReadContext& context, std::size_t animation) {
    BlendedMeshes meshes(context);
    for (const auto& channel : context.model().animations[animation].channels)
        if (channel.target_path == "weights") meshes.add_node(static_cast<std::size_t>(channel.target_node));
    for (const PointerChannel& pointer : context.accessors.facts().pointers) {
        if (pointer.animation != animation) continue;
        if (const auto node = index_in(pointer.pointer, "/nodes/")) meshes.add_node(*node);
        if (const auto mesh = index_in(pointer.pointer, "/meshes/")) meshes.add_mesh(*mesh);
    }
    return meshes;
}

}  // namespace

bool aims_at_weights(std::string_view pointer) {
    return index_in(pointer, "/nodes/") || index_in(pointer, "/meshes/");
}

void note_morph_channels(ReadContext& context) {
    const auto& animations = context.model().animations;
    std::size_t found = 0;
    for (std::size_t a = 0; a < animations.size(); ++a) {
        const BlendedMeshes meshes = meshes_blended_by(context, a);
        if (meshes.is_empty() || ++found > kMostAnimations) continue;
        const std::string name = animations[a].name.empty() ? fmt::format("clip_{}", a) : animations[a].name;
        context.note(base::IssueCode::warn_left_out, fmt::format("animations/{}", a),
                     fmt::format("'{}' blends morph targets of {}: not in the palette",
                                 base::shortened(name, 60), meshes.text()));
    }
    if (found > kMostAnimations)
        context.note(base::IssueCode::warn_left_out, "animations",
                     fmt::format("{} more animations blend morph targets: not in the palette",
                                 found - kMostAnimations));
}

}  // namespace posepack::animal
