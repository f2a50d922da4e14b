// SPDX-License-Identifier: MIT
// Sun, sky and haze, in linear light.
uniform vec3 eye;
uniform vec3 to_sun;
uniform mat4 shadow_from_world;
uniform sampler2D shadow_map;
uniform vec2 shadow_texel;

const vec3 kSunlight = vec3(3.3, 2.75, 2.05);
const vec3 kSkylight = vec3(0.50, 0.66, 0.95);
const vec3 kBounce = vec3(0.30, 0.28, 0.13);

float noise_corner(vec2 p) {
    return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453);
}

float noise(vec2 p) {
    vec2 i = floor(p), f = p - i;
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(noise_corner(i), noise_corner(i + vec2(1, 0)), f.x),
               mix(noise_corner(i + vec2(0, 1)), noise_corner(i + vec2(1, 1)), f.x), f.y);
}

float cloud_noise(vec2 p) {
    float sum = 0.0, share = 0.5;
    for (int i = 0; i < 5; ++i) {
        sum += share * noise(p);
        p = p * 2.03 + 17.0;
        share *= 0.5;
    }
    return sum;
}

vec3 sky_colour(vec3 way) {
    float up = max(way.y, 0.0);
    float towards_sun = max(dot(normalize(vec3(way.x, way.y * 0.6, way.z)), to_sun), 0.0);
    vec3 horizon = mix(vec3(0.70, 0.79, 0.88), vec3(1.10, 0.88, 0.66), smoothstep(-0.3, 0.9, dot(normalize(way.xz), normalize(to_sun.xz))));
    vec3 colour = mix(horizon, vec3(0.32, 0.57, 0.93), smoothstep(0.0, 0.20, up));
    colour = mix(colour, vec3(0.11, 0.32, 0.74), smoothstep(0.12, 0.60, up));
    return colour + vec3(0.55, 0.33, 0.12) * pow(towards_sun, 6.0) * 0.5;
}

vec3 in_haze(vec3 colour, vec3 place) {
    vec3 way = place - eye;
    float away = length(way);
    float thickness = 1.0 - exp(-pow(away / 420.0, 1.3));
    return mix(colour, sky_colour(normalize(vec3(way.x, 0.0, way.z))), thickness);
}

// Share of the sun that reaches a place: a soft filter over the depth map.
float sunlit(vec3 place, vec3 normal) {
    vec4 p = shadow_from_world * vec4(place + normal * 0.012, 1.0);
    vec3 at = p.xyz * 0.5 + 0.5;
    if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
    float lit = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            vec2 texel = at.xy / shadow_texel - 0.5 + vec2(x, y);
            vec2 f = fract(texel);
            vec2 corner = (floor(texel) + 0.5) * shadow_texel;
            vec4 open = vec4(
                step(at.z, texture(shadow_map, corner).r + 4e-5), step(at.z, texture(shadow_map, corner + vec2(shadow_texel.x, 0)).r + 4e-5),
                step(at.z, texture(shadow_map, corner + vec2(0, shadow_texel.y)).r + 4e-5), step(at.z, texture(shadow_map, corner + shadow_texel).r + 4e-5));
            lit += mix(mix(open.x, open.y, f.x), mix(open.z, open.w, f.x), f.y);
        }
    return lit / 25.0;
}

vec3 light_on(vec3 place, vec3 normal, float openness) {
    float facing = max(dot(normal, to_sun), 0.0);
    float lit = facing > 0.0 ? sunlit(place, normal) : 0.0;
    vec3 ambient = mix(kBounce, kSkylight, 0.5 + 0.5 * normal.y) * openness;
    return kSunlight * facing * lit + ambient;
}
