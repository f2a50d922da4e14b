// SPDX-License-Identifier: MIT
// Closed surfaces from a few sections: rings along a path, and ellipsoids. A section names the joint that
// owns it; the rings between sections share their joints' weights smoothly.
#pragma once

#include <optional>
#include <vector>

#include "menagerie/mesh.hpp"

namespace posepack::menagerie {

// The colours of a ring: along its upper, middle and lower line.
struct Paint {
    Colour back = 0x808080;
    Colour side = 0x808080;
    Colour belly = 0x808080;
};

// One hue all round.
Paint plain(Colour colour);

// A cross-section of a loft. With the path along t and the loft's side vector s, "up" is t x s.
struct Section {
    Vec3 centre{};
    double half_width = 0.0;  // along the side vector, metres
    double up = 0.0;          // from the centre upwards and downwards
    double down = 0.0;
    int joint = 0;
    Paint paint;
    int rings = 2;  // rings from here up to, not including, the next section
};

struct Loft {
    std::vector<Section> sections;  // at least two
    Vec3 side = kAxisX;
    int segments = 12;                // vertices of a ring
    std::optional<double> start_cap;  // how far the closing point stands out, metres; nothing: left open
    std::optional<double> end_cap;
};

struct Ellipsoid {
    Vec3 centre{};
    Vec3 radii{};  // along X, Y, Z before the turn
    Quat turn = kNoTurn;
    int segments = 8;
    int rings = 3;          // between the two poles, which lie on the ellipsoid's Z axis
    Colour colour = 0;      // from the equator on
    Colour tip_colour = 0;  // towards +Z (an iris)
    int joint = 0;
};

// Appends segments x rings vertices, and one for each closed end.
void add_loft(Mesh& mesh, const Loft& loft);

// Appends segments x rings + 2 vertices.
void add_ellipsoid(Mesh& mesh, const Ellipsoid& ellipsoid);

}  // namespace posepack::menagerie
