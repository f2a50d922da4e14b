// SPDX-License-Identifier: MIT
// A floor, the shadow of an animal on it, or the animal itself, in a cell of the contact sheet.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec4 bones;
layout(location = 4) in vec4 weights;
uniform mat4 clip_from_model;
uniform int part;  // 0: floor, 1: shadow, 2: animal
uniform int clip;
uniform float cycles;
uniform float half_m;  // half of what the cell shows
out vec3 place;
out vec3 world_normal;
out vec3 surface_colour;

const vec3 kToSun = vec3(0.30, 0.85, 0.44);

void main() {
    surface_colour = vec3(1.0);
    world_normal = vec3(0.0, 1.0, 0.0);
    if (part == 0) {
        vec2 corner = vec2(gl_VertexID == 1 || gl_VertexID == 3 || gl_VertexID == 4 ? 1.0 : -1.0,
                           gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5 ? 1.0 : -1.0);
        place = vec3(corner.x, 0.0, corner.y) * half_m * 30.0;
    } else {
        mat3x4 skin = skin_matrix(rows_at(clip, cycles), bones, weights);
        place = vec4(position, 1.0) * skin;
        world_normal = vec4(normal, 0.0) * skin;
        surface_colour = colour;
        if (part == 1) place = vec3(place.xz - kToSun.xz * max(place.y, 0.0) / kToSun.y, 0.0).xzy;
    }
    gl_Position = clip_from_model * vec4(place, 1.0);
    if (part == 0) gl_Position.z += 0.0002 * gl_Position.w;
}
