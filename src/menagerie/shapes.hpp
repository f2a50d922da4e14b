// SPDX-License-Identifier: MIT
// The animals as tables of measures over the body plans. Each is built as published, or as one of its kind:
// larger or smaller, longer or shorter in the parts, lighter or darker.
#pragma once

#include "menagerie/model.hpp"
#include "menagerie/variation.hpp"

namespace posepack::menagerie {

// Four legs: paws.
Model bear(const Variation& variation);
Model cat(const Variation& variation);
Model crocodile(const Variation& variation);
Model fox(const Variation& variation);
Model lion(const Variation& variation);
Model mouse(const Variation& variation);
Model rabbit(const Variation& variation);
Model wolf(const Variation& variation);

// Four legs: hooves, and the elephant. Cow and bull share a rig, and so do deer and stag.
Model bull(const Variation& variation);
Model cow(const Variation& variation);
Model deer(const Variation& variation);
Model donkey(const Variation& variation);
Model elephant(const Variation& variation);
Model giraffe(const Variation& variation);
Model goat(const Variation& variation);
Model horse(const Variation& variation);
Model pig(const Variation& variation);
Model sheep(const Variation& variation);
Model stag(const Variation& variation);

// Birds.
Model crow(const Variation& variation);
Model duck(const Variation& variation);
Model eagle(const Variation& variation);
Model owl(const Variation& variation);
Model sparrow(const Variation& variation);

// Fish, a snake, and what walks on six legs or more.
Model bee(const Variation& variation);
Model crab(const Variation& variation);
Model shark(const Variation& variation);
Model spider(const Variation& variation);
Model trout(const Variation& variation);
Model viper(const Variation& variation);

}  // namespace posepack::menagerie
