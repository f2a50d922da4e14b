// SPDX-License-Identifier: MIT
// The buffer of a GLB being written, with its views and accessors, and the file around it.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace posepack::menagerie {

using Json = nlohmann::ordered_json;

// Bytes on their way into a buffer view, little-endian on every host.
struct Payload {
    std::string bytes;

    void put_u8(std::uint32_t value);
    void put_u16(std::uint32_t value);
    void put_f32(float value);
};

// glTF 2.0, section 3.6.2.2.
enum class ComponentType { u8 = 5121, u16 = 5123, f32 = 5126 };

class GlbBuffer {
 public:
    // A view of its own and an accessor over it. `target` is 34962 (vertices), 34963 (indices) or 0. Returns
    // the accessor's index. Bounds are written by the caller through `accessor`.
    int add_accessor(const Payload& payload, ComponentType component, std::string_view type,
                     std::size_t count, int target, bool normalised = false);

    // An accessor in the view that all animation data share; equal data are stored and described once.
    int add_animation_accessor(const Payload& payload, std::string_view type, std::size_t count);

    Json& accessor(int index);

    // Appends the animation view and writes buffers, bufferViews and accessors; returns the buffer's bytes.
    std::string finish(Json& document);

 private:
    std::size_t append(std::string_view bytes);

    std::string bytes_;
    std::string animation_bytes_;
    std::vector<Json> views_;
    std::vector<Json> accessors_;
    std::vector<std::size_t> animation_accessors_;
    std::map<std::string, int> known_;
};

// The file: both chunks behind the header (glTF 2.0, section 4.4). `buffer` has a multiple of four bytes.
std::vector<std::uint8_t> pack_glb(std::string json, const std::string& buffer);

}  // namespace posepack::menagerie
