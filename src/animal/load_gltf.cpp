// SPDX-License-Identifier: MIT
#include "animal/load_gltf.hpp"

#include <fmt/format.h>

#include <string>

#include "animal/glb_file.hpp"
#include "animal/read_animal.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::size_t kMaxJsonBytes = 64u << 20;

std::string without_line_end(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

}  // namespace

base::Result<LoadedGltf> load_gltf(std::span<const std::uint8_t> bytes, const ReadOptions& options) {
    if (bytes.size() > kMaxGlbBytes)
        return Issue{IssueCode::lim_file, "",
                     fmt::format("expected at most {} bytes, found {}", kMaxGlbBytes, bytes.size())};
    const auto glb = split_glb(bytes);
    if (!glb) return glb.issue();
    const std::string_view json = glb.value().json;
    if (json.size() > kMaxJsonBytes)
        return Issue{IssueCode::lim_file, "JSON chunk",
                     fmt::format("expected at most {} bytes, found {}", kMaxJsonBytes, json.size())};
    auto facts = read_gltf_facts(json, options.allow_data_uris);
    if (!facts) return facts.issue();

    // tinygltf sees the rest of the JSON alone: how numbers are stored is ours (BufferViews, AccessorReader),
    // and images nobody needs.
    const std::string text = text_for_parser(json, facts.value());
    LoadedGltf loaded{std::make_unique<tinygltf::Model>(), std::move(facts).value(), glb.value().bin,
                      bytes.size(), glb.value().unknown_chunk_count};
    tinygltf::TinyGLTF parser;
    std::string error;
    std::string warning;
    try {
        if (parser.LoadASCIIFromString(loaded.model.get(), &error, &warning, text.data(),
                                       static_cast<unsigned>(text.size()), ""))
            return loaded;
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    // tinygltf refuses some valid files. Where nothing moves, that is the answer, whatever else is said of
    // the file.
    if (!loaded.facts.has_target)
        return Issue{IssueCode::glb_no_animation, "animations",
                     fmt::format("expected a channel that moves something, found none (and: {})",
                                 base::shortened(without_line_end(error), 160))};
    return Issue{IssueCode::glb_schema, "",
                 "expected glTF 2.0, found: " + base::shortened(without_line_end(error), 200)};
}

}  // namespace posepack::animal
