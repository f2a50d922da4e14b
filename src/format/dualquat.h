/* SPDX-License-Identifier: MIT */
/*
 * Bones of the form `dualquat`: a dual quaternion that carries a signed uniform scale, as eight numbers.
 *
 * A rotation q and a translation t are the dual quaternion real = q, dual = t q / 2 (t as a quaternion
 * without a scalar part). One of the eight numbers is redundant, because real . dual = 0; the form stores
 *
 *     dual' = dual + e real,    e = (s - 1) L / 2,
 *
 * with s the scale and L a length of the animal (the header's dualquat_length). The vector part of
 * 2 dual' conj(real) / |real|^2 is t whatever e is, and e = real . dual' / |real|^2 comes back by one dot
 * product. The length of `real` is free, which the compiler uses to round better.
 *
 * Two rows are blended by mixing real, dual and s (each row's own, taken first), then normalising.
 * Neighbouring rows lie in one hemisphere, so that nobody tests signs. docs/encodings/dualquat.md has the
 * algebra; docs/format/posepack-1.md, section 10, the order of operations, which this file follows to the
 * bit.
 */
#ifndef POSEPACK_FORMAT_DUALQUAT_H
#define POSEPACK_FORMAT_DUALQUAT_H

#ifdef __cplusplus
extern "C" {
#endif

/* The two texels of a bone-row; components x y z w. */
typedef struct posepack_dualquat {
    float real[4];
    float dual[4]; /* dual' above */
} posepack_dualquat;

/* A bone-row, or a blend, with its scale taken out: `dual` is that of the transform again. */
typedef struct posepack_scaled_dualquat {
    float real[4], dual[4], scale;
} posepack_scaled_dualquat;

/* The numbers of one bone-row. `real` must not vanish; `length` is L, above zero. */
posepack_scaled_dualquat posepack_dualquat_take_scale(const posepack_dualquat* row, float length);

/* The numbers between `a` and `b`, whatever their signs: `factor` is the share of `b`. */
posepack_scaled_dualquat posepack_dualquat_mix(const posepack_scaled_dualquat* a,
                                               const posepack_scaled_dualquat* b, float factor);

/* The same between poses that no writer put into one hemisphere: `b` is turned where real . real < 0. */
posepack_scaled_dualquat posepack_dualquat_fade(const posepack_scaled_dualquat* a,
                                                const posepack_scaled_dualquat* b, float factor);

/* scale x rotation | translation, of a real part of any length; finite where it vanishes. */
void posepack_dualquat_write(const posepack_scaled_dualquat* numbers, float matrix[12]);

/* The 3x4 row-major matrix of one bone-row. `real` must not vanish; `length` is L, above zero. */
void posepack_dualquat_decode(const posepack_dualquat* row, float length, float matrix[12]);

/*
 * The matrix between two bone-rows: `factor` 0 gives `a`, 1 gives `b`. Where the mixed real part vanishes
 * (opposite rows, which no writer makes) the matrix is finite and means nothing.
 */
void posepack_dualquat_blend(const posepack_dualquat* a, const posepack_dualquat* b, float factor,
                             float length, float matrix[12]);

#ifdef __cplusplus
}
#endif

#endif
