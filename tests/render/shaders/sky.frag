// SPDX-License-Identifier: MIT
uniform mat4 world_from_clip;
in vec2 screen;
out vec4 colour;

void main() {
    vec4 far = world_from_clip * vec4(screen, 1.0, 1.0);
    vec3 way = normalize(far.xyz / far.w - eye);
    vec3 sky = sky_colour(way);
    // Clouds on a flat ceiling: they shrink towards the horizon and fade before it.
    vec2 ceiling = way.xz / max(way.y + 0.06, 0.02);
    float cloud = smoothstep(0.50, 0.80, cloud_noise(ceiling * vec2(0.55, 0.9) + vec2(3.0, 8.0)));
    cloud *= smoothstep(0.015, 0.13, way.y) * 0.75;
    colour = vec4(mix(sky, vec3(1.25, 1.14, 1.02), cloud), 1.0);
}
