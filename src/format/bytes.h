/* SPDX-License-Identifier: MIT */
/*
 * Little-endian numbers in unaligned bytes.
 *
 * Every number of a container passes through these functions: by copy, so that neither alignment
 * nor the host's byte order matters, and never through a struct laid over the file.
 * `bytes` must have room for the number; nothing is checked here.
 */
#ifndef POSEPACK_FORMAT_BYTES_H
#define POSEPACK_FORMAT_BYTES_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

static inline uint16_t posepack_read_u16(const uint8_t* bytes) {
    return (uint16_t)((unsigned)bytes[0] | ((unsigned)bytes[1] << 8));
}

static inline uint32_t posepack_read_u32(const uint8_t* bytes) {
    return (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8) | ((uint32_t)bytes[2] << 16) |
           ((uint32_t)bytes[3] << 24);
}

static inline uint64_t posepack_read_u64(const uint8_t* bytes) {
    return (uint64_t)posepack_read_u32(bytes) | ((uint64_t)posepack_read_u32(bytes + 4) << 32);
}

/* The float whose IEEE 754 bits are `bits`. */
static inline float posepack_float_from_bits(uint32_t bits) {
    union {
        uint32_t bits;
        float value;
    } pun;
    pun.bits = bits;
    return pun.value;
}

/* The IEEE 754 bits of `value`. */
static inline uint32_t posepack_bits_from_float(float value) {
    union {
        uint32_t bits;
        float value;
    } pun;
    pun.value = value;
    return pun.bits;
}

static inline float posepack_read_f32(const uint8_t* bytes) {
    return posepack_float_from_bits(posepack_read_u32(bytes));
}

static inline void posepack_write_u16(uint8_t* bytes, uint16_t value) {
    bytes[0] = (uint8_t)(value & 0xFFu);
    bytes[1] = (uint8_t)(value >> 8);
}

static inline void posepack_write_u32(uint8_t* bytes, uint32_t value) {
    posepack_write_u16(bytes, (uint16_t)(value & 0xFFFFu));
    posepack_write_u16(bytes + 2, (uint16_t)(value >> 16));
}

static inline void posepack_write_u64(uint8_t* bytes, uint64_t value) {
    posepack_write_u32(bytes, (uint32_t)(value & 0xFFFFFFFFu));
    posepack_write_u32(bytes + 4, (uint32_t)(value >> 32));
}

static inline void posepack_write_f32(uint8_t* bytes, float value) {
    posepack_write_u32(bytes, posepack_bits_from_float(value));
}

#ifdef __cplusplus
}
#endif

#endif
