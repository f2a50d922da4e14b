/* SPDX-License-Identifier: MIT */
/*
 * IEEE 754 binary16 ("half") numbers, in software: the same bits on every host, and the same as the
 * F16C and NEON instructions give for every float that is not a NaN.
 */
#ifndef POSEPACK_FORMAT_HALF_H
#define POSEPACK_FORMAT_HALF_H

#include <stdint.h>

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

/* The value of `half` as a float: exact for numbers; a NaN keeps sign and payload. */
float posepack_float_from_half(uint16_t half);

#ifdef __cplusplus
}
#endif

#endif
