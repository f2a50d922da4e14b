/* SPDX-License-Identifier: MIT */
/*
 * IEEE 754 binary16 ("half") numbers, in software: the same bits on every host, and the same as the
 * F16C and NEON instructions give for every float that is not a NaN.
 */
#ifndef POSEPACK_FORMAT_HALF_H
#define POSEPACK_FORMAT_HALF_H

#include <stdint.h>

#include "format/bytes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define POSEPACK_HALF_ONE 0x3C00u
#define POSEPACK_HALF_MAX 65504.0f /* the largest finite half */

/*
 * The half nearest to `value`, ties to even. Values of 65520 and more in magnitude become infinite;
 * values below 2^-14 become subnormal or zero with the same sign; a NaN becomes a quiet NaN that
 * keeps its sign and the upper ten bits of its payload.
 */
uint16_t posepack_half_from_float(float value);

/*
 * The value of `half` as a float: exact for numbers; a NaN keeps sign and payload. Inline, because
 * every component of every decoded matrix passes here.
 */
static inline float posepack_float_from_half(uint16_t half) {
    const uint32_t sign = ((uint32_t)half & 0x8000u) << 16;
    const float two_to_minus_14 = 0.00006103515625f;
    /* Exponent and fraction in their new places. */
    const uint32_t magnitude = ((uint32_t)half & 0x7FFFu) << 13;
    if (magnitude >= 0x0F800000u) return posepack_float_from_bits(sign | 0x70000000u | magnitude);
    if (magnitude >= 0x00800000u) return posepack_float_from_bits(sign | (magnitude + 0x38000000u));
    /* Subnormal: read as 2^-14 too much, then take that away, which is exact. */
    return posepack_float_from_bits(
        sign | posepack_bits_from_float(posepack_float_from_bits(magnitude + 0x38800000u) - two_to_minus_14));
}

#ifdef __cplusplus
}
#endif

#endif
