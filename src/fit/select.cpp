// SPDX-License-Identifier: MIT
#include "fit/select.hpp"

#include <algorithm>
#include <cmath>

#include "posepack/format.h"

namespace posepack::fit {
namespace {

constexpr double kHopeless = 4.0;      // times the largest error allowed
constexpr double kShareAbove = 0.001;  // of places may lie above p99.9

// Numbers of intervals worth a try: the key grid's, its multiples, and below it some an octave.
std::vector<std::uint32_t> make_ladder(const Tracks& tracks, std::uint32_t finest) {
    std::vector<std::uint32_t> ladder{0};
    if (tracks.interval_count == 0) return ladder;
    if (!tracks.slots.slots.empty()) return {0, tracks.slots.interval_count};
    const std::uint32_t keys = tracks.key_intervals;
    const std::uint32_t least = tracks.loop ? 2 : 1;
    for (double below = keys; below >= least; below *= 0.88)
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

// Where only the large errors are limited, samples that a first fit leaves far off weigh more in a second.
std::vector<float> weights_of(const std::vector<float>& errors, double p999) {
    constexpr double kLargest = 25.0;
    std::vector<float> weights;
    for (const float error : errors) {
        const double share = static_cast<double>(error) / p999;
        weights.push_back(static_cast<float>(1.0 + std::min(share * share, kLargest)));
    }
    return weights;
}

}  // namespace

RowSelector::RowSelector(const Tracks& tracks, const std::vector<BonePoints>& points, std::size_t point_count,
                         std::uint32_t row_bytes, double reach, double floor, std::uint32_t finest,
                         const Means& means)
    : tracks_(tracks),
      points_(points),
      places_(static_cast<double>(point_count) * tracks.known_count),
      row_bytes_(row_bytes),
      reach_(reach),
      floor_(floor),
      means_(means),
      ladder_(make_ladder(tracks, finest)),
      candidates_(tracks.bone_count) {}

// Errors so far above the limit are not looked at to the end.
RowSelector::Candidate RowSelector::make_candidate(std::size_t bone, std::uint32_t intervals,
                                                   const Limits& limits) const {
    const double enough = kHopeless * limits.max;
    if (!means_.least_squares) {
        Polyline sampled = sample_polyline(tracks_, bone, intervals);
        const Profile profile = profile_of(tracks_, sampled, bone, points_[bone], reach_, floor_, enough);
        return {intervals, std::move(sampled), profile, profile.max <= enough};
    }
    Polyline line = fit_polyline(tracks_, bone, intervals);
    std::vector<float> errors;
    Profile profile = profile_of(tracks_, line, bone, points_[bone], reach_, floor_, enough, &errors);
    if (profile.max > enough) return {intervals, std::move(line), profile, false};
    if (!std::isfinite(limits.rms) && intervals > 0 && profile.max > floor_) {
        line = fit_polyline(tracks_, bone, intervals, weights_of(errors, limits.p999));
        profile = profile_of(tracks_, line, bone, points_[bone], reach_, floor_);
    }
    return {intervals, std::move(line), profile, true};
}

// From coarse to fine, until nothing is to be gained: no place above the floor, and a mean square that does
// not count.
const std::vector<RowSelector::Candidate>& RowSelector::candidates(std::size_t bone, const Limits& limits) {
    std::vector<Candidate>& known = candidates_[bone];
    const double small = std::isfinite(limits.rms) ? 0.1 * limits.rms * limits.rms * places_ /
                                                         static_cast<double>(candidates_.size())
                                                   : HUGE_VAL;
    for (Candidate& candidate : known)
        if (!candidate.is_whole && candidate.profile.max <= kHopeless / 2.0 * limits.max)
            candidate = make_candidate(bone, candidate.interval_count, limits);
    while (known.size() < ladder_.size()) {
        if (!known.empty()) {
            const Profile& last = known.back().profile;
            if (last.max <= limits.max && last.count_above(floor_) == 0.0 && last.square_sum <= small) break;
        }
        known.push_back(make_candidate(bone, ladder_[known.size()], limits));
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
    const double square_limit = std::isfinite(limits.rms) ? limits.rms * limits.rms * places_ : HUGE_VAL;
    Prices prices{0.0, 0.0};
    const auto settle = [&](double Prices::*price, double smallest, auto is_kept) {
        prices.*price = 0.0;
        if (is_kept()) return true;
        double low = smallest;
        double high = smallest * 0x1p70;
        prices.*price = high;
        if (!is_kept()) return false;
        for (int i = 0; i < 24; ++i) {
            const double middle = std::sqrt(low * high);
            prices.*price = middle;
            (is_kept() ? high : low) = middle;
        }
        prices.*price = high;
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

const Profile& RowSelector::profile(std::size_t bone, const Pick& pick) const {
    return pick.shared ? *pick.shared : candidates_[bone][pick.candidate].profile;
}

Limits RowSelector::expected(const std::vector<Pick>& picks) const {
    Limits out;
    double square = 0.0;
    std::vector<const Profile*> profiles;
    for (std::size_t bone = 0; bone < picks.size(); ++bone) {
        profiles.push_back(&profile(bone, picks[bone]));
        out.max = std::max(out.max, profiles.back()->max);
        square += profiles.back()->square_sum;
    }
    out.rms = std::sqrt(square / places_);
    // The distance that a thousandth of the places lies above.
    double low = floor_;
    double high = std::max(out.max, floor_);
    for (int i = 0; i < 24; ++i) {
        const double middle = std::sqrt(low * high);
        double count = 0.0;
        for (const Profile* one : profiles) count += one->count_above(middle);
        (count > kShareAbove * places_ ? low : high) = middle;
    }
    out.p999 = high;
    return out;
}

// How much of the limits on places and on the mean square is taken.
class RowSelector::Room {
 public:
    Room(const Limits& limits, double places)
        : p999_(limits.p999),
          count_limit_(std::isfinite(limits.p999) ? kShareAbove * places : HUGE_VAL),
          square_limit_(std::isfinite(limits.rms) ? limits.rms * limits.rms * places : HUGE_VAL) {}

    void add(const Profile& profile) {
        count_ += count_of(profile);
        square_ += profile.square_sum;
    }
    void exchange(const Profile& before, const Profile& after) {
        count_ += count_of(after) - count_of(before);
        square_ += after.square_sum - before.square_sum;
    }
    bool allows(const Profile& before, const Profile& after) const {
        const double more = count_of(after) - count_of(before);
        const double wider = after.square_sum - before.square_sum;
        return (more <= 0.0 || count_ + more <= count_limit_) &&
               (wider <= 0.0 || square_ + wider <= square_limit_);
    }
    // The larger share of a limit that the change takes.
    double taken(const Profile& before, const Profile& after) const {
        return std::max((count_of(after) - count_of(before)) / count_limit_,
                        (after.square_sum - before.square_sum) / square_limit_);
    }

 private:
    double count_of(const Profile& profile) const {
        return std::isfinite(p999_) ? profile.count_above(p999_) : 0.0;
    }
    double p999_, count_limit_, square_limit_;
    double count_ = 0.0, square_ = 0.0;
};

// The profile of `bone` under another's rows. One that stopped at a distance stands where that is still too
// far.
const Profile& RowSelector::shared_profile(std::uint32_t bone, std::uint32_t other, std::size_t candidate,
                                           const Limits& limits) {
    const Candidate& rows = candidates_[other][candidate];
    Shared& shared = shared_[{bone, other, rows.interval_count}];
    if (!shared.profile || (shared.profile->max > shared.enough && shared.profile->max <= limits.max)) {
        shared.profile = profile_of(tracks_, rows.line, bone, points_[bone], reach_, floor_, limits.max);
        shared.enough = limits.max;
    }
    return *shared.profile;
}

// A bone that moves like another shares its rows where that is cheaper, errors counted, and there is room.
void RowSelector::join_alike(const Limits& limits, const Prices& prices, Room& room,
                             std::vector<Pick>& picks) {
    std::vector<std::uint32_t> order(picks.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return picks[a].candidate < picks[b].candidate;
    });
    const auto value_of = [&](const Profile& profile) {
        if (profile.max > limits.max) return HUGE_VAL;
        const double above = prices.count > 0.0 ? prices.count * profile.count_above(limits.p999) : 0.0;
        return above + prices.square * profile.square_sum;
    };
    for (const std::uint32_t bone : order) {
        if (picks[bone].is_shared || points_[bone].is_empty()) continue;
        const Candidate& own = candidates_[bone][picks[bone].candidate];
        double least = cost(own, limits, prices);
        for (const std::uint32_t other : order) {
            if (other == bone || picks[other].like != animal::kNone || points_[other].is_empty()) continue;
            const double far = 2.0 * limits.max;
            if (distance_between(tracks_, other, bone, points_[bone], reach_, far) > far) continue;
            const Profile& shared = shared_profile(bone, other, picks[other].candidate, limits);
            const double value = value_of(shared);
            if (value >= least || !room.allows(own.profile, shared)) continue;
            least = value;
            picks[bone].like = other;
            picks[bone].shared = shared;
        }
        if (picks[bone].like == animal::kNone) continue;
        picks[picks[bone].like].is_shared = true;
        room.exchange(own.profile, *picks[bone].shared);
    }
}

// Prices leave some room below the limits: it is given to the bones that save most for what they take of it.
void RowSelector::spend_slack(const Limits& limits, Room& room, std::vector<Pick>& picks) const {
    for (;;) {
        double best = 0.0;
        std::size_t best_bone = 0, best_candidate = 0;
        for (std::size_t bone = 0; bone < picks.size(); ++bone) {
            const Pick& pick = picks[bone];
            if (pick.like != animal::kNone || pick.is_shared) continue;
            const Candidate& now = candidates_[bone][pick.candidate];
            for (std::size_t i = 0; i < pick.candidate; ++i) {
                const Candidate& next = candidates_[bone][i];
                if (next.profile.max > limits.max || !room.allows(now.profile, next.profile)) continue;
                const double taken = std::max(room.taken(now.profile, next.profile), 1e-9);
                const double worth = (now.interval_count - next.interval_count) / taken;
                if (worth <= best) continue;
                best = worth;
                best_bone = bone;
                best_candidate = i;
            }
        }
        if (best <= 0.0) return;
        room.exchange(profile(best_bone, picks[best_bone]), candidates_[best_bone][best_candidate].profile);
        picks[best_bone].candidate = best_candidate;
    }
}

// Gives all bones that move as many rows as the one that has most.
void RowSelector::level(const Limits& limits, std::vector<Pick>& picks) {
    std::size_t most = 0;
    for (const Pick& pick : picks) most = std::max(most, pick.candidate);
    for (std::size_t bone = 0; bone < picks.size(); ++bone) {
        if (picks[bone].candidate == 0) continue;
        std::vector<Candidate>& known = candidates_[bone];
        while (known.size() <= most) known.push_back(make_candidate(bone, ladder_[known.size()], limits));
        picks[bone].candidate = most;
    }
}

std::optional<Selection> RowSelector::select(const Limits& limits) {
    for (std::size_t bone = 0; bone < candidates_.size(); ++bone)
        if (candidates(bone, limits).back().profile.max > limits.max) return std::nullopt;
    const std::optional<Prices> prices = find_prices(limits);
    if (!prices) return std::nullopt;
    std::vector<Pick> picks(candidates_.size());
    for (std::size_t bone = 0; bone < picks.size(); ++bone)
        picks[bone].candidate = cheapest(bone, limits, *prices);
    if (!means_.own_rows) level(limits, picks);
    Room room(limits, places_);
    for (std::size_t bone = 0; bone < picks.size(); ++bone) room.add(profile(bone, picks[bone]));
    if (means_.sharing) join_alike(limits, *prices, room, picks);
    if (means_.own_rows) spend_slack(limits, room, picks);
    Selection out;
    out.expected = expected(picks);
    for (std::size_t bone = 0; bone < picks.size(); ++bone)
        out.rows.push_back({candidates_[bone][picks[bone].candidate].interval_count, picks[bone].like});
    return out;
}

const Polyline& RowSelector::line(std::size_t bone, std::uint32_t interval_count) {
    for (const Candidate& candidate : candidates_[bone])
        if (candidate.interval_count == interval_count) return candidate.line;
    return candidates_[bone].back().line;
}

}  // namespace posepack::fit
