// SPDX-License-Identifier: MIT
#include "stress/choose_palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "bake/bake_animal.hpp"
#include "base/interrupt.hpp"
#include "stress/form.hpp"

namespace posepack::stress {
namespace {

using base::Issue;
using base::IssueCode;
using recipe::Encoding;
using recipe::Space;
using recipe::TexelFormat;

// A mat4 is an affine and a fourth texel of nothing: never the smallest.
constexpr std::array kForms = {Form{Encoding::dualquat, TexelFormat::rgba16f, Space::normalised},
                               Form{Encoding::affine, TexelFormat::rgba16f, Space::normalised},
                               Form{Encoding::dualquat, TexelFormat::rgba32f, Space::normalised},
                               Form{Encoding::affine, TexelFormat::rgba32f, Space::normalised}};
constexpr std::array kRowFactors = {1u, 2u, 4u, 8u, 16u, 32u};
constexpr double kMaxRateHz = 1000.0;  // as in catalogs

struct Trial {
    Form form;
    unsigned row_factor = 1;
    unsigned size() const { return bytes_of(form) * row_factor; }
};

// Smallest first; of equal sizes the smaller form, whose last row costs less.
std::vector<Trial> trials() {
    std::vector<Trial> all;
    for (const unsigned factor : kRowFactors)
        for (const Form& form : kForms) all.push_back({form, factor});
    std::stable_sort(all.begin(), all.end(), [](const Trial& a, const Trial& b) {
        return std::pair(a.size(), bytes_of(a.form)) < std::pair(b.size(), bytes_of(b.form));
    });
    return all;
}

bool holds(const recipe::ErrorRecord& error, const Bound& bound) {
    return static_cast<double>(error.max) <= bound.max && static_cast<double>(error.p999) <= bound.p999;
}

// How far an error is above the bound: 1 and less holds it.
double excess(const recipe::ErrorRecord& error, const Bound& bound) {
    return std::max(static_cast<double>(error.max) / bound.max, static_cast<double>(error.p999) / bound.p999);
}

// The best that was reached, for the refusal.
struct Nearest {
    Trial trial;
    recipe::ErrorRecord error;
    std::string clip;
    double rate_hz = 0.0;
};

class Search {
 public:
    Search(const recipe::AnimalEntry& entry, std::span<const std::uint8_t> glb, const Bound& bound)
        : entry_(entry), glb_(glb), bound_(bound) {}

    base::Result<base::Bytes> run() {
        for (const Trial& trial : trials()) {
            if (auto status = base::check_interrupt(); !status) return status.issue();
            if (!is_possible(trial)) continue;
            auto baked = bake::bake_animal(at_rows(in_form(entry_, trial.form), trial.row_factor), glb_, {});
            if (!baked) {
                // What one form cannot hold another may; what is wrong with the file no form mends.
                if (issue_kind(baked.issue().code).exit_code != base::ExitCode::limit) return baked.issue();
                refusal_ = baked.issue();
                continue;
            }
            learn_rates(baked.value().record, trial.row_factor);
            if (auto container = judge(trial, std::move(baked).value())) return std::move(*container);
        }
        if (!nearest_) return *refusal_;
        return out_of_reach();
    }

 private:
    bool is_possible(const Trial& trial) const {
        if (trial.row_factor == 1) return true;
        if (rates_hz_.empty()) return false;  // nothing could be baked, or nothing moves
        const double highest_hz = *std::max_element(rates_hz_.begin(), rates_hz_.end());
        return highest_hz > 0.0 && highest_hz * trial.row_factor <= kMaxRateHz;
    }

    // The rates of the clips at the start: those asked for, or those of the key grids.
    void learn_rates(const recipe::BakeRecord& record, unsigned row_factor) {
        if (!rates_hz_.empty() || row_factor != 1) return;
        for (const recipe::ClipRecord& clip : record.clips) {
            rates_hz_.push_back(static_cast<double>(clip.rate_hz));
            clip_names_.push_back(clip.name);
        }
    }

    recipe::AnimalEntry at_rows(recipe::AnimalEntry entry, unsigned row_factor) const {
        if (row_factor == 1) return entry;
        const recipe::ClipWish wish = entry.clips.empty() ? recipe::ClipWish{} : entry.clips.front();
        entry.clips.clear();
        for (std::size_t c = 0; c < rates_hz_.size(); ++c) {
            recipe::ClipWish finer = wish;
            finer.name = clip_names_[c];
            finer.rate_hz = rates_hz_[c] > 0.0 ? rates_hz_[c] * row_factor : 1.0;
            entry.clips.push_back(std::move(finer));
        }
        return entry;
    }

    // The container where every clip holds the bound.
    std::optional<base::Bytes> judge(const Trial& trial, bake::BakedAnimal baked) {
        const recipe::ClipRecord* worst = nullptr;
        for (const recipe::ClipRecord& clip : baked.record.clips)
            if (worst == nullptr || excess(clip.error, bound_) > excess(worst->error, bound_)) worst = &clip;
        if (holds(worst->error, bound_)) return std::move(baked.container);
        if (!nearest_ || excess(worst->error, bound_) < excess(nearest_->error, bound_))
            nearest_ = Nearest{trial, worst->error, worst->name, static_cast<double>(worst->rate_hz)};
        return std::nullopt;
    }

    Issue out_of_reach() const {
        const recipe::ErrorRecord& error = nearest_->error;
        return {IssueCode::lim_bound, fmt::format("{}: {}", entry_.id, nearest_->clip),
                fmt::format("expected errors up to {:.3g} R (p99.9 {:.3g} R), found {:.3g} R ({:.3g} R) at "
                            "{:.4g} s, bone '{}', with {} at {:.4g} rows a second, the best that was tried",
                            bound_.max, bound_.p999, error.max, error.p999, error.time_s, error.bone,
                            label_of(nearest_->trial.form), nearest_->rate_hz)};
    }

    const recipe::AnimalEntry& entry_;
    std::span<const std::uint8_t> glb_;
    const Bound& bound_;
    std::vector<double> rates_hz_;
    std::vector<std::string> clip_names_;
    std::optional<Nearest> nearest_;
    std::optional<Issue> refusal_;
};

}  // namespace

base::Result<base::Bytes> choose_palette(const recipe::AnimalEntry& entry, std::span<const std::uint8_t> glb,
                                         const Bound& bound) {
    return Search(entry, glb, bound).run();
}

}  // namespace posepack::stress
