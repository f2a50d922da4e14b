// SPDX-License-Identifier: MIT
#include "reference_animal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace posepack::oracle {

using Json = nlohmann::json;

// The JSON of a GLB (glTF 2.0, section 4.4) and the numbers in its accessors (section 3.6.2).
class Glb {
 public:
    explicit Glb(const std::filesystem::path& path);

    // All components of an accessor, element after element; integers are scaled where it is normalised.
    std::vector<double> numbers(const Json& index) const;

    Json json;

 private:
    double component(std::size_t at, int type, bool normalised) const;

    std::string binary_;
};

namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr Affine kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

// componentType (glTF 2.0, section 5.1.3).
constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kFloat = 5126;

// Key times are single precision: a time that is meant for a STEP must not miss it for a rounding.
constexpr double kStepLeadS = 1e-6;

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
    Number number;
    if (at + sizeof number > bytes.size()) throw std::runtime_error("the GLB ends before its numbers do");
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

std::size_t width_of(const std::string& type) {
    static const std::map<std::string, std::size_t> kWidths{
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    return kWidths.at(type);
}

Affine affine_of_columns(const std::vector<double>& numbers, std::size_t first) {
    Affine out{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c) out[4 * r + c] = numbers.at(first + 4 * c + r);
    return out;
}

Affine affine_of(const Value& t, const Value& q, const Value& s) {
    const auto [x, y, z, w] = q;
    return {s[0] * (1 - 2 * (y * y + z * z)), s[1] * 2 * (x * y - w * z),
            s[2] * 2 * (x * z + w * y),       t[0],
            s[0] * 2 * (x * y + w * z),       s[1] * (1 - 2 * (x * x + z * z)),
            s[2] * 2 * (y * z - w * x),       t[1],
            s[0] * 2 * (x * z - w * y),       s[1] * 2 * (y * z + w * x),
            s[2] * (1 - 2 * (x * x + y * y)), t[2]};
}

double dot(const Value& a, const Value& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Value sum(double u, const Value& a, double v, const Value& b) {
    return {u * a[0] + v * b[0], u * a[1] + v * b[1], u * a[2] + v * b[2], u * a[3] + v * b[3]};
}

Value unit(const Value& q) {
    return sum(1.0 / std::sqrt(dot(q, q)), q, 0.0, q);
}

// glTF 2.0, appendix C.4. The angle of close rotations is lost to rounding, and does not matter there.
Value slerp(const Value& a, const Value& b, double u) {
    const double sign = dot(a, b) < 0.0 ? -1.0 : 1.0;
    const double angle = std::acos(std::min(std::abs(dot(a, b)), 1.0));
    if (angle < 1e-7) return sum(1.0 - u, a, sign * u, b);
    return sum(std::sin((1.0 - u) * angle) / std::sin(angle), a, sign * std::sin(u * angle) / std::sin(angle),
               b);
}

// The value of a key; `part` chooses in-tangent, value or out-tangent (0, 1, 2) of a cubic one.
Value value_of(const ReferenceChannel& channel, std::size_t key, std::size_t part = 1) {
    const std::size_t place = channel.interpolation == "CUBICSPLINE" ? 3 * key + part : key;
    Value out{};
    for (std::size_t c = 0; c < channel.width; ++c) out[c] = channel.values.at(place * channel.width + c);
    return out;
}

// glTF 2.0, appendix C.5.
Value cubic(const ReferenceChannel& channel, std::size_t key, double u) {
    const double span_s = channel.times_s[key + 1] - channel.times_s[key];
    const double u2 = u * u, u3 = u2 * u;
    const Value here = sum(2 * u3 - 3 * u2 + 1, value_of(channel, key), span_s * (u3 - 2 * u2 + u),
                           value_of(channel, key, 2));
    const Value there =
        sum(-2 * u3 + 3 * u2, value_of(channel, key + 1), span_s * (u3 - u2), value_of(channel, key + 1, 0));
    return sum(1.0, here, 1.0, there);
}

void grow(Box& box, const std::vector<double>& positions, std::size_t vertex) {
    for (std::size_t c = 0; c < 3; ++c) {
        box.low[c] = std::min(box.low[c], positions.at(3 * vertex + c));
        box.high[c] = std::max(box.high[c], positions.at(3 * vertex + c));
    }
}

// Grows the boxes of a skin's joints, and the one of all its vertices, by those of a primitive.
void grow_boxes(const Glb& glb, const Json& attributes, std::vector<Box>& boxes, Box& whole) {
    const std::vector<double> positions = glb.numbers(attributes.at("POSITION"));
    for (std::size_t v = 0; v < positions.size() / 3; ++v) grow(whole, positions, v);
    for (int set = 0; attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
        const std::vector<double> joints = glb.numbers(attributes.at("JOINTS_" + std::to_string(set)));
        const std::vector<double> weights = glb.numbers(attributes.at("WEIGHTS_" + std::to_string(set)));
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i] > 0.0) grow(boxes.at(static_cast<std::size_t>(joints.at(i))), positions, i / 4);
    }
}

