// SPDX-License-Identifier: MIT
// How many rows each bone gets, so that the clip keeps a bound with the fewest bytes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "fit/profile.hpp"

namespace posepack::fit {

// What a clip may be off by, fractions of R.
struct Limits {
    double max = 0.0, p999 = 0.0, rms = 0.0;  // HUGE_VAL: no limit
};

// The rows of one bone: a polyline of its own, or that of the bone it moves like.
struct BoneRows {
    std::uint32_t interval_count = 0;
    std::uint32_t like = animal::kNone;  // another bone, which has rows of its own
    bool operator==(const BoneRows&) const = default;
};

// Rows of every bone, and what single bones tell of their error: those of several bones on one vertex are
// taken as if each were alone.
struct Selection {
    std::vector<BoneRows> rows;
    Limits expected;
};

// What the selector may use. All of it, but where the worth of each is measured.
struct Means {
    bool own_rows = true;       // else all moving bones have as many rows as the one that needs most
    bool sharing = true;        // bones that move alike read one run
    bool least_squares = true;  // else rows are samples of the motion
};

// Looks for rows under changing limits; what was fitted and measured is kept.
class RowSelector {
 public:
    //   row_bytes  of one bone-row
    //   reach  R in units of palette space
    //   finest  rows at most so many times as many as the key grid's; the tracks hold twice as many samples.
    //           With slots a bone has their rows or none.
    RowSelector(const Tracks& tracks, const std::vector<BonePoints>& points, std::size_t point_count,
                std::uint32_t row_bytes, double reach, double floor, std::uint32_t finest,
                const Means& means = {});

    // The cheapest rows whose expected errors keep the limits. Nothing where the finest rows are not enough.
    std::optional<Selection> select(const Limits& limits);

    // The polyline that select() means by so many intervals.
    const Polyline& line(std::size_t bone, std::uint32_t interval_count);

 private:
    struct Candidate {
        std::uint32_t interval_count;
        Polyline line;
        Profile profile;
        bool is_whole;  // else profile.max is a distance that was enough to stop at
    };
    struct Prices {
        double count, square;  // bytes for a place above p99.9, and for a unit of square
    };
    // What a bone takes: a candidate of its own, or another bone's line with the profile it has under that.
    struct Pick {
        std::size_t candidate = 0;
        std::uint32_t like = animal::kNone;
        std::optional<Profile> shared;
        bool is_shared = false;  // others read its rows
    };
    void level(const Limits& limits, std::vector<Pick>& picks);
    Candidate make_candidate(std::size_t bone, std::uint32_t intervals, const Limits& limits) const;
    const std::vector<Candidate>& candidates(std::size_t bone, const Limits& limits);
    const Profile& profile(std::size_t bone, const Pick& pick) const;
    Limits expected(const std::vector<Pick>& picks) const;
    class Room;
    void spend_slack(const Limits& limits, Room& room, std::vector<Pick>& picks) const;
    double cost(const Candidate& candidate, const Limits& limits, const Prices& prices) const;
    std::size_t cheapest(std::size_t bone, const Limits& limits, const Prices& prices) const;
    struct Totals {
        double count = 0.0, square = 0.0;
    };
    Totals totals(const Limits& limits, const Prices& prices) const;
    std::optional<Prices> find_prices(const Limits& limits) const;
    void join_alike(const Limits& limits, const Prices& prices, Room& room, std::vector<Pick>& picks);
    struct Shared {
        std::optional<Profile> profile;
        double enough = 0.0;
    };
    const Profile& shared_profile(std::uint32_t bone, std::uint32_t other, std::size_t candidate,
                                  const Limits& limits);

    const Tracks& tracks_;
    const std::vector<BonePoints>& points_;
    double places_;  // (vertices x samples) of the clip
    std::uint32_t row_bytes_;
    double reach_, floor_;
    Means means_;
    std::vector<std::uint32_t> ladder_;  // rising
    std::vector<std::vector<Candidate>> candidates_;
    std::map<std::array<std::uint32_t, 3>, Shared> shared_;  // by bone, the other and its intervals
};

}  // namespace posepack::fit
