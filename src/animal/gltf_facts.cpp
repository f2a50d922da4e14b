// SPDX-License-Identifier: MIT
#include "animal/gltf_facts.hpp"

#include <fmt/format.h>

#include "animal/rapidjson_settings.hpp"

#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <array>

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

// Extensions that a file may require: they change neither joints nor the place of a vertex in its mesh,
// or only the component types that the accessor reader knows anyway.
constexpr std::array<std::string_view, 22> kHarmlessExtensions{
    "KHR_mesh_quantization",     "KHR_texture_transform",
    "KHR_texture_basisu",        "KHR_materials_unlit",
    "KHR_materials_clearcoat",   "KHR_materials_transmission",
    "KHR_materials_ior",         "KHR_materials_sheen",
    "KHR_materials_specular",    "KHR_materials_volume",
    "KHR_materials_iridescence", "KHR_materials_anisotropy",
    "KHR_materials_dispersion",  "KHR_materials_emissive_strength",
    "KHR_materials_variants",    "KHR_materials_pbrSpecularGlossiness",
    "KHR_lights_punctual",       "KHR_xmp_json_ld",
    "EXT_texture_webp",          "EXT_texture_avif",
    "MSFT_texture_dds",          "KHR_node_visibility"};

// Follows the path of keys: depth 1 is the root object.
struct FactHandler : rapidjson::BaseReaderHandler<rapidjson::UTF8<>, FactHandler> {
    int depth = 0;
    bool root_is_object = false;
    std::string section;  // key in the root object
    std::string key;      // last key at any deeper level
    std::string buffer_uri;
    bool has_buffer_uri = false;
    std::string unknown_extension;

    bool StartObject() {
        if (depth == 0) root_is_object = true;
        ++depth;
        return true;
    }
    bool EndObject(rapidjson::SizeType) { return --depth, true; }
    bool StartArray() { return ++depth, true; }
    bool EndArray(rapidjson::SizeType) { return --depth, true; }
    bool Key(const char* text, rapidjson::SizeType size, bool) {
        (depth == 1 ? section : key).assign(text, size);
        return true;
    }
    bool String(const char* text, rapidjson::SizeType size, bool) {
        const std::string_view value(text, size);
        if (section == "buffers" && depth == 3 && key == "uri" && !has_buffer_uri) {
            has_buffer_uri = true;
            buffer_uri = value;
        }
        if (section == "extensionsRequired" && depth == 2 && unknown_extension.empty() &&
            std::find(kHarmlessExtensions.begin(), kHarmlessExtensions.end(), value) ==
                kHarmlessExtensions.end())
            unknown_extension = value;
        return true;
    }
};

}  // namespace

base::Status check_gltf_facts(std::string_view json) {
    FactHandler facts;
    rapidjson::MemoryStream stream(json.data(), json.size());
    rapidjson::Reader reader;
    reader.Parse<rapidjson::kParseIterativeFlag>(stream, facts);
    if (!facts.root_is_object)
        return Issue{IssueCode::glb_json, "", "expected a JSON object as the root, found another value"};
    if (!facts.unknown_extension.empty())
        return Issue{
            IssueCode::glb_extension, "extensionsRequired",
            fmt::format("expected extensions that posepack reads, found {}", facts.unknown_extension)};
    if (facts.has_buffer_uri)
        return Issue{IssueCode::glb_uri, "buffers",
                     fmt::format("expected the data in the BIN chunk, found the uri '{}'",
                                 facts.buffer_uri.substr(0, 64))};
    return {};
}

}  // namespace posepack::animal