Value value_of(const Json& numbers) {
    Value out{};
    for (std::size_t c = 0; c < numbers.size(); ++c) out.at(c) = numbers[c];
    return out;
}

}  // namespace

Glb::Glb(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.compare(0, 4, "glTF") != 0) throw std::runtime_error(path.string() + ": expected a GLB");
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const auto size = number_at<std::uint32_t>(bytes, at);
        const std::string kind = bytes.substr(at + 4, 4);
        if (kind == "JSON") json = Json::parse(bytes.substr(at + 8, size));
        if (kind == std::string("BIN\0", 4)) binary_ = bytes.substr(at + 8, size);
        at += 8 + std::size_t{size};
    }
}

std::vector<double> Glb::numbers(const Json& index) const {
    const Json& accessor = json.at("accessors").at(index.get<std::size_t>());
    if (accessor.contains("sparse")) throw std::runtime_error("expected no sparse accessor");
    const Json& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const int type = accessor.at("componentType");
    const std::size_t width = width_of(accessor.at("type"));
    const std::size_t size =
        type == kByte || type == kUnsignedByte ? 1 : (type == kShort || type == kUnsignedShort ? 2 : 4);
    const std::size_t stride = view.value("byteStride", width * size);
    const std::size_t first =
        view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    const std::size_t count = accessor.at("count");
    std::vector<double> out;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < width; ++c)
            out.push_back(
                component(first + i * stride + c * size, type, accessor.value("normalized", false)));
    return out;
}

double Glb::component(std::size_t at, int type, bool normalised) const {
    const auto scaled = [&](double number, double largest) {
        return normalised ? std::max(number / largest, -1.0) : number;  // glTF 2.0, section 3.11
    };
    switch (type) {
        case kByte:
            return scaled(number_at<std::int8_t>(binary_, at), 127.0);
        case kUnsignedByte:
            return scaled(number_at<std::uint8_t>(binary_, at), 255.0);
        case kShort:
            return scaled(number_at<std::int16_t>(binary_, at), 32767.0);
        case kUnsignedShort:
            return scaled(number_at<std::uint16_t>(binary_, at), 65535.0);
        case kFloat:
            return static_cast<double>(number_at<float>(binary_, at));
        default:
            throw std::runtime_error("unexpected componentType " + std::to_string(type));
    }
}

Affine operator*(const Affine& a, const Affine& b) {
    Affine out{};
    for (std::size_t r = 0; r < 12; r += 4)
        for (std::size_t c = 0; c < 4; ++c)
            out[r + c] = a[r] * b[c] + a[r + 1] * b[4 + c] + a[r + 2] * b[8 + c] + (c == 3 ? a[r + 3] : 0.0);
    return out;
}

Value ReferenceChannel::at(double time_s) const {
    const bool step = interpolation == "STEP";
    const auto next = std::upper_bound(times_s.begin(), times_s.end(), step ? time_s + kStepLeadS : time_s);
    const auto after = static_cast<std::size_t>(next - times_s.begin());
    const std::size_t key = after == 0 ? 0 : after - 1;
    Value out = value_of(*this, key);
    if (after > 0 && after < times_s.size() && !step) {
        const double u = (time_s - times_s[key]) / (times_s[after] - times_s[key]);
        if (interpolation == "CUBICSPLINE")
            out = cubic(*this, key, u);
        else if (width == 4)
            out = slerp(unit(out), unit(value_of(*this, after)), u);
        else
            out = sum(1.0 - u, out, u, value_of(*this, after));
    }
    return width == 4 ? unit(out) : out;
}

ReferenceAnimal::ReferenceAnimal(const std::filesystem::path& path) {
    const Glb glb(path);
    read_nodes(glb);
    if (glb.json.contains("skins"))
        for (std::size_t s = 0; s < glb.json.at("skins").size(); ++s) read_skin(glb, s);
    read_rigid_meshes(glb);
    for (std::size_t a = 0; a < glb.json.at("animations").size(); ++a) read_clip(glb, a);
}

void ReferenceAnimal::read_nodes(const Glb& glb) {
    const Json& sources = glb.json.at("nodes");
    nodes_.assign(sources.size(), {kNone});
    for (std::size_t n = 0; n < sources.size(); ++n) {
        for (const std::size_t child : sources[n].value("children", std::vector<std::size_t>{}))
            nodes_.at(child).parent = n;
        Node& node = nodes_[n];
        node.has_matrix = sources[n].contains("matrix");
        if (node.has_matrix) node.matrix = affine_of_columns(sources[n]["matrix"], 0);
        if (sources[n].contains("translation")) node.translation = value_of(sources[n]["translation"]);
        if (sources[n].contains("rotation")) node.rotation = unit(value_of(sources[n]["rotation"]));
        if (sources[n].contains("scale")) node.scale = value_of(sources[n]["scale"]);
    }
}

