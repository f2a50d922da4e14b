// SPDX-License-Identifier: MIT
uniform mat4 world_from_clip;
in vec2 screen;
out vec4 colour;

// Sharp crests: noise folded at its middle.
float ridge(float along) {
    float sum = 0.0, share = 0.5;
    for (int i = 0; i < 5; ++i) {
        sum += share * (1.0 - abs(2.0 * noise(vec2(along, 0.5 + float(i))) - 1.0));
        along = along * 2.1 + 5.0;
        share *= 0.45;
    }
    return sum;
}

void main() {
    vec4 far = world_from_clip * vec4(screen, 1.0, 1.0);
    vec3 way = normalize(far.xyz / far.w - eye);
    vec3 sky = sky_colour(way);
    // Clouds on a flat ceiling: they shrink towards the horizon and fade before it.
    vec2 ceiling = way.xz / max(way.y + 0.06, 0.02);
    float cloud = smoothstep(0.48, 0.70, cloud_noise(ceiling * vec2(0.55, 0.9) + vec2(3.0, 8.0)));
    cloud *= smoothstep(0.015, 0.13, way.y) * 0.75;
    sky = mix(sky, vec3(1.25, 1.14, 1.02), cloud);
    // Two ranges of mountains, by the angle at which they stand over the horizon.
    float bearing = atan(way.x, -way.z);
    float far_range = 0.030 + 0.15 * ridge(bearing * 5.0 + 2.0);
    float near_range = 0.010 + 0.10 * ridge(bearing * 7.0 + 31.0);
    vec3 haze = sky_colour(normalize(vec3(way.x, 0.0, way.z)));
    if (way.y < far_range) sky = mix(mix(vec3(0.36, 0.46, 0.62), haze, 0.40), haze, smoothstep(0.10, 0.0, way.y) * 0.6);
    if (way.y < near_range) sky = mix(mix(vec3(0.27, 0.37, 0.44), haze, 0.28), haze, smoothstep(0.08, 0.0, way.y) * 0.6);
    colour = vec4(sky, 1.0);
}
