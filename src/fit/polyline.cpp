// SPDX-License-Identifier: MIT
#include "fit/polyline.hpp"

#include <algorithm>
#include <cmath>

namespace posepack::fit {
namespace {

// What nothing is known of weighs a little, so that every row has a place.
constexpr double kUnknownWeight = 1e-4;

// The normal equations of a polyline: a symmetric matrix with three diagonals and, of a loop, two corners.
struct Normal {
    std::vector<double> diagonal, above;  // above[j] couples j and j + 1
    double corner = 0.0;                  // couples the last and 0
    std::vector<double> right;            // [row][column]
    std::size_t columns = 0;
};

struct Place {
    std::size_t row;
    double factor;
};

Place place_of(double phase, std::uint32_t intervals) {
    const double position = phase * intervals;
    const auto row = std::min(static_cast<std::size_t>(position), std::size_t{intervals} - 1);
    return {row, position - static_cast<double>(row)};
}

// Solves a symmetric positive system by elimination, right sides in place: small ones of any shape.
void solve_dense(std::vector<double>& a, std::size_t n, std::vector<double>& b, std::size_t columns) {
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            const double share = a[j * n + i] / a[i * n + i];
            if (share == 0.0) continue;
            for (std::size_t k = i; k < n; ++k) a[j * n + k] -= share * a[i * n + k];
            for (std::size_t c = 0; c < columns; ++c) b[j * columns + c] -= share * b[i * columns + c];
        }
    for (std::size_t i = n; i-- > 0;)
        for (std::size_t c = 0; c < columns; ++c) {
            double sum = b[i * columns + c];
            for (std::size_t k = i + 1; k < n; ++k) sum -= a[i * n + k] * b[k * columns + c];
            b[i * columns + c] = sum / a[i * n + i];
        }
}

// Thomas' algorithm, several right sides at once.
void solve_tridiagonal(std::vector<double> diagonal, const std::vector<double>& above, std::vector<double>& b,
                       std::size_t columns) {
    const std::size_t n = diagonal.size();
    for (std::size_t i = 1; i < n; ++i) {
        const double share = above[i - 1] / diagonal[i - 1];
        diagonal[i] -= share * above[i - 1];
        for (std::size_t c = 0; c < columns; ++c) b[i * columns + c] -= share * b[(i - 1) * columns + c];
    }
    for (std::size_t i = n; i-- > 0;)
        for (std::size_t c = 0; c < columns; ++c) {
            double sum = b[i * columns + c];
            if (i + 1 < n) sum -= above[i] * b[(i + 1) * columns + c];
            b[i * columns + c] = sum / diagonal[i];
        }
}

void solve(Normal& normal) {
    const std::size_t n = normal.diagonal.size();
    if (n <= 4) {
        std::vector<double> dense(n * n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            dense[i * n + i] += normal.diagonal[i];
            if (i + 1 < n) {
                dense[i * n + i + 1] += normal.above[i];
                dense[(i + 1) * n + i] += normal.above[i];
            }
        }
        dense[n - 1] += normal.corner;
        dense[(n - 1) * n] += normal.corner;
        return solve_dense(dense, n, normal.right, normal.columns);
    }
    if (normal.corner == 0.0)
        return solve_tridiagonal(normal.diagonal, normal.above, normal.right, normal.columns);
    // Sherman and Morrison: the corners as a matrix of rank one, u u' / gamma (Press et al., Numerical
    // Recipes, section 2.7).
    const double gamma = -normal.diagonal[0];
    std::vector<double> diagonal = normal.diagonal;
    diagonal[0] -= gamma;
    diagonal[n - 1] -= normal.corner * normal.corner / gamma;
    solve_tridiagonal(diagonal, normal.above, normal.right, normal.columns);
    std::vector<double> u(n, 0.0);
    u[0] = gamma;
    u[n - 1] = normal.corner;
    solve_tridiagonal(diagonal, normal.above, u, 1);
    const double ratio = normal.corner / gamma;
    const double scale = 1.0 / (1.0 + u[0] + ratio * u[n - 1]);
    for (std::size_t c = 0; c < normal.columns; ++c) {
        const double share = scale * (normal.right[c] + ratio * normal.right[(n - 1) * normal.columns + c]);
        for (std::size_t i = 0; i < n; ++i) normal.right[i * normal.columns + c] -= share * u[i];
    }
}

// Columns [first, last) of the track, which close with `sign` of their first row when it is a loop.
void fit_columns(const Tracks& tracks, std::size_t bone, std::size_t first, std::size_t last, double sign,
                 std::span<const float> weights, Polyline& line) {
    const std::uint32_t intervals = line.interval_count;
    const std::size_t width = numbers_of(tracks.form);
    const std::size_t rows = std::size_t{intervals} + (tracks.loop ? 0 : 1);
    Normal normal;
    normal.columns = last - first;
    normal.diagonal.assign(rows, 0.0);
    normal.above.assign(rows, 0.0);
    normal.right.assign(rows * normal.columns, 0.0);
    const std::size_t samples = tracks.loop ? tracks.interval_count : tracks.sample_count();
    for (std::size_t k = 0; k < samples; ++k) {
        const double weight = k >= tracks.known_count ? kUnknownWeight
                              : weights.empty()       ? 1.0
                                                      : static_cast<double>(weights[k]);
        const Place place = place_of(tracks.phase(k), intervals);
        const bool wraps = tracks.loop && place.row + 1 == intervals;
        const std::size_t next = wraps ? 0 : place.row + 1;
        const double a = 1.0 - place.factor;
        const double b = (wraps ? sign : 1.0) * place.factor;
        normal.diagonal[place.row] += weight * a * a;
        normal.diagonal[next] += weight * b * b;
        if (wraps)
            normal.corner += weight * a * b;
        else
            normal.above[place.row] += weight * a * b;
        const std::span<const float> numbers = tracks.numbers_at(bone, k);
        for (std::size_t c = 0; c < normal.columns; ++c) {
            const double value = weight * static_cast<double>(numbers[first + c]);
            normal.right[place.row * normal.columns + c] += a * value;
            normal.right[next * normal.columns + c] += b * value;
        }
    }
    if (rows == 1) {  // one interval of a loop that closes on itself: a pose
        normal.diagonal[0] += 2.0 * normal.corner;
        normal.corner = 0.0;
        for (std::size_t c = 0; c < normal.columns; ++c) normal.right[c] /= normal.diagonal[0];
    } else {
        solve(normal);
    }
    for (std::size_t row = 0; row <= intervals; ++row)
        for (std::size_t c = 0; c < normal.columns; ++c)
            line.rows[row * width + first + c] =
                row < rows ? normal.right[row * normal.columns + c] : sign * normal.right[c];
}

void hold_means(const Tracks& tracks, std::size_t bone, Polyline& line) {
    const std::size_t width = numbers_of(tracks.form);
    std::vector<double> counts(line.interval_count + std::size_t{1}, 0.0);
    for (std::size_t k = 0; k < tracks.known_count; ++k) {
        const bool is_end = k == tracks.interval_count;
        const std::size_t row =
            is_end ? line.interval_count : place_of(tracks.phase(k), line.interval_count).row;
        counts[row] += 1.0;
        for (std::size_t c = 0; c < width; ++c)
            line.rows[row * width + c] += static_cast<double>(tracks.numbers_at(bone, k)[c]);
    }
    for (std::size_t row = 0; row <= line.interval_count; ++row)
        for (std::size_t c = 0; c < width; ++c) {
            double& number = line.rows[row * width + c];
            if (counts[row] > 0.0)
                number /= counts[row];
            else  // behind the last key of an open loop the last pose is held; at the end of a loop the first
                number = row == line.interval_count ? line.rows[c] : line.rows[(row - 1) * width + c];
        }
    if (!tracks.loop || !tracks.turned[bone]) return;
    for (std::size_t c = 0; c < 8; ++c) line.rows[line.interval_count * width + c] = -line.rows[c];
}

void mean_pose(const Tracks& tracks, std::size_t bone, Polyline& line) {
    const std::size_t width = numbers_of(tracks.form);
    for (std::size_t k = 0; k < tracks.known_count; ++k)
        for (std::size_t c = 0; c < width; ++c)
            line.rows[c] += static_cast<double>(tracks.numbers_at(bone, k)[c]) / tracks.known_count;
}

}  // namespace

