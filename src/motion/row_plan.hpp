// SPDX-License-Identifier: MIT
// RowPlan: at which times a clip is baked, how it wraps, and the time law that reads it back.
#pragma once

#include <optional>
#include <vector>

#include "animal/animal.hpp"
#include "motion/clip_sampler.hpp"
#include "motion/skin_set.hpp"
#include "recipe/catalog.hpp"

namespace posepack::motion {

// Two rows and how far between them: the pose is row0 * (1 - factor) + row1 * factor. Rows of the clip.
struct RowBlend {
    std::uint32_t row0 = 0, row1 = 0;
    double factor = 0.0;
};

struct RowPlan {
    std::uint32_t row_count = 1;
    double rate_hz = 0.0;                      // rows a second; 0 for one row
    double duration_s = 0.0;                   // first key to last key
    double period_s = 0.0;                     // loop: until row 0 comes again; else the duration
    recipe::Wrap wrap = recipe::Wrap::once;    // never automatic
    recipe::Seam seam = recipe::Seam::closed;  // never automatic
    bool step = false;                         // poses are held, not blended
    double seam_gap = 0.0;                     // fraction of R
    bool on_key_grid = false;                  // rows lie on the keys' own grid
    std::vector<base::Issue> remarks;

    // Clip time of a row, seconds.
    double row_time_s(std::uint32_t row) const;
    // The rows that show clip time `time_s` in [0, period_s]; the end of a loop is its last interval's end.
    RowBlend rows_at(double time_s) const;
};

// What the catalog asks of one clip.
struct RowWish {
    std::optional<double> rate_hz;  // nothing: the clip's own key grid
    recipe::Wrap wrap = recipe::Wrap::automatic;
    recipe::Seam seam = recipe::Seam::automatic;
    // Fraction of R: ends further apart than this are not taken for closed, however small a part of a key
    // step that is. Nothing: they may be, with a remark.
    std::optional<double> largest_gap{};
};

// Chooses rows, wrap and seam of a clip. A loop whose ends meet (gap below 1e-3 R) is closed; one whose gap
// is below 0.3 of a key step is closed with a remark; up to 1.5 steps it is open: the last key is a pose of
// its own and one more step leads to row 0; beyond that the clip plays once. Wishes override what is
// measured. Loops keep their exact period: row_count is round(period / step), never rounded up.
RowPlan plan_rows(const animal::Animal& animal, const animal::Clip& clip, ClipSampler& sampler,
                  const SkinSet& points, double radius, const RowWish& wish);

// The skinning matrices that row `row` of the plan stores. Between the last key of an open loop and its first
// row the pose is blended from the two.
void sample_row(ClipSampler& sampler, const RowPlan& plan, std::uint32_t row, std::span<Affine> bones);

}  // namespace posepack::motion
