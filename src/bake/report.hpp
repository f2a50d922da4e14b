// SPDX-License-Identifier: MIT
// Error against run time: every encoding and rate of every animal, baked, measured and timed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bake/bake_catalog.hpp"

namespace posepack::bake {

struct ReportRow {
    std::string id;
    std::string encoding, texel_format;
    std::string rate;  // "keys" or a number in Hz
    std::uint64_t texel_bytes = 0;
    recipe::ErrorRecord error;
    double decode_ns_per_vertex = 0.0;  // two rows decoded and blended, all vertices skinned, one thread
    double bake_ms = 0.0;               // read, sample, encode; without the measurement
};

struct Report {
    std::vector<ReportRow> rows;
    std::vector<base::Issue> refused;  // forms that an animal cannot have: no row
};

// Bakes all six forms (mat4, affine, dualquat; RGBA32F, RGBA16F), each in its default space, at each of
// `rates_hz` (nothing: the clips' own key grids). Animals are taken one after the other on one thread, so
// that times can be compared. Errors: those of open_catalog, read_model and bake_animal.
base::Result<Report> report_catalog(const CatalogSource& source,
                                    const std::vector<std::optional<double>>& rates_hz);

}  // namespace posepack::bake
