/* SPDX-License-Identifier: MIT */
#include "format/half.h"

/* The magnitude `bits` (a float's bits without its sign) divided by 2^shift, nearest, ties to even. */
static uint32_t shift_right_to_even(uint32_t bits, uint32_t shift) {
    const uint32_t kept = bits >> shift;
    const uint32_t rest = bits & ((1u << shift) - 1u);
    const uint32_t tie = 1u << (shift - 1u);
    return kept + (uint32_t)(rest > tie || (rest == tie && (kept & 1u) != 0));
}

uint16_t posepack_half_from_float(float value) {
    const uint32_t bits = posepack_bits_from_float(value);
    const uint32_t sign = (bits >> 16) & 0x8000u;
    const uint32_t magnitude = bits & 0x7FFFFFFFu;
    uint32_t half;
    if (magnitude > 0x7F800000u) {
        half = 0x7E00u | ((magnitude >> 13) & 0x3FFu);
    } else if (magnitude >= 0x477FF000u) { /* 65520: halfway between 65504 and 65536 */
        half = 0x7C00u;
    } else if (magnitude >=
               0x38800000u) { /* 2^-14: normal. A carry out of the fraction raises the exponent */
        half = shift_right_to_even(magnitude - 0x38000000u, 13);
    } else if (magnitude >= 0x33000000u) { /* 2^-25: subnormal, a count of 2^-24 */
        half = shift_right_to_even((magnitude & 0x7FFFFFu) | 0x800000u, 126u - (magnitude >> 23));
    } else {
        half = 0;
    }
    return (uint16_t)(sign | half);
}
