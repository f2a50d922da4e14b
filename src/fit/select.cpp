// SPDX-License-Identifier: MIT
#include "fit/select.hpp"

#include <algorithm>
#include <cmath>

#include "posepack/format.h"

namespace posepack::fit {
namespace {

constexpr double kShareAbove = 0.001;  // of places may lie above p99.9

// Numbers of intervals worth a try: the key grid's, its multiples, and below it some an octave.
std::vector<std::uint32_t> make_ladder(const Tracks& tracks, std::uint32_t finest) {
    std::vector<std::uint32_t> ladder{0};
    if (tracks.interval_count == 0) return ladder;
    const std::uint32_t keys = tracks.key_intervals;
    const std::uint32_t least = tracks.loop ? 2 : 1;
    for (double below = keys; below >= least; below *= 0.84)
        ladder.push_back(static_cast<std::uint32_t>(std::lround(below)));
    ladder.push_back(least);
    for (std::uint32_t times = 2; times <= finest; times *= 2) {
        ladder.push_back(keys * times);
        if (times * 3 / 2 <= finest) ladder.push_back(keys * times * 3 / 2);
    }
    std::sort(ladder.begin(), ladder.end());
    ladder.erase(std::unique(ladder.begin(), ladder.end()), ladder.end());
    std::erase_if(ladder, [&](std::uint32_t n) {
        return n > POSEPACK_RUN_MAX_INTERVALS || (n > 0 && 2 * n > tracks.interval_count && n > keys);
    });
    return ladder;
}

}  // namespace

RowSelector::RowSelector(const Tracks& tracks, const std::vector<BonePoints>& points, std::size_t point_count,
                         std::uint32_t row_bytes, double reach, double floor, std::uint32_t finest)
    : tracks_(tracks),
      points_(points),
      places_(static_cast<double>(point_count) * tracks.known_count),
      row_bytes_(row_bytes),
      reach_(reach),
      floor_(floor),
      ladder_(make_ladder(tracks, finest)),
      candidates_(tracks.bone_count) {}

// From coarse to fine; finer ones than the first without a place above the floor are never needed, and coarser
// ones than `max` allows are left out by their cost.
const std::vector<RowSelector::Candidate>& RowSelector::candidates(std::size_t bone, double max) {
    std::vector<Candidate>& known = candidates_[bone];
    while (known.size() < ladder_.size()) {
        if (!known.empty() && known.back().profile.max <= max && known.back().profile.count_above(floor_) == 0.0)
            break;
        const std::uint32_t intervals = ladder_[known.size()];
        Polyline line = fit_polyline(tracks_, bone, intervals);
        Profile profile = profile_of(tracks_, line, bone, points_[bone], reach_, floor_);
        known.push_back({intervals, std::move(line), profile});
    }
    return known;
}

double RowSelector::cost(const Candidate& candidate, const Limits& limits, const Prices& prices) const {
    if (candidate.profile.max > limits.max) return HUGE_VAL;
    double sum = static_cast<double>(row_bytes_) * (candidate.interval_count + 1.0);
    if (prices.count > 0.0) sum += prices.count * candidate.profile.count_above(limits.p999);
    return sum + prices.square * candidate.profile.square_sum;
}

std::size_t RowSelector::cheapest(std::size_t bone, const Limits& limits, const Prices& prices) const {
    const std::vector<Candidate>& known = candidates_[bone];
    std::size_t best = known.size() - 1;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < known.size(); ++i)
        if (const double value = cost(known[i], limits, prices); value < least) {
            least = value;
            best = i;
        }
    return best;
}

RowSelector::Totals RowSelector::totals(const Limits& limits, const Prices& prices) const {
    Totals sum;
    for (std::size_t bone = 0; bone < candidates_.size(); ++bone) {
        const Profile& profile = candidates_[bone][cheapest(bone, limits, prices)].profile;
        if (std::isfinite(limits.p999)) sum.count += profile.count_above(limits.p999);
        sum.square += profile.square_sum;
    }
    return sum;
}

