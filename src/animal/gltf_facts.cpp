// SPDX-License-Identifier: MIT
#include "animal/gltf_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "animal/gltf_rules.hpp"
#include "base/json.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

// Extensions that a file may require: those that posepack reads, and those that change neither joints nor
// the place of a vertex in its mesh.
constexpr std::array<std::string_view, 27> kKnownExtensions{"KHR_draco_mesh_compression",
                                                            "EXT_meshopt_compression",
                                                            "KHR_meshopt_compression",
                                                            "KHR_mesh_quantization",
                                                            "KHR_animation_pointer",
                                                            "KHR_texture_transform",
                                                            "KHR_texture_basisu",
                                                            "KHR_materials_unlit",
                                                            "KHR_materials_clearcoat",
                                                            "KHR_materials_transmission",
                                                            "KHR_materials_ior",
                                                            "KHR_materials_sheen",
                                                            "KHR_materials_specular",
                                                            "KHR_materials_volume",
                                                            "KHR_materials_iridescence",
                                                            "KHR_materials_anisotropy",
                                                            "KHR_materials_dispersion",
                                                            "KHR_materials_emissive_strength",
                                                            "KHR_materials_variants",
                                                            "KHR_materials_pbrSpecularGlossiness",
                                                            "KHR_materials_diffuse_transmission",
                                                            "KHR_lights_punctual",
                                                            "KHR_xmp_json_ld",
                                                            "EXT_texture_webp",
                                                            "EXT_texture_avif",
                                                            "MSFT_texture_dds",
                                                            "KHR_node_visibility"};

constexpr std::size_t kShownUriBytes = 64;

enum class Section : std::uint8_t { other, buffers, views, accessors, images, meshes, animations, required };

// Keys below the root that matter somewhere.
enum class KeyName : std::uint8_t {
    other,
    uri,
    byte_length,
    extensions,
    meshopt,
    fallback,
    primitives,
    indices,
    channels,
    sampler,
    animation_pointer,
    pointer
};

struct NamedKey {
    std::string_view name;
    KeyName key;
};

constexpr std::array<NamedKey, 12> kKeys{{{"uri", KeyName::uri},
                                          {"byteLength", KeyName::byte_length},
                                          {"extensions", KeyName::extensions},
                                          {"EXT_meshopt_compression", KeyName::meshopt},
                                          {"KHR_meshopt_compression", KeyName::meshopt},
                                          {"fallback", KeyName::fallback},
                                          {"primitives", KeyName::primitives},
                                          {"indices", KeyName::indices},
                                          {"channels", KeyName::channels},
                                          {"sampler", KeyName::sampler},
                                          {"KHR_animation_pointer", KeyName::animation_pointer},
                                          {"pointer", KeyName::pointer}}};

constexpr std::array<std::pair<std::string_view, Section>, 7> kSections{
    {{"buffers", Section::buffers},
     {"bufferViews", Section::views},
     {"accessors", Section::accessors},
     {"images", Section::images},
     {"meshes", Section::meshes},
     {"animations", Section::animations},
     {"extensionsRequired", Section::required}}};

KeyName key_of(std::string_view name) {
    for (const NamedKey& known : kKeys)
        if (known.name == name) return known.key;
    return KeyName::other;
}

// Depth counts open objects and arrays: keys of the root object are at depth 1, those of a buffer at 3.
class FactVisitor final : public base::JsonVisitor {
 public:
    explicit FactVisitor(bool keep_data_uris) : keep_data_uris_(keep_data_uris) {}

    GltfFacts facts;
    GltfRules rules;

    void key(std::string_view name, std::size_t offset) override {
        rules.key(name, depth_);
        if (depth_ == 1) {
            open_section(name);
        } else if (keeps_storage()) {
            storage_.key(depth_, name);
        } else if (section_ != Section::other && depth_ < keys_.size()) {
            keys_[depth_] = key_of(name);
            if (section_ == Section::meshes && is_at(5, KeyName::indices, 3, KeyName::primitives))
                facts.hidden_keys.push_back(offset);
        }
    }

