// SPDX-License-Identifier: MIT
#include "palette/rounding.hpp"

#include <array>
#include <cmath>

#include "format/half.h"

namespace posepack::palette {
namespace {

constexpr double kSmallestNormalHalf = 0x1p-14;
constexpr int kRealLengths = 24;

double value_of(std::uint16_t half) {
    return static_cast<double>(posepack_float_from_half(half));
}

std::uint16_t nearest_half(double value, Halves allowed) {
    if (allowed == Halves::normal && std::abs(value) < kSmallestNormalHalf)
        value = std::abs(value) < 0.5 * kSmallestNormalHalf ? 0.0 : std::copysign(kSmallestNormalHalf, value);
    return posepack_half_from_float(static_cast<float>(value));
}

// The halves around a number: the nearest, and the one on its other side unless the nearest is exact.
struct Around {
    std::array<std::uint16_t, 2> halves{};
    int count = 1;
};

Around halves_around(double value, Halves allowed) {
    constexpr std::uint16_t kSign = 0x8000;
    constexpr std::uint16_t kSmallestNormal = 0x0400;
    Around around;
    const std::uint16_t nearest = nearest_half(value, allowed);
    around.halves[0] = nearest;
    const double found = value_of(nearest);
    if (found == value || !std::isfinite(found)) return around;
    const bool away = std::abs(value) > std::abs(found);
    const auto sign = static_cast<std::uint16_t>(value < 0.0 ? kSign : 0);
    const auto magnitude = static_cast<std::uint16_t>(nearest & ~kSign);
    const std::uint16_t step = allowed == Halves::normal && magnitude == (away ? 0 : kSmallestNormal)
                                   ? kSmallestNormal
                                   : std::uint16_t{1};
    const auto other = static_cast<std::uint16_t>(sign | (away ? magnitude + step : magnitude - step));
    if (!std::isfinite(value_of(other))) return around;
    around.halves[1] = other;
    around.count = 2;
    return around;
}

void round_row(const std::array<double, 4>& row, const BoneMoment& moment, Halves allowed,
               std::span<std::uint16_t, 4> halves) {
    std::array<Around, 3> around;
    for (std::size_t c = 0; c < 3; ++c) around[c] = halves_around(row[c], allowed);
    const glm::dvec3 centroid = moment.centroid();
    double least = HUGE_VAL;
    for (std::size_t c = 0; c < 3; ++c) halves[c] = around[c].halves[0];
    halves[3] = nearest_half(row[3], allowed);  // what stays where every choice is infinite
    for (int choice = 0; choice < 8; ++choice) {
        std::array<std::uint16_t, 4> chosen{};
        std::array<double, 4> d{};
        bool exists = true;
        double shift = 0.0;
        for (int c = 0; c < 3; ++c) {
            const int side = choice >> c & 1;
            const auto i = static_cast<std::size_t>(c);
            if (side >= around[i].count) exists = false;
            chosen[i] = around[i].halves[static_cast<std::size_t>(side)];
            d[i] = value_of(chosen[i]) - row[i];
            shift += d[i] * centroid[c];
        }
        if (!exists) continue;
        chosen[3] = nearest_half(row[3] - shift, allowed);
        d[3] = value_of(chosen[3]) - row[3];
        const double cost = moment.cost(d);
        if (!(cost < least)) continue;
        least = cost;
        for (std::size_t c = 0; c < 4; ++c) halves[c] = chosen[c];
    }
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

glm::dvec4 round_vector(const glm::dvec4& v, Halves allowed, std::span<std::uint16_t> halves) {
    glm::dvec4 out;
    for (int c = 0; c < 4; ++c) {
        const std::uint16_t half = nearest_half(v[c], allowed);
        halves[static_cast<std::size_t>(c)] = half;
        out[c] = value_of(half);
    }
    return out;
}

}  // namespace

void round_affine(const motion::Affine& matrix, const BoneMoment& moment, Halves allowed,
                  std::span<std::uint16_t, 12> halves) {
    for (int r = 0; r < 3; ++r)
        round_row({matrix.linear[0][r], matrix.linear[1][r], matrix.linear[2][r], matrix.translation[r]},
                  moment, allowed, std::span<std::uint16_t, 4>(&halves[static_cast<std::size_t>(4 * r)], 4));
}

void dualquat_numbers(const Similarity& target, double length, std::span<double, 8> numbers) {
    const glm::dvec4 dual = dual_of(target.rotation, target.translation, target.scale, length);
    for (int c = 0; c < 4; ++c) {
        numbers[static_cast<std::size_t>(c)] = target.rotation[c];
        numbers[static_cast<std::size_t>(4 + c)] = dual[c];
    }
}

void round_dualquat(const motion::Affine& exact, const Similarity& target, const BoneMoment& moment,
                    double length, Halves allowed, std::span<std::uint16_t, 8> halves, double span) {
    const glm::dvec3 centroid = moment.centroid();
    const glm::dvec3 kept = exact * centroid;
    double least = HUGE_VAL;
    for (int i = 0; i < kRealLengths; ++i) {
        std::array<std::uint16_t, 8> chosen{};
        DualNumbers n;
        const double real_length = 1.0 - span * i / (kRealLengths - 1);
        n.real = round_vector(real_length * target.rotation, allowed, std::span(chosen).first(4));
        const glm::dmat3 rotation = rotation_matrix(n.real);
        const glm::dvec3 translation = kept - target.scale * (rotation * centroid);
        n.dual = round_vector(dual_of(n.real, translation, target.scale, length), allowed,
                              std::span(chosen).last(4));
        const double cost = cost_of(matrix_of(n, rotation, length), exact, moment);
        if (i > 0 && !(cost < least)) continue;
        least = cost;
        for (std::size_t c = 0; c < 8; ++c) halves[c] = chosen[c];
    }
}

}  // namespace posepack::palette
