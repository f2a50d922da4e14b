// SPDX-License-Identifier: MIT
#include "menagerie/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <set>
#include <vector>

#include "base/trig.hpp"

namespace posepack::menagerie {
namespace {

constexpr double kStillDegrees = 0.05;

std::size_t depth_of(const Rig& rig) {
    std::vector<std::size_t> depths;
    for (const RigJoint& joint : rig.joints)
        depths.push_back(joint.parent < 0 ? 1 : depths[static_cast<std::size_t>(joint.parent)] + 1);
    return *std::max_element(depths.begin(), depths.end());
}

void count_weights(const Model& model, Statistics& out) {
    std::set<int> used;
    std::size_t influences = 0;
    for (const Vertex& vertex : model.mesh.vertices) {
        for (std::size_t slot = 0; slot < 4; ++slot) {
            if (vertex.influences.weights[slot] == 0.0) continue;
            ++influences;
            used.insert(vertex.influences.joints[slot]);
        }
    }
    out.mean_influences = static_cast<double>(influences) / static_cast<double>(out.vertices);
    out.weightless_share = 1.0 - static_cast<double>(used.size()) / static_cast<double>(out.joints);
}

double turn_degrees(const Quat& a, const Quat& b) {
    const double dot = std::min(1.0, std::abs(glm::dot(a, b)));
    return 2.0 * std::acos(dot) * (180.0 / base::kPi);
}

void count_channels(const Model& model, Statistics& out) {
    std::size_t channels = 0;
    std::size_t constant = 0;
    std::vector<double> steps;
    for (const Clip& clip : model.clips) {
        for (std::size_t joint = 0; joint < out.joints; ++joint) {
            bool turns = false;
            bool shifts = false;
            bool scales = false;
            for (std::size_t key = 1; key < clip.keys.size(); ++key) {
                const Pose& before = clip.keys[key - 1];
                const Pose& pose = clip.keys[key];
                const double step = turn_degrees(before.turns[joint], pose.turns[joint]);
                turns = turns || step > 1e-4;
                shifts = shifts || glm::any(glm::notEqual(before.shifts[joint], pose.shifts[joint]));
                scales = scales || glm::any(glm::notEqual(before.scales[joint], pose.scales[joint]));
                steps.push_back(step);
            }
            channels += 3;
            constant += static_cast<std::size_t>(!turns) + static_cast<std::size_t>(!shifts) +
                        static_cast<std::size_t>(!scales);
        }
    }
    out.constant_channel_share = static_cast<double>(constant) / static_cast<double>(channels);
    std::sort(steps.begin(), steps.end());
    const auto moving = std::upper_bound(steps.begin(), steps.end(), kStillDegrees);
    out.step_p50_degrees = *(moving + (steps.end() - moving) / 2);
    out.step_p99_degrees = steps[steps.size() * 99 / 100];
    out.step_max_degrees = steps.back();
}

}  // namespace

Statistics statistics_of(const Model& model, std::size_t json_bytes) {
    Statistics out;
    out.joints = model.rig.joints.size();
    out.root_joints =
        static_cast<std::size_t>(std::count_if(model.rig.joints.begin(), model.rig.joints.end(),
                                               [](const RigJoint& joint) { return joint.parent < 0; }));
    out.depth = depth_of(model.rig);
    out.vertices = model.mesh.vertices.size();
    out.clips = model.clips.size();
    out.json_bytes = json_bytes;
    out.rate_hz = model.clips.front().rate_hz;
    count_weights(model, out);
    count_channels(model, out);
    return out;
}

const std::array<RealRange, 10>& real_ranges() {
    static constexpr std::array<RealRange, 10> kRanges = {{{"joints", 38, 51},
                                                           {"root joints", 5, 5},
                                                           {"depth", 9, 13},
                                                           {"vertices", 3752, 4906},
                                                           {"clips", 12, 13},
                                                           {"influences a vertex", 2.36, 2.89},
                                                           {"weightless joints, %", 8.7, 14.3},
                                                           {"JSON chunk, bytes", 118732, 155900},
                                                           {"key step p99, degrees", 19.9, 26.1},
                                                           {"key step max, degrees", 45.8, 86.2}}};
    return kRanges;
}

}  // namespace posepack::menagerie
