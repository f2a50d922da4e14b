// SPDX-License-Identifier: MIT
in vec3 place;
in vec3 world_normal;
in vec3 surface_colour;
uniform int part;
uniform float half_m;
uniform float shade;
out vec4 colour;

const vec3 kToSun = vec3(0.30, 0.85, 0.44);

void main() {
    if (part == 0) {
        colour = vec4(vec3(0.62, 0.60, 0.54) * shade, 1.0);
        return;
    }
    if (part == 1) {
        colour = vec4(vec3(0.34, 0.33, 0.31) * shade, 1.0);
        return;
    }
    vec3 normal = normalize(world_normal);
    float facing = max(dot(normal, normalize(kToSun)), 0.0);
    float side = max(dot(normal, normalize(vec3(1.0, 0.15, 0.55))), 0.0);
    vec3 light = vec3(1.75, 1.65, 1.45) * facing + vec3(0.55, 0.58, 0.62) * side +
                 mix(vec3(0.36, 0.33, 0.28), vec3(0.60, 0.66, 0.78), 0.5 + 0.5 * normal.y);
    colour = vec4(surface_colour * light, 1.0);
}
