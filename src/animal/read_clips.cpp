// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "animal/names.hpp"
#include "animal/read_parts.hpp"
#include "base/text.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::size_t kMaxChannels = 65'536;
constexpr std::size_t kMaxKeys = 1'000'000;
constexpr double kMaxDurationS = 600.0;
constexpr double kEqualTimesS = 1e-6;
constexpr double kUnitTolerance = 1e-3;

// Counted over a clip, so that a file gets one line and not thousands.
struct ClipRepairs {
    std::uint32_t equal_times = 0, not_unit = 0, doubled = 0, left_out = 0;
};

base::Status check_times(std::span<const float> times, const std::string& where, ClipRepairs& repairs) {
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (times[k] < 0.0f)
            return Issue{IssueCode::glb_times, where,
                         fmt::format("expected key times from 0 s on, found key {} at {} s", k, times[k])};
        if (k == 0) continue;
        if (times[k] < times[k - 1])
            return Issue{IssueCode::glb_times, where,
                         fmt::format("expected rising key times, found key {} at {} s behind {} s", k,
                                     times[k], times[k - 1])};
        if (static_cast<double>(times[k]) - times[k - 1] < kEqualTimesS) ++repairs.equal_times;
    }
    return {};
}

// Makes the rotations of a channel unit length; tangents of cubic splines keep theirs.
base::Status check_rotations(std::span<float> values, bool cubic, const std::string& where,
                             ClipRepairs& repairs) {
    const std::size_t stride = cubic ? 12 : 4;
    for (std::size_t k = 0; k * stride < values.size(); ++k) {
        float* q = &values[k * stride + (cubic ? 4 : 0)];
        double sum = 0.0;
        for (int c = 0; c < 4; ++c) sum += static_cast<double>(q[c]) * q[c];
        const double length = std::sqrt(sum);
        if (length < 1e-6)
            return Issue{IssueCode::glb_quat, where,
                         fmt::format("expected unit quaternions, found rotation key {} with length {:.3g}", k,
                                     length)};
        if (std::abs(length - 1.0) > kUnitTolerance) {
            ++repairs.not_unit;
            for (int c = 0; c < 4; ++c) q[c] = static_cast<float>(q[c] / length);
        }
    }
    return {};
}

std::optional<Path> path_of(const std::string& name) {
    if (name == "translation") return Path::translation;
    if (name == "rotation") return Path::rotation;
    if (name == "scale") return Path::scale;
    return std::nullopt;
}

// Reads samplers once each, though many channels may share their times.
class ChannelReader {
 public:
    explicit ChannelReader(ReadContext& context) : context_(context) {}

    base::Status read(const tinygltf::AnimationSampler& sampler, const std::string& where, Channel& channel,
                      ClipRepairs& repairs) {
        if (auto status = read_interpolation(sampler.interpolation, where, channel); !status) return status;
        if (auto status = read_times(sampler.input, where + "/input", channel, repairs); !status)
            return status;
        return read_values(sampler.output, where + "/output", channel, repairs);
    }

 private:
    static base::Status read_interpolation(const std::string& name, const std::string& where,
                                           Channel& channel) {
        if (name.empty() || name == "LINEAR")
            channel.interpolation = Interpolation::linear;
        else if (name == "STEP")
            channel.interpolation = Interpolation::step;
        else if (name == "CUBICSPLINE")
            channel.interpolation = Interpolation::cubic_spline;
        else
            return Issue{IssueCode::glb_channel, where,
                         fmt::format("expected interpolation LINEAR, STEP or CUBICSPLINE, found '{}'",
                                     name.substr(0, 64))};
        return {};
    }

