// SPDX-License-Identifier: MIT
#include "menagerie/shape_kit.hpp"

namespace posepack::menagerie {

Model built(const QuadrupedShape& shape, const Variation& variation, const ExportStyle& style, int rate_hz) {
    Model model = quadruped_model(settled(varied(shape, variation)), style, rate_hz);
    keep_above_ground(model);
    return model;
}

void paint(QuadrupedShape& s, Colour coat, Colour back, Colour belly) {
    s.coat = s.neck = s.face = s.leg = s.ear = s.tail = coat;
    s.back = back;
    s.belly = s.muzzle = belly;
    s.sock = coat;
}

QuadrupedShape hoofed(const char* name, double size) {
    QuadrupedShape s = scaled(QuadrupedShape{}, size);
    s.name = name;
    return s;
}

}  // namespace posepack::menagerie
