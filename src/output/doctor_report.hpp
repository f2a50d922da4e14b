// SPDX-License-Identifier: MIT
// A diagnosis as text for people and as JSON for programs.
#pragma once

#include <string>

#include "output/diagnosis.hpp"

namespace posepack::output {

// Short sections in plain words, from the verdict to what a bake would give; ends with a newline. Names of
// the file are escaped and cut.
std::string doctor_text(const Diagnosis& diagnosis);

// One JSON object of schemas/doctor-1.schema.json, canonical: keys sorted, every key there.
//   indent  spaces a level; below 0: one line
std::string doctor_json(const Diagnosis& diagnosis, int indent);

}  // namespace posepack::output
