// SPDX-License-Identifier: MIT
#include "support/extreme_models.hpp"

#include <cmath>

namespace posepack::support {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A vertex for every joint, at the joint's place in a translation-only rest pose, and one a little beside it
// that also follows the parent.
struct MeshMaker {
    MeshSpec mesh;

    void add(int joint, int parent, const std::array<double, 3>& at) {
        const std::array<double, 3> beside{at[0] + 0.1, at[1] + 0.2, at[2] - 0.1};
        for (const auto& point : {at, beside})
            for (const double c : point) mesh.positions.push_back(static_cast<float>(c));
        for (int i = 0; i < 2; ++i) mesh.normals.insert(mesh.normals.end(), {0, 0, 1});
        const auto own = static_cast<std::uint16_t>(joint);
        const auto other = static_cast<std::uint16_t>(parent < 0 ? joint : parent);
        mesh.joints.insert(mesh.joints.end(), {own, 0, 0, 0, own, other, 0, 0});
        mesh.weights.insert(mesh.weights.end(), {1, 0, 0, 0, 0.75f, 0.25f, 0, 0});
    }
};

std::vector<float> swing(std::size_t keys, double degrees, double x, double y, double z) {
    std::vector<float> values;
    for (std::size_t k = 0; k < keys; ++k) {
        const double phase = 2 * kPi * static_cast<double>(k) / static_cast<double>(keys - 1);
        const auto q = turn(degrees * std::sin(phase), x, y, z);
        values.insert(values.end(), q.begin(), q.end());
    }
    return values;
}

// A model whose joints are its nodes, all at rest by translation alone: node i hangs from parents[i].
ModelSpec translated_joints(const std::vector<int>& parents,
                            const std::vector<std::array<double, 3>>& steps) {
    ModelSpec spec;
    SkinSpec skin;
    MeshMaker maker;
    maker.mesh.name = "Body";
    std::vector<std::array<double, 3>> places;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        std::array<double, 3> place = steps[i];
        if (parents[i] >= 0) {
            const auto parent = static_cast<std::size_t>(parents[i]);
            for (std::size_t c = 0; c < 3; ++c) place[c] += places[parent][c];
            spec.nodes[parent]["children"].push_back(i);
        }
        places.push_back(place);
        spec.nodes.push_back({{"name", "joint " + std::to_string(i)}, {"translation", steps[i]}});
        skin.joints.push_back(static_cast<int>(i));
        skin.inverse_binds.push_back({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, static_cast<float>(-place[0]),
                                      static_cast<float>(-place[1]), static_cast<float>(-place[2]), 1});
        maker.add(static_cast<int>(i), parents[i], place);
    }
    spec.skins = {skin};
    spec.meshes = {maker.mesh};
    return spec;
}

// Joints 0 - 1 - 2 in a row along X; `middle` is merged into the node of joint 1.
ModelSpec three_joints(const Json& middle) {
    ModelSpec spec = translated_joints({-1, 0, 1}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}});
    spec.nodes[1].update(middle);
    spec.skins[0].inverse_binds = inverse_binds_of(spec.nodes, spec.skins[0].joints);
    return spec;
}

}  // namespace

ModelSpec many_joints(int count) {
    std::vector<int> parents;
    std::vector<std::array<double, 3>> steps;
    for (int i = 0; i < count; ++i) {
        parents.push_back(i == 0 ? -1 : (i - 1) / 4);
        steps.push_back({0.5 + 0.01 * (i % 7), 0.1 * (i % 4), 0.05 * (i % 3)});
    }
    ModelSpec spec = translated_joints(parents, steps);
    ClipSpec clip{"Turn", {}};
    for (int i = 0; i < count; ++i)
        clip.channels.push_back({i, "rotation", grid(16, kExtremeRateHz), swing(16, 5.0, 1, i % 5, i % 3)});
    spec.clips = {clip};
    return spec;
}

ModelSpec long_chain(int count) {
    std::vector<int> parents;
    std::vector<std::array<double, 3>> steps;
    for (int i = 0; i < count; ++i) {
        parents.push_back(i - 1);
        steps.push_back({i == 0 ? 0.0 : 0.25, 0, 0});
    }
    ModelSpec spec = translated_joints(parents, steps);
    ClipSpec clip{"Curl", {}};
    for (int i = 0; i < count; ++i)
        clip.channels.push_back({i, "rotation", grid(16, kExtremeRateHz), swing(16, 0.5, 0, 0.2, 1)});
    spec.clips = {clip};
    return spec;
}

ModelSpec mirrored_joint() {
    ModelSpec spec = three_joints({{"scale", {-1, 1, 1}}});
    spec.clips = {{"Wave",
                   {{0, "rotation", grid(16, kExtremeRateHz), swing(16, 20, 0, 1, 0)},
                    {1, "rotation", grid(16, kExtremeRateHz), swing(16, 30, 1, 1, 0)},
                    {2, "rotation", grid(16, kExtremeRateHz), swing(16, 25, 0, 0, 1)}}}};
    return spec;
}

