// SPDX-License-Identifier: MIT
#include "menagerie/loft.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>

namespace posepack::menagerie {
namespace {

// Shares of the three sections nearest to a point at u between sections `index` and `index + 1`: the uniform
// quadratic B-spline, smooth and local. At most three joints take part.
Influences spline_influences(const std::vector<Section>& sections, std::size_t index, double u) {
    const std::size_t middle = u < 0.5 ? index : index + 1;
    const double x = u < 0.5 ? u : u - 1.0;
    const std::size_t before = middle == 0 ? 0 : middle - 1;
    const std::size_t after = std::min(middle + 1, sections.size() - 1);
    Influences influences;
    add_share(influences, sections[middle].joint, 0.75 - x * x);
    add_share(influences, sections[before].joint, 0.5 * (0.5 - x) * (0.5 - x));
    add_share(influences, sections[after].joint, 0.5 * (0.5 + x) * (0.5 + x));
    return influences;
}

// The numbers of a section that are interpolated along the path.
struct Profile {
    Vec3 centre{};
    Vec3 size{};  // half width, up, down
};

Profile operator+(const Profile& a, const Profile& b) {
    return {a.centre + b.centre, a.size + b.size};
}

Profile operator-(const Profile& a, const Profile& b) {
    return {a.centre - b.centre, a.size - b.size};
}

Profile operator*(const Profile& a, double factor) {
    return {a.centre * factor, a.size * factor};
}

Profile profile_of(const Section& section) {
    return {section.centre, {section.half_width, section.up, section.down}};
}

struct Ring {
    Profile profile;
    Influences influences;
    Vec3 back{}, side{}, belly{};  // colours
};

double span_length(const Section& a, const Section& b) {
    return std::max(glm::length(b.centre - a.centre), 1e-9);
}

// Slope of the path at a section by unequal finite differences, per metre of chord; one-sided at the ends.
Profile slope_at(const std::vector<Section>& sections, std::size_t index) {
    const std::size_t before = index == 0 ? 0 : index - 1;
    const std::size_t after = std::min(index + 1, sections.size() - 1);
    const double length = (before == index ? 0.0 : span_length(sections[before], sections[index])) +
                          (after == index ? 0.0 : span_length(sections[index], sections[after]));
    return (profile_of(sections[after]) - profile_of(sections[before])) * (1.0 / length);
}

Ring ring_between(const std::vector<Section>& sections, std::size_t index, double u) {
    const Section& a = sections[index];
    const Section& b = sections[index + 1];
    const double length = span_length(a, b);
    Ring ring;
    ring.profile = hermite(profile_of(a), slope_at(sections, index) * length, profile_of(b),
                           slope_at(sections, index + 1) * length, u);
    ring.profile.size = glm::max(ring.profile.size, Vec3(1e-4));
    ring.influences = spline_influences(sections, index, u);
    ring.back = mixed(linear_colour(a.paint.back), linear_colour(b.paint.back), u);
    ring.side = mixed(linear_colour(a.paint.side), linear_colour(b.paint.side), u);
    ring.belly = mixed(linear_colour(a.paint.belly), linear_colour(b.paint.belly), u);
    return ring;
}

std::vector<Ring> rings_of(const Loft& loft) {
    assert(loft.sections.size() >= 2);
    std::vector<Ring> rings;
    for (std::size_t index = 0; index + 1 < loft.sections.size(); ++index) {
        const int count = loft.sections[index].rings;
        for (int step = 0; step < count; ++step) {
            rings.push_back(ring_between(loft.sections, index, static_cast<double>(step) / count));
        }
    }
    rings.push_back(ring_between(loft.sections, loft.sections.size() - 2, 1.0));
    return rings;
}

Vec3 tangent_at(const std::vector<Ring>& rings, std::size_t index) {
    const std::size_t before = index == 0 ? 0 : index - 1;
    const std::size_t after = std::min(index + 1, rings.size() - 1);
    return glm::normalize(rings[after].profile.centre - rings[before].profile.centre);
}

void add_ring(Mesh& mesh, const Ring& ring, const Vec3& tangent, const Loft& loft) {
    const Vec3 up = glm::normalize(glm::cross(tangent, loft.side));
    const Vec3 side = glm::cross(up, tangent);
    for (int step = 0; step < loft.segments; ++step) {
        const double turns = static_cast<double>(step) / loft.segments;
        const double s = sine_of_turns(turns);
        const Vec3& size = ring.profile.size;
        Vertex vertex;
        vertex.position = ring.profile.centre + side * (size.x * cosine_of_turns(turns)) +
                          up * (s * (s >= 0.0 ? size.y : size.z));
        vertex.colour = mixed(ring.side, s >= 0.0 ? ring.back : ring.belly, s * s);
        vertex.influences = ring.influences;
        mesh.vertices.push_back(vertex);
    }
}

// Triangles between the rings that begin at `lower` and `upper`; upper lies further along the path.
void join_rings(Mesh& mesh, std::size_t lower, std::size_t upper, std::size_t segments) {
    for (std::size_t step = 0; step < segments; ++step) {
        const std::size_t next = (step + 1) % segments;
        add_triangle(mesh, lower + step, lower + next, upper + step);
        add_triangle(mesh, lower + next, upper + next, upper + step);
    }
}

// A point that closes the ring beginning at `ring`; `forward`: the closing end of the path.
void close_ring(Mesh& mesh, std::size_t ring, std::size_t segments, const Vertex& point, bool forward) {
    const std::size_t tip = mesh.vertices.size();
    mesh.vertices.push_back(point);
    for (std::size_t step = 0; step < segments; ++step) {
        const std::size_t a = ring + step;
        const std::size_t b = ring + (step + 1) % segments;
        if (forward) {
            add_triangle(mesh, a, b, tip);
        } else {
            add_triangle(mesh, b, a, tip);
        }
    }
}

Vertex cap_point(const Ring& ring, const Vec3& outwards) {
    return {ring.profile.centre + outwards, {}, ring.side, ring.influences};
}

}  // namespace

Paint plain(Colour colour) {
    return {colour, colour, colour};
}

void add_loft(Mesh& mesh, const Loft& loft) {
    const std::vector<Ring> rings = rings_of(loft);
    const auto segments = static_cast<std::size_t>(loft.segments);
    const std::size_t first = mesh.vertices.size();
    for (std::size_t index = 0; index < rings.size(); ++index) {
        add_ring(mesh, rings[index], tangent_at(rings, index), loft);
        if (index > 0) join_rings(mesh, first + (index - 1) * segments, first + index * segments, segments);
    }
    const std::size_t last = first + (rings.size() - 1) * segments;
    if (loft.start_cap) {
        const Vec3 outwards = tangent_at(rings, 0) * -*loft.start_cap;
        close_ring(mesh, first, segments, cap_point(rings.front(), outwards), false);
    }
    if (loft.end_cap) {
        const Vec3 outwards = tangent_at(rings, rings.size() - 1) * *loft.end_cap;
        close_ring(mesh, last, segments, cap_point(rings.back(), outwards), true);
    }
}

void add_ellipsoid(Mesh& mesh, const Ellipsoid& ellipsoid) {
    const std::size_t first = mesh.vertices.size();
    const auto segments = static_cast<std::size_t>(ellipsoid.segments);
    const auto vertex_at = [&](const Vec3& unit) {
        const bool tip = unit.z > 0.45;
        return Vertex{ellipsoid.centre + ellipsoid.turn * (unit * ellipsoid.radii),
                      {},
                      linear_colour(tip ? ellipsoid.tip_colour : ellipsoid.colour),
                      one_influence(ellipsoid.joint)};
    };
    for (int ring = 0; ring < ellipsoid.rings; ++ring) {
        const double latitude =
            static_cast<double>(ring + 1) / (2.0 * (ellipsoid.rings + 1));  // turns from -Z
        for (int step = 0; step < ellipsoid.segments; ++step) {
            const double turns = static_cast<double>(step) / ellipsoid.segments;
            const double radius = sine_of_turns(latitude);
            mesh.vertices.push_back(vertex_at({radius * cosine_of_turns(turns), radius * sine_of_turns(turns),
                                               -cosine_of_turns(latitude)}));
        }
        const std::size_t begin = first + static_cast<std::size_t>(ring) * segments;
        if (ring > 0) join_rings(mesh, begin - segments, begin, segments);
    }
    const std::size_t last = mesh.vertices.size() - segments;
    close_ring(mesh, first, segments, vertex_at(-kAxisZ), false);
    close_ring(mesh, last, segments, vertex_at(kAxisZ), true);
}

}  // namespace posepack::menagerie
