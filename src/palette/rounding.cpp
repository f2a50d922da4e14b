// SPDX-License-Identifier: MIT
#include "palette/rounding.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace posepack::palette {
namespace {

constexpr double kSmallestNormalHalf = 0x1p-14;
constexpr int kRealLengths = 24;
constexpr int kRealLengthsTried = 64;  // where the cost is still too high

// Half floats as doubles: multiples of a step that depends on the number's size. All of this is exact, and
// many times faster than to convert to halves and back.
class HalfGrid {
 public:
    explicit HalfGrid(Halves allowed)
        : least_step_(allowed == Halves::normal ? kSmallestNormalHalf : 0x1p-24) {}

    // The distance of two neighbouring halves about a number. Where subnormals are left out the neighbours of
    // the smallest normal halves are 0.
    double step(double value) const {
        const double size = std::abs(value);
        if (size < kSmallestNormalHalf) return least_step_;
        // 2^e * 2^-10 of a number between 2^e and 2^(e+1): its exponent, less 10.
        constexpr std::uint64_t kExponent = 0x7ff0000000000000u;
        constexpr std::uint64_t kTen = std::uint64_t{10} << 52;
        return std::bit_cast<double>((std::bit_cast<std::uint64_t>(value) & kExponent) - kTen);
    }
    // The nearest half, ties to even; finite numbers only. What is too large for a half stays too large.
    double nearest(double value) const {
        const double large = anchor(value);
        return (value + large) - large;
    }
    // What rounds numbers of this size when it is added and taken away again: so large a double has no digits
    // below the step.
    double anchor(double value) const { return step(value) * 0x1.8p52; }

 private:
    double least_step_;
};

// Two doubles at once, an extension of GCC and clang. Wider ones are slower where the processor's registers
// are not so wide by default.
using Pair = double __attribute__((vector_size(16)));

// A row of a matrix in halves, as doubles: of the eight ways to round its three entries the one that costs
// least. The translation takes up what moves the centroid, so what is seen is the spread about the centroid
// and the rounding of the translation: d' S d = e' C e + r^2. No branches: this runs for every row of every
// bone.
void round_row(const std::array<double, 4>& row, const BoneMoment& moment, const HalfGrid& grid,
               std::span<double, 4> rounded) {
    std::array<std::array<double, 2>, 3> side{}, error{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double nearest = grid.nearest(row[c]);
        const double step = nearest == row[c] ? 0.0 : grid.step(row[c]);
        side[c] = {nearest, nearest + std::copysign(step, row[c] - nearest)};
        for (std::size_t s = 0; s < 2; ++s) error[c][s] = side[c][s] - row[c];
    }
    const glm::dvec3& centroid = moment.centroid;
    const auto shift_of = [&](std::size_t c) {
        return std::max(std::abs(error[c][0]), std::abs(error[c][1]));
    };
    const double largest = std::abs(row[3]) + shift_of(0) * std::abs(centroid.x) +
                           shift_of(1) * std::abs(centroid.y) + shift_of(2) * std::abs(centroid.z);
    const double anchor = grid.anchor(largest);  // one grid for all eight, the coarsest of theirs

    constexpr std::size_t kChoices = 8;
    alignas(Pair) std::array<double, kChoices> cost{}, translation{};
    const auto& spread = moment.spread;
    const Pair x = {error[0][0], error[0][1]};
    for (std::size_t i = 0; i < kChoices; i += 2) {
        const double y = error[1][i >> 1 & 1], z = error[2][i >> 2];
        const Pair wanted = row[3] - (x * centroid.x + (y * centroid.y + z * centroid.z));
        const Pair nearest = (wanted + anchor) - anchor;
        const Pair rest = nearest - wanted;
        const Pair sum = x * (spread[0] * x + 2.0 * (spread[3] * y + spread[4] * z)) +
                         (y * (spread[1] * y + 2.0 * spread[5] * z) + spread[2] * z * z) + rest * rest;
        std::memcpy(&translation[i], &nearest, sizeof nearest);
        std::memcpy(&cost[i], &sum, sizeof sum);
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < kChoices; ++i) best = cost[i] < cost[best] ? i : best;
    rounded[0] = side[0][best & 1];
    rounded[1] = side[1][best >> 1 & 1];
    rounded[2] = side[2][best >> 2];
    rounded[3] = grid.nearest(translation[best]);  // a subnormal half may still have to go
}

struct DualNumbers {
    glm::dvec4 real{0.0}, dual{0.0};
};

// dual' of a translation and a scale, for a real part of any length.
glm::dvec4 dual_of(const glm::dvec4& q, const glm::dvec3& t, double scale, double length) {
    const glm::dvec4 dual(
        0.5 * (t.x * q.w + t.y * q.z - t.z * q.y), 0.5 * (t.y * q.w + t.z * q.x - t.x * q.z),
        0.5 * (t.z * q.w + t.x * q.y - t.y * q.x), -0.5 * (t.x * q.x + t.y * q.y + t.z * q.z));
    return dual + 0.5 * (scale - 1.0) * length * q;
}

// What a reader makes of them, in double precision.
motion::Affine matrix_of(const DualNumbers& n, const glm::dmat3& rotation, double length) {
    const glm::dvec4& q = n.real;
    const glm::dvec4& d = n.dual;
    const double square = glm::dot(q, q);
    const double h = 2.0 / square;
    motion::Affine out;
    out.linear = (1.0 + 2.0 * glm::dot(q, d) / square / length) * rotation;
    out.translation = h * glm::dvec3(q.w * d.x - d.w * q.x + (q.y * d.z - q.z * d.y),
                                     q.w * d.y - d.w * q.y + (q.z * d.x - q.x * d.z),
                                     q.w * d.z - d.w * q.z + (q.x * d.y - q.y * d.x));
    return out;
}

double cost_of(const motion::Affine& found, const motion::Affine& exact, const BoneMoment& moment) {
    double sum = 0.0;
    for (int r = 0; r < 3; ++r)
        sum += moment.cost({found.linear[0][r] - exact.linear[0][r], found.linear[1][r] - exact.linear[1][r],
                            found.linear[2][r] - exact.linear[2][r],
                            found.translation[r] - exact.translation[r]});
    return sum;
}

// What the linear part alone costs; never more than the whole.
double spread_cost(const glm::dmat3& found, const glm::dmat3& exact, const BoneMoment& moment) {
    double sum = 0.0;
    for (int r = 0; r < 3; ++r)
        sum += moment.spread_cost(found[0][r] - exact[0][r], found[1][r] - exact[1][r],
                                  found[2][r] - exact[2][r]);
    return sum;
}

glm::dvec4 round_vector(const glm::dvec4& v, const HalfGrid& grid) {
    return {grid.nearest(v.x), grid.nearest(v.y), grid.nearest(v.z), grid.nearest(v.w)};
}

void keep(const DualNumbers& n, std::span<float, 8> rounded) {
    for (int c = 0; c < 4; ++c) {
        rounded[static_cast<std::size_t>(c)] = static_cast<float>(n.real[c]);
        rounded[static_cast<std::size_t>(4 + c)] = static_cast<float>(n.dual[c]);
    }
}

// One of the sixteen ways to round four numbers up or down.
glm::dvec4 round_to_side(const glm::dvec4& v, int sides, const HalfGrid& grid) {
    glm::dvec4 out;
    for (int c = 0; c < 4; ++c) {
        out[c] = grid.nearest(v[c]);
        if (sides >> c & 1) out[c] = grid.nearest(out[c] + std::copysign(grid.step(v[c]), v[c] - out[c]));
    }
    return out;
}

}  // namespace

