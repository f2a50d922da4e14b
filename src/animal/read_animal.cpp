// SPDX-License-Identifier: MIT
#include "animal/read_animal.hpp"

#include <fmt/format.h>

#include "animal/load_gltf.hpp"
#include "animal/read_parts.hpp"

namespace posepack::animal {

using base::Issue;
using base::IssueCode;

base::Status ReadContext::repair(IssueCode warning, IssueCode refusal, std::string where,
                                 std::string detail) {
    if (options.strict) return Issue{refusal, std::move(where), std::move(detail)};
    note(warning, std::move(where), std::move(detail));
    return {};
}

void ReadContext::note(IssueCode code, std::string where, std::string detail) {
    animal.findings.push_back({code, std::move(where), std::move(detail)});
}

base::Result<Animal> read_animal(std::span<const std::uint8_t> bytes, const ReadOptions& options) {
    auto gltf = load_gltf(bytes, options);
    if (!gltf) return gltf.issue();
    Animal animal;
    AccessorReader accessors(gltf.value());
    ReadContext context{accessors, options, animal};
    if (const std::uint32_t chunks = gltf.value().unknown_chunk_count; chunks > 0)
        context.note(IssueCode::warn_glb_chunk, "",
                     fmt::format("{} chunks of unknown type were skipped", chunks));
    if (auto status = read_nodes(context); !status) return status.issue();
    // Said before the data is looked at: valid files without motion may have placeholder buffers.
    if (!accessors.facts().has_target)
        return Issue{IssueCode::glb_no_animation, "animations",
                     "expected a channel that moves something, found none"};
    if (auto status = read_skins(context); !status) return status.issue();
    if (auto status = read_meshes(context); !status) return status.issue();
    if (auto status = read_clips(context); !status) return status.issue();
    if (animal.bones.empty())
        return Issue{IssueCode::glb_no_mesh, "nodes", "expected a node with a mesh, found none"};
    if (animal.vertices.positions.empty())
        return Issue{
            IssueCode::glb_no_mesh, "meshes",
            "expected a mesh with positions, and joints and weights where it is skinned, found none"};
    return animal;
}

}  // namespace posepack::animal