// The lowest prices under which what is cheapest keeps the limits: each by bisection, in turn.
std::optional<RowSelector::Prices> RowSelector::find_prices(const Limits& limits) const {
    const double count_limit = std::isfinite(limits.p999) ? kShareAbove * places_ : HUGE_VAL;
    const double square_limit =
        std::isfinite(limits.rms) ? limits.rms * limits.rms * places_ : HUGE_VAL;
    Prices prices{0.0, 0.0};
    const auto settle = [&](double Prices::*price, double smallest, auto is_kept) {
        prices.*price = 0.0;
        if (is_kept()) return true;
        double low = std::log2(smallest);
        double high = low + 70.0;
        prices.*price = std::exp2(high);
        if (!is_kept()) return false;
        for (int i = 0; i < 24; ++i) {
            const double middle = 0.5 * (low + high);
            prices.*price = std::exp2(middle);
            (is_kept() ? high : low) = middle;
        }
        prices.*price = std::exp2(high);
        return true;
    };
    for (int turn = 0; turn < 3; ++turn) {
        if (!settle(&Prices::count, 1e-9, [&] { return totals(limits, prices).count <= count_limit; }))
            return std::nullopt;
        if (!settle(&Prices::square, 1e-3, [&] { return totals(limits, prices).square <= square_limit; }))
            return std::nullopt;
        if (totals(limits, prices).count <= count_limit) break;
    }
    return prices;
}

// A bone that moves like another shares its rows where that is cheaper, errors counted.
void RowSelector::join_alike(const Limits& limits, const Prices& prices, std::vector<BoneRows>& rows) {
    std::vector<std::uint32_t> order(rows.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return rows[a].interval_count < rows[b].interval_count;
    });
    std::vector<bool> is_shared(rows.size());
    const auto value_of = [&](const Profile& profile, double bytes) {
        if (profile.max > limits.max) return HUGE_VAL;
        if (prices.count > 0.0) bytes += prices.count * profile.count_above(limits.p999);
        return bytes + prices.square * profile.square_sum;
    };
    for (const std::uint32_t bone : order) {
        if (is_shared[bone]) continue;
        const Candidate& own = candidates_[bone][cheapest(bone, limits, prices)];
        double least = cost(own, limits, prices);
        for (const std::uint32_t other : order) {
            if (other == bone || rows[other].like != animal::kNone || points_[other].is_empty()) continue;
            if (distance_between(tracks_, other, bone, points_[bone], reach_, 2.0 * limits.max) >
                2.0 * limits.max)
                continue;
            const Polyline& line = candidates_[other][cheapest(other, limits, prices)].line;
            const double value =
                value_of(profile_of(tracks_, line, bone, points_[bone], reach_, floor_), 0.0);
            if (value >= least) continue;
            least = value;
            rows[bone].like = other;
        }
        if (rows[bone].like != animal::kNone) is_shared[rows[bone].like] = true;
    }
}

std::optional<std::vector<BoneRows>> RowSelector::select(const Limits& limits) {
    for (std::size_t bone = 0; bone < candidates_.size(); ++bone) {
        const std::vector<Candidate>& known = candidates(bone, limits.max);
        if (known.back().profile.max > limits.max) return std::nullopt;
    }
    const std::optional<Prices> prices = find_prices(limits);
    if (!prices) return std::nullopt;
    std::vector<BoneRows> rows(candidates_.size());
    for (std::size_t bone = 0; bone < rows.size(); ++bone)
        rows[bone].interval_count = candidates_[bone][cheapest(bone, limits, *prices)].interval_count;
    join_alike(limits, *prices, rows);
    return rows;
}

const Polyline& RowSelector::line(std::size_t bone, std::uint32_t interval_count) {
    for (const Candidate& candidate : candidates_[bone])
        if (candidate.interval_count == interval_count) return candidate.line;
    return candidates_[bone].back().line;
}

}  // namespace posepack::fit