void ReferenceAnimal::read_skin(const Glb& glb, std::size_t index) {
    const Json& source = glb.json["skins"][index];
    ReferenceSkin skin;
    skin.nodes = source.at("joints").get<std::vector<std::size_t>>();
    skin.inverse_binds.assign(skin.nodes.size(), kIdentity);
    skin.boxes.resize(skin.nodes.size());
    if (source.contains("inverseBindMatrices")) {
        const std::vector<double> numbers = glb.numbers(source["inverseBindMatrices"]);
        for (std::size_t j = 0; j < skin.nodes.size(); ++j)
            skin.inverse_binds[j] = affine_of_columns(numbers, 16 * j);
    }
    Box whole;
    for (const Json& node : glb.json["nodes"]) {
        if (!node.contains("mesh") || node.value("skin", kNone) != index) continue;
        const Json& mesh = glb.json.at("meshes").at(node["mesh"].get<std::size_t>());
        for (const Json& primitive : mesh.at("primitives"))
            grow_boxes(glb, primitive.at("attributes"), skin.boxes, whole);
    }
    for (Box& box : skin.boxes)
        if (box.low[0] > box.high[0]) box = whole;
    skins.push_back(std::move(skin));
}

void ReferenceAnimal::read_rigid_meshes(const Glb& glb) {
    for (std::size_t n = 0; n < glb.json["nodes"].size(); ++n) {
        const Json& node = glb.json["nodes"][n];
        if (!node.contains("mesh") || node.contains("skin")) continue;
        ReferenceRigidMesh rigid{n, {}};
        const Json& mesh = glb.json.at("meshes").at(node["mesh"].get<std::size_t>());
        for (const Json& primitive : mesh.at("primitives")) {
            const std::vector<double> positions = glb.numbers(primitive.at("attributes").at("POSITION"));
            for (std::size_t v = 0; v < positions.size() / 3; ++v) grow(rigid.box, positions, v);
        }
        rigid_meshes.push_back(rigid);
    }
}

void ReferenceAnimal::read_clip(const Glb& glb, std::size_t index) {
    const Json& source = glb.json["animations"][index];
    ReferenceClip clip;
    clip.name = source.value("name", "");
    if (clip.name.empty()) clip.name = "clip_" + std::to_string(index);
    clip.start_s = std::numeric_limits<double>::infinity();
    for (const Json& channel : source.at("channels")) {
        const Json& target = channel.at("target");
        const std::string path = target.at("path");
        if (!target.contains("node") || (path != "translation" && path != "rotation" && path != "scale"))
            continue;
        const Json& sampler = source.at("samplers").at(channel.at("sampler").get<std::size_t>());
        ReferenceChannel keys{sampler.value("interpolation", "LINEAR"), glb.numbers(sampler.at("input")),
                              glb.numbers(sampler.at("output")), path == "rotation" ? 4u : 3u};
        clip.start_s = std::min(clip.start_s, keys.times_s.at(0));
        clip.end_s = std::max(clip.end_s, keys.times_s.back());
        clip.channels[{target["node"].get<std::size_t>(), path}] = std::move(keys);
    }
    if (!clip.channels.empty()) clips.push_back(std::move(clip));
}

std::vector<Affine> ReferenceAnimal::globals(const ReferenceClip& clip, double time_s) const {
    std::vector<Affine> out(nodes_.size());
    std::vector<bool> done(nodes_.size(), false);
    for (std::size_t n = 0; n < nodes_.size(); ++n) resolve(n, clip, time_s, out, done);
    return out;
}

Affine ReferenceAnimal::local(std::size_t node, const ReferenceClip& clip, double time_s) const {
    const Node& rest = nodes_[node];
    if (rest.has_matrix) return rest.matrix;
    const auto animated = [&](const char* path, const Value& otherwise) {
        const auto channel = clip.channels.find({node, path});
        return channel == clip.channels.end() ? otherwise : channel->second.at(time_s);
    };
    return affine_of(animated("translation", rest.translation), animated("rotation", rest.rotation),
                     animated("scale", rest.scale));
}

void ReferenceAnimal::resolve(std::size_t node, const ReferenceClip& clip, double time_s,
                              std::vector<Affine>& out, std::vector<bool>& done) const {
    if (done[node]) return;
    out[node] = local(node, clip, time_s);
    if (const std::size_t parent = nodes_[node].parent; parent != kNone) {
        resolve(parent, clip, time_s, out, done);
        out[node] = out[parent] * out[node];
    }
    done[node] = true;
}

}  // namespace posepack::oracle