    base::Status read_times(int accessor, const std::string& where, Channel& channel, ClipRepairs& repairs) {
        const auto known = times_.find(accessor);
        if (known != times_.end()) {
            channel.first_time = known->second.first_time;
            channel.key_count = known->second.key_count;
            return {};
        }
        const auto times = context_.accessors.read_floats(
            accessor, {where, TINYGLTF_TYPE_SCALAR, {TINYGLTF_COMPONENT_TYPE_FLOAT}});
        if (!times) return times.issue();
        if (times.value().size() > kMaxKeys)
            return Issue{IssueCode::lim_count, where,
                         fmt::format("expected at most {} keys, found {}", kMaxKeys, times.value().size())};
        if (auto status = check_times(times.value(), where, repairs); !status) return status;
        auto& pool = context_.animal.key_times;
        channel.first_time = static_cast<std::uint32_t>(pool.size());
        channel.key_count = static_cast<std::uint32_t>(times.value().size());
        pool.insert(pool.end(), times.value().begin(), times.value().end());
        times_.emplace(accessor, channel);
        return {};
    }

    base::Status read_values(int accessor, const std::string& where, Channel& channel, ClipRepairs& repairs) {
        const bool rotation = channel.path == Path::rotation;
        const bool cubic = channel.interpolation == Interpolation::cubic_spline;
        const std::initializer_list<int> kinds{TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                               TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                               TINYGLTF_COMPONENT_TYPE_SHORT,
                                               TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
        auto values = context_.accessors.read_floats(
            accessor, {where, rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3, kinds});
        if (!values) return values.issue();
        const std::size_t needed = std::size_t{channel.key_count} * (rotation ? 4 : 3) * (cubic ? 3 : 1);
        if (values.value().size() < needed)
            return Issue{IssueCode::glb_accessor_count, where,
                         fmt::format("expected {} numbers for {} keys, found {}", needed, channel.key_count,
                                     values.value().size())};
        values.value().resize(needed);
        if (rotation)
            if (auto status = check_rotations(values.value(), cubic, where, repairs); !status) return status;
        auto& pool = context_.animal.key_values;
        channel.first_value = static_cast<std::uint32_t>(pool.size());
        pool.insert(pool.end(), values.value().begin(), values.value().end());
        return {};
    }

    ReadContext& context_;
    std::map<int, Channel> times_;
};

// The channels of one clip by what they move.
using Targets = std::map<std::pair<std::uint32_t, Path>, std::size_t>;

// The last of several channels on one target wins (glTF 2.0 section 3.11 forbids them).
void add_channel(Clip& clip, Targets& targets, const Channel& channel, ClipRepairs& repairs) {
    const auto [place, is_new] = targets.try_emplace({channel.node, channel.path}, clip.channels.size());
    if (is_new) {
        clip.channels.push_back(channel);
    } else {
        ++repairs.doubled;
        clip.channels[place->second] = channel;
    }
}

base::Status read_channel(ReadContext& context, ChannelReader& reader, const tinygltf::Animation& source,
                          std::size_t index, const std::string& where, Clip& clip, Targets& targets,
                          ClipRepairs& repairs) {
    const tinygltf::AnimationChannel& channel_source = source.channels[index];
    const std::string place = fmt::format("{}/channels/{}", where, index);
    if (channel_source.target_path == "weights") return ++repairs.left_out, base::Status{};
    const auto path = path_of(channel_source.target_path);
    if (!path || channel_source.target_node < 0) return ++repairs.left_out, base::Status{};
    if (static_cast<std::size_t>(channel_source.target_node) >= context.animal.nodes.size())
        return Issue{IssueCode::glb_reference, place,
                     fmt::format("expected one of {} nodes as target, found index {}",
                                 context.animal.nodes.size(), channel_source.target_node)};
    if (channel_source.sampler < 0 ||
        static_cast<std::size_t>(channel_source.sampler) >= source.samplers.size())
        return Issue{IssueCode::glb_channel, place,
                     fmt::format("expected one of {} samplers, found index {}", source.samplers.size(),
                                 channel_source.sampler)};
    Channel channel;
    channel.node = static_cast<std::uint32_t>(channel_source.target_node);
    channel.path = *path;
    const auto sampler_place = fmt::format("{}/samplers/{}", where, channel_source.sampler);
    if (auto status = reader.read(source.samplers[static_cast<std::size_t>(channel_source.sampler)],
                                  sampler_place, channel, repairs);
        !status)
        return status;
    if (context.animal.nodes[channel.node].has_matrix)
        return Issue{
            IssueCode::glb_channel, place,
            fmt::format(
                "expected a target node with translation, rotation and scale, found node {} with a matrix",
                channel.node)};
    add_channel(clip, targets, channel, repairs);
    return {};
}

base::Status report_repairs(ReadContext& context, const ClipRepairs& repairs, const std::string& where) {
    if (repairs.equal_times > 0)
        if (auto s = context.repair(
                IssueCode::warn_times, IssueCode::glb_times, where,
                fmt::format("expected keys at least 1e-6 s apart, found {} nearer to the one before",
                            base::counted(repairs.equal_times, "key")));
            !s)
            return s;
    if (repairs.not_unit > 0)
        if (auto s = context.repair(IssueCode::warn_quat, IssueCode::glb_quat, where,
                                    fmt::format("expected unit quaternions, found {} of another length",
                                                base::counted(repairs.not_unit, "rotation key")));
            !s)
            return s;
    if (repairs.doubled > 0)
        if (auto s =
                context.repair(IssueCode::warn_channel, IssueCode::glb_channel, where,
                               fmt::format("expected one channel a target, found {} on the target of another",
                                           base::counted(repairs.doubled, "channel")));
            !s)
            return s;
    return {};
}

base::Status measure_span(const Animal& animal, const std::string& where, Clip& clip) {
    double first = HUGE_VAL;
    double last = 0.0;
    for (const Channel& channel : clip.channels) {
        first = std::min(first, static_cast<double>(animal.key_times[channel.first_time]));
        last =
            std::max(last, static_cast<double>(animal.key_times[channel.first_time + channel.key_count - 1]));
    }
    clip.start_s = first;
    clip.duration_s = last - first;
    if (clip.duration_s > kMaxDurationS)
        return Issue{IssueCode::lim_duration, where,
                     fmt::format("expected at most {} s, found {:.6g} s", kMaxDurationS, clip.duration_s)};
    return {};
}

base::Status refuse_without_clips(const tinygltf::Model& model) {
    bool morphs = false;
    for (const auto& animation : model.animations)
        for (const auto& channel : animation.channels) morphs = morphs || channel.target_path == "weights";
    if (morphs)
        return Issue{IssueCode::glb_morph_only, "animations",
                     "expected a channel that moves a node, found morph targets only"};
    return Issue{IssueCode::glb_no_animation, "animations",
                 fmt::format("expected a channel that moves a node, found none in {} animations",
                             model.animations.size())};
}

}  // namespace

