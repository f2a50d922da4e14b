// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "animal/animation_target.hpp"
#include "animal/morph_findings.hpp"
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

base::Status check_times(std::span<const float> times, const Place& place, ClipRepairs& repairs) {
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (times[k] < 0.0f)
            return Issue{IssueCode::glb_times, place.text(),
                         fmt::format("expected key times from 0 s on, found key {} at {} s", k, times[k])};
        if (k == 0) continue;
        if (times[k] < times[k - 1])
            return Issue{IssueCode::glb_times, place.text(),
                         fmt::format("expected rising key times, found key {} at {} s behind {} s", k,
                                     times[k], times[k - 1])};
        if (static_cast<double>(times[k]) - times[k - 1] < kEqualTimesS) ++repairs.equal_times;
    }
    return {};
}

// Makes the rotations of a channel unit length; tangents of cubic splines keep theirs.
base::Status check_rotations(std::span<float> values, bool cubic, const Place& place, ClipRepairs& repairs) {
    // Squares of lengths that are surely within the tolerance, so that few keys cost a square root.
    constexpr double kLow = (1.0 - 0.99 * kUnitTolerance) * (1.0 - 0.99 * kUnitTolerance);
    constexpr double kHigh = (1.0 + 0.99 * kUnitTolerance) * (1.0 + 0.99 * kUnitTolerance);
    const std::size_t stride = cubic ? 12 : 4;
    for (std::size_t k = 0; k * stride < values.size(); ++k) {
        float* q = &values[k * stride + (cubic ? 4 : 0)];
        double sum = 0.0;
        for (int c = 0; c < 4; ++c) sum += static_cast<double>(q[c]) * q[c];
        if (sum > kLow && sum < kHigh) continue;
        const double length = std::sqrt(sum);
        if (length < 1e-6)
            return Issue{IssueCode::glb_quat, place.text(),
                         fmt::format("expected unit quaternions, found rotation key {} with length {:.3g}", k,
                                     length)};
        if (std::abs(length - 1.0) > kUnitTolerance) {
            ++repairs.not_unit;
            for (int c = 0; c < 4; ++c) q[c] = static_cast<float>(q[c] / length);
        }
    }
    return {};
}

// Reads samplers once each, though many channels may share their times.
class ChannelReader {
 public:
    explicit ChannelReader(ReadContext& context) : context_(context) {}

    // `place` is the sampler's, without a leaf.
    base::Status read(const tinygltf::AnimationSampler& sampler, Place place, Channel& channel,
                      ClipRepairs& repairs) {
        if (auto status = read_interpolation(sampler.interpolation, place, channel); !status) return status;
        place.leaf = "input";
        if (auto status = read_times(sampler.input, place, channel, repairs); !status) return status;
        place.leaf = "output";
        return read_values(sampler.output, place, channel, repairs);
    }

 private:
    static base::Status read_interpolation(const std::string& name, const Place& place, Channel& channel) {
        if (name.empty() || name == "LINEAR")
            channel.interpolation = Interpolation::linear;
        else if (name == "STEP")
            channel.interpolation = Interpolation::step;
        else if (name == "CUBICSPLINE")
            channel.interpolation = Interpolation::cubic_spline;
        else
            return Issue{IssueCode::glb_interpolation, place.text(),
                         fmt::format("expected LINEAR, STEP or CUBICSPLINE, found '{}'", name.substr(0, 64))};
        return {};
    }

    base::Status read_times(int accessor, const Place& place, Channel& channel, ClipRepairs& repairs) {
        const auto known = times_.find(accessor);
        if (known != times_.end()) {
            channel.first_time = known->second.first_time;
            channel.key_count = known->second.key_count;
            return {};
        }
        auto& pool = context_.animal.key_times;
        const std::size_t first = pool.size();
        const auto added =
            context_.accessors.append_floats(accessor, {place, ElementType::scalar, {kFloat}}, pool);
        if (!added) return added.issue();
        if (added.value() > kMaxKeys)
            return Issue{IssueCode::lim_count, place.text(),
                         fmt::format("expected at most {} keys, found {}", kMaxKeys, added.value())};
        if (auto status = check_times(std::span(pool).subspan(first), place, repairs); !status) return status;
        channel.first_time = static_cast<std::uint32_t>(first);
        channel.key_count = static_cast<std::uint32_t>(added.value());
        times_.emplace(accessor, channel);
        return {};
    }

