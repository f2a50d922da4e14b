// SPDX-License-Identifier: MIT
#include "animal/weights.hpp"

#include <algorithm>
#include <cmath>

namespace posepack::animal {
namespace {

constexpr double kSumTolerance = 1e-3;  // beyond it a sum is reported; smaller ones are rounding

struct Influence {
    std::uint16_t bone;
    double weight;
};

// Index of the vertex nearest to `vertex` among those that have weights, or the vertex itself when none has.
std::size_t nearest_good(std::size_t vertex, const std::vector<bool>& good,
                         std::span<const std::array<float, 3>> positions) {
    std::size_t best = vertex;
    double best_distance = HUGE_VAL;
    for (std::size_t v = 0; v < good.size(); ++v) {
        if (!good[v]) continue;
        double distance = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = static_cast<double>(positions[v][c]) - positions[vertex][c];
            distance += d * d;
        }
        if (distance < best_distance) {
            best_distance = distance;
            best = v;
        }
    }
    return best;
}

// The influences of one vertex: equal bones joined, largest first.
void gather(std::span<const std::uint16_t> bones, std::span<const float> weights, std::vector<Influence>& out,
            bool& bad) {
    out.clear();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!std::isfinite(weights[i]) || weights[i] < 0.0f) {
            bad = true;
            continue;
        }
        if (weights[i] == 0.0f) continue;
        const auto same =
            std::find_if(out.begin(), out.end(), [&](const Influence& f) { return f.bone == bones[i]; });
        if (same != out.end())
            same->weight += weights[i];
        else
            out.push_back({bones[i], weights[i]});
    }
    // Insertion sort: stable, and these are few.
    for (std::size_t i = 1; i < out.size(); ++i)
        for (std::size_t k = i; k > 0 && out[k].weight > out[k - 1].weight; --k)
            std::swap(out[k], out[k - 1]);
}

// Adds all influences of a vertex, `sum` of whose weights is not one.
void remember(std::size_t vertex, const std::vector<Influence>& found, double sum, ReducedVertices& reduced) {
    reduced.vertices.push_back(static_cast<std::uint32_t>(vertex));
    reduced.first.push_back(static_cast<std::uint32_t>(reduced.bones.size()));
    for (const Influence& f : found) {
        reduced.bones.push_back(f.bone);
        reduced.weights.push_back(static_cast<float>(f.weight / sum));
    }
}

}  // namespace

WeightRepairs reduce_weights(std::span<const std::uint16_t> bones, std::span<const float> weights,
                             std::size_t influences, std::size_t keep,
                             std::span<const std::array<float, 3>> positions, std::uint64_t& tests_left,
                             Vertices& out, ReducedVertices& reduced) {
    WeightRepairs repairs;
    const std::size_t count = positions.size();
    const std::size_t first = out.bones.size();
    std::vector<bool> good(count, true);
    std::vector<Influence> found;
    for (std::size_t v = 0; v < count; ++v) {
        bool bad = false;
        gather(bones.subspan(v * influences, influences), weights.subspan(v * influences, influences), found,
               bad);
        repairs.bad += bad ? 1 : 0;
        double sum = 0.0;
        for (const Influence& f : found) sum += f.weight;
        if (!bad && !found.empty() && std::abs(sum - 1.0) > kSumTolerance) ++repairs.sum_not_one;
        if (found.size() > keep) {
            ++repairs.truncated;
            repairs.influences_most = std::max(repairs.influences_most, found.size());
            remember(first + v, found, sum, reduced);
            double dropped = 0.0;
            for (std::size_t i = keep; i < found.size(); ++i) dropped += found[i].weight / sum;
            repairs.truncated_weight_max = std::max(repairs.truncated_weight_max, dropped);
            found.resize(keep);
            sum = 0.0;
            for (const Influence& f : found) sum += f.weight;
        }
        InfluenceBones vertex_bones{};
        InfluenceWeights vertex_weights{};
        for (std::size_t i = 0; i < found.size(); ++i) {
            vertex_bones[i] = found[i].bone;
            vertex_weights[i] = static_cast<float>(found[i].weight / sum);
        }
        good[v] = !found.empty();
        out.bones.push_back(vertex_bones);
        out.weights.push_back(vertex_weights);
    }
    const auto good_count = static_cast<std::size_t>(std::count(good.begin(), good.end(), true));
    const std::uint64_t tests = std::uint64_t{good_count} * (count - good_count);
    if (tests > tests_left) {
        repairs.hopeless = true;
        return repairs;
    }
    tests_left -= tests;
    for (std::size_t v = 0; v < count; ++v) {
        if (good[v]) continue;
        ++repairs.none_left;
        const std::size_t source = nearest_good(v, good, positions);
        out.bones[first + v] = out.bones[first + source];
        out.weights[first + v] = out.weights[first + source];
        if (source != v) continue;
        // No vertex has weights: each follows the first joint it names.
        out.bones[first + v][0] = bones[v * influences];
        out.weights[first + v][0] = 1.0f;
    }
    return repairs;
}

}  // namespace posepack::animal
