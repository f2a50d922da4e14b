// SPDX-License-Identifier: MIT
// Files that hold one animal twice, plainly and compressed: the posed bodies must be the same but for what
// the compression rounded.
//
//   posepack_storage_twins PROJECT
//
// For each pair and each clip of both, at four times: how far a vertex of one posed body is from the nearest
// vertex of the other, in parts of the radius (half the diagonal of the rest pose's box), both ways.
// Compression reorders vertices, and quantisation moves a part of the transform from the mesh into the
// inverse bind matrices, so neither vertices nor matrices can be compared one by one. Models lie in
// POSEPACK_ASSETS, else in
// ../shared/assets beside the project; without them the test is skipped (exit code 77), but fails where
// CI=true.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "animal/read_animal.hpp"
#include "motion/clip_sampler.hpp"

namespace {

namespace fs = std::filesystem;
using posepack::animal::Animal;
using posepack::animal::Clip;
using Point = std::array<double, 3>;

struct Pair {
    const char* plain;
    const char* stored;
    double limit;  // parts of the radius
    const char* reason;
};

// Positions of 14 bits over the box: half a step is 6e-5 of its longest side.
constexpr double kPositions = 2e-4;
// And weights of 8 bits, 1/510 at most, times what the joints of a vertex move apart.
constexpr double kWeights = 2e-3;
// Keys on a grid of 30 Hz, linearly between those at 24 Hz.
constexpr double kGrid = 4e-2;

const Pair kPairs[] = {
    {"animals/wolf", "features/gt_draco", kPositions, "positions of 14 bits"},
    {"animals/wolf", "features/gt_draco_seq", kPositions, "positions of 14 bits"},
    {"animals/wolf", "features/gt_quantize", kWeights, "positions of 14 bits, weights of 8"},
    // Translations that are 4e-4 off, below an armature that is scaled by 100.
    {"animals/wolf", "features/gt_resample", kGrid, "keys that lie nearly between others are left out"},
    {"animals/wolf", "features/gt_meshopt_high", kWeights, "positions of 14 bits, weights of 8, keys of 16"},
    {"animals/wolf", "features/gltfpack_noq_c", kGrid, "keys on another grid"},
    {"animals/wolf", "features/gltfpack_quant", kGrid, "positions of 14 bits; keys on another grid"},
    {"features/gltfpack_quant", "features/gltfpack_c", 0.0, "nothing: streams without filters are exact"},
    {"features/gltfpack_c", "features/gltfpack_cf", 0.0, "nothing: the same with a fallback buffer"},
    {"features/gltfpack_quant", "features/gltfpack_cc", kWeights, "keys behind filters"},
    {"features/gltfpack_cc", "features/gltfpack_cc_merged", 0.0, "nothing: nodes without names"},
    {"animals/fox", "features/draco_fox", kGrid, "positions of 14 bits; keys on another grid"},
    {"animals/alpaca", "features/draco_alpaca", 1e-2, "positions of 14 bits; another export of the clips"},
};
// Two clips of the last two pairs go by other names.
constexpr std::size_t kMostUnmatched = 2;
constexpr int kTimes = 4;
constexpr std::size_t kProbeStep = 7;  // every seventh vertex looks for its neighbour

Animal read(const fs::path& assets, const std::string& name) {
    std::ifstream file(assets / (name + ".glb"), std::ios::binary);
    const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(file), {});
    auto animal = posepack::animal::read_animal(bytes);
    if (!animal) throw std::runtime_error(name + ": " + posepack::base::format_issue(animal.issue()));
    return std::move(animal).value();
}

std::vector<Point> posed(const Animal& animal, const std::vector<posepack::motion::Affine>& bones) {
    std::vector<Point> out(animal.vertices.positions.size(), Point{});
    for (std::size_t v = 0; v < out.size(); ++v) {
        const auto& p = animal.vertices.positions[v];
        for (std::size_t i = 0; i < posepack::animal::kMaxInfluences; ++i) {
            const double weight = animal.vertices.weights[v][i];
            if (weight == 0.0) continue;
            const glm::dvec3 moved = bones[animal.vertices.bones[v][i]] * glm::dvec3(p[0], p[1], p[2]);
            for (int c = 0; c < 3; ++c) out[v][static_cast<std::size_t>(c)] += weight * moved[c];
        }
    }
    return out;
}

