// SPDX-License-Identifier: MIT
#include "menagerie/model.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace posepack::menagerie {
namespace {

constexpr double kDepthAllowed = 0.005;   // of the height
constexpr std::size_t kVertexStride = 3;  // every third vertex speaks for its neighbours

Vec3 skinned(const Model& model, const Placement& placed, const Vertex& vertex) {
    Vec3 sum(0.0);
    for (std::size_t slot = 0; slot < 4; ++slot) {
        const double weight = vertex.influences.weights[slot];
        if (weight == 0.0) continue;
        const auto joint = static_cast<std::size_t>(vertex.influences.joints[slot]);
        const Vec3 arm = vertex.position - model.rig.joints[joint].head;
        sum += (placed.heads[joint] + placed.turns[joint] * arm) * weight;
    }
    return sum;
}

double lowest_point(const Model& model, const Pose& pose) {
    const Placement placed = place(model.rig, pose);
    double lowest = 0.0;
    for (std::size_t index = 0; index < model.mesh.vertices.size(); index += kVertexStride)
        lowest = std::min(lowest, skinned(model, placed, model.mesh.vertices[index]).y);
    return lowest;
}

}  // namespace

std::vector<Clip> perform(const std::vector<ClipScript>& scripts, int rate_hz, double unit_m,
                          const Poser& pose) {
    std::vector<Clip> clips;
    for (const ClipScript& script : scripts) {
        const int cycle = cycle_step_count(script, rate_hz);
        Clip clip{script.name, rate_hz, script.ending, 0.0, {}, script.name};
        for (int key = 0; key <= step_count(script, rate_hz); ++key) {
            const bool closing = script.ending == Ending::closed && key == cycle;
            clip.keys.push_back(pose(script, closing ? 0.0 : static_cast<double>(key) / cycle));
        }
        clip.ground_speed_mps = travel_per_cycle(script) * unit_m * rate_hz / cycle;
        clips.push_back(std::move(clip));
    }
    return clips;
}

void name_clips(Model& model) {
    for (Clip& clip : model.clips) {
        switch (model.style.naming) {
            case Naming::titled:
                clip.name = clip.action;
                break;
            case Naming::lower_case:
                clip.name = base::lowered(clip.action);
                break;
            case Naming::with_animal:
                clip.name = model.name + "_" + clip.action;
                break;
            case Naming::numbered:
                // Those that were copied from another file when a clip of this name was there already.
                clip.name = clip.action + (clip.action.size() % 2 == 0 ? ".001" : "");
                break;
        }
    }
}

void set_interpolation(Model& model, std::string_view action, Interpolation interpolation) {
    for (Clip& clip : model.clips) {
        if (clip.action == action) clip.interpolation = interpolation;
    }
}

void keep_above_ground(Model& model) {
    double height = 0.0;
    for (const Vertex& vertex : model.mesh.vertices) height = std::max(height, vertex.position.y);
    for (Clip& clip : model.clips) {
        if (clip.ground_speed_mps > 0.0 || clip.action == "Jump") continue;
        for (Pose& pose : clip.keys) {
            const double lift = -lowest_point(model, pose) - kDepthAllowed * height;
            if (lift <= 0.0) continue;
            for (std::size_t joint = 0; joint < model.rig.joints.size(); ++joint)
                if (model.rig.joints[joint].parent < 0) pose.shifts[joint].y += lift;
        }
    }
}

}  // namespace posepack::menagerie