base::Status read_clips(ReadContext& context) {
    const auto& animations = context.model().animations;
    ChannelReader reader(context);
    std::uint32_t left_out = 0;
    for (std::size_t a = 0; a < animations.size(); ++a) {
        const std::string where = fmt::format("animations/{}", a);
        if (animations[a].channels.size() > kMaxChannels)
            return Issue{IssueCode::lim_count, where,
                         fmt::format("expected at most {} channels, found {}", kMaxChannels,
                                     animations[a].channels.size())};
        Clip clip;
        auto source_name = usable_name(animations[a].name, fmt::format("clip_{}", a));
        if (!source_name) return base::at(where, source_name.issue());
        clip.source_name = std::move(source_name).value();
        ClipRepairs repairs;
        Targets targets;
        for (std::size_t c = 0; c < animations[a].channels.size(); ++c)
            if (auto s = read_channel(context, reader, animations[a], c, where, clip, targets, repairs); !s)
                return s;
        if (auto s = report_repairs(context, repairs, where); !s) return s;
        left_out += repairs.left_out;
        if (clip.channels.empty()) continue;
        if (auto s = measure_span(context.animal, where, clip); !s) return s;
        context.animal.clips.push_back(std::move(clip));
    }
    if (context.animal.clips.empty()) return refuse_without_clips(context.model());
    if (left_out > 0)
        context.note(
            IssueCode::warn_left_out, "animations",
            fmt::format("{} channels that move no node (morph weights, pointers) are not in the palette",
                        left_out));
    std::vector<std::string> source_names;
    for (const Clip& clip : context.animal.clips) source_names.push_back(clip.source_name);
    const std::vector<std::string> names = clip_names(source_names);
    for (std::size_t i = 0; i < names.size(); ++i) context.animal.clips[i].name = names[i];
    return {};
}

}  // namespace posepack::animal
