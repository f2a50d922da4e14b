// SPDX-License-Identifier: MIT
// Tracks of made-up bones: one that waves, one that waves faster, one that is still.
#pragma once

#include <cmath>

#include "fit/tracks.hpp"

namespace posepack::fit {

inline constexpr double kTurn = 6.283185307179586;

// Bones move along x by sin(2 pi k phase), k = `waves` for each bone; 0 is still.
inline Tracks wave_tracks(const std::vector<double>& waves, std::uint32_t keys, bool loop,
                          std::uint32_t per_key = 8) {
    Tracks tracks;
    tracks.form = Form::affine;
    tracks.loop = loop;
    tracks.bone_count = static_cast<std::uint32_t>(waves.size());
    tracks.key_intervals = keys;
    tracks.interval_count = keys * per_key;
    tracks.known_count = tracks.interval_count + (loop ? 0 : 1);
    tracks.turned.resize(waves.size());
    for (const double wave : waves)
        for (std::size_t k = 0; k < tracks.sample_count(); ++k) {
            const auto x = static_cast<float>(0.3 * std::sin(kTurn * wave * tracks.phase(k)));
            const float matrix[12] = {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0};
            tracks.numbers.insert(tracks.numbers.end(), matrix, matrix + 12);
            tracks.exact.insert(tracks.exact.end(), matrix, matrix + 12);
        }
    return tracks;
}

}  // namespace posepack::fit