    base::Status read_values(int accessor, const Place& place, Channel& channel, ClipRepairs& repairs) {
        const bool rotation = channel.path == Path::rotation;
        const bool cubic = channel.interpolation == Interpolation::cubic_spline;
        // Channels may share an output: read again for each, a small file would ask for its values a thousand
        // times.
        const Values key{accessor, rotation, cubic, channel.key_count};
        if (const auto known = values_.find(key); known != values_.end()) {
            channel.first_value = known->second;
            return {};
        }
        const AccessorUse use{place,
                              rotation ? ElementType::vec4 : ElementType::vec3,
                              {kFloat, kByte, kUnsignedByte, kShort, kUnsignedShort}};
        auto& pool = context_.animal.key_values;
        const std::size_t first = pool.size();
        const auto added = context_.accessors.append_floats(accessor, use, pool);
        if (!added) return added.issue();
        const std::size_t needed = std::size_t{channel.key_count} * (rotation ? 4 : 3) * (cubic ? 3 : 1);
        if (added.value() < needed)
            return Issue{IssueCode::glb_accessor_count, place.text(),
                         fmt::format("expected {} numbers for {} keys, found {}", needed, channel.key_count,
                                     added.value())};
        pool.resize(first + needed);
        channel.first_value = static_cast<std::uint32_t>(first);
        values_.emplace(key, channel.first_value);
        if (!rotation) return {};
        return check_rotations(std::span(pool).subspan(first), cubic, place, repairs);
    }

    // How an output accessor is read: its index, as rotations, as cubic splines, for how many keys.
    using Values = std::tuple<int, bool, bool, std::uint32_t>;

    ReadContext& context_;
    std::unordered_map<int, Channel> times_;
    std::map<Values, std::uint32_t> values_;  // where the values of each begin
};

// The channels of one clip by what they move.
class Targets {
 public:
    explicit Targets(std::size_t node_count) : channels_(node_count * 3, kNone) {}

    // The last of several channels on one target wins (glTF 2.0 section 3.11 forbids them).
    void add(Clip& clip, const Channel& channel, ClipRepairs& repairs) {
        std::uint32_t& slot =
            channels_[channel.node * std::size_t{3} + static_cast<std::size_t>(channel.path)];
        if (slot == kNone) {
            slot = static_cast<std::uint32_t>(clip.channels.size());
            clip.channels.push_back(channel);
        } else {
            ++repairs.doubled;
            clip.channels[slot] = channel;
        }
    }

    // Forgets the clip, for the next one.
    void clear(const Clip& clip) {
        for (const Channel& channel : clip.channels)
            channels_[channel.node * std::size_t{3} + static_cast<std::size_t>(channel.path)] = kNone;
    }

 private:
    std::vector<std::uint32_t> channels_;
};

// Reads the channels of one clip after the other.
class ClipReader {
 public:
    explicit ClipReader(ReadContext& context)
        : context_(context), channels_(context), targets_(context.animal.nodes.size()) {}

