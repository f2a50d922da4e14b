// SPDX-License-Identifier: MIT
// Hands out what the shader of the herd computes, for a comparison on the CPU.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec4 bones;
layout(location = 4) in vec4 weights;
uniform int clip;
uniform float cycles;
out vec3 skinned_position;
out vec3 skinned_normal;
out vec3 chosen_rows;

void main() {
    RowBlend rows = rows_at(clip, cycles);
    mat3x4 skin = skin_matrix(rows, bones, weights);
    skinned_position = vec4(position, 1.0) * skin;
    skinned_normal = vec4(normal, 0.0) * skin;
    chosen_rows = vec3(float(rows.row), float(rows.next), rows.factor);
    gl_Position = vec4(0.0);
}
