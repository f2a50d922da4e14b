// SPDX-License-Identifier: MIT
in vec3 world_position;
in vec3 world_normal;
in float path;
out vec4 colour;

void main() {
    vec2 place = world_position.xz;
    float away = length(world_position - eye);
    float broad = cloud_noise(place * 0.07);
    float fine = mix(cloud_noise(place * 0.9), 0.5, smoothstep(8.0, 60.0, away));
    vec3 grass = mix(vec3(0.070, 0.122, 0.030), vec3(0.185, 0.190, 0.058), smoothstep(0.3, 0.72, 0.6 * broad + 0.4 * fine));
    vec3 earth = mix(vec3(0.20, 0.135, 0.075), vec3(0.30, 0.215, 0.125), fine);
    vec3 surface = mix(grass, earth, path * 0.85);
    vec3 normal = normalize(world_normal);
    colour = vec4(in_haze(surface * light_on(world_position, normal, 1.0), world_position), 1.0);
}
