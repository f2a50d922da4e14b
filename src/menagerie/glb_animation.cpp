// SPDX-License-Identifier: MIT
#include "menagerie/glb_animation.hpp"

#include <array>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "menagerie/glb_values.hpp"

namespace posepack::menagerie {
namespace {

enum class Path { translation, rotation, scale };

constexpr std::array<std::string_view, 3> kPathNames = {"translation", "rotation", "scale"};

// The samplers and channels of one clip on their way into the document.
class ClipWriter {
 public:
    ClipWriter(GlbBuffer& buffer, const Model& model, const Clip& clip)
        : buffer_(buffer),
          model_(model),
          clip_(clip),
          all_times_(add_times(1)),
          end_times_(model.style.full_constant_keys ? all_times_ : add_times(clip.keys.size() - 1)) {}

    Json write() {
        for (std::size_t joint = 0; joint < model_.rig.joints.size(); ++joint) {
            add_channel(joint, Path::translation);
            add_channel(joint, Path::rotation);
            // Helpers directly under the armature are never scaled, and exporters know it.
            if (model_.rig.joints[joint].parent >= 0) add_channel(joint, Path::scale);
        }
        const std::string prefix = model_.style.prefixed ? model_.style.armature + "|" : "";
        return {{"name", prefix + clip_.name},
                {"samplers", std::move(samplers_)},
                {"channels", std::move(channels_)}};
    }

 private:
    int add_times(std::size_t stride) {
        Payload payload;
        std::size_t count = 0;
        double last = 0.0;
        for (std::size_t key = 0; key < clip_.keys.size(); key += stride, ++count) {
            last = static_cast<double>(key) / clip_.rate_hz;
            payload.put_f32(static_cast<float>(last));
        }
        const int accessor = buffer_.add_animation_accessor(payload, "SCALAR", count);
        buffer_.accessor(accessor)["min"] = Json::array({0.0});
        buffer_.accessor(accessor)["max"] = Json::array({number(last)});
        return accessor;
    }

    // A channel's value in one key, as x, y, z and perhaps w.
    using Value = glm::dvec4;

    std::vector<Value> key_values(std::size_t joint, Path path) const {
        std::vector<Value> values;
        Quat previous = kNoTurn;
        for (const Pose& pose : clip_.keys) {
            Local local = local_of(model_, joint, pose.turns[joint], pose.shifts[joint]);
            if (!values.empty() && glm::dot(previous, local.rotation) < 0.0) local.rotation = -local.rotation;
            previous = local.rotation;
            const Quat& q = local.rotation;
            const Vec3& v = path == Path::scale ? pose.scales[joint] : local.translation;
            values.push_back(path == Path::rotation ? Value(q.x, q.y, q.z, q.w) : Value(v, 0.0));
        }
        return values;
    }

    static void put(Payload& payload, Path path, const Value& value) {
        const int count = path == Path::rotation ? 4 : 3;
        for (int part = 0; part < count; ++part) payload.put_f32(static_cast<float>(value[part]));
    }

    // The slope at a key, a second: that of the chord between its neighbours (Catmull and Rom, 1974). A
    // closed loop goes on behind its last key.
    Value slope_at(const std::vector<Value>& values, std::size_t key) const {
        const std::size_t last = values.size() - 1;
        const bool closed = clip_.ending == Ending::closed;
        const std::size_t before = key > 0 ? key - 1 : closed ? last - 1 : 0;
        const std::size_t after = key < last ? key + 1 : closed ? 1 : last;
        const double steps = closed || (key > 0 && key < last) ? 2.0 : 1.0;
        return (values[after] - values[before]) * (clip_.rate_hz / steps);
    }

    // The bytes of a sampler's output; those of a cubic spline hold three values a key (glTF 2.0, appendix
    // C).
    Payload output_of(const std::vector<Value>& values, Path path, bool is_constant) const {
        const bool cubic = clip_.interpolation == Interpolation::cubic;
        Payload payload;
        for (std::size_t key = 0; key < values.size(); ++key) {
            const Value slope = cubic && !is_constant ? slope_at(values, key) : Value(0.0);
            if (cubic) put(payload, path, slope);
            put(payload, path, values[key]);
            if (cubic) put(payload, path, slope);
        }
        return payload;
    }

    void add_channel(std::size_t joint, Path path) {
        std::vector<Value> values = key_values(joint, path);
        bool is_constant = true;
        for (const Value& value : values) {
            Payload first;
            Payload other;
            put(first, path, values.front());
            put(other, path, value);
            is_constant = is_constant && first.bytes == other.bytes;
        }
        const bool two_keys = is_constant && !model_.style.full_constant_keys;
        if (two_keys) values.resize(2);
        const Payload payload = output_of(values, path, is_constant);
        const std::size_t count = values.size() * (clip_.interpolation == Interpolation::cubic ? 3 : 1);
        const int output =
            buffer_.add_animation_accessor(payload, path == Path::rotation ? "VEC4" : "VEC3", count);
        channels_.push_back({{"sampler", add_sampler(two_keys ? end_times_ : all_times_, output)},
                             {"target",
                              {{"node", kFirstJointNode + static_cast<int>(joint)},
                               {"path", kPathNames[static_cast<std::size_t>(path)]}}}});
    }

    // Channels with the same values share a sampler, where the style does so.
    int add_sampler(int input, int output) {
        if (const auto known = known_.find(output); known != known_.end()) return known->second;
        const int index = static_cast<int>(samplers_.size());
        if (model_.style.shared_samplers) known_[output] = index;
        Json sampler{{"input", input}, {"output", output}};
        constexpr std::array kWords = {"LINEAR", "STEP", "CUBICSPLINE"};
        // LINEAR is what a reader assumes; some exporters say it all the same.
        if (clip_.interpolation != Interpolation::linear || !model_.style.shared_samplers)
            sampler["interpolation"] = kWords[static_cast<std::size_t>(clip_.interpolation)];
        samplers_.push_back(std::move(sampler));
        return index;
    }

    GlbBuffer& buffer_;
    const Model& model_;
    const Clip& clip_;
    int all_times_;
    int end_times_;
    std::map<int, int> known_;
    Json samplers_ = Json::array();
    Json channels_ = Json::array();
};

}  // namespace

Json animation_json(GlbBuffer& buffer, const Model& model, const Clip& clip) {
    return ClipWriter(buffer, model, clip).write();
}

}  // namespace posepack::menagerie
