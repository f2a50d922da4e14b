// SPDX-License-Identifier: MIT
// Error against run time: every encoding and rate of every animal, baked, measured and timed.
#pragma once

#include <optional>
#include <vector>

#include "bake/bake_catalog.hpp"
#include "output/report_model.hpp"

namespace posepack::bake {

struct ReportOptions {
    std::vector<std::optional<double>> rates_hz;  // nothing: the clips' own key grids
    bool with_heat = false;                       // maps of the error over time and bone, of the chosen rows
};

// Bakes all six forms (mat4, affine, dualquat; RGBA32F, RGBA16F), each in the space that the catalog asks
// for, at each of the rates; and what a bake of the catalog writes, where that is not among them. Animals are
// taken one after the other on one thread, so that times can be compared. Errors: those of open_catalog,
// read_model and bake_animal, but for E-LIM-SIMILARITY: a form that an animal cannot have stands in
// AnimalReport::refused.
base::Result<output::Report> report_catalog(const CatalogSource& source, const ReportOptions& options);

}  // namespace posepack::bake