    void text(std::string_view value) override {
        rules.text(value, depth_);
        if (keeps_storage()) return storage_.text(depth_, value);
        if (section_ == Section::images && is_at(3, KeyName::uri)) {
            if (!value.empty() && !value.starts_with("data:")) ++facts.outside_image_count;
        } else if (section_ == Section::buffers && is_at(3, KeyName::uri)) {
            const bool keep = keep_data_uris_ && value.starts_with("data:");
            facts.buffers.back().has_uri = true;
            facts.buffers.back().uri = keep ? value : value.substr(0, kShownUriBytes);
        } else if (section_ == Section::animations &&
                   is_at(8, KeyName::pointer, 7, KeyName::animation_pointer)) {
            channel_.pointer = value;
        } else if (section_ == Section::required && depth_ == 2 && facts.unknown_extension.empty() &&
                   std::find(kKnownExtensions.begin(), kKnownExtensions.end(), value) ==
                       kKnownExtensions.end()) {
            facts.unknown_extension = value;
        }
    }

    void number(double value) override {
        rules.number(value, depth_);
        if (keeps_storage()) return storage_.number(depth_, value);
        if (section_ == Section::buffers && is_at(3, KeyName::byte_length))
            facts.buffers.back().byte_length = value;
        else if (section_ == Section::animations && is_at(5, KeyName::sampler, 3, KeyName::channels))
            channel_.sampler = index_of(value);
        else if (section_ == Section::meshes && is_at(5, KeyName::indices, 3, KeyName::primitives))
            facts.indices.push_back({counts_[2], counts_[4], index_of(value)});
    }

    void truth(bool value) override {
        rules.truth(depth_);
        if (keeps_storage()) return storage_.truth(depth_, value);
        if (section_ == Section::buffers && is_at(5, KeyName::fallback, 4, KeyName::meshopt) &&
            keys_[3] == KeyName::extensions)
            facts.buffers.back().is_fallback = value;
    }

    void open(bool is_array, std::size_t offset) override {
        rules.open(depth_, is_array);
        if (depth_ == 0) facts.root_is_object = !is_array;
        if (depth_ == 1 && is_hidden()) facts.hidden_lists.emplace_back(offset + 1, offset + 1);
        if (keeps_storage())
            storage_.open(depth_, is_array);
        else if (section_ != Section::other)
            begin_item(is_array);
        ++depth_;
    }

    void close(std::size_t offset) override {
        --depth_;
        if (depth_ == 1 && is_hidden()) facts.hidden_lists.back().second = offset;
        if (keeps_storage()) return storage_.close(depth_);
        if (section_ == Section::other || depth_ >= counts_.size()) return;
        if (section_ == Section::animations && depth_ == 4 && keys_[3] == KeyName::channels &&
            !channel_.pointer.empty())
            facts.pointers.push_back(channel_);
        ++counts_[depth_];
    }

    // To be called once, at the end.
    base::Status take_storage() {
        facts.accessors = std::move(storage_.accessors);
        facts.views = std::move(storage_.views);
        return storage_.status();
    }

 private:
    // Keys of the root object that matter.
    void open_section(std::string_view name) {
        section_ = Section::other;
        for (const auto& [known, section] : kSections)
            if (known == name) section_ = section;
        if (is_storage())
            storage_.begin(section_ == Section::accessors ? StorageVisitor::List::accessors
                                                          : StorageVisitor::List::views);
    }

    bool is_storage() const { return section_ == Section::accessors || section_ == Section::views; }
    // A file that is refused for its size is read to the end, but not kept.
    bool keeps_storage() const { return is_storage() && !rules.is_over(); }
    bool is_hidden() const {
        return is_storage() || section_ == Section::buffers || section_ == Section::images;
    }

    // counts_[d]: how many objects and arrays have closed in the one that is open at depth d.
    void begin_item(bool is_array) {
        if (depth_ + 1 < counts_.size()) {
            counts_[depth_ + 1] = 0;
            keys_[depth_ + 1] = KeyName::other;
        }
        if (depth_ == 2 && section_ == Section::buffers && !is_array && !rules.is_over())
            facts.buffers.emplace_back();
        if (depth_ == 2 && section_ == Section::images) ++facts.image_count;
        if (depth_ == 4 && section_ == Section::animations) channel_ = {counts_[2], counts_[4], -1, {}};
    }

