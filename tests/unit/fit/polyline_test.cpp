// SPDX-License-Identifier: MIT
// Least squares: exact where the motion is a polyline, optimal where it is not, and closed where it loops.
#include "fit/polyline.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "wave.hpp"

namespace posepack::fit {
namespace {

double square_error(const Tracks& tracks, const Polyline& line) {
    double sum = 0.0;
    std::array<double, 12> numbers{};
    for (std::size_t k = 0; k < tracks.known_count; ++k) {
        blend_numbers(line, 12, tracks.step, tracks.phase(k), numbers.data());
        for (std::size_t c = 0; c < 12; ++c) {
            const double d = numbers[c] - static_cast<double>(tracks.numbers_at(0, k)[c]);
            sum += d * d;
        }
    }
    return sum;
}

TEST(Polyline, IsExactWhereTheMotionIsOne) {
    for (const bool loop : {false, true}) {
        Tracks tracks = wave_tracks({1.0}, 12, loop);
        const Polyline truth = fit_polyline(tracks, 0, 6);
        std::array<double, 12> numbers{};
        for (std::size_t k = 0; k < tracks.sample_count(); ++k) {
            blend_numbers(truth, 12, false, tracks.phase(k), numbers.data());
            for (std::size_t c = 0; c < 12; ++c) tracks.numbers[k * 12 + c] = static_cast<float>(numbers[c]);
        }
        const Polyline again = fit_polyline(tracks, 0, 6);
        for (std::size_t i = 0; i < again.rows.size(); ++i) EXPECT_NEAR(again.rows[i], truth.rows[i], 1e-6);
        EXPECT_LT(square_error(tracks, again), 1e-10);
    }
}

TEST(Polyline, IsTheBestOfItsKind) {
    std::mt19937 random(7);
    std::normal_distribution<double> step(0.0, 0.01);
    for (const std::uint32_t intervals : {1u, 2u, 3u, 5u, 8u, 13u})
        for (const bool loop : {false, true}) {
            if (loop && intervals == 1) continue;
            const Tracks tracks = wave_tracks({1.5}, 20, loop);
            const Polyline best = fit_polyline(tracks, 0, intervals);
            const double least = square_error(tracks, best);
            for (int round = 0; round < 50; ++round) {
                Polyline other = best;
                for (std::size_t row = 0; row <= intervals; ++row) other.rows[row * 12 + 3] += step(random);
                if (loop) other.rows[intervals * 12 + 3] = other.rows[3];
                EXPECT_GE(square_error(tracks, other), least - 1e-12) << intervals << " " << loop;
            }
            for (std::size_t c = 0; loop && c < 12; ++c)
                EXPECT_EQ(best.rows[c], best.rows[intervals * 12 + c]);
        }
}

TEST(Polyline, TwiceTheRowsAreNeverWorse) {
    for (const bool loop : {false, true}) {
        const Tracks tracks = wave_tracks({2.0}, 32, loop);
        double before = HUGE_VAL;
        for (std::uint32_t intervals = 2; intervals <= 64; intervals *= 2) {
            const double error = square_error(tracks, fit_polyline(tracks, 0, intervals));
            EXPECT_LE(error, before * (1 + 1e-9)) << intervals;
            before = error;
        }
    }
}

TEST(Polyline, OfATurnedLoopEndsInTheOtherHemisphere) {
    Tracks tracks;
    tracks.form = Form::dualquat;
    tracks.loop = true;
    tracks.bone_count = 1;
    tracks.key_intervals = 16;
    tracks.interval_count = 128;
    tracks.known_count = 128;
    tracks.turned = {true};
    for (std::size_t k = 0; k <= 128; ++k) {  // one whole turn about z: q goes half way round
        const double half = 0.5 * kTurn * tracks.phase(k);
        const float numbers[9] = {
            0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half)), 0, 0, 0, 0, 1};
        tracks.numbers.insert(tracks.numbers.end(), numbers, numbers + 9);
    }
    const Polyline line = fit_polyline(tracks, 0, 16);
    for (std::size_t c = 0; c < 8; ++c) EXPECT_EQ(line.rows[16 * 9 + c], -line.rows[c]);
    EXPECT_NEAR(line.rows[16 * 9 + 8], 1.0, 1e-9) << "a scale has no sign to turn";
    for (std::size_t row = 0; row < 16; ++row) {
        const double half = 0.5 * kTurn * static_cast<double>(row) / 16.0;
        EXPECT_NEAR(line.rows[row * 9 + 2], std::sin(half), 4e-3);
        EXPECT_NEAR(line.rows[row * 9 + 3], std::cos(half), 4e-3);
    }
}

TEST(Polyline, OfHeldPosesHoldsThem) {
    Tracks tracks = wave_tracks({1.0}, 4, false);
    tracks.step = true;
    for (std::size_t k = 0; k < tracks.sample_count(); ++k)
        tracks.numbers[k * 12 + 3] = static_cast<float>(std::floor(tracks.phase(k) * 4.0));
    const Polyline line = fit_polyline(tracks, 0, 4);
    for (std::size_t row = 0; row <= 4; ++row) EXPECT_EQ(line.rows[row * 12 + 3], static_cast<double>(row));
    EXPECT_EQ(square_error(tracks, line), 0.0);
}

TEST(Polyline, WeightsPullItTowardsWhatWeighs) {
    const Tracks tracks = wave_tracks({1.0}, 8, false);
    std::vector<float> weights(tracks.known_count, 1.0f);
    weights[16] = 1000.0f;  // the crest, which two intervals cut off
    std::array<double, 12> plain{}, pulled{};
    blend_numbers(fit_polyline(tracks, 0, 2), 12, false, tracks.phase(16), plain.data());
    blend_numbers(fit_polyline(tracks, 0, 2, weights), 12, false, tracks.phase(16), pulled.data());
    const auto exact = static_cast<double>(tracks.numbers_at(0, 16)[3]);
    EXPECT_LT(std::abs(pulled[3] - exact), 0.1 * std::abs(plain[3] - exact));
}

TEST(SamplePolyline, GoesThroughTheTrackAtItsRows) {
    const Tracks tracks = wave_tracks({1.0}, 12, false);
    const Polyline line = sample_polyline(tracks, 0, 5);
    ASSERT_EQ(line.interval_count, 5u);
    double numbers[kAffineNumbers];
    for (std::uint32_t row = 0; row <= 5; ++row) {
        blend_numbers(line, kAffineNumbers, false, row / 5.0, numbers);
        EXPECT_NEAR(numbers[3], 0.3 * std::sin(kTurn * row / 5.0), 2e-3) << row;
    }
    // Least squares lie nearer to it on the whole.
    const auto square_sum = [&](const Polyline& of) {
        double sum = 0.0;
        for (std::size_t k = 0; k < tracks.sample_count(); ++k) {
            blend_numbers(of, kAffineNumbers, false, tracks.phase(k), numbers);
            const double off = numbers[3] - static_cast<double>(tracks.numbers_at(0, k)[3]);
            sum += off * off;
        }
        return sum;
    };
    EXPECT_LT(square_sum(fit_polyline(tracks, 0, 5)), 0.5 * square_sum(line));
}

}  // namespace
}  // namespace posepack::fit
