// SPDX-License-Identifier: MIT
// The doctor: what a GLB holds, what is odd in it, and what a bake of it would do and give.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "animal/animal.hpp"
#include "output/diagnosis.hpp"

namespace posepack::bake {

struct DoctorOptions {
    bool strict = false;  // as bake --strict
    bool measure = true;  // measure the error that a bake would have
};

// Examines the GLB in `bytes` as a bake of a catalog entry without wishes would see it. Never fails: what a
// bake would refuse is Diagnosis::refusal, and whatever could be read before is filled in. Costs three parses
// and one bake in memory.
output::Diagnosis diagnose(const std::string& file_name, std::span<const std::uint8_t> bytes,
                           const DoctorOptions& options);

// Adds what an artist may want to know and no bake minds: Diagnosis::oddities, from all that is filled in.
void find_oddities(const animal::Animal& animal, output::Diagnosis& diagnosis);

}  // namespace posepack::bake
