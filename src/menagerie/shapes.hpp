// SPDX-License-Identifier: MIT
// The animals as tables of measures over the body plans.
#pragma once

#include "menagerie/model.hpp"

namespace posepack::menagerie {

Model goat();
Model sparrow();
Model trout();
Model viper();
Model wolf();

}  // namespace posepack::menagerie
