// SPDX-License-Identifier: MIT
// The samples of a pixel, each brought to display range before they are averaged: edges stay smooth in bright light.
uniform sampler2D samples;
uniform int samples_a_side;
uniform vec2 picture_size;
out vec4 colour;

// The filmic curve of K. Narkowicz, "ACES Filmic Tone Mapping Curve" (2016).
vec3 filmic(vec3 x) {
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

vec3 srgb(vec3 linear) {
    return mix(linear * 12.92, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * samples_a_side;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < samples_a_side; ++y)
        for (int x = 0; x < samples_a_side; ++x)
            sum += filmic(texelFetch(samples, first + ivec2(x, y), 0).rgb * 0.62);
    vec3 mean = sum / float(samples_a_side * samples_a_side);
    vec2 from_centre = gl_FragCoord.xy / picture_size - 0.5;
    mean *= 1.0 - 0.28 * dot(from_centre, from_centre);
    colour = vec4(srgb(mean), 1.0);
}