    bool is_at(std::size_t depth, KeyName key) const { return depth_ == depth && keys_[depth] == key; }
    bool is_at(std::size_t depth, KeyName key, std::size_t above, KeyName key_above) const {
        return is_at(depth, key) && keys_[above] == key_above;
    }
    static int index_of(double value) {
        return value >= 0.0 && value < 2147483647.0 ? static_cast<int>(value) : -1;
    }

    bool keep_data_uris_;
    Section section_ = Section::other;
    std::size_t depth_ = 0;
    std::array<KeyName, 9> keys_{};
    std::array<std::size_t, 9> counts_{};
    PointerChannel channel_;
    StorageVisitor storage_;
};

base::Status check_text(const base::JsonCheck& check) {
    const auto issue = [&](IssueCode code) {
        return Issue{code, fmt::format("JSON chunk, byte {}", check.offset), check.detail};
    };
    switch (check.fault) {
        case base::JsonFault::none:
            return {};
        case base::JsonFault::syntax:
        case base::JsonFault::utf8:
            return issue(IssueCode::glb_json);
        case base::JsonFault::number_range:
            return issue(IssueCode::glb_number);
        case base::JsonFault::duplicate_key:
            return issue(IssueCode::glb_json_dup);
        case base::JsonFault::too_deep:
            return issue(IssueCode::lim_json_depth);
    }
    return {};
}

base::Status check_buffers(const GltfFacts& facts, bool allow_data_uris) {
    for (std::size_t b = 0; b < facts.buffers.size(); ++b) {
        const BufferFacts& buffer = facts.buffers[b];
        const std::string where = fmt::format("buffers/{}", b);
        if (buffer.byte_length < 1.0)
            return Issue{IssueCode::glb_schema, where,
                         "expected a byteLength of at least 1, found less or none"};
        if (!buffer.has_uri || buffer.is_fallback) continue;
        const bool is_data = buffer.uri.starts_with("data:");
        if (is_data && allow_data_uris) continue;
        return Issue{IssueCode::glb_uri, where,
                     fmt::format("expected the data in the BIN chunk, found the uri '{}'{}",
                                 base::printable(base::shortened(buffer.uri, kShownUriBytes)),
                                 is_data ? " (--allow-data-uris reads it)" : "")};
    }
    return {};
}

}  // namespace

int GltfFacts::indices_of(std::size_t mesh, std::size_t primitive) const {
    const auto found = std::find_if(indices.begin(), indices.end(), [&](const PrimitiveIndices& item) {
        return item.mesh == mesh && item.primitive == primitive;
    });
    return found == indices.end() ? -1 : found->accessor;
}

base::Result<GltfFacts> read_gltf_facts(std::string_view json, bool allow_data_uris) {
    FactVisitor visitor(allow_data_uris);
    if (auto status = check_text(base::check_json(json, &visitor)); !status) return status.issue();
    const base::Status storage = visitor.take_storage();
    const GltfFacts& facts = visitor.facts;
    if (!facts.root_is_object)
        return Issue{IssueCode::glb_json, "", "expected a JSON object as the root, found another value"};
    if (auto status = visitor.rules.status(); !status) return status.issue();
    if (!facts.unknown_extension.empty())
        return Issue{
            IssueCode::glb_extension, "extensionsRequired",
            fmt::format("expected extensions that posepack reads, found {}", facts.unknown_extension)};
    if (auto status = check_buffers(facts, allow_data_uris); !status) return status.issue();
    // Where nothing moves, that is the reason, whatever else is wrong.
    if (!storage && visitor.rules.has_target()) return storage.issue();
    visitor.facts.has_target = visitor.rules.has_target();
    return std::move(visitor.facts);
}

std::string text_for_parser(std::string_view json, const GltfFacts& facts) {
    std::string text(json);
    // The byte behind the opening quote belongs to the key, even where it begins an escape.
    for (const std::size_t offset : facts.hidden_keys) text[offset + 1] = '~';
    // Lists are cut from the last to the first, so that earlier offsets stay.
    for (auto list = facts.hidden_lists.rbegin(); list != facts.hidden_lists.rend(); ++list)
        text.erase(list->first, list->second - list->first);
    return text;
}

}  // namespace posepack::animal