ModelSpec scale_through_zero() {
    ModelSpec spec = three_joints(Json::object());
    std::vector<float> scales;
    for (int k = 0; k <= 20; ++k)
        for (int c = 0; c < 3; ++c) scales.push_back(1.0f - 0.1f * static_cast<float>(k));
    for (int c = 0; c < 3; ++c) scales[10 * 3 + static_cast<std::size_t>(c)] = 0.0f;  // not 1 - 10 * 0.1f
    spec.clips = {{"Vanish",
                   {{1, "scale", grid(21, kExtremeRateHz), scales},
                    {2, "rotation", grid(21, kExtremeRateHz), swing(21, 30, 0, 0, 1)}}}};
    return spec;
}

ModelSpec shear_under_rotation() {
    ModelSpec spec = three_joints(Json::object());
    spec.nodes.push_back(
        {{"name", "Stretch"}, {"rotation", turn(25, 0, 1, 1)}, {"scale", {1, 3, 0.5}}, {"children", {0}}});
    spec.skins[0].inverse_binds = inverse_binds_of(spec.nodes, spec.skins[0].joints);
    spec.clips = {{"Lean",
                   {{0, "rotation", grid(16, kExtremeRateHz), swing(16, 40, 0, 0, 1)},
                    {1, "rotation", grid(16, kExtremeRateHz), swing(16, 40, 1, 0, 1)}}}};
    return spec;
}

ModelSpec shared_joint() {
    ModelSpec spec = three_joints(Json::object());
    SkinSpec second;
    second.joints = {2, 0};
    second.inverse_binds = {spec.skins[0].inverse_binds[2], spec.skins[0].inverse_binds[0]};
    spec.skins.push_back(second);
    MeshSpec tail;
    tail.name = "Tail";
    tail.skin = 1;
    tail.positions = {2, 0, 0, 2, 1, 0, 1, 0.5f, 0};
    tail.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    tail.joints = {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0};
    tail.weights = {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0.75f, 0.25f, 0, 0};
    spec.meshes.push_back(tail);
    spec.clips = {{"Wag",
                   {{0, "rotation", grid(16, kExtremeRateHz), swing(16, 15, 0, 1, 0)},
                    {2, "rotation", grid(16, kExtremeRateHz), swing(16, 35, 0, 0, 1)}}}};
    return spec;
}

ModelSpec many_clips(int count) {
    ModelSpec spec = three_joints(Json::object());
    for (int c = 0; c < count; ++c) {
        const std::size_t keys = 2 + static_cast<std::size_t>(c % 5);
        std::vector<float> places;
        for (std::size_t k = 0; k < keys; ++k)
            places.insert(places.end(), {static_cast<float>(c) * 0.001f, static_cast<float>(k) * 0.1f, 0});
        spec.clips.push_back(
            {"clip " + std::to_string(c),
             {{0, "translation", grid(keys, kExtremeRateHz), places},
              {1, "rotation", grid(keys, kExtremeRateHz), swing(keys, 3.0 + c % 11, 1, 0, c % 3)}}});
    }
    return spec;
}

ModelSpec long_clip(double duration_s) {
    ModelSpec spec = three_joints(Json::object());
    const auto keys = static_cast<std::size_t>(std::lround(duration_s * kExtremeRateHz)) + 1;
    std::vector<float> values;
    for (std::size_t k = 0; k < keys; ++k) {
        const double time_s = static_cast<double>(k) / kExtremeRateHz;
        const auto q = turn(30 * std::sin(2 * kPi * time_s / 1.7) + 0.05 * time_s, 0, 1, 1);
        values.insert(values.end(), q.begin(), q.end());
    }
    std::vector<float> times = grid(keys, kExtremeRateHz);
    times.back() = static_cast<float>(duration_s);
    spec.clips = {{"Doze", {{1, "rotation", times, values}}}};
    return spec;
}

ModelSpec walking_in_circles(double radius) {
    ModelSpec spec = three_joints(Json::object());
    const std::size_t keys = 121;
    std::vector<float> places;
    std::vector<float> turns_of_root;
    for (std::size_t k = 0; k < keys; ++k) {
        const double angle = 4 * kPi * static_cast<double>(k) / static_cast<double>(keys - 1);
        // Ends a step outside the circle, so that the clip does not close.
        const double r = radius * (1.0 + static_cast<double>(k) / static_cast<double>(keys - 1));
        places.insert(places.end(),
                      {static_cast<float>(r * std::sin(angle)), 0, static_cast<float>(r * std::cos(angle))});
        const auto q = turn(angle * 180 / kPi, 0, 1, 0);
        turns_of_root.insert(turns_of_root.end(), q.begin(), q.end());
    }
    spec.clips = {{"Circle",
                   {{0, "translation", grid(keys, kExtremeRateHz), places},
                    {0, "rotation", grid(keys, kExtremeRateHz), turns_of_root},
                    {1, "rotation", grid(keys, kExtremeRateHz), swing(keys, 20, 1, 0, 0)}}}};
    return spec;
}

}  // namespace posepack::support
