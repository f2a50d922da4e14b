// SPDX-License-Identifier: MIT
// Grass, flowers and trees.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 5) in vec4 place;    // position, heading
layout(location = 6) in float scale;
layout(location = 7) in vec3 tint;
uniform mat4 clip_from_world;
out vec3 world_position;
out vec3 world_normal;
out vec3 surface_colour;
out float openness;

void main() {
    float s = sin(place.w), c = cos(place.w);
    mat3 turn = mat3(c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c);
    world_position = place.xyz + turn * position * scale;
    world_normal = turn * normal;
    surface_colour = colour * tint;
    openness = 1.0;
    gl_Position = clip_from_world * vec4(world_position, 1.0);
}
