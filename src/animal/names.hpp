// SPDX-License-Identifier: MIT
// Names of clips and bones, made from what exporters write.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace posepack::animal {

// The text after the last '|' ("AnimalArmature|Walk" -> "Walk").
std::string_view after_last_bar(std::string_view name);

// Names for clips: the text after the last '|', "clip_<index>" where that is empty, with "_2", "_3" ... added
// to later ones that equal an earlier one without case. Control characters become '_'.
std::vector<std::string> clip_names(const std::vector<std::string>& source_names);

// `name` with control characters replaced by '_', or `fallback` when it is empty. E-LIM-STRING over 255
// bytes.
base::Result<std::string> usable_name(std::string_view name, std::string_view fallback);

}  // namespace posepack::animal