Polyline fit_polyline(const Tracks& tracks, std::size_t bone, std::uint32_t interval_count,
                      std::span<const float> weights) {
    const std::size_t width = numbers_of(tracks.form);
    Polyline line;
    line.interval_count = tracks.interval_count == 0 ? 0 : interval_count;
    line.rows.assign((std::size_t{line.interval_count} + 1) * width, 0.0);
    if (line.interval_count == 0)
        mean_pose(tracks, bone, line);
    else if (tracks.step)
        hold_means(tracks, bone, line);
    else if (tracks.loop && tracks.turned[bone]) {
        fit_columns(tracks, bone, 0, 8, -1.0, weights, line);
        fit_columns(tracks, bone, 8, width, 1.0, weights, line);
    } else {
        fit_columns(tracks, bone, 0, width, 1.0, weights, line);
    }
    return line;
}

Polyline sample_polyline(const Tracks& tracks, std::size_t bone, std::uint32_t interval_count) {
    const std::size_t width = numbers_of(tracks.form);
    Polyline line;
    line.interval_count = tracks.interval_count == 0 ? 0 : interval_count;
    std::size_t after = 0;  // the first sample at the row or behind it
    for (std::uint32_t row = 0; row <= line.interval_count; ++row) {
        const double phase = line.interval_count == 0 ? 0.0 : static_cast<double>(row) / line.interval_count;
        while (after < tracks.interval_count && tracks.phase(after) < phase) ++after;
        const std::size_t before = after == 0 ? 0 : after - 1;
        const double span = tracks.phase(after) - tracks.phase(before);
        const double factor = span > 0.0 ? (phase - tracks.phase(before)) / span : 0.0;
        for (std::size_t c = 0; c < width; ++c)
            line.rows.push_back(static_cast<double>(tracks.numbers_at(bone, before)[c]) * (1.0 - factor) +
                                static_cast<double>(tracks.numbers_at(bone, after)[c]) * factor);
    }
    return line;
}

void blend_numbers(const Polyline& line, std::size_t width, bool step, double phase, double* numbers) {
    if (line.interval_count == 0) {
        std::copy_n(line.rows.begin(), width, numbers);
        return;
    }
    const Place place = place_of(phase, line.interval_count);
    const double* a = &line.rows[place.row * width];
    if (step && place.factor < 1.0) {
        std::copy_n(a, width, numbers);
        return;
    }
    for (std::size_t c = 0; c < width; ++c)
        numbers[c] = a[c] * (1.0 - place.factor) + a[width + c] * place.factor;
}

}  // namespace posepack::fit
