// SPDX-License-Identifier: MIT
// Why a clip has the form and the rows that it has, in words.
#pragma once

#include <string>

#include "recipe/manifest.hpp"

namespace posepack::output {

// One sentence without an end: "slots of dualquat, 3,004 bytes: the smallest of 3 that keep the bound, of 5
// tried; runs need 14,136". "as asked for" where no bound chose.
std::string choice_sentence(const recipe::ClipRecord& clip);

}  // namespace posepack::output
