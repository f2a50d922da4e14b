// SPDX-License-Identifier: MIT
#include "fit/profile.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace posepack::fit {
namespace {

constexpr std::size_t kCountedPoints = 20;
constexpr std::size_t kSamplesCompared = 5;
constexpr std::size_t kManySamples = 8;  // an interval: half of them show as much
// Bins of squares: the exponent of a float and two bits, four an octave of the square.
constexpr int kBinShift = 21;

struct Influence {
    std::array<float, 3> point;
    float weight;
};

// Every so manieth vertex, then the outermost along the axes; both filled up with points of no weight.
BonePoints choose_points(const std::vector<Influence>& all) {
    BonePoints out;
    const auto push = [&](const Influence& influence) {
        out.x.push_back(influence.point[0]);
        out.y.push_back(influence.point[1]);
        out.z.push_back(influence.point[2]);
        out.weight.push_back(influence.weight);
    };
    const auto fill_up = [&] {
        while (out.x.size() % kPointsAtOnce != 0) push({});
    };
    if (all.empty()) return out;
    const std::size_t count = std::min(kCountedPoints, all.size());
    for (std::size_t i = 0; i < count; ++i) push(all[i * all.size() / count]);
    fill_up();
    out.counted = out.x.size();
    out.share = static_cast<double>(all.size()) / static_cast<double>(count);
    if (all.size() == count) return out;
    out.outermost = out.counted;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // A vertex that hardly belongs to the bone is not its end.
        const auto score = [&](const Influence& i) { return i.weight * i.point[axis]; };
        const auto [low, high] = std::minmax_element(
            all.begin(), all.end(), [&](const auto& a, const auto& b) { return score(a) < score(b); });
        push(*low);
        push(*high);
    }
    fill_up();
    return out;
}

// The matrix of blended numbers, row by row; a dual quaternion as a reader computes it.
void write_matrix(Form form, const double* n, float* m) {
    if (form == Form::affine) {
        for (std::size_t i = 0; i < 12; ++i) m[i] = static_cast<float>(n[i]);
        return;
    }
    const double x = n[0], y = n[1], z = n[2], w = n[3], s = n[8];
    const double square = x * x + y * y + z * z + w * w;
    const double h = 2.0 / std::max(square, 1e-12);
    m[0] = static_cast<float>(s * (1 - h * (y * y + z * z)));
    m[1] = static_cast<float>(s * h * (x * y - w * z));
    m[2] = static_cast<float>(s * h * (x * z + w * y));
    m[3] = static_cast<float>(h * (w * n[4] - n[7] * x + (y * n[6] - z * n[5])));
    m[4] = static_cast<float>(s * h * (x * y + w * z));
    m[5] = static_cast<float>(s * (1 - h * (x * x + z * z)));
    m[6] = static_cast<float>(s * h * (y * z - w * x));
    m[7] = static_cast<float>(h * (w * n[5] - n[7] * y + (z * n[4] - x * n[6])));
    m[8] = static_cast<float>(s * h * (x * z - w * y));
    m[9] = static_cast<float>(s * h * (y * z + w * x));
    m[10] = static_cast<float>(s * (1 - h * (x * x + y * y)));
    m[11] = static_cast<float>(h * (w * n[6] - n[7] * z + (x * n[5] - y * n[4])));
}

// Four points at once, an extension of GCC and clang that every processor has.
using Four = float __attribute__((vector_size(16)));
using FourBits = std::int32_t __attribute__((vector_size(16)));
static_assert(sizeof(Four) == kPointsAtOnce * sizeof(float));

Four load(const float* values) {
    Four four;
    std::memcpy(&four, values, sizeof four);
    return four;
}

// The squares of the distances, weights taken in, that a difference of matrices makes of points i to i + 3.
Four squares_of(const float* e, const BonePoints& points, std::size_t i, float scale) {
    const Four x = load(&points.x[i]), y = load(&points.y[i]), z = load(&points.z[i]);
    const Four dx = e[0] * x + e[1] * y + e[2] * z + e[3];
    const Four dy = e[4] * x + e[5] * y + e[6] * z + e[7];
    const Four dz = e[8] * x + e[9] * y + e[10] * z + e[11];
    const Four w = load(&points.weight[i]) * scale;
    return w * w * (dx * dx + dy * dy + dz * dz);
}

// Of squares, which have no sign, the larger are the larger integers; NaN is the largest.
class LargestSquare {
 public:
    void add(Four squares) {
        const auto bits = std::bit_cast<FourBits>(squares);
        const FourBits is_larger = bits > largest_;
        largest_ = (bits & is_larger) | (largest_ & ~is_larger);
    }
    float value() const {
        const auto four = std::bit_cast<std::array<std::int32_t, kPointsAtOnce>>(largest_);
        return std::bit_cast<float>(*std::max_element(four.begin(), four.end()));
    }

 private:
    FourBits largest_{};
};

void subtract(std::span<float, 12> matrix, std::span<const float> exact) {
    for (std::size_t i = 0; i < 12; ++i) matrix[i] -= exact[i];
}

}  // namespace

