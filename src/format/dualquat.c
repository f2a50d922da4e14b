/* SPDX-License-Identifier: MIT */
#include "format/dualquat.h"

static float dot(const float a[4], const float b[4]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

posepack_scaled_dualquat posepack_dualquat_take_scale(const posepack_dualquat* row, float length) {
    posepack_scaled_dualquat out;
    const float along = dot(row->real, row->dual) / dot(row->real, row->real);
    int c;
    for (c = 0; c < 4; ++c) {
        out.real[c] = row->real[c];
        out.dual[c] = row->dual[c] - along * row->real[c];
    }
    out.scale = 1.0f + 2.0f * along / length;
    return out;
}

void posepack_dualquat_write(const posepack_scaled_dualquat* numbers, float matrix[12]) {
    const posepack_scaled_dualquat* d = numbers;
    const float smallest = 1e-12f; /* of a square; rows of a palette are near length 1 */
    const float x = d->real[0], y = d->real[1], z = d->real[2], w = d->real[3];
    const float square = dot(d->real, d->real);
    const float h = 2.0f / (square < smallest ? smallest : square);
    const float s = d->scale;
    matrix[0] = s * (1.0f - h * (y * y + z * z));
    matrix[1] = s * (h * (x * y - w * z));
    matrix[2] = s * (h * (x * z + w * y));
    matrix[3] = h * (w * d->dual[0] - d->dual[3] * x + (y * d->dual[2] - z * d->dual[1]));
    matrix[4] = s * (h * (x * y + w * z));
    matrix[5] = s * (1.0f - h * (x * x + z * z));
    matrix[6] = s * (h * (y * z - w * x));
    matrix[7] = h * (w * d->dual[1] - d->dual[3] * y + (z * d->dual[0] - x * d->dual[2]));
    matrix[8] = s * (h * (x * z - w * y));
    matrix[9] = s * (h * (y * z + w * x));
    matrix[10] = s * (1.0f - h * (x * x + y * y));
    matrix[11] = h * (w * d->dual[2] - d->dual[3] * z + (x * d->dual[1] - y * d->dual[0]));
}

posepack_scaled_dualquat posepack_dualquat_mix(const posepack_scaled_dualquat* a,
                                               const posepack_scaled_dualquat* b, float factor) {
    const float rest = 1.0f - factor;
    posepack_scaled_dualquat mixed;
    int c;
    for (c = 0; c < 4; ++c) {
        mixed.real[c] = a->real[c] * rest + b->real[c] * factor;
        mixed.dual[c] = a->dual[c] * rest + b->dual[c] * factor;
    }
    mixed.scale = a->scale * rest + b->scale * factor;
    return mixed;
}

posepack_scaled_dualquat posepack_dualquat_fade(const posepack_scaled_dualquat* a,
                                                const posepack_scaled_dualquat* b, float factor) {
    const float sign = dot(a->real, b->real) < 0.0f ? -1.0f : 1.0f;
    posepack_scaled_dualquat turned;
    int c;
    for (c = 0; c < 4; ++c) {
        turned.real[c] = sign * b->real[c];
        turned.dual[c] = sign * b->dual[c];
    }
    turned.scale = b->scale;
    return posepack_dualquat_mix(a, &turned, factor);
}

void posepack_dualquat_decode(const posepack_dualquat* row, float length, float matrix[12]) {
    const posepack_scaled_dualquat scaled = posepack_dualquat_take_scale(row, length);
    posepack_dualquat_write(&scaled, matrix);
}

void posepack_dualquat_blend(const posepack_dualquat* a, const posepack_dualquat* b, float factor,
                             float length, float matrix[12]) {
    const posepack_scaled_dualquat first = posepack_dualquat_take_scale(a, length);
    const posepack_scaled_dualquat second = posepack_dualquat_take_scale(b, length);
    const posepack_scaled_dualquat mixed = posepack_dualquat_mix(&first, &second, factor);
    posepack_dualquat_write(&mixed, matrix);
}
