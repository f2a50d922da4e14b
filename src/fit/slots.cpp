// SPDX-License-Identifier: MIT
#include "fit/slots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "posepack/format.h"

namespace posepack::fit {
namespace {

constexpr std::uint32_t kMostSlotsAnInterval = 255;
constexpr std::array<std::uint32_t, 7> kCuts = {2, 3, 4, 6, 8, 12, 16};
constexpr std::uint32_t kSamplesOfALongInterval = 4;  // a key that are looked at
constexpr double kEqualTimesS = 2e-6;

// Tells whether straight lines between two samples stay near the tracks.
class Chords {
 public:
    Chords(const Tracks& tracks, const std::vector<BonePoints>& points, double limit, double reach)
        : tracks_(tracks),
          points_(points),
          limit_square_(static_cast<float>(limit * limit)),
          scale_(static_cast<float>(1 / reach)) {
        for (std::size_t bone = 0; bone < points.size(); ++bone)
            if (!points[bone].is_empty()) bones_.push_back(bone);
    }

    // Between samples `first` and `last`, every `step`-th sample between them looked at.
    //   toward  the sample that the lines go through: `last`, or the one before where the pose jumps there
    bool are_near(std::size_t first, std::size_t last, std::size_t toward, std::size_t step) {
        for (std::size_t i = 0; i < bones_.size(); ++i) {
            for (std::size_t k = first + step; k < last; k += step) {
                if (k >= tracks_.known_count || is_near(bones_[i], first, toward, k)) continue;
                // A bone that left the line once will again.
                std::rotate(bones_.begin(), bones_.begin() + static_cast<std::ptrdiff_t>(i),
                            bones_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
                return false;
            }
        }
        return true;
    }

 private:
    bool is_near(std::size_t bone, std::size_t first, std::size_t toward, std::size_t k) const {
        const std::size_t width = numbers_of(tracks_.form);
        const std::span<const float> a = tracks_.numbers_at(bone, first);
        const std::span<const float> b = tracks_.numbers_at(bone, toward);
        const double factor = static_cast<double>(k - first) / static_cast<double>(toward - first);
        std::array<double, kAffineNumbers> blend{};
        for (std::size_t c = 0; c < width; ++c)
            blend[c] = static_cast<double>(a[c]) * (1.0 - factor) + static_cast<double>(b[c]) * factor;
        return largest_square(tracks_, bone, k, blend.data(), points_[bone], scale_) <= limit_square_;
    }

    const Tracks& tracks_;
    const std::vector<BonePoints>& points_;
    float limit_square_, scale_;
    std::vector<std::size_t> bones_;
};

// Keys at which a channel jumps.
std::vector<bool> jumps_at_keys(std::uint32_t keys, double period_s,
                                const std::vector<double>& jump_times_s) {
    std::vector<bool> jumps(keys + std::size_t{1}, false);
    for (const double time_s : jump_times_s) {
        const double key = std::round(time_s / period_s * keys);
        if (key > 0.0 && key < keys && std::abs(key / keys * period_s - time_s) <= kEqualTimesS)
            jumps[static_cast<std::size_t>(key)] = true;
    }
    return jumps;
}

}  // namespace

SlotPlan plan_slots(const Tracks& tracks, const std::vector<BonePoints>& points, double limit, double reach,
                    double period_s, const std::vector<double>& jump_times_s) {
    SlotPlan plan;
    const std::uint32_t keys = tracks.key_intervals;
    if (tracks.interval_count == 0 || tracks.step || keys == 0) return plan;
    const std::size_t per_key = tracks.interval_count / keys;
    const std::size_t step = std::max<std::size_t>(1, per_key / kSamplesOfALongInterval);
    const std::vector<bool> jumps = jumps_at_keys(keys, period_s, jump_times_s);
    Chords chords(tracks, points, limit, reach);
    const auto are_near = [&](std::size_t first, std::size_t last, std::size_t every) {
        const bool jump = last % per_key == 0 && jumps[last / per_key] && last > first + 1;
        return chords.are_near(first, last, jump ? last - 1 : last, every);
    };
    std::uint32_t row = 0;
    for (std::uint32_t key = 0; key < keys;) {
        if (jumps[key]) ++row;  // the row that the slot before ends at is not this one's
        std::uint32_t length = 0;
        while (key + length < keys && length < kMostSlotsAnInterval &&
               (length == 0 || !jumps[key + length]) &&
               are_near(key * per_key, (key + length + 1) * per_key, step))
            ++length;
        if (length > 0) {
            for (std::uint32_t slot = 0; slot < length; ++slot) plan.slots.push_back({row, slot, length});
            row += 1;
            key += length;
            continue;
        }
        std::uint32_t cut = 1;
        bool near = false;
        for (const std::uint32_t parts : kCuts) {
            if (near || per_key % parts != 0 || per_key < 2 * parts) continue;
            cut = parts;
            near = true;
            for (std::uint32_t part = 0; part < parts && near; ++part)
                near = are_near(key * per_key + part * per_key / parts,
                                key * per_key + (part + 1) * per_key / parts, 1);
        }
        plan.is_rough |= !near;
        plan.slots.push_back({row, cut, 0});
        row += cut;
        ++key;
    }
    plan.interval_count = row;
    return row <= POSEPACK_RUN_MAX_INTERVALS ? plan : SlotPlan{};
}

void bend(Tracks& tracks, SlotPlan plan) {
    tracks.bent.clear();
    tracks.bent.reserve(tracks.sample_count());
    const std::size_t per_slot = tracks.interval_count / plan.slots.size();
    for (std::size_t k = 0; k < tracks.sample_count(); ++k) {
        const std::size_t index = std::min(k / per_slot, plan.slots.size() - 1);
        const double along = static_cast<double>(k - index * per_slot) / static_cast<double>(per_slot);
        const Slot& slot = plan.slots[index];
        const double rows = slot.span > 0 ? (slot.offset + along) / slot.span : along * slot.offset;
        tracks.bent.push_back((slot.row + rows) / plan.interval_count);
    }
    tracks.slots = std::move(plan);
}

}  // namespace posepack::fit