std::vector<BonePoints> bone_points(const motion::SkinSet& points, const palette::Spaces& spaces,
                                    std::size_t bone_count) {
    std::vector<std::vector<Influence>> all(bone_count);
    for (std::size_t n = 1; n + 1 < points.first.size(); ++n)
        for (std::uint32_t i = points.first[n]; i < points.first[n + 1]; ++i)
            for (std::size_t k = 0; k < n; ++k) {
                const std::size_t bone = points.bones[i][k];
                const auto& v = points.vectors[i];
                const glm::dvec3 p = spaces.bone_entry(bone) * glm::dvec3(v[0], v[1], v[2]);
                all[bone].push_back(
                    {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                     points.weights[i][k]});
            }
    std::vector<BonePoints> out;
    out.reserve(bone_count);
    for (const auto& influences : all) out.push_back(choose_points(influences));
    return out;
}

void Profile::count(float square, double share) {
    if (static_cast<double>(square) <= floor_square_) return;
    const auto bin = (std::bit_cast<std::uint32_t>(square) -
                      std::bit_cast<std::uint32_t>(static_cast<float>(floor_square_))) >>
                     kBinShift;
    counts_[std::min<std::size_t>(bin, kBins - 1)] += share;
}

double Profile::count_above(double distance) const {
    const auto bits = [](double square) {
        return static_cast<double>(std::bit_cast<std::uint32_t>(static_cast<float>(square)));
    };
    const double place = (bits(distance * distance) - bits(floor_square_)) / (1 << kBinShift);
    const auto first = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, double{kBins - 1}));
    double sum = 0.0;
    for (std::size_t i = first + 1; i < kBins; ++i) sum += counts_[i];
    // Of the bin that the distance falls into, the part above it.
    return sum + counts_[first] * (1.0 - std::clamp(place - static_cast<double>(first), 0.0, 1.0));
}

Profile profile_of(const Tracks& tracks, const Polyline& line, std::size_t bone, const BonePoints& points,
                   double reach, double floor, double enough, std::vector<float>* sample_errors) {
    Profile profile(floor);
    if (points.is_empty()) return profile;
    const auto scale = static_cast<float>(1.0 / reach);
    const auto floor_square = static_cast<float>(floor * floor);
    const std::size_t width = numbers_of(tracks.form);
    std::array<double, kAffineNumbers> numbers{};
    std::array<float, 12> found{};
    std::vector<float> squares(points.x.size());
    // Slots have few samples an interval where rows are close.
    const bool has_many =
        tracks.slots.slots.empty() && line.interval_count * kManySamples <= tracks.interval_count;
    const std::size_t every = has_many ? 2 : 1;
    const double share = points.share * static_cast<double>(every);
    for (std::size_t k = 0; k < tracks.known_count; k += every) {
        blend_numbers(line, width, tracks.step, tracks.phase(k), numbers.data());
        write_matrix(tracks.form, numbers.data(), found.data());
        subtract(found, tracks.exact_at(bone, k));
        LargestSquare here, counted_here;
        Four sum{};
        for (std::size_t i = 0; i < points.x.size(); i += kPointsAtOnce) {
            const Four four = squares_of(found.data(), points, i, scale);
            std::memcpy(&squares[i], &four, sizeof four);
            here.add(four);
            if (i >= points.counted) continue;
            sum += four;
            counted_here.add(four);
        }
        profile.square_sum += share * (static_cast<double>(sum[0] + sum[1]) + (sum[2] + sum[3]));
        if (counted_here.value() > floor_square)
            for (std::size_t i = 0; i < points.counted; ++i) profile.count(squares[i], share);
        if (sample_errors != nullptr)
            sample_errors->insert(sample_errors->end(), std::min(every, tracks.known_count - k),
                                  std::sqrt(here.value()));
        profile.max = std::max(profile.max, std::sqrt(static_cast<double>(here.value())));
        if (profile.max > enough) break;
    }
    return profile;
}

float largest_square(const Tracks& tracks, std::size_t bone, std::size_t sample, const double* numbers,
                     const BonePoints& points, float scale) {
    std::array<float, 12> found{};
    write_matrix(tracks.form, numbers, found.data());
    subtract(found, tracks.exact_at(bone, sample));
    LargestSquare largest;
    for (std::size_t i = points.outermost; i < points.x.size(); i += kPointsAtOnce)
        largest.add(squares_of(found.data(), points, i, scale));
    return largest.value();
}

double distance_between(const Tracks& tracks, std::size_t first, std::size_t second, const BonePoints& points,
                        double reach, double enough) {
    const auto scale = static_cast<float>(1.0 / reach);
    std::array<float, 12> difference{};
    float max = 0.0f;
    for (std::size_t i = 0; i < kSamplesCompared; ++i) {
        const std::size_t k = i * (tracks.known_count - 1) / (kSamplesCompared - 1);
        std::copy_n(tracks.exact_at(first, k).begin(), 12, difference.begin());
        subtract(difference, tracks.exact_at(second, k));
        LargestSquare largest;
        for (std::size_t p = points.outermost; p < points.x.size(); p += kPointsAtOnce)
            largest.add(squares_of(difference.data(), points, p, scale));
        max = std::max(max, largest.value());
        if (static_cast<double>(max) > enough * enough) break;
    }
    return std::sqrt(static_cast<double>(max));
}

}  // namespace posepack::fit
