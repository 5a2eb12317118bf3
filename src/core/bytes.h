/* SPDX-License-Identifier: MIT
 *
 * Internal: numbers as bytes, the least significant first, on any machine.
 */
#ifndef INVCAL_BYTES_H
#define INVCAL_BYTES_H

#include "invcal/invcal.h"
#include "names.h"

#if FLT_RADIX != 2 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128
#error "float is not IEEE-754 binary32 here"
#endif

/* Four bytes are one load if alignment does not matter, which gcc does not find by itself. */
#ifdef __GNUC__
#define INVCAL_ALWAYS_INLINE __attribute__((always_inline)) inline
#else
#define INVCAL_ALWAYS_INLINE inline
#endif

static inline uint16_t invcali_get_u16(const uint8_t *bytes)
{
    return (uint16_t)(bytes[0] | (unsigned)bytes[1] << 8);
}

static INVCAL_ALWAYS_INLINE uint32_t invcali_get_u32(const uint8_t *bytes)
{
    return invcali_get_u16(bytes) | (uint32_t)invcali_get_u16(bytes + 2) << 16;
}

/* Writes four bytes. Returns their end, as do all functions that write. */
uint8_t *invcali_put_u32(uint8_t *bytes, uint32_t value);

/* Writes two numbers of 16 bits. */
static inline uint8_t *invcali_put_two(uint8_t *bytes, unsigned first, unsigned second)
{
    return invcali_put_u32(bytes, first | (uint32_t)second << 16);
}

/* Writes the reals at the beginning of a structure, as binary32; one beyond float becomes a NaN. */
uint8_t *invcali_put_reals(uint8_t *bytes, const void *reals, unsigned count);

/* Reads them. Returns 1 if all are finite. */
int invcali_get_reals(const uint8_t *bytes, void *reals, unsigned count);

/* CRC-32 (IEEE 802.3, as zlib): 0xCBF43926 for "123456789". Starts at 0, and goes on where an
 * earlier call ended. */
uint32_t invcali_crc32(uint32_t crc, const uint8_t *bytes, unsigned count);
#define INVCAL_CRC_RESIDUE UINT32_C(0x2144DF1C) /* of anything followed by its own CRC-32 */

/* A verdict as a byte of a record, and back: its steps of 16 are stored as steps of 1. */
static inline uint8_t invcali_swap(unsigned verdict)
{
    return (uint8_t)(verdict >> 4 | verdict << 4);
}

/* Records have a frame: kind, version, length (16 bits), the content, and at the end of the length
 * the CRC of all before it. */
enum { INVCAL_CRC_SIZE = 4 };
enum {
    INVCAL_RECORD_KIND = 0x02CA, /* version and kind */
    INVCAL_THERMAL_KIND = 0x02CB,
    INVCAL_IMU_KIND = 0x01CC
};
void invcali_seal(uint8_t *bytes, unsigned kind, unsigned length);

/* Returns INVCAL_OK; INVCAL_DAMAGED; INVCAL_OTHER_VERSION for sound bytes of another kind or
 * version. */
invcal_status invcali_unseal(const uint8_t *bytes, uint32_t size, unsigned kind);

#endif
