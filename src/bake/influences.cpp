// SPDX-License-Identifier: MIT
#include "bake/influences.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "measure/reduction_error.hpp"

namespace posepack::bake {
namespace {

recipe::ReductionRecord record_of(const measure::ReductionError& error, const animal::Animal& animal,
                                  const palette::Palette& palette) {
    // From the radius as the header has it, so that a reader of the container finds the same metres.
    const double radius_m = static_cast<float>(palette.radius * palette.metres_per_unit);
    recipe::ReductionRecord record;
    record.measured = true;
    record.vertex_count = error.vertex_count;
    record.influences_most = error.influences_most;
    record.max = static_cast<float>(error.max);
    record.rms = static_cast<float>(error.rms);
    record.max_m = static_cast<float>(static_cast<double>(record.max) * radius_m);
    record.rms_m = static_cast<float>(static_cast<double>(record.rms) * radius_m);
    record.clip = animal.clips[palette.clips[error.clip].source].name;
    record.time_s = static_cast<float>(error.time_s);
    record.mesh = animal.meshes[error.mesh].name;
    record.vertex = error.vertex;
    return record;
}

}  // namespace

base::Status measure_influences(const animal::Animal& animal, const palette::Palette& palette,
                                BakedAnimal& baked) {
    const auto error = measure::measure_reduction(animal, palette);
    if (!error) return error.issue();
    if (error.value().vertex_count == 0) return {};
    const recipe::ReductionRecord& record = baked.record.reduction =
        record_of(error.value(), animal, palette);
    const auto finding =
        std::find_if(baked.findings.rbegin(), baked.findings.rend(),
                     [](const base::Issue& issue) { return issue.code == base::IssueCode::warn_influences; });
    if (finding != baked.findings.rend())
        finding->detail += fmt::format(
            "; that moves {} of the model by at most {:.3g} R ({:.3g} mm, in {} at {:.3g} s), rms {:.3g} R",
            base::counted(record.vertex_count, "vertex", "vertices"), record.max,
            static_cast<double>(record.max_m) * 1e3, record.clip, record.time_s, record.rms);
    return {};
}

}  // namespace posepack::bake
