// SPDX-License-Identifier: MIT
// A model baked in memory, and its vertices as the loader and the weights of the file pose them.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "animal/animal.hpp"
#include "base/files.hpp"
#include "posepack/loader.h"
#include "recipe/manifest.hpp"

namespace posepack::derived {

struct PosedModel {
    animal::Animal animal;
    base::Bytes container;  // RGBA32F affine, every clip, played once, with both end poses
    recipe::BakeRecord record;
    posepack_view view;  // of `container`
};

// Reads and bakes the GLB at `path`. `rate_hz`: of every clip; nothing: their key grids.
// Throws when the file cannot be read or is refused.
PosedModel pose_model(const std::filesystem::path& path, std::optional<double> rate_hz = std::nullopt);

// The matrices of one row of the container: 12 floats a bone, 3x4 row-major.
std::vector<float> decoded_row(const PosedModel& model, std::uint32_t row);

// Every vertex under the matrices of a row.
//   before  one map a bone that is applied before its matrix, or empty
std::vector<glm::dvec3> posed_vertices(const PosedModel& model, const std::vector<float>& row,
                                       const std::vector<glm::dmat4>& before = {});

}  // namespace posepack::derived