void round_affine(const motion::Affine& matrix, const BoneMoment& moment, Halves allowed,
                  std::span<float, 12> rounded) {
    const HalfGrid grid(allowed);
    for (int r = 0; r < 3; ++r) {
        const std::array<double, 4> row{matrix.linear[0][r], matrix.linear[1][r], matrix.linear[2][r],
                                        matrix.translation[r]};
        std::array<double, 4> halves{};
        round_row(row, moment, grid, halves);
        for (std::size_t c = 0; c < 4; ++c)
            rounded[static_cast<std::size_t>(4 * r) + c] = static_cast<float>(halves[c]);
    }
}

void dualquat_numbers(const Similarity& target, double length, std::span<double, 8> numbers) {
    const glm::dvec4 dual = dual_of(target.rotation, target.translation, target.scale, length);
    for (int c = 0; c < 4; ++c) {
        numbers[static_cast<std::size_t>(c)] = target.rotation[c];
        numbers[static_cast<std::size_t>(4 + c)] = dual[c];
    }
}

void round_dualquat(const motion::Affine& exact, const Similarity& target, const BoneMoment& moment,
                    double length, Halves allowed, std::span<float, 8> rounded, double enough, double span) {
    const HalfGrid grid(allowed);
    const glm::dvec3 kept = exact * moment.centroid;
    double least = HUGE_VAL;
    const auto try_length = [&](double real_length, int ways) {
        DualNumbers n;
        n.real = round_vector(real_length * target.rotation, grid);
        const glm::dmat3 rotation = rotation_matrix(n.real);
        // Before the scale is rounded too, which is seen last.
        if (least < HUGE_VAL && !(spread_cost(target.scale * rotation, exact.linear, moment) < least)) return;
        const glm::dvec3 translation = kept - target.scale * (rotation * moment.centroid);
        const glm::dvec4 dual = dual_of(n.real, translation, target.scale, length);
        for (int sides = 0; sides < ways; ++sides) {
            n.dual = round_to_side(dual, sides, grid);
            const double cost = cost_of(matrix_of(n, rotation, length), exact, moment);
            if (least < HUGE_VAL && !(cost < least)) continue;
            least = cost;
            keep(n, rounded);
        }
    };
    for (int i = 0; i < kRealLengths; ++i) try_length(1.0 - span * i / (kRealLengths - 1), 1);
    for (int i = 0; i < kRealLengthsTried && least > enough; ++i)
        try_length(1.0 - span * i / (kRealLengthsTried - 1), 16);
}

}  // namespace posepack::palette
