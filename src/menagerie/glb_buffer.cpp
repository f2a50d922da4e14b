// SPDX-License-Identifier: MIT
#include "menagerie/glb_buffer.hpp"

#include <bit>
#include <utility>

namespace posepack::menagerie {
namespace {

std::size_t rounded_up(std::size_t size_bytes) {
    return (size_bytes + 3u) & ~std::size_t{3};
}

}  // namespace

void Payload::put_u8(std::uint32_t value) {
    bytes.push_back(static_cast<char>(value & 255u));
}

void Payload::put_u16(std::uint32_t value) {
    put_u8(value);
    put_u8(value >> 8);
}

void Payload::put_f32(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value);  // no negative zeros
    put_u16(bits);
    put_u16(bits >> 16);
}

std::size_t GlbBuffer::append(std::string_view bytes) {
    bytes_.resize(rounded_up(bytes_.size()), '\0');
    const std::size_t offset = bytes_.size();
    bytes_ += bytes;
    return offset;
}

int GlbBuffer::add_accessor(const Payload& payload, ComponentType component, std::string_view type,
                            std::size_t count, int target, bool normalised) {
    Json view{{"buffer", 0}, {"byteLength", payload.bytes.size()}, {"byteOffset", append(payload.bytes)}};
    if (target != 0) view["target"] = target;
    Json accessor{{"bufferView", views_.size()}, {"componentType", static_cast<int>(component)}};
    if (normalised) accessor["normalized"] = true;
    accessor["count"] = count;
    accessor["type"] = type;
    views_.push_back(std::move(view));
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::add_animation_accessor(const Payload& payload, std::string_view type, std::size_t count) {
    const std::string key = std::string(type) + payload.bytes;
    const auto [place, is_new] = known_.try_emplace(key, static_cast<int>(accessors_.size()));
    if (!is_new) return place->second;
    animation_accessors_.push_back(accessors_.size());
    accessors_.push_back({{"bufferView", 0},
                          {"byteOffset", animation_bytes_.size()},
                          {"componentType", static_cast<int>(ComponentType::f32)},
                          {"count", count},
                          {"type", type}});
    animation_bytes_ += payload.bytes;
    return place->second;
}

Json& GlbBuffer::accessor(int index) {
    return accessors_[static_cast<std::size_t>(index)];
}

std::string GlbBuffer::finish(Json& document) {
    if (!animation_accessors_.empty()) {
        const std::size_t view = views_.size();
        views_.push_back({{"buffer", 0},
                          {"byteLength", animation_bytes_.size()},
                          {"byteOffset", append(animation_bytes_)}});
        for (const std::size_t index : animation_accessors_) accessors_[index]["bufferView"] = view;
    }
    bytes_.resize(rounded_up(bytes_.size()), '\0');
    document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    document["bufferViews"] = std::move(views_);
    document["accessors"] = std::move(accessors_);
    return std::move(bytes_);
}

std::vector<std::uint8_t> pack_glb(std::string json, const std::string& buffer) {
    json.resize((json.size() + 3u) & ~std::size_t{3}, ' ');
    Payload out;
    const auto put_u32 = [&out](std::size_t value) {
        out.put_u16(static_cast<std::uint32_t>(value));
        out.put_u16(static_cast<std::uint32_t>(value >> 16));
    };
    put_u32(0x46546C67u);  // "glTF"
    put_u32(2);
    put_u32(12 + 8 + json.size() + 8 + buffer.size());
    put_u32(json.size());
    put_u32(0x4E4F534Au);  // "JSON"
    out.bytes += json;
    put_u32(buffer.size());
    put_u32(0x004E4942u);  // "BIN"
    out.bytes += buffer;
    return {out.bytes.begin(), out.bytes.end()};
}

}  // namespace posepack::menagerie
