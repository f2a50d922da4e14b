// SPDX-License-Identifier: MIT
#include "animal/load_gltf.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "animal/glb_file.hpp"
#include "animal/gltf_facts.hpp"
#include "animal/read_animal.hpp"
#include "base/json.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::size_t kMaxJsonBytes = 64u << 20;

base::Status check_text(std::string_view json) {
    if (json.size() > kMaxJsonBytes)
        return Issue{IssueCode::lim_file, "JSON chunk",
                     fmt::format("expected at most {} bytes, found {}", kMaxJsonBytes, json.size())};
    const base::JsonCheck check = base::check_json(json);
    const std::string where = fmt::format("JSON chunk, byte {}", check.offset);
    switch (check.fault) {
        case base::JsonFault::none:
            return {};
        case base::JsonFault::syntax:
        case base::JsonFault::utf8:
            return Issue{IssueCode::glb_json, where, check.detail};
        case base::JsonFault::number_range:
            return Issue{IssueCode::glb_number, where, check.detail};
        case base::JsonFault::duplicate_key:
            return Issue{IssueCode::glb_json_dup, where, check.detail};
        case base::JsonFault::too_deep:
            return Issue{IssueCode::lim_json_depth, where, check.detail};
    }
    return {};
}

// Images are not needed: whatever they hold is accepted unseen.
bool skip_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                void*) {
    return true;
}

// The GLB again with its JSON and BIN chunks alone: tinygltf knows no other chunks.
std::vector<std::uint8_t> without_unknown_chunks(const GlbFile& glb) {
    std::vector<std::uint8_t> out;
    const auto append_u32 = [&](std::uint32_t v) {
        for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(v >> (8 * i)));
    };
    const bool has_bin = !glb.bin.empty();
    append_u32(0x46546C67);
    append_u32(2);
    append_u32(static_cast<std::uint32_t>(20 + glb.json.size() + (has_bin ? 8 + glb.bin.size() : 0)));
    append_u32(static_cast<std::uint32_t>(glb.json.size()));
    append_u32(0x4E4F534A);
    out.insert(out.end(), glb.json.begin(), glb.json.end());
    if (has_bin) {
        append_u32(static_cast<std::uint32_t>(glb.bin.size()));
        append_u32(0x004E4942);
        out.insert(out.end(), glb.bin.begin(), glb.bin.end());
    }
    return out;
}

}  // namespace

base::Result<LoadedGltf> load_gltf(std::span<const std::uint8_t> bytes) {
    if (bytes.size() > kMaxGlbBytes)
        return Issue{IssueCode::lim_file, "",
                     fmt::format("expected at most {} bytes, found {}", kMaxGlbBytes, bytes.size())};
    const auto glb = split_glb(bytes);
    if (!glb) return glb.issue();
    if (const auto status = check_text(glb.value().json); !status) return status.issue();
    if (const auto status = check_gltf_facts(glb.value().json); !status) return status.issue();

    std::vector<std::uint8_t> rebuilt;
    if (glb.value().unknown_chunk_count > 0) {
        rebuilt = without_unknown_chunks(glb.value());
        bytes = rebuilt;
    }
    LoadedGltf loaded{std::make_unique<tinygltf::Model>(), bytes.size(), glb.value().unknown_chunk_count};
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(skip_image, nullptr);
    std::string error;
    std::string warning;
    try {
        if (parser.LoadBinaryFromMemory(loaded.model.get(), &error, &warning, bytes.data(),
                                        static_cast<unsigned>(bytes.size())))
            return loaded;
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    while (!error.empty() && error.back() == '\n') error.pop_back();
    return Issue{IssueCode::glb_schema, "", "expected glTF 2.0, found: " + base::shortened(error, 200)};
}

}  // namespace posepack::animal
