// SPDX-License-Identifier: MIT
in vec3 world_position;
in vec3 world_normal;
in vec3 surface_colour;
in float openness;
out vec4 colour;

void main() {
    vec3 normal = normalize(world_normal);
    vec3 lit = surface_colour * light_on(world_position, normal, openness);
    // Hair and blades catch light at their edges.
    vec3 to_eye = normalize(eye - world_position);
    float edge = pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
    lit += edge * openness * surface_colour * (kSkylight * 0.5 + kSunlight * 0.35 * max(dot(normal, to_sun) + 0.3, 0.0));
    colour = vec4(in_haze(lit, world_position), 1.0);
}