std::vector<Point> pose_at(const Animal& animal, const Clip& clip, double time_s) {
    posepack::motion::ClipSampler sampler(animal, clip);
    std::vector<posepack::motion::Affine> bones(animal.bones.size());
    sampler.sample(time_s, bones);
    return posed(animal, bones);
}

double square(const Point& a, const Point& b) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

// The largest distance from a probe of `from` to what is nearest to it in `to`.
double farthest(const std::vector<Point>& from, const std::vector<Point>& to) {
    double largest = 0.0;
    for (std::size_t i = 0; i < from.size(); i += kProbeStep) {
        double nearest = HUGE_VAL;
        for (const Point& other : to) nearest = std::min(nearest, square(from[i], other));
        largest = std::max(largest, nearest);
    }
    return std::sqrt(largest);
}

double radius_of(const std::vector<Point>& points) {
    Point low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const Point& p : points)
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    return std::sqrt(square(low, high)) / 2;
}

struct Outcome {
    double worst = 0.0;
    std::string clip;
    std::size_t clips = 0;
};

Outcome compare(const Animal& plain, const Animal& stored) {
    const double radius = radius_of(posed(plain, posepack::motion::rest_pose(plain)));
    Outcome outcome;
    for (const Clip& clip : plain.clips) {
        const auto twin = std::find_if(stored.clips.begin(), stored.clips.end(),
                                       [&](const Clip& other) { return other.name == clip.name; });
        if (twin == stored.clips.end()) continue;
        ++outcome.clips;
        for (int t = 0; t < kTimes; ++t) {
            const double time_s = std::min(clip.duration_s, twin->duration_s) * (t + 0.5) / kTimes;
            const auto a = pose_at(plain, clip, time_s);
            const auto b = pose_at(stored, *twin, time_s);
            const double distance = std::max(farthest(a, b), farthest(b, a)) / radius;
            if (!(distance <= outcome.worst)) outcome = {distance, clip.name, outcome.clips};
        }
    }
    return outcome;
}

// Compares every pair; returns how many are too far apart.
int compare_all(const fs::path& assets) {
    int faults = 0;
    fmt::print("{:<26}{:<28}{:>6}{:>11}{:>11}  {}\n", "plain", "stored", "clips", "max / R", "limit",
               "what may differ");
    for (const Pair& pair : kPairs) {
        const Animal plain = read(assets, pair.plain);
        const Outcome outcome = compare(plain, read(assets, pair.stored));
        const bool is_good =
            outcome.clips + kMostUnmatched >= plain.clips.size() && outcome.worst <= pair.limit;
        faults += is_good ? 0 : 1;
        fmt::print("{:<26}{:<28}{:>6}{:>11.1e}{:>11.1e}  {}{}\n", pair.plain, pair.stored, outcome.clips,
                   outcome.worst, pair.limit, pair.reason,
                   is_good ? "" : fmt::format("  <- not so in {}", outcome.clip));
    }
    return faults;
}

}  // namespace

int main(int argc, char** argv) {
    const char* variable = std::getenv("POSEPACK_ASSETS");
    const fs::path assets = variable != nullptr && *variable != '\0'
                                ? fs::path(variable)
                                : fs::path(argc > 1 ? argv[1] : ".") / ".." / "shared" / "assets";
    if (!fs::exists(assets)) {
        fmt::print("SKIPPED: no folder {}; POSEPACK_ASSETS names it\n", assets.string());
        const char* ci = std::getenv("CI");
        return ci != nullptr && std::string(ci) == "true" ? 1 : 77;
    }
    try {
        return compare_all(assets) == 0 ? 0 : 1;
    } catch (const std::exception& exception) {
        fmt::print(stderr, "{}\n", exception.what());
        return 1;
    }
}
