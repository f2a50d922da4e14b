// SPDX-License-Identifier: MIT
#include "menagerie/glb_animation.hpp"

#include <array>
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
        return {{"name", model_.style.armature + "|" + clip_.name},
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

    std::vector<std::string> key_values(std::size_t joint, Path path) const {
        std::vector<std::string> values;
        Quat previous = kNoTurn;
        for (const Pose& pose : clip_.keys) {
            Local local = local_of(model_, joint, pose.turns[joint], pose.shifts[joint]);
            if (!values.empty() && glm::dot(previous, local.rotation) < 0.0) local.rotation = -local.rotation;
            previous = local.rotation;
            Payload payload;
            if (path == Path::translation) put_vector(payload, local.translation);
            if (path == Path::rotation) put_quaternion(payload, local.rotation);
            if (path == Path::scale) put_vector(payload, pose.scales[joint]);
            values.push_back(std::move(payload.bytes));
        }
        return values;
    }

    void add_channel(std::size_t joint, Path path) {
        std::vector<std::string> values = key_values(joint, path);
        bool is_constant = true;
        for (const std::string& value : values) is_constant = is_constant && value == values.front();
        const bool two_keys = is_constant && !model_.style.full_constant_keys;
        if (two_keys) values.resize(2);
        Payload payload;
        for (const std::string& value : values) payload.bytes += value;
        const int output =
            buffer_.add_animation_accessor(payload, path == Path::rotation ? "VEC4" : "VEC3", values.size());
        channels_.push_back({{"sampler", add_sampler(two_keys ? end_times_ : all_times_, output)},
                             {"target",
                              {{"node", kFirstJointNode + static_cast<int>(joint)},
                               {"path", kPathNames[static_cast<std::size_t>(path)]}}}});
    }

    // Channels with the same values share a sampler.
    int add_sampler(int input, int output) {
        const auto [place, is_new] = known_.try_emplace(output, static_cast<int>(samplers_.size()));
        if (is_new) samplers_.push_back({{"input", input}, {"output", output}});
        return place->second;
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
