// SPDX-License-Identifier: MIT
// The smallest rows of a clip that keep a bound, proved on the bytes as the loader reads them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "animal/animal.hpp"
#include "base/result.hpp"
#include "fit/profile.hpp"
#include "fit/select.hpp"
#include "motion/skin_set.hpp"
#include "palette/dualquat_fit.hpp"
#include "palette/encode.hpp"
#include "palette/palette.hpp"

namespace posepack::choose {

// One try: what it was, its size and its measured error. The last that keeps the bound with the fewest bytes
// is taken.
struct Attempt {
    std::uint8_t encoding = 0;
    bool has_slots = false;
    std::uint64_t bytes = 0;  // of bone-rows, entries and slots
    float max = 0, p999 = 0, rms = 0;
    bool keeps_bound = false;
};

// What the chooser may use. All of it, but where the worth of each is measured.
struct Means {
    bool dual_quaternions = true;  // else every clip is matrices
    bool slots = true;
    fit::Means rows;
};

struct ChosenRows {
    palette::ClipRuns runs;
    palette::Box bounds;
    std::vector<Attempt> attempts;
};

// Chooses the rows of the clips of one animal, in their order.
class RowChooser {
 public:
    //   palette  with clips planned, spaces and the length of dual quaternions; layout.texel_format is used
    //   aids  for rounding, of the whole animal
    // All must outlive the chooser.
    RowChooser(const animal::Animal& animal, const palette::Palette& palette,
               const palette::RoundingAids& aids, const motion::SkinSet& points, const Means& means = {});

    // The rows of clip `index`, of dual quaternions or of matrices.
    // Errors: E-LIM-BOUND with the best that was reached, where, and what would reach it; those of
    // measure_error.
    base::Result<ChosenRows> choose(std::uint32_t index, fit::Form form, const fit::Limits& bound);

 private:
    class Contest;
    base::Result<palette::ClipError> measure(palette::PaletteClip clip) const;
    base::Status try_runs(const fit::Tracks& tracks, fit::RowSelector& selector, Contest& contest) const;
    base::Status try_wider(const fit::Tracks& tracks, fit::RowSelector& selector, Contest& contest) const;
    // Whether more samples would lead further.
    base::Result<bool> try_slots(fit::Tracks& tracks, Contest& contest) const;
    // Encodes, measures and enters one selection; whether it could be encoded.
    base::Result<bool> enter(const fit::Tracks& tracks, fit::RowSelector& selector,
                             const fit::Selection& selection, Contest& contest) const;
    std::optional<ChosenRows> encode(const fit::Tracks& tracks, fit::RowSelector& selector,
                                     std::vector<fit::BoneRows> rows, const fit::Limits& bound) const;
    std::uint32_t row_bytes(fit::Form form) const;
    double expected_bytes(const fit::Selection& selection, const fit::Tracks& tracks) const;
    void give_weightless_rows(std::vector<fit::BoneRows>& rows) const;

    const animal::Animal& animal_;
    const palette::Palette& palette_;
    const palette::RoundingAids& aids_;
    const motion::SkinSet& points_;
    const Means means_;
    const motion::SkinSet no_normals_;
    std::vector<fit::BonePoints> bone_points_;
    palette::BoneBoxes boxes_;
    palette::Hemispheres hemispheres_;
};

// Chooses the rows of every clip of a palette that is planned and has its spaces: dual quaternions, where all
// bones of a clip turn and scale evenly, else matrices. Sets runs, bounds, first rows, the length of dual
// quaternions and the layout.
//   bounds  one a clip
//   attempts  receives what was tried for each clip
//   aids  for rounding; the length of dual quaternions is set
// Errors: E-LIM-BOUND, E-LIM-ROWS, E-LIM-CONTAINER, those of measure_error.
base::Status choose_rows(const animal::Animal& animal, const motion::SkinSet& points,
                         const std::vector<fit::Limits>& bounds, std::uint8_t texel_format,
                         palette::RoundingAids& aids, palette::Palette& palette,
                         std::vector<std::vector<Attempt>>& attempts, const Means& means = {});

}  // namespace posepack::choose
