/* SPDX-License-Identifier: MIT */
/*
 * CRC-32C, the checksum of header, section table and sections (Castagnoli polynomial 0x1EDC6F41,
 * reflected, initial value and final XOR 0xFFFFFFFF: RFC 3720, appendix B.4).
 */
#ifndef POSEPACK_FORMAT_CRC32C_H
#define POSEPACK_FORMAT_CRC32C_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The CRC-32C of `size` bytes, continued from `crc_seed`: 0 to begin, else the result for the bytes
 * before these. `bytes` may be null when `size` is 0. Uses the processor's CRC instruction where
 * there is one; the result is the same. No table is built and nothing is remembered.
 */
uint32_t posepack_crc32c(uint32_t crc_seed, const void* bytes, size_t size);

/* The same result from the portable table alone; tests compare the two. */
uint32_t posepack_crc32c_table(uint32_t crc_seed, const void* bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
