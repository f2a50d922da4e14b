// SPDX-License-Identifier: MIT
// One animal of a crowd: its rows from clip, rate, phase and time; its skin; its place in the meadow.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec4 bones;
layout(location = 4) in vec4 weights;
layout(location = 5) in vec4 place;    // position, heading
layout(location = 6) in vec4 playing;  // scale, clip, rate, bank
layout(location = 7) in vec3 tint;
uniform mat4 clip_from_world;
uniform float time_s;
uniform float radius_m;
out vec3 world_position;
out vec3 world_normal;
out vec3 surface_colour;
out float openness;  // share of the sky that reaches the surface

const float kGoldenRatio = 0.6180339887;

void main() {
    int clip = int(playing.y);
    float period = texelFetch(clip_table, ivec2(clip, 0), 0).z;
    // Multiples of the golden ratio spread phases evenly, however many animals there are.
    float phase = fract(float(gl_InstanceID) * kGoldenRatio);
    float cycles = phase + (period > 0.0 ? time_s * playing.z / period : 0.0);
    mat3x4 skin = skin_matrix(rows_at(clip, cycles), bones, weights);
    vec3 posed = vec4(position, 1.0) * skin;
    vec3 posed_normal = vec4(normal, 0.0) * skin;

    float s = sin(place.w), c = cos(place.w);
    float bs = sin(playing.w), bc = cos(playing.w);
    mat3 turn = mat3(c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c) * mat3(bc, bs, 0.0, -bs, bc, 0.0, 0.0, 0.0, 1.0);
    world_position = place.xyz + turn * posed * playing.x;
    world_normal = turn * posed_normal;
    surface_colour = colour * tint;
    openness = mix(0.5, 1.0, smoothstep(0.0, 1.1 * radius_m, posed.y));
    gl_Position = clip_from_world * vec4(world_position, 1.0);
}