    base::Status read(std::size_t index, Clip& clip, ClipRepairs& repairs) {
        const auto& channels = context_.model().animations[index].channels;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const auto path = path_of(channels[c].target_path);
            if (!path || channels[c].target_node < 0) {
                // Pointers follow below; weights of morph targets are noted by themselves.
                const std::string& name = channels[c].target_path;
                if (name != "pointer" && name != "weights") ++repairs.left_out;
                continue;
            }
            const Aim aim{channels[c].target_node, channels[c].sampler, *path};
            if (auto status = read_channel(index, aim, c, clip, repairs); !status) return status;
        }
        for (const PointerChannel& pointer : context_.accessors.facts().pointers) {
            if (pointer.animation != index) continue;
            const auto aim = aim_of(pointer);
            if (!aim)
                repairs.left_out += aims_at_weights(pointer.pointer) ? 0 : 1;
            else if (auto status = read_channel(index, *aim, pointer.channel, clip, repairs); !status)
                return status;
        }
        targets_.clear(clip);
        return {};
    }

 private:
    base::Status read_channel(std::size_t animation, const Aim& aim, std::size_t channel_index, Clip& clip,
                              ClipRepairs& repairs) {
        const auto& samplers = context_.model().animations[animation].samplers;
        const auto refuse = [&](IssueCode code, std::string detail) {
            return Issue{code, Place{"animations", animation, "channels", channel_index}.text(),
                         std::move(detail)};
        };
        if (static_cast<std::size_t>(aim.node) >= context_.animal.nodes.size())
            return refuse(IssueCode::glb_reference,
                          fmt::format("expected one of {} nodes as target, found index {}",
                                      context_.animal.nodes.size(), aim.node));
        if (aim.sampler < 0 || static_cast<std::size_t>(aim.sampler) >= samplers.size())
            return refuse(IssueCode::glb_channel, fmt::format("expected one of {} samplers, found index {}",
                                                              samplers.size(), aim.sampler));
        Channel channel;
        channel.node = static_cast<std::uint32_t>(aim.node);
        channel.path = aim.path;
        const auto sampler = static_cast<std::size_t>(aim.sampler);
        if (auto status = channels_.read(samplers[sampler], {"animations", animation, "samplers", sampler},
                                         channel, repairs);
            !status)
            return status;
        if (context_.animal.nodes[channel.node].has_matrix)
            return refuse(
                IssueCode::glb_channel,
                fmt::format("expected a target node with translation, rotation and scale, found node {} "
                            "with a matrix",
                            channel.node));
        targets_.add(clip, channel, repairs);
        return {};
    }

    ReadContext& context_;
    ChannelReader channels_;
    Targets targets_;
};

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

base::Status refuse_without_clips(const tinygltf::Model& model, std::span<const PointerChannel> pointers) {
    bool morphs = false;
    for (const auto& animation : model.animations)
        for (const auto& channel : animation.channels) morphs = morphs || channel.target_path == "weights";
    for (const PointerChannel& pointer : pointers) morphs = morphs || aims_at_weights(pointer.pointer);
    if (morphs)
        return Issue{IssueCode::glb_morph_only, "animations",
                     "expected a channel that moves a node, found morph targets only: those need a vertex "
                     "animation texture (VAT)"};
    return Issue{IssueCode::glb_no_animation, "animations",
                 fmt::format("expected a channel that moves a node, found none in {} animations",
                             model.animations.size())};
}

}  // namespace

base::Status read_clips(ReadContext& context) {
    const auto& animations = context.model().animations;
    // One allocation: few files hold more floats of keys than they have bytes for, and those that do may
    // grow.
    context.animal.key_values.reserve(context.accessors.stored_bytes() / sizeof(float));
    ClipReader reader(context);
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
        if (auto s = reader.read(a, clip, repairs); !s) return s;
        if (auto s = report_repairs(context, repairs, where); !s) return s;
        left_out += repairs.left_out;
        if (clip.channels.empty()) continue;
        if (auto s = measure_span(context.animal, where, clip); !s) return s;
        context.animal.clips.push_back(std::move(clip));
    }
    if (context.animal.clips.empty())
        return refuse_without_clips(context.model(), context.accessors.facts().pointers);
    note_morph_channels(context);
    if (left_out > 0)
        context.note(
            IssueCode::warn_left_out, "animations",
            fmt::format("{} that move no node: not in the palette", base::counted(left_out, "channel")));
    std::vector<std::string> source_names;
    for (const Clip& clip : context.animal.clips) source_names.push_back(clip.source_name);
    const std::vector<std::string> names = clip_names(source_names);
    for (std::size_t i = 0; i < names.size(); ++i) context.animal.clips[i].name = names[i];
    return {};
}

}  // namespace posepack::animal
