// SPDX-License-Identifier: MIT
// Reads a palette: rows from a time, matrices from rows, and the skin of a vertex.
// A matrix here is a mat3x4 whose three columns are the rows of the 3x4: position' = vec4(position, 1.0) * matrix.
uniform sampler2D palette;
uniform sampler2D clip_table;  // a texel a clip: first row, row count, period in seconds, wrap (+ 4: rows are held; + 8: closing row)
uniform int palette_encoding;    // 1: mat4, 2: affine, 3: dualquat
uniform float dualquat_length;   // L of dualquat
uniform mat3x4 model_from_palette;
uniform int bone_step;         // texels from a bone to the next: 1 in planar order
uniform int texel_step;        // texels from a bone's texel to its next: 1 in bone-major order
uniform int row_texels;
uniform int rows_per_line;

struct RowBlend {
    int row;
    int next;
    float factor;  // of `next`
};

float wrapped_phase(int wrap, float cycles) {
    if (wrap == 0) return fract(cycles);
    if (wrap == 1) return clamp(cycles, 0.0, 1.0);
    return 1.0 - abs(1.0 - 2.0 * fract(0.5 * cycles));
}

// The two rows around the time `cycles` x period of a clip.
RowBlend rows_at(int clip, float cycles) {
    vec4 entry = texelFetch(clip_table, ivec2(clip, 0), 0);
    int first = int(entry.x);
    int count = int(entry.y);
    int wrap = int(entry.w) & 3;
    if (count == 1) return RowBlend(first, first, 0.0);
    float position = wrapped_phase(wrap, cycles) * float(wrap == 0 ? count : count - 1);
    int row = min(int(position), count - 1);
    int behind_last = wrap != 0 ? row : ((int(entry.w) & 8) != 0 ? count : 0);
    int next = row + 1 < count ? row + 1 : behind_last;
    float factor = (int(entry.w) & 4) != 0 ? 0.0 : position - float(row);
    return RowBlend(first + row, first + next, factor);
}

mat3x4 bone_matrix(int row, int bone) {
    int line = row / rows_per_line;
    int x = (row - line * rows_per_line) * row_texels + bone * bone_step;
    vec4 a = texelFetch(palette, ivec2(x, line), 0);
    vec4 b = texelFetch(palette, ivec2(x + texel_step, line), 0);
    vec4 c = texelFetch(palette, ivec2(x + 2 * texel_step, line), 0);
    if (palette_encoding == 2) return mat3x4(a, b, c);
    vec4 d = texelFetch(palette, ivec2(x + 3 * texel_step, line), 0);
    return transpose(mat4x3(a.xyz, b.xyz, c.xyz, d.xyz));
}

// A bone-row as a dual quaternion without its scale, and the scale. The twin of src/format/dualquat.c.
struct DualQuaternion {
    vec4 real;
    vec4 dual;
    float scale;
};

DualQuaternion bone_dualquat(int row, int bone) {
    int line = row / rows_per_line;
    int x = (row - line * rows_per_line) * row_texels + bone * bone_step;
    vec4 real = texelFetch(palette, ivec2(x, line), 0);
    vec4 dual = texelFetch(palette, ivec2(x + texel_step, line), 0);
    float along = dot(real, dual) / dot(real, real);
    return DualQuaternion(real, dual - along * real, 1.0 + 2.0 * along / dualquat_length);
}

mat3x4 dualquat_matrix(vec4 q, vec4 d, float s) {
    float h = 2.0 / max(dot(q, q), 1e-12);
    vec3 t = h * (q.w * d.xyz - d.w * q.xyz + cross(q.xyz, d.xyz));
    return mat3x4(vec4(s * vec3(1.0 - h * (q.y * q.y + q.z * q.z), h * (q.x * q.y - q.w * q.z), h * (q.x * q.z + q.w * q.y)), t.x),
                  vec4(s * vec3(h * (q.x * q.y + q.w * q.z), 1.0 - h * (q.x * q.x + q.z * q.z), h * (q.y * q.z - q.w * q.x)), t.y),
                  vec4(s * vec3(h * (q.x * q.z - q.w * q.y), h * (q.y * q.z + q.w * q.x), 1.0 - h * (q.x * q.x + q.y * q.y)), t.z));
}

// One bone between two rows: dual quaternions are mixed and normalised, matrices mixed entry by entry.
mat3x4 blended_bone(RowBlend rows, int bone) {
    if (palette_encoding != 3)
        return (1.0 - rows.factor) * bone_matrix(rows.row, bone) + rows.factor * bone_matrix(rows.next, bone);
    DualQuaternion a = bone_dualquat(rows.row, bone);
    DualQuaternion b = bone_dualquat(rows.next, bone);
    return dualquat_matrix(mix(a.real, b.real, rows.factor), mix(a.dual, b.dual, rows.factor),
                           mix(a.scale, b.scale, rows.factor));
}

// The skin of a vertex, from palette space to model space.
mat3x4 skin_matrix(RowBlend rows, vec4 bones, vec4 weights) {
    mat3x4 sum = mat3x4(0.0);
    for (int i = 0; i < 4; ++i) {
        if (weights[i] == 0.0) continue;
        int bone = int(bones[i]);
        sum += weights[i] * blended_bone(rows, bone);
    }
    mat3x4 model;
    for (int r = 0; r < 3; ++r) {
        vec4 row = model_from_palette[r];
        model[r] = row.x * sum[0] + row.y * sum[1] + row.z * sum[2] + vec4(0.0, 0.0, 0.0, row.w);
    }
    return model;
}
